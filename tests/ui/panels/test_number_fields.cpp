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
#include "core/surface/texture_parameters.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/base/numbers.h"
#include "ui/base/units.h"
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

    void numbersAsText() {
        QCOMPARE(numberText(0.6, 2), "0.60");
        QCOMPARE(numberText(-0.004, 2), "0.00"); // not -0.00
        QCOMPARE(numberText(-0.006, 2), "-0.01");
        QCOMPARE(numberText(1e6, 0), "1000000");
        QCOMPARE(numberText(std::nan(""), 2), "-");
        QCOMPARE(numberText(INFINITY, 2), "-");
    }

    void areasAsText() {
        QCOMPARE(areaText(0), QString::fromUtf8("0.00 mm\u00b2"));
        QCOMPARE(areaText(2.5e-7), QString::fromUtf8("0.25 mm\u00b2"));
        QCOMPARE(areaText(4.25e-5), QString::fromUtf8("42.5 mm\u00b2"));
        QCOMPARE(areaText(0.9999e-4), QString::fromUtf8("1.00 cm\u00b2"));
        QCOMPARE(areaText(0.01), QString::fromUtf8("100 cm\u00b2"));
        QCOMPARE(areaText(1.2), QString::fromUtf8("1.20 m\u00b2"));
    }

    void lengthsAndTimesAsText() {
        QCOMPARE(lengthText(0), "0.00 mm");
        QCOMPARE(lengthText(1.4e-10), "0.14 nm");
        QCOMPARE(lengthText(1.4e-7), QString::fromUtf8("0.14 \u00b5m"));
        QCOMPARE(lengthText(9.99e-6), QString::fromUtf8("10 \u00b5m"));
        QCOMPARE(lengthText(1.4e-5), QString::fromUtf8("14 \u00b5m"));
        QCOMPARE(lengthText(0.99e-4), QString::fromUtf8("99 \u00b5m"));
        QCOMPARE(lengthText(0.9999e-4), "0.10 mm");
        QCOMPARE(lengthText(0.00014), "0.14 mm");
        QCOMPARE(lengthText(0.0003), "0.30 mm");
        QCOMPARE(lengthText(0.00999), "9.99 mm");
        QCOMPARE(lengthText(0.01), "10 mm");
        QCOMPARE(lengthText(0.2), "200 mm");
        QCOMPARE(lengthText(0.999), "999 mm");
        QCOMPARE(lengthText(1), "1.0 m");
        QCOMPARE(lengthText(4.2), "4.2 m");
        QCOMPARE(lengthText(10), "10 m");
        QCOMPARE(lengthText(1234.4), "1234 m");
        QCOMPARE(durationText(0), "1 s"); // never nothing
        QCOMPARE(durationText(3), "3 s");
        QCOMPARE(durationText(89), "89 s");
        QCOMPARE(durationText(90), "2 min");
        QCOMPARE(durationText(600), "10 min");
    }

    void parametersInUnitsForTheScreen() {
        const DisplayUnit radius = displayUnit(kProxyRadius), stiffness = displayUnit(kStiffness),
                          turn = displayUnit(kTextureRotation), none = displayUnit(kStaticFriction);
        QCOMPARE(radius.factor, 1000.0);
        QCOMPARE(radius.name, "mm");
        QCOMPARE(radius.decimals, kProxyRadius.decimals - 3);
        QCOMPARE(stiffness.factor, 1.0);
        QCOMPARE(stiffness.name, "N/m");
        QCOMPARE(stiffness.decimals, kStiffness.decimals);
        COMPARE_NEAR(turn.factor * std::acos(-1.0), 180, 1e-9, "degrees");
        QCOMPARE(turn.name, QString::fromUtf8("\u00b0"));
        QCOMPARE(turn.decimals, std::max(0, kTextureRotation.decimals - 2));
        QCOMPARE(none.name, "");
        QCOMPARE(none.decimals, 3);
    }

    void unitsAreRead_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("factor");
        QTest::addColumn<QList<int>>("powers"); // of kg, m and s
        const auto row = [](const char* text, double factor, const QList<int>& powers) {
            QTest::newRow(text) << QString::fromUtf8(text) << factor << powers;
        };
        row("", 1, {0, 0, 0});
        row("1", 1, {0, 0, 0});
        row("N", 1, {1, 1, -2});
        row("m", 1, {0, 1, 0});
        row("s", 1, {0, 0, 1});
        row("g", 1e-3, {1, 0, 0});
        row("kg", 1, {1, 0, 0});
        row("Hz", 1, {0, 0, -1});
        row("kHz", 1e3, {0, 0, -1});
        row("rad", 1, {0, 0, 0});
        row("mrad", 1e-3, {0, 0, 0});
        row("deg", std::acos(-1.0) / 180, {0, 0, 0});
        row("\u00b0", std::acos(-1.0) / 180, {0, 0, 0});
        row("%", 0.01, {0, 0, 0});
        row("in", 0.0254, {0, 1, 0});
        row("min", 60, {0, 0, 1});
        row("mm", 1e-3, {0, 1, 0});
        row("cm", 1e-2, {0, 1, 0});
        row("km", 1e3, {0, 1, 0});
        row("nm", 1e-9, {0, 1, 0});
        row("um", 1e-6, {0, 1, 0});
        row("\u00b5m", 1e-6, {0, 1, 0});
        row("\u03bcm", 1e-6, {0, 1, 0});
        row("MN", 1e6, {1, 1, -2});
        row("N/mm", 1e3, {1, 0, -2});
        row("N s/m", 1, {1, 0, -1});
        row("N*s/m", 1, {1, 0, -1});
        row("N\u00b7s/m", 1, {1, 0, -1});
        row("N\u22c5s", 1, {1, 1, -1});
        row("1/s", 1, {0, 0, -1});
        row("m/s/s", 1, {0, 1, -2});
        row("m/s^2", 1, {0, 1, -2});
        row("m/s\u00b2", 1, {0, 1, -2});
        row("mm^2", 1e-6, {0, 2, 0});
        row("cm\u00b3", 1e-6, {0, 3, 0});
        row("mm^3", 1e-9, {0, 3, 0});
        row("kg m/s^2", 1, {1, 1, -2});
        row(" m ", 1, {0, 1, 0});
        row("N / m", 1, {1, 0, -2});
    }

    void unitsAreRead() {
        QFETCH(QString, text);
        QFETCH(double, factor);
        QFETCH(QList<int>, powers);
        const auto unit = readUnit(text);
        QVERIFY(unit.has_value());
        COMPARE_NEAR(unit->factor / factor, 1, 1e-12, "");
        for (int i = 0; i < 3; ++i)
            QCOMPARE(unit->dimension[std::size_t(i)], powers[i]);
    }

    void whatIsNoUnitIsRefused() {
        for (const char* text :
             {"x", "kdeg", "k", "N/", "/", "m*", "N//m", "N*/m", "mmm", "kin", "m^4", "M", "2", "m2"})
            QVERIFY2(!readUnit(QString::fromUtf8(text)), text);
    }

    void numbersAreReadWithTheirUnits() {
        const auto read = [](const char* text, const char* unit = "") {
            return readNumber(QString::fromUtf8(text), QString::fromUtf8(unit));
        };
        QCOMPARE(read("1.5"), 1.5);
        QCOMPARE(read(" 1,5 "), 1.5);
        QCOMPARE(read("-2e-3"), -2e-3);
        QCOMPARE(read("800", "N/m"), 800.0);
        COMPARE_NEAR(*read("1.2 N/mm", "N/m"), 1200, 1e-9, "N/m");
        COMPARE_NEAR(*read("0.3 mm", "mm"), 0.3, 1e-12, "mm");
        COMPARE_NEAR(*read("0.3m", "mm"), 300, 1e-9, "mm");
        COMPARE_NEAR(*read("1e-3 m", "mm"), 1, 1e-12, "mm");
        COMPARE_NEAR(*read("50 %"), 0.5, 1e-12, "");
        COMPARE_NEAR(*read("1 rad", "\u00b0"), 180 / std::acos(-1.0), 1e-9, "degrees");
        for (const char* text : {"", "x", "1 x", "mm", "1 2", "--1", "1 kg"})
            QVERIFY2(!read(text, "mm"), text);
        QVERIFY(!read("1 m")); // of another kind
        QVERIFY(!read("nan"));
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
