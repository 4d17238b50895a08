// Fields for numbers: what may be typed, what is told of it, where the slider stands, and units.
#include <cmath>

#include <QApplication>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include "core/scene/bodies.h"
#include "core/scene/scene.h"
#include "core/surface/material.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/base/numbers.h"
#include "ui/panels/parameter_field.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/value_slider.h"

namespace test_number_fields {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

void type(QWidget& field, const QString& text) {
    field.setFocus();
    QTest::keyClick(&field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

/// A slider in a width that is known, with events as from a mouse.
struct Drag {
    explicit Drag(ValueSlider& on) : slider(on) { slider.resize(112, 20); } // a groove of 100 pixels from 6
    void send(QEvent::Type what, double x, Qt::KeyboardModifiers keys = {},
              Qt::MouseButton button = Qt::LeftButton) {
        const QPointF at(x, 10);
        QMouseEvent event(what, at, slider.mapToGlobal(at), what == QEvent::MouseMove ? Qt::NoButton : button,
                          what == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button), keys);
        QApplication::sendEvent(&slider, &event);
    }
    void press(double x) { send(QEvent::MouseButtonPress, x); }
    void move(double x, Qt::KeyboardModifiers keys = {}) { send(QEvent::MouseMove, x, keys); }
    void release(double x) { send(QEvent::MouseButtonRelease, x); }

    ValueSlider& slider;
};

void wheel(QWidget& widget, int angle) {
    QWheelEvent event(QPointF(5, 5), widget.mapToGlobal(QPointF(5, 5)), {}, {0, angle}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

} // namespace

class TestNumberFields : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumFields"); }

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }

    // A microgram is typed and read again, and what is not small keeps its form.
    void smallMassesAreShown() {
        ParameterField field(kBodyMass);
        auto* box = field.findChild<NumberBox*>();
        QSignalSpy edited(&field, &ParameterField::edited);
        for (const auto& [mass, text] : {std::pair(0.1, "100.0000"),
                                         {1.5e-7, "0.000150"},
                                         {2.5e-9, "0.00000250"},
                                         {1e-12, "0.00000000100"},
                                         {7864.4282, "7864428.2"},
                                         {1e9, "1000000000000"}}) {
            field.setValue(mass);
            QCOMPARE(box->text(), QString(text));
        }
        type(*box, "3 ug");
        QCOMPARE(edited.size(), 1);
        COMPARE_NEAR(edited[0][0].toDouble(), 3e-9, 1e-20, "kg");
        QCOMPARE(numberText(0.6, decimalsFor(0.6, 2)), "0.60");
        QCOMPARE(numberText(0, decimalsFor(0, 9)), "0.0000"); // it has no first figure to count from
    }

    void theScaleOfASliderIsLinearOrLogarithmic() {
        const Parameter wide{"w", "Wide", "", 1, 1000, 1, 1, 0, ""},
            narrow{"n", "Narrow", "", 1, 999, 2, 1, 0, ""}, signs{"s", "Signs", "", -1, 3, 0.25, 0, 2, ""};
        const ValueScale a(wide), b(narrow), c(signs);
        COMPARE_NEAR(a.fraction(1), 0, 1e-12, "");
        COMPARE_NEAR(a.fraction(10), 1.0 / 3, 1e-12, "");
        COMPARE_NEAR(a.fraction(1000), 1, 1e-12, "");
        COMPARE_NEAR(a.fraction(1e9), 1, 1e-12, "");
        COMPARE_NEAR(a.fraction(0), 0, 1e-12, "");
        COMPARE_NEAR(a.value(0.5), 32, 1e-9, "");  // 31.6 in two figures
        COMPARE_NEAR(a.value(0.9), 500, 1e-9, ""); // 501
        COMPARE_NEAR(a.value(2), 1000, 1e-9, "");
        COMPARE_NEAR(a.value(-1), 1, 1e-12, "");
        COMPARE_NEAR(b.fraction(500), 0.5, 1e-12, "");
        COMPARE_NEAR(b.value(0.5), 500, 1e-12, "");
        COMPARE_NEAR(b.value(0.5011), 502, 1e-12, ""); // whole steps
        COMPARE_NEAR(c.fraction(0), 0.25, 1e-12, "");
        COMPARE_NEAR(c.value(0.25), 0, 1e-12, "");
        COMPARE_NEAR(c.value(0.3), 0.25, 1e-12, "");
        COMPARE_NEAR(c.value(0), -1, 1e-12, "");
        COMPARE_NEAR(c.value(1), 3, 1e-12, "");
    }

    void aSliderIsDragged() {
        const Parameter ratio{"r", "Ratio", "", 0, 1, 0.01, 0.5, 2, ""};
        ValueSlider slider(ratio);
        Drag drag(slider);
        slider.display(0.2);
        QCOMPARE(slider.current(), 0.2);
        QSignalSpy moved(&slider, &QSlider::valueChanged), pressed(&slider, &QSlider::sliderPressed),
            released(&slider, &QSlider::sliderReleased);
        slider.display(0.25);
        QCOMPARE(moved.size(), 0); // shown without telling anybody
        drag.press(6 + 25);        // on the handle: nothing jumps
        QCOMPARE(pressed.size(), 1);
        QVERIFY(slider.isSliderDown());
        QCOMPARE(slider.current(), 0.25);
        drag.press(6 + 32); // still on it
        QCOMPARE(slider.current(), 0.25);
        drag.release(6 + 32);
        QCOMPARE(released.size(), 2 - 1);
        QVERIFY(!slider.isSliderDown());
        drag.press(6 + 60); // beside it: it comes
        QCOMPARE(slider.current(), 0.6);
        slider.display(0.1); // the hand on it knows better
        QCOMPARE(slider.current(), 0.6);
        drag.move(6 + 70);
        QCOMPARE(slider.current(), 0.7);
        drag.move(6 + 80, Qt::ShiftModifier); // ten times finer
        QCOMPARE(slider.current(), 0.71);
        drag.move(6 + 83, Qt::ControlModifier); // 0.74, in twentieths
        QCOMPARE(slider.current(), 0.75);
        drag.move(6 + 500);
        QCOMPARE(slider.current(), 1.0);
        drag.move(6 + 490); // begins at the end that it was held at
        QCOMPARE(slider.current(), 0.9);
        drag.move(-1000);
        QCOMPARE(slider.current(), 0.0);
        drag.release(0);
        drag.move(6 + 50); // let go
        QCOMPARE(slider.current(), 0.0);
        drag.send(QEvent::MouseButtonPress, 6 + 50, {}, Qt::RightButton);
        QVERIFY(!slider.isSliderDown());
        QCOMPARE(slider.current(), 0.0);
    }

    void keysAndTheWheelStepASlider() {
        const Parameter ratio{"r", "Ratio", "", 0, 1, 0.01, 0.5, 2, ""};
        ValueSlider slider(ratio);
        slider.display(0.5);
        QTest::keyClick(&slider, Qt::Key_Right);
        QCOMPARE(slider.current(), 0.51);
        QTest::keyClick(&slider, Qt::Key_PageUp);
        QCOMPARE(slider.current(), 0.56);
        QTest::keyClick(&slider, Qt::Key_Home);
        QCOMPARE(slider.current(), 0.0);
        QTest::keyClick(&slider, Qt::Key_End);
        QCOMPARE(slider.current(), 1.0);
        QSignalSpy notched(&slider, &ValueSlider::notched);
        wheel(slider, 120);
        wheel(slider, -240);
        wheel(slider, 60); // not a notch yet
        QCOMPARE(notched.size(), 2);
        QCOMPARE(notched[0][0].toInt(), 1);
        QCOMPARE(notched[1][0].toInt(), -2);
        QCOMPARE(slider.current(), 1.0); // it asks; it does not step itself
    }

    void aSliderIsDrawn() {
        ValueSlider slider(kStiffness);
        slider.resize(112, 20);
        slider.display(100);
        COMPARE_SHOWN(drawnBy(slider), "slider");
        slider.setCeiling(1000);
        slider.setEnabled(false);
        COMPARE_SHOWN(drawnBy(slider), "slider-ceiling");
        slider.setCeiling(std::nullopt);
        slider.setEnabled(true);
        COMPARE_SHOWN(drawnBy(slider), "slider");
    }

    void aBoxSaysWhatWasTyped() {
        NumberBox box(QStringLiteral("N/m"));
        box.setRange(1, 10000);
        box.setDecimals(0);
        box.setSingleStep(10);
        box.setValue(800);
        box.show();
        QSignalSpy typed(&box, &NumberBox::typed), stepped(&box, &NumberBox::stepped),
            out(&box, &NumberBox::outOfRange), wrong(&box, &NumberBox::notUnderstood);
        type(box, "1.2 N/mm");
        QCOMPARE(box.value(), 1200.0);
        QCOMPARE(box.text(), "1200");
        QCOMPARE(typed.size(), 1);
        QCOMPARE(typed[0][0].toDouble(), 1200.0);
        QVERIFY(out.isEmpty());
        type(box, "99999");
        QCOMPARE(box.value(), 10000.0);
        QCOMPARE(out.size(), 1);
        QCOMPARE(out[0][0].toDouble(), 99999.0);
        type(box, "-5");
        QCOMPARE(box.value(), 1.0);
        QCOMPARE(out.size(), 2);
        type(box, "10000");
        type(box, "1");
        QCOMPARE(out.size(), 2); // the ends themselves are in it
        QVERIFY(wrong.isEmpty());
        type(box, "soft");
        QCOMPARE(box.value(), 1.0);
        QCOMPARE(box.text(), "1");
        QCOMPARE(wrong.size(), 1);
        QCOMPARE(wrong[0][0].toString(), "soft");
        type(box, "3 mm"); // of another kind
        QCOMPARE(wrong.size(), 2);
        QVERIFY(stepped.isEmpty());
        box.setValue(500);
        typed.clear();
        box.stepBy(3);
        QCOMPARE(box.value(), 530.0);
        QCOMPARE(stepped.size(), 1);
        QCOMPARE(stepped[0][0].toDouble(), 530.0);
        QVERIFY(typed.isEmpty());
        box.setValue(600); // after a step, by the program
        QCOMPARE(stepped.size(), 1);
    }

    void charactersThatNoNumberHasAreNotTaken() {
        NumberBox box(QStringLiteral("N/m"));
        const auto stateOf = [&](const char* text) {
            QString typed = QString::fromUtf8(text);
            int at = 0;
            return box.validate(typed, at);
        };
        for (const char* text : {"1", "1.5", "-3", "+2", "1e3", "1,5", "2 N/mm"})
            QCOMPARE(stateOf(text), QValidator::Acceptable);
        for (const char* text : {"", "-", "1e", "1.5 N", "5 %", "N^2", "1*2", "3\u00b0", "a\u00b7b"})
            QCOMPARE(stateOf(text), QValidator::Intermediate);
        for (const char* text : {"1!", "(2)", "1=1", "#"})
            QCOMPARE(stateOf(text), QValidator::Invalid);
    }

    void severalValuesAreMixed() {
        NumberBox box(QString{});
        box.setRange(0, 10);
        box.setValue(4);
        box.show();
        box.setMixed(true);
        QCOMPARE(box.text(), "mixed");
        QSignalSpy typed(&box, &NumberBox::typed);
        type(box, "4.00"); // the very value of one of them counts for all
        QCOMPARE(typed.size(), 1);
        QCOMPARE(typed[0][0].toDouble(), 4.0);
        box.setMixed(false);
        QCOMPARE(box.text(), "4.00");
        box.setMixed(true);
        type(box, "20");
        QCOMPARE(typed.back()[0].toDouble(), 10.0); // brought into range
        box.setMixed(false);
        typed.clear();
        type(box, "10"); // as it was: nothing is told
        QCOMPARE(typed.size(), 0);
    }

    void keysOfTheProgramPassTheBox() {
        NumberBox box(QString{});
        box.show();
        const auto keeps = [&](int key, Qt::KeyboardModifiers with = Qt::ControlModifier) {
            QKeyEvent event(QEvent::ShortcutOverride, key, with);
            event.ignore();
            QApplication::sendEvent(&box, &event);
            return event.isAccepted();
        };
        QVERIFY(!keeps(Qt::Key_E)); // the end of the line for Qt, export for us
        QVERIFY(!keeps(Qt::Key_Z));
        QVERIFY(keeps(Qt::Key_C));
        QVERIFY(keeps(Qt::Key_V));
        QVERIFY(keeps(Qt::Key_X));
        QVERIFY(keeps(Qt::Key_A));
        box.findChild<QLineEdit*>()->setModified(true); // something typed that the line can take back
        QVERIFY(keeps(Qt::Key_Z));
        QVERIFY(!keeps(Qt::Key_E));
    }

    void aFieldIsMadeFromItsParameter() {
        ParameterField stiffness(kStiffness), radius(kProxyRadius), ratio(kStaticFriction);
        COMPARE_SHOWN(shownIn(stiffness), "field-stiffness");
        COMPARE_SHOWN(shownIn(radius), "field-radius");
        COMPARE_SHOWN(shownIn(ratio), "field-ratio");
        stiffness.setValue(1000);
        stiffness.setCeiling(1200.0, QStringLiteral("no more"));
        COMPARE_SHOWN(shownIn(stiffness), "field-stiffness-ceiling");
        stiffness.setMixed(true);
        COMPARE_SHOWN(shownIn(stiffness), "field-stiffness-mixed");
        stiffness.setMixed(false);
        stiffness.setCeiling(std::nullopt, QStringLiteral("not said"));
        stiffness.setValue(kStiffness.initial);
        COMPARE_SHOWN(shownIn(stiffness), "field-stiffness");
        ratio.setCompact();
        ratio.setValue(1);
        COMPARE_SHOWN(shownIn(ratio), "field-ratio-compact");
        ratio.setMixed(true);
        QVERIFY(ratio.findChild<QToolButton*>(QStringLiteral("static-friction-reset"))->isHidden());
    }

    void aFieldTellsEveryWayOfEditing() {
        ParameterField field(kProxyRadius); // shown in mm
        field.show();
        auto& box = *field.findChild<NumberBox*>(QStringLiteral("proxy-radius"));
        auto& slider = *field.findChild<ValueSlider*>(QStringLiteral("proxy-radius-slider"));
        auto& reset = *field.findChild<QToolButton*>(QStringLiteral("proxy-radius-reset"));
        auto& hint = *field.findChild<QLabel*>(QStringLiteral("proxy-radius-hint"));
        std::vector<std::pair<double, Gesture>> told;
        connect(&field, &ParameterField::edited, &field,
                [&](double value, Gesture gesture) { told.emplace_back(value, gesture); });
        field.setValue(0.002);
        QVERIFY(told.empty());
        QCOMPARE(box.value(), 2.0);
        QVERIFY(!reset.isHidden());
        type(box, "3");
        QCOMPARE(told.size(), 1u);
        COMPARE_NEAR(told.back().first, 0.003, 1e-12, "m");
        QCOMPARE(told.back().second, 0); // each by itself
        QElapsedTimer clock;             // steps that follow each other within 0.8 s are one run
        clock.start();
        box.stepBy(1);
        COMPARE_NEAR(told.back().first, 0.0031, 1e-12, "m");
        const Gesture first = told.back().second;
        QVERIFY(first != 0);
        box.stepBy(1);
        const Gesture second = told.back().second;
        wheel(slider, 120);
        const Gesture third = told.back().second;
        if (clock.elapsed() < 800) {
            QCOMPARE(second, first);
            QCOMPARE(third, first);
        }
        COMPARE_NEAR(told.back().first, 0.0033, 1e-12, "m");
        QTest::qWait(900); // at least: the run is over
        box.stepBy(-1);
        QVERIFY(told.back().second != third);
        QVERIFY(told.back().second != 0);
        const std::size_t before = told.size();
        reset.click();
        QCOMPARE(told.size(), before + 1);
        QCOMPARE(told.back(), (std::pair<double, Gesture>(kProxyRadius.initial, 0)));
        auto* label = field.findChildren<QLabel*>().front();
        QTest::mouseDClick(label, Qt::LeftButton);
        QCOMPARE(told.size(), before + 2);
        QCOMPARE(told.back().first, kProxyRadius.initial);
        // A drag is one gesture, and the next drag another.
        Drag drag(slider);
        drag.press(20);
        drag.move(50);
        const Gesture held = told.back().second;
        drag.move(60);
        QCOMPARE(told.back().second, held);
        drag.release(60);
        drag.press(20);
        drag.move(80);
        QVERIFY(told.back().second != held);
        drag.release(80);
        // What cannot be is told beneath, until something else is set.
        QVERIFY(hint.isHidden());
        type(box, "1000");
        QVERIFY(!hint.isHidden());
        QCOMPARE(hint.text(), "At most 100.00 mm");
        type(box, "0");
        QCOMPARE(hint.text(), "At least 0.01 mm");
        type(box, "wide");
        QCOMPARE(hint.text(), QString::fromUtf8("\u201cwide\u201d is not a number in mm"));
        field.setValue(box.value() / 1000); // the same: the hint stays
        QVERIFY(!hint.isHidden());
        field.setValue(0.005);
        QVERIFY(hint.isHidden());
        type(box, "wide");
        QVERIFY(!hint.isHidden());
        type(box, "6");
        QVERIFY(hint.isHidden());
    }
};

TACTUM_GUI_TEST(TestNumberFields)

} // namespace test_number_fields

#include "test_number_fields.moc"
