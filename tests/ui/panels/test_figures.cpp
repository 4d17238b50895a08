// Small pictures of figures: what each draws for known values, and what it says to those who hear it.
#include <cmath>
#include <limits>

#include <QApplication>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include "core/runtime/period_histogram.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/panels/panels.h"
#include "tests/ui/panels/touch_traces.h"
#include "ui/panels/flat_swatch.h"
#include "ui/panels/profile_chart.h"
#include "ui/panels/workspace_picture.h"
#include "ui/widgets/button_lamps.h"
#include "ui/widgets/compare_chart.h"
#include "ui/widgets/force_meter.h"
#include "ui/widgets/level_bar.h"
#include "ui/widgets/loupe.h"
#include "ui/widgets/period_chart.h"
#include "ui/widgets/strip_chart.h"
#include "ui/widgets/swatch.h"

namespace test_figures {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

void point(QWidget& widget, QPointF at) {
    QMouseEvent event(QEvent::MouseMove, at, widget.mapToGlobal(at), Qt::NoButton, {}, {});
    QApplication::sendEvent(&widget, &event);
}

void leave(QWidget& widget) {
    QEvent event(QEvent::Leave);
    QApplication::sendEvent(&widget, &event);
}

void turn(QWidget& widget, int angle) {
    QWheelEvent event(QPointF(5, 5), widget.mapToGlobal(QPointF(5, 5)), {}, {0, angle}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(&widget, &event);
}

QString tipAt(QWidget& widget, QPoint at) {
    QToolTip::hideText();
    QHelpEvent event(QEvent::ToolTip, at, widget.mapToGlobal(at));
    QApplication::sendEvent(&widget, &event);
    return QToolTip::text();
}

std::shared_ptr<const TouchTrace> trace(double peak, double seconds = 2, int rows = 21) {
    auto made = std::make_shared<TouchTrace>();
    for (int i = 0; i < rows; ++i) {
        const double part = double(i) / (rows - 1);
        made->push_back({.t = 1 + seconds * part, .force = {0, peak * (1 - std::abs(2 * part - 1)), 0}});
    }
    return made;
}

} // namespace

class TestFigures : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumFigures"); }

private slots:
    void initTestCase() {
        speakEnglish();
        applyTheme(ThemeChoice::Dark);
    }

    void theLoupeSaysHowLargeItIs() {
        QWidget below;
        Loupe loupe(&below);
        QVERIFY(loupe.isHidden());
        loupe.resize(200, 160);
        QImage picture(8, 8, QImage::Format_RGB32);
        picture.fill(Qt::red);
        loupe.setPicture(picture);
        loupe.setTimes(5);
        QCOMPARE(loupe.accessibleDescription(), "5 times as large");
        COMPARE_SHOWN(drawnBy(loupe), "loupe");
        loupe.setTimes(2.5);
        QCOMPARE(loupe.accessibleDescription(), "2.5 times as large");
        loupe.setPicture(picture, QStringLiteral("From the right"));
        QCOMPARE(loupe.accessibleDescription(), "From the right: 2.5 times as large");
        COMPARE_SHOWN(shownIn(loupe), "loupe-words");
        QSignalSpy turned(&loupe, &Loupe::turned), left(&loupe, &Loupe::left);
        turn(loupe, 180);
        turn(loupe, -120);
        QCOMPARE(turned.size(), 2);
        QCOMPARE(turned[0][0].toDouble(), 1.5);
        QCOMPARE(turned[1][0].toDouble(), -1.0);
        leave(loupe);
        QCOMPARE(left.size(), 1);
    }

    void lampsOfButtons() {
        ButtonLamps lamps;
        lamps.setButtons(0, 0);
        QCOMPARE(lamps.accessibleName(), "No button is held");
        QCOMPARE(lamps.sizeHint(), QSize(20, 20));
        lamps.setButtons(3, 0b101);
        QCOMPARE(lamps.accessibleName(), "Held buttons: 1, 3");
        QCOMPARE(lamps.sizeHint(), QSize(68, 20));
        QCOMPARE(lamps.minimumSizeHint(), QSize(68, 20));
        lamps.resize(lamps.sizeHint());
        COMPARE_SHOWN(shownIn(lamps) + drawnBy(lamps), "lamps");
        lamps.setButtons(3, 0b010);
        QCOMPARE(lamps.accessibleName(), "Held buttons: 2");
        lamps.setButtons(3, 0);
        QCOMPARE(lamps.accessibleName(), "No button is held");
        lamps.setButtons(40, 0xFFFFFFFF); // there is room for eight
        QCOMPARE(lamps.accessibleName(), "Held buttons: 1, 2, 3, 4, 5, 6, 7, 8");
        lamps.setButtons(-1, 1);
        QCOMPARE(lamps.accessibleName(), "No button is held");
    }

    void aMeterOfTheForce() {
        ForceMeter meter;
        QCOMPARE(meter.size(), QSize(216, 20));
        meter.setForce(1.5, 6);
        QCOMPARE(meter.accessibleName(), "Force 1.50 N of 6.0 N");
        COMPARE_SHOWN(shownIn(meter) + drawnBy(meter), "force");
        meter.setForce(5.993, 6); // all but a thousandth
        COMPARE_SHOWN(drawnBy(meter), "force-below-limit");
        meter.setForce(5.995, 6);
        COMPARE_SHOWN(drawnBy(meter), "force-at-limit");
        meter.setForce(60, 6);
        COMPARE_SHOWN(drawnBy(meter), "force-beyond-limit");
        meter.setForce(0, 6);
        COMPARE_SHOWN(drawnBy(meter), "force-none");
    }

    void aLevelWithItsMark() {
        LevelBar bar;
        QCOMPARE(bar.sizeHint(), QSize(120, 28));
        QCOMPARE(bar.minimumSizeHint(), QSize(64, 28));
        bar.resize(102, 28);
        for (const auto& [value, name] : {std::pair(0.5, "level-below"),
                                          {1.0, "level-at"},
                                          {1.5, "level-above"},
                                          {9.0, "level-beyond"}}) {
            bar.setLevel(value, 1, 2, QStringLiteral("ceiling"));
            COMPARE_SHOWN(drawnBy(bar), name);
        }
        bar.setLevel(0.5, 0, 2, QStringLiteral("at the left")); // the word stays inside
        COMPARE_SHOWN(drawnBy(bar), "level-left");
        bar.setLevel(0.5, 2, 2, QStringLiteral("at the right"));
        COMPARE_SHOWN(shownIn(bar) + drawnBy(bar), "level-right");
    }

    void periodsAsBars() {
        PeriodChart chart;
        chart.resize(44 + 12 * 20, 123);
        COMPARE_SHOWN(shownIn(chart) + drawnBy(chart), "periods-none");
        PeriodHistogram periods;
        periods.count = {90000, 9000, 900, 90, 9, 0, 0, 0, 0, 1, 0, 0};
        chart.setPeriods(periods, 1000);
        COMPARE_SHOWN(drawnBy(chart), "periods");
        chart.setToolTip(QStringLiteral("meaning"));
        // Each bar is 20 pixels wide, from 40 on.
        QCOMPARE(tipAt(chart, {41, 50}),
                 QString::fromUtf8("<p>0 to 2 \u00b5s: 90000 ticks, 90 %<br>meaning</p>"));
        QCOMPARE(tipAt(chart, {61, 50}),
                 QString::fromUtf8("<p>2 to 5 \u00b5s: 9000 ticks, 9.0 %<br>meaning</p>"));
        QCOMPARE(tipAt(chart, {121, 50}),
                 QString::fromUtf8("<p>20 to 50 \u00b5s: 9 ticks, 0.009 %<br>meaning</p>"));
        QCOMPARE(tipAt(chart, {279, 50}),
                 QString::fromUtf8("<p>more than 5000 \u00b5s: 0 ticks, 0.000 %<br>meaning</p>"));
        QCOMPARE(tipAt(chart, {39, 50}), QString::fromUtf8("<p>meaning</p>"));
        QCOMPARE(tipAt(chart, {281, 50}), QString::fromUtf8("<p>meaning</p>"));
        periods.count = {};
        periods.count[11] = 5;
        chart.setPeriods(periods, 500); // all late; the mark moves
        COMPARE_SHOWN(drawnBy(chart), "periods-late");
    }

    void theHandleInItsWorkspace() {
        WorkspacePicture picture;
        picture.resize(240, 128);
        QCOMPARE(picture.sizeHint(), QSize(240, 128));
        QCOMPARE(drawnBy(picture), "\n"); // nothing is known yet
        picture.setHandle({0.02, 0.03, -0.04}, 0.1);
        QCOMPARE(picture.accessibleName(),
                 "Handle at 20, 30, -40 mm in a workspace of 100 mm about the centre");
        COMPARE_SHOWN(shownIn(picture) + drawnBy(picture), "workspace-inside");
        picture.setHandle({0.2, 0, 0.01}, 0.1); // it stays in the picture
        COMPARE_SHOWN(drawnBy(picture), "workspace-outside");
        picture.setHandle({std::numeric_limits<double>::quiet_NaN(), 0, 0}, 0.1);
        COMPARE_SHOWN(drawnBy(picture), "workspace-outside"); // as it was
        picture.setHandle({0.05, 0, 0}, 0);                   // not known: as far as it went
        COMPARE_CONTAINS(picture.accessibleName(), "a workspace of 200 mm");
        WorkspacePicture fresh;
        fresh.setHandle({0, 0.001, 0}, 0);
        COMPARE_CONTAINS(fresh.accessibleName(), "Handle at 0, 1, 0 mm in a workspace of 10 mm");
    }

    void aProfileAlongAStroke() {
        ProfileChart chart;
        chart.resize(104, 136); // an area of 100 by 100
        chart.displayNone(QStringLiteral("stroke it"));
        COMPARE_SHOWN(shownIn(chart) + drawnBy(chart), "profile-hint");
        const double none = std::numeric_limits<double>::quiet_NaN();
        chart.display({TextureTarget::Height, 0.04, {0, 1e-4, none, 2e-4, 5e-5, none, 1e-4}});
        QVERIFY(chart.hint().isEmpty());
        COMPARE_SHOWN(drawnBy(chart), "profile");
        point(chart, {52, 60});
        COMPARE_SHOWN(drawnBy(chart), "profile-cursor");
        point(chart, {-50, 60});
        COMPARE_SHOWN(drawnBy(chart), "profile-cursor-left");
        leave(chart);
        COMPARE_SHOWN(drawnBy(chart), "profile");
        chart.display({TextureTarget::Stiffness, 2, {1.25, 1.25, 1.25}}); // flat: in the middle
        COMPARE_SHOWN(drawnBy(chart), "profile-flat");
        chart.display({TextureTarget::Height, 0.5, {1e-6, 1e-6}});
        COMPARE_SHOWN(drawnBy(chart), "profile-flat-height");
        chart.displayNone(QStringLiteral("stroke it"));
        QVERIFY(!chart.profile().any());
    }

    void twoTouchesOfOneStroke() {
        CompareChart chart;
        chart.resize(160, 148); // an area of 100 by 100
        chart.setHint(QStringLiteral("mark A"));
        COMPARE_SHOWN(shownIn(chart) + drawnBy(chart), "compare-hint");
        chart.show(trace(1.5), trace(3));
        COMPARE_SHOWN(drawnBy(chart), "compare");
        chart.show(trace(0.01), trace(0.05, 0.5)); // the axis ends at 0.1 N at least
        COMPARE_SHOWN(drawnBy(chart), "compare-little");
        chart.show(trace(80), trace(20));
        COMPARE_SHOWN(drawnBy(chart), "compare-much");
        chart.show(trace(1), trace(1, 2, 1)); // of one row there is nothing to see
        COMPARE_SHOWN(drawnBy(chart), "compare-short");
        chart.show(nullptr, trace(1));
        COMPARE_SHOWN(drawnBy(chart), "compare-short");
        QCOMPARE(chart.sizeHint(), QSize(360, 150));
        QCOMPARE(chart.minimumSizeHint(), QSize(160, 80));
    }

    void valuesOfLayersAsText() {
        QCOMPARE(layerValueText(TextureTarget::Height, 1.2e-4), QString::fromUtf8("120 \u00b5m"));
        QCOMPARE(layerValueText(TextureTarget::Height, 1e-5), QString::fromUtf8("10 \u00b5m"));
        QCOMPARE(layerValueText(TextureTarget::Height, -9.94e-6), QString::fromUtf8("-9.9 \u00b5m"));
        QCOMPARE(layerValueText(TextureTarget::Stiffness, 1.349), QString::fromUtf8("\u00d7 1.35"));
        QCOMPARE(layerValueText(TextureTarget::Stiffness, NAN), "-");
    }

    void layersOnFlatGround() {
        FlatSwatch swatch;
        COMPARE_SHOWN(shownIn(swatch) + drawnBy(swatch), "swatch-empty");
        QCOMPARE(swatch.readingAt({10, 10}), "");
        TextureLayer layer;
        layer.name = "Grooves";
        layer.pattern.source = TextureSource::Grooves;
        layer.pattern.mapping = TextureMapping::Planar;
        layer.pattern.size = 0.01;
        layer.strength = 1e-4;
        swatch.display({layer}, TextureTarget::Height, plates(1), 0);
        QVERIFY(waitFor([&] { return !swatch.working() && !swatch.ground().values.empty(); }));
        QCOMPARE(swatch.ground().side, 0.03);
        QCOMPARE(swatch.ground().pixels, 112);
        COMPARE_NEAR(swatch.ground().high, 1e-4, 5e-7, "m");
        COMPARE_NEAR(swatch.ground().low, 0, 5e-7, "m");
        COMPARE_SHOWN(drawnBy(swatch), "swatch");
        QVERIFY(swatch.readingAt({56, 28}).endsWith(QStringLiteral(" at 15.0, 22.5 mm")));
        QVERIFY(!swatch.readingAt({0, 0}).isEmpty());
        for (const QPointF& outside : {QPointF(-1, 5), {5, -1}, {112, 5}, {5, 112}})
            QCOMPARE(swatch.readingAt(outside), "");
        point(swatch, {56, 28});
        const QString reading = layerValueText(TextureTarget::Height, swatch.ground().at(0.5, 0.25));
        COMPARE_CONTAINS(drawnBy(swatch), QStringLiteral("\"%1\"").arg(reading));
        point(swatch, {56, 120}); // on the caption
        COMPARE_SHOWN(drawnBy(swatch), "swatch");
        leave(swatch);
        // The wheel shows less or more ground, as far as the list goes.
        const auto sideAfter = [&](int angle) {
            turn(swatch, angle);
            (void)waitFor([&] { return !swatch.working(); });
            return swatch.ground().side;
        };
        for (const double side : {0.01, 0.003, 0.001, 0.001})
            QCOMPARE(sideAfter(120), side);
        COMPARE_CONTAINS(swatch.readingAt({56, 56}), " at 0.50, 0.50 mm");
        for (const double side : {0.003, 0.01, 0.03, 0.1, 0.3, 0.3})
            QCOMPARE(sideAfter(-120), side);
        COMPARE_CONTAINS(drawnBy(swatch), "\"300 mm\"");
    }

    /// A picture that is under way ends; what was asked for meanwhile comes after it.
    void theNewestGroundComes() {
        FlatSwatch swatch;
        TextureLayer layer;
        layer.pattern.source = TextureSource::Dots;
        for (int i = 1; i <= 5; ++i) {
            layer.strength = 1e-4 * i;
            swatch.display({layer}, TextureTarget::Height, nullptr, 0);
        }
        QVERIFY(waitFor([&] { return !swatch.working() && swatch.ground().high > 4.9e-4; }));
        COMPARE_NEAR(swatch.ground().high, 5e-4, 2e-5, "m"); // some waves are finer than the pixels
        layer.target = TextureTarget::Stiffness;
        layer.strength = 0.5;
        swatch.display({layer}, TextureTarget::Stiffness, nullptr, 0);
        QVERIFY(
            waitFor([&] { return !swatch.working() && swatch.ground().target == TextureTarget::Stiffness; }));
        COMPARE_NEAR(swatch.ground().high, 1.5, 0.05, "");
    }

    void aColourAsASquare() {
        const QImage picture = swatch({1, 0.5f, 0}).toImage();
        QCOMPARE(picture.size(), QSize(16, 16));
        QCOMPARE(picture.pixelColor(0, 0).alpha(), 0);
        QCOMPARE(picture.pixelColor(8, 8), QColor(255, int(std::lround(255 * std::pow(0.5, 1 / 2.2))), 0));
        QCOMPARE(picture.pixelColor(2, 8).alpha(), 0);
        QCOMPARE(picture.pixelColor(13, 8).alpha(), 0);
        QCOMPARE(picture.pixelColor(12, 8).alpha(), 255);
    }

    void axesOfStrips_data() {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<int>("most");
        QTest::addColumn<QList<double>>("axis"); // low, high, step
        const auto row = [](double low, double high, int most, const QList<double>& axis) {
            QTest::addRow("%g to %g in %d", low, high, most) << low << high << most << axis;
        };
        row(0, 1, 5, {0, 1.06, 0.5});
        row(0, 0, 5, {0, 1.06, 0.5});
        row(2, 3, 5, {0, 3.18, 1});
        row(-1, 3, 5, {-1, 3.24, 1});
        row(-0.3, 0, 1, {-0.5, 0.5, 0.5});
        row(0, 9, 5, {0, 9.54, 2});
        row(0, 45, 5, {0, 47.7, 10});
        row(-5, -2, 5, {-6, 2, 2});
    }

    void axesOfStrips() {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(int, most);
        QFETCH(QList<double>, axis);
        const StripAxis made = axisFor(low, high, most);
        COMPARE_NEAR(made.low, axis[0], 1e-9, "");
        COMPARE_NEAR(made.high, axis[1], 1e-9, "");
        COMPARE_NEAR(made.step, axis[2], 1e-9, "");
    }

    void placesOfStrips() {
        StripTime time;
        QCOMPARE(stripArea(QRectF(0, 0, 200, 100), time), QRectF(52, 22, 132, 56));
        time.axis = false;
        QCOMPARE(stripArea(QRectF(0, 0, 200, 100), time), QRectF(52, 22, 132, 72));
        QCOMPARE(stripLines(QRectF(0, 0, 10, 5)), 1);
        QCOMPARE(stripLines(QRectF(0, 0, 10, 59)), 2);
        QCOMPARE(stripLines(QRectF(0, 0, 10, 1000)), 5);
    }

    void stripsOfATouch() {
        TouchHistory history;
        const HapticOutput touch = pulledTouch();
        history.add(pulled(0, 2.001, 0.01), {&touch, 2000});
        StripKind force{
            "force",
            "Force",
            "N",
            1,
            2,
            {{"normal", &TouchSample::normal, &Theme::contact, StripLine::Style::Filled},
             {"tangential", &TouchSample::tangential, &Theme::proxy, StripLine::Style::Friction, true},
             {"static", &TouchSample::staticFriction, &Theme::text, StripLine::Style::Limit}}};
        force.hasLimit = true;
        StripChart chart(force, history);
        QCOMPARE(chart.objectName(), "strip-force");
        chart.resize(268, 144); // an area of 200 by 100 with the time below
        StripTime time;
        time.span = 1;
        chart.show(time, 3);
        COMPARE_SHOWN(shownIn(chart) + drawnBy(chart), "strip");
        time.cursor = 1.5;
        time.axis = false;
        chart.show(time, 30); // far above
        COMPARE_SHOWN(drawnBy(chart), "strip-cursor");
        time.cursor = 0.5; // before what is seen
        chart.show(time, 0);
        COMPARE_SHOWN(drawnBy(chart), "strip-no-limit");
        StripKind lag{"lag", "Lag", "mm", 1000, 1, {{"lag", &TouchSample::lag, &Theme::accent}}, 5.0};
        StripChart other(lag, history);
        other.resize(268, 144);
        time.span = 30;
        time.axis = true;
        other.show(time, 3); // the axis reaches 5 although it needs not; no limit belongs to it
        COMPARE_SHOWN(drawnBy(other), "strip-lag");
        QCOMPARE(chart.sizeHint(), QSize(480, 132));
        QCOMPARE(chart.minimumSizeHint(), QSize(240, 60));
    }

    void stripsAreAskedForTimeAndSpan() {
        TouchHistory history;
        const HapticOutput touch = pulledTouch();
        history.add(pulled(0, 2.001, 0.01), {&touch, 2000});
        StripChart chart({"lag", "Lag", "mm", 1000, 1, {{"lag", &TouchSample::lag, &Theme::accent}}},
                         history);
        chart.resize(268, 144);
        StripTime time;
        time.span = 1;
        chart.show(time, 0);
        std::vector<std::optional<double>> told;
        std::vector<double> factors;
        connect(&chart, &StripChart::pointed, &chart, [&](std::optional<double> t) { told.push_back(t); });
        connect(&chart, &StripChart::zoomed, &chart, [&](double factor) { factors.push_back(factor); });
        for (const double x : {51.0, 52.0, 152.0, 252.0, 253.0})
            point(chart, {x, 50});
        QVERIFY(!told[0]);
        COMPARE_NEAR(*told[1], history.end() - 1, 1e-9, "s");
        COMPARE_NEAR(*told[2], history.end() - 0.5, 1e-9, "s");
        COMPARE_NEAR(*told[3], history.end(), 1e-9, "s");
        QVERIFY(!told[4]);
        leave(chart);
        QCOMPARE(told.size(), 6u);
        QVERIFY(!told[5]);
        turn(chart, 120);
        turn(chart, -240);
        COMPARE_NEAR(factors[0], 0.8, 1e-12, "");
        COMPARE_NEAR(factors[1], 1 / 0.64, 1e-12, "");
    }
};

TACTUM_GUI_TEST(TestFigures)

} // namespace test_figures

#include "test_figures.moc"
