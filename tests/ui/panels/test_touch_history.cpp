#include <clocale>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/panels/touch_traces.h"
#include "ui/widgets/strip_chart.h"
#include "ui/widgets/touch_history.h"

namespace test_touch_history {

using namespace tactum;
using namespace tactum::testing;

namespace {

TouchHistory historyOf(const std::vector<TracePoint>& points) {
    TouchHistory history;
    const HapticOutput touch = pulledTouch();
    history.add(points, {&touch, 2000});
    return history;
}

} // namespace

class TestTouchHistory : public QObject {
    Q_OBJECT
private slots:
    void everyTickSaysWhatWasFelt() {
        const TouchHistory history = historyOf(pulled(0, 1.5));
        QCOMPARE(history.samples().size(), std::size_t(1500));
        const TouchSample& s = *history.at(0.8004);
        COMPARE_NEAR(s.t, 0.8, 1e-9, "s");
        COMPARE_NEAR(s.normal, 2, 1e-9, "N");
        COMPARE_NEAR(s.tangential, 0.8, 1e-9, "N");
        COMPARE_NEAR(s.ratio, 0.4, 1e-9, "");
        COMPARE_NEAR(s.magnitude, std::hypot(2, 0.8), 1e-9, "N");
        COMPARE_NEAR(s.lag, 1e-3, 1e-9, "m");
        COMPARE_NEAR(s.energy, -0.8e-3, 1e-9, "J");
        COMPARE_NEAR(s.servoRate, 1000, 1e-6, "Hz");
        QCOMPARE_EQ(s.proxyRate, 2000);
        QCOMPARE_EQ(s.staticFriction, 0.8);
        QCOMPARE_EQ(s.dynamicFriction, 0.5);
        QVERIFY(s.touching);
        QVERIFY(!s.slipping);
        QCOMPARE(history.at(-3), &history.samples().front());
        QCOMPARE(history.at(9), &history.samples().back());
    }

    // What turns has an angle and a torque, what slides a way and a force: none is drawn as the other.
    void jointsAreHeldByTheirKind() {
        for (const bool turns : {true, false}) {
            TouchHistory history;
            TouchFrame frame;
            frame.body.turns = turns, frame.body.slides = !turns;
            frame.body.value = 0.3, frame.body.rate = -2, frame.body.force = 0.7;
            frame.body.kinetic = 5, frame.body.potential = -4;
            history.add(pulled(0, 0.1), frame);
            const TouchSample& s = *history.at(0.05);
            QCOMPARE_EQ(turns ? s.jointAngle : s.jointWay, 0.3);
            QCOMPARE_EQ(turns ? s.jointTurning : s.jointSpeed, -2);
            QCOMPARE_EQ(turns ? s.jointTorque : s.jointForce, 0.7);
            QCOMPARE_EQ(turns ? s.jointWay : s.jointAngle, 0);
            QCOMPARE_EQ(turns ? s.jointSpeed : s.jointTurning, 0);
            QCOMPARE_EQ(turns ? s.jointForce : s.jointTorque, 0);
            QCOMPARE_EQ(s.kinetic, 5);
            QCOMPARE_EQ(s.potential, -4);
        }
    }

    void aProxyThatMovesSlips() {
        std::vector<TracePoint> points = pulled(0, 0.2);
        for (std::size_t i = 100; i < points.size(); ++i)
            points[i].proxy.x() = 1e-5 * double(i - 100); // 10 mm/s
        const TouchHistory history = historyOf(points);
        QVERIFY(!history.at(0.095)->slipping);
        QVERIFY(history.at(0.12)->slipping);
    }

    void freeMotionHasNoFriction() {
        std::vector<TracePoint> points = pulled(0, 0.1);
        for (TracePoint& point : points) {
            point.touching = false;
            point.normalForce = point.tangentialForce = 0;
        }
        const TouchSample s = *historyOf(points).at(0.05);
        QCOMPARE_EQ(s.ratio, 0);
        QCOMPARE_EQ(s.staticFriction, 0);
        QVERIFY(!s.slipping);
    }

    void onlyTheLastHalfMinuteIsKept() {
        TouchHistory history = historyOf(pulled(0, TouchHistory::kSpan + 5, 0.01));
        COMPARE_NEAR(history.samples().front().t, 5, 0.02, "s");
        const HapticOutput touch = pulledTouch();
        history.add(pulled(2, 2.5), {&touch, 0}); // a recording jumped back
        COMPARE_NEAR(history.samples().front().t, 2, 1e-9, "s");
    }

    void csvHoldsEveryTickWithUnitsAndPoints() {
        const char* before = std::setlocale(LC_NUMERIC, nullptr);
        std::setlocale(LC_NUMERIC, "de_DE.UTF-8"); // where there is one
        std::vector<TracePoint> points{pulledAt(0.5), pulledAt(0.75)};
        const std::string csv = csvOf(historyOf(points), 0);
        std::setlocale(LC_NUMERIC, before);
        const std::string expected =
            "time (s),finger x (m),finger y (m),finger z (m),proxy x (m),proxy y (m),proxy z (m),"
            "force x (N),force y (N),force z (N),force (N),normal force (N),tangential force (N),"
            "friction ratio,static friction,dynamic friction,proxy lag (m),energy (J),"
            "servo rate (Hz),proxy rate (Hz),joint angle (rad),joint way (m),joint turning (rad/s),"
            "joint speed (m/s),joint torque (N m),joint force (N),kinetic energy (J),potential energy "
            "(J),touching,slipping\n"
            "0,0,-0.001,0,0,0,0,0.5,2,0,2.0615528128088303,2,0.5,0.25,0.8,0.5,0.001,-5e-04,0,2000,"
            "0,0,0,0,0,0,0,0,1,0\n"
            "0.25,0,-0.001,0,0,0,0,0.75,2,0,2.1360009363293826,2,0.75,0.375,0.8,0.5,0.001,-0.00075,4,2000,"
            "0,0,0,0,0,0,0,0,1,0\n";
        QCOMPARE_EQ(csv, expected);
        QCOMPARE(QString::fromStdString(csvOf(historyOf(points), 0.6)).count('\n'), 2);
    }

    void axesHoldTheirCurvesAndHaveRoundSteps() {
        const StripAxis force = axisFor(0, 3.9, 5);
        COMPARE_NEAR(force.step, 1, 1e-9, "N");
        QCOMPARE_EQ(force.low, 0);
        QCOMPARE_GT(force.high, 3.9);
        QCOMPARE_LT(force.high, 4.5);
        const StripAxis energy = axisFor(-0.7, 0.1, 4);
        QCOMPARE_LE(energy.low, -0.7);
        QCOMPARE_GE(energy.high, 0.1);
        COMPARE_NEAR(energy.step, 0.5, 1e-9, "J");
        QCOMPARE_GT(axisFor(0, 0, 3).high, 0);
    }
};

TACTUM_TEST(TestTouchHistory)

} // namespace test_touch_history

#include "test_touch_history.moc"
