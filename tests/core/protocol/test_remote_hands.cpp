// The hands of a server, as a window there uses them: devices of the test, whose pushes say what was felt.
#include <optional>

#include <QTest>

#include "tests/core/protocol/remote_window.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_remote_hands {

using namespace tactum;
using test::kDepth;
using test::Served;
using test::Window;

class TestRemoteHands : public QObject {
    Q_OBJECT

private slots:
    void eachHandIsSeenAndLed();
    void anotherServerMayHaveFewerHands();
};

void TestRemoteHands::eachHandIsSeenAndLed() {
    Served served({}, 2);
    QCOMPARE(served.begin(), std::string());
    Window window(served.target());
    RemoteEngine& engine = window.engine;
    VERIFY_RESULT(engine.start());
    QVERIFY(window.felt());
    QCOMPARE(engine.hands(), std::size_t(2));
    QCOMPARE(engine.told(1).device.name, std::string("Probe 2"));
    QCOMPARE(engine.device().name, std::string("Probe"));
    engine.setAllArmed(true);
    const auto gains = [&](double first, double second) {
        return window.sees(
            [&] { return engine.told(0).servo.gain == first && engine.told(1).servo.gain == second; });
    };
    QVERIFY(gains(1, 1));
    const auto forceOf = [](int hand) { return kStiffness.initial * kDepth * (1 + hand); };
    for (int hand : {0, 1})
        served.setHeight(kProxyRadius.initial - kDepth * (1 + hand), std::size_t(hand));
    QVERIFY(window.sees([&] {
        return std::abs(engine.told(0).servo.force.z() - forceOf(0)) < 1e-3 &&
               std::abs(engine.told(1).servo.force.z() - forceOf(1)) < 1e-3;
    }));
    for (int hand : {0, 1}) {
        COMPARE_NEAR(served.push(std::size_t(hand)), forceOf(hand), 1e-3, "N");
        QCOMPARE_EQ(engine.told(std::size_t(hand)).touch.output.contacts, 1);
        COMPARE_NEAR(engine.told(std::size_t(hand)).touch.output.proxy.z(), kProxyRadius.initial, 1e-9, "m");
    }
    // What it speaks of, plots and status, is of the hand that is chosen.
    engine.speakOf(1);
    QCOMPARE(engine.device().name, std::string("Probe 2"));
    COMPARE_NEAR(engine.servo().force.z(), forceOf(1), 1e-3, "N");
    std::size_t ticks = 0; // since the first of the press: on a busy machine some of before are on their way
    double furthest = 0;
    QVERIFY(window.sees([&] {
        for (TracePoint point; engine.popTrace(point);) {
            const double far = std::abs(point.force.z() - forceOf(1));
            if (ticks > 0 || far < 1e-2) ++ticks, furthest = std::max(furthest, far);
        }
        return ticks > 200;
    }));
    QCOMPARE_LT(furthest, 1e-2);
    // Orders are of one hand, a stop is for all.
    engine.setArmedOf(0, false);
    QVERIFY(window.sees([&] { return served.push(0) == 0; }));
    QVERIFY(!engine.told(0).armed && engine.told(1).armed);
    QVERIFY(served.push(1) > 0);
    engine.setArmedOf(0, true);
    QVERIFY(gains(1, 1));
    engine.setArmed(false);
    QVERIFY(window.sees([&] { return served.push(0) == 0 && served.push(1) == 0; }));
    QVERIFY(!engine.told(0).armed && !engine.told(1).armed);
    Workspace workspace;
    workspace.scale = 2;
    VERIFY_RESULT(engine.setWorkspace(workspace));
    QVERIFY(window.sees([&] { return engine.told(1).servo.frame.scale == 2; }));
    QCOMPARE(engine.told(0).servo.frame.scale, 1.0);
}

void TestRemoteHands::anotherServerMayHaveFewerHands() {
    std::optional<Served> served(std::in_place, ServerSettings{}, 2);
    QCOMPARE(served->begin(), std::string());
    Window window(served->target());
    VERIFY_RESULT(window.engine.start());
    QVERIFY(window.felt());
    window.engine.speakOf(1);
    window.engine.setGraspedOf(1, true);
    ServerSettings settings;
    settings.port = std::uint16_t(served->server->port());
    served.reset();
    QVERIFY(window.sees([&] { return !window.engine.running(); }));
    QCOMPARE(window.engine.hands(), std::size_t(2)); // nothing is known of others yet
    QVERIFY(!window.engine.armed());
    Served next(settings);
    QCOMPARE(next.begin(), std::string());
    QVERIFY(window.sees([&] { return window.engine.running() && window.engine.hands() == 1; }));
    QCOMPARE(window.engine.spokenOf(), std::size_t(0));
    QVERIFY(window.felt());
    QCOMPARE(window.refused, std::string());
}

TACTUM_TEST(TestRemoteHands)

} // namespace test_remote_hands

#include "test_remote_hands.moc"
