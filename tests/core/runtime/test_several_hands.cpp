// The engine with several devices whose fingers the test leads: what one hand does, and what that is to the
// others.
#include <QTest>

#include "core/haptics/compile.h"
#include "core/runtime/hands.h"
#include "core/runtime/local_engine.h"
#include "tests/core/runtime/patience.h"
#include "tests/core/runtime/probe_device.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_several_hands {

using namespace tactum;

namespace {

constexpr double kRadius = 1e-3, kDepth = 2e-3, kStiffness = 500, kPush = kStiffness * kDepth;

std::shared_ptr<const World> plateWorld() {
    TriangleSoup soup;
    soup.positions = {{-0.1, -0.1, 0}, {0.1, -0.1, 0}, {0.1, 0.1, 0}, {-0.1, 0.1, 0}};
    soup.triangles = {{0, 1, 2}, {0, 2, 3}};
    soup.surfaceOf = {0, 0};
    Scene scene;
    scene.proxyRadius = kRadius;
    SceneObject object;
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    object.surfaces.resize(1);
    object.surfaces[0].material.stiffness = kStiffness;
    scene.add(object);
    return compile(scene).value();
}

/// Two fingers on a plate, the second at half the rate of the first.
struct TwoOnAPlate {
    TwoOnAPlate() {
        probes[0]->name = "Left", probes[1]->name = "Right";
        probes[1]->rate = 500;
        engine.publish(plateWorld());
    }
    bool start() {
        return engine.start().has_value() &&
               engine.addDevice(std::make_unique<ProbeDevice>(probes[1])).has_value() && eventually([&] {
                   engine.poll();
                   return engine.proxy().updates > 10 && engine.servo().ticks > 10 &&
                          engine.hand(1).servo().ticks > 10;
               });
    }
    /// The hand presses until it feels what it should. Whoever lost the surface on a busy machine comes from
    /// above again, and arms again where that was a fault.
    bool presses(std::size_t hand) {
        bool above = true;
        return eventually([&] {
            engine.poll();
            const double proxy = engine.hand(hand).touch().output.proxy.z();
            if (proxy < 0) above = true;
            if (proxy > 2 * kRadius) above = false;
            probes[hand]->height = above ? 0.01 : kRadius - kDepth;
            if (above && engine.hand(hand).servo().finger.z() > 2 * kRadius) engine.hand(hand).restartProxy();
            if (engine.hand(hand).servo().inhibit == InhibitReason::NotArmed)
                engine.hand(hand).setArmed(true);
            return !above && std::abs(probes[hand]->push - kPush) < 1e-5 * kPush;
        });
    }

    std::array<std::shared_ptr<Probe>, 2> probes{std::make_shared<Probe>(), std::make_shared<Probe>()};
    LocalEngine engine{std::make_unique<ProbeDevice>(probes[0])};
};

} // namespace

class TestSeveralHands : public QObject {
    Q_OBJECT

private slots:
    void eachFeelsWhatItTouches() {
        TwoOnAPlate two;
        QVERIFY(two.start());
        QCOMPARE(two.engine.hands(), std::size_t(2));
        QCOMPARE(two.engine.hand(1).device().name, std::string("Right"));
        QVERIFY(two.presses(0));
        QVERIFY(!two.engine.hand(1).armed());
        QCOMPARE(two.probes[1]->push.load(), 0.0);
        QCOMPARE(two.engine.hand(1).touch().output.contacts, 0);
        QVERIFY(two.presses(1));
        QCOMPARE(two.engine.hand(1).touch().output.contacts, 1);
        TracePoint point;
        QVERIFY(two.engine.hand(1).popTrace(point));
        two.engine.setAllArmed(false);
        QVERIFY(eventually([&] { return two.probes[0]->push == 0 && two.probes[1]->push == 0; }));
    }

    /// As an Engine it is about the one that was chosen, with what all share.
    void anEngineSpeaksOfTheChosenOne() {
        TwoOnAPlate two;
        Hands hands(two.engine);
        QVERIFY(two.start());
        QVERIFY(two.presses(1));
        QCOMPARE(two.engine.proxy().output.contacts, 0);
        hands.choose(1);
        QCOMPARE(two.engine.device().name, std::string("Right"));
        QCOMPARE(two.engine.proxy().output.contacts, 1);
        QVERIFY(two.engine.armed());
        const std::uint64_t updates = two.engine.proxy().updates;
        QVERIFY(eventually([&] { return two.engine.poll(), two.engine.proxy().updates > updates; }));
        QCOMPARE(two.engine.proxy().output.contacts, 1);
        QVERIFY(hands.anyArmed());
        QVERIFY(!hands.armed(0));
        VERIFY_RESULT(hands.remove(0));
        QCOMPARE(hands.chosen(), std::size_t(0));
        QCOMPARE(two.engine.device().name, std::string("Right"));
    }

    void aFaultOfOneIsItsOwn() {
        TwoOnAPlate two;
        QVERIFY(two.start());
        QVERIFY(two.presses(1));
        QVERIFY(two.presses(0));
        two.probes[1]->nonsense = true;
        QVERIFY(eventually([&] {
            two.engine.poll();
            return two.engine.hand(1).servo().faults > 0;
        }));
        QVERIFY(eventually([&] { return two.probes[1]->push == 0; }));
        QVERIFY(two.presses(0)); // still, and not only until the next step
        QCOMPARE(two.engine.servo().inhibit, InhibitReason::Nothing);
    }

    /// The first or the second: nothing stands on which it is.
    void whoIsSilentHoldsUpNobody_data() {
        QTest::addColumn<int>("silent");
        QTest::newRow("the first") << 0;
        QTest::newRow("the second") << 1;
    }
    void whoIsSilentHoldsUpNobody() {
        QFETCH(int, silent);
        const std::size_t other = 1 - std::size_t(silent);
        TwoOnAPlate two;
        QVERIFY(two.start());
        auto hand = two.engine.hand(std::size_t(silent));
        const auto isInhibitedBy = [&](InhibitReason why) {
            return eventually([&] { return two.engine.poll(), hand.servo().inhibit == why; });
        };
        hand.setArmed(true);
        two.probes[std::size_t(silent)]->valid = false;
        QVERIFY(isInhibitedBy(InhibitReason::DeviceLost));
        QVERIFY(two.presses(other));
        two.probes[std::size_t(silent)]->valid = true;
        hand.setArmed(false);
        QVERIFY(isInhibitedBy(InhibitReason::NotArmed));
        QVERIFY(two.presses(std::size_t(silent)));
    }

    void devicesComeAndGo() {
        TwoOnAPlate two;
        QVERIFY(two.start());
        QVERIFY(two.presses(0));
        const auto third = std::make_shared<Probe>();
        third->name = "Third";
        VERIFY_RESULT(two.engine.exchangeDevice(1, std::make_unique<ProbeDevice>(third)));
        QVERIFY(!two.probes[1]->isOpen);
        QVERIFY(!two.engine.armed());
        QCOMPARE(two.engine.hand(1).device().name, std::string("Third"));
        VERIFY_RESULT(two.engine.removeDevice(0));
        QVERIFY(!two.probes[0]->isOpen);
        QVERIFY(third->isOpen);
        QVERIFY(two.engine.running());
        QCOMPARE(two.engine.hands(), std::size_t(1));
        QCOMPARE(two.engine.device().name, std::string("Third"));
        two.probes[1] = two.probes[0] = third;
        QVERIFY(two.presses(0));
        const auto last = two.engine.removeDevice(0);
        QVERIFY(!last);
        COMPARE_CONTAINS(last.error().text, "cannot be removed");
        QVERIFY(two.engine.running());
    }

    void moreThanThereCanBeAreRefused() {
        LocalEngine engine(std::make_unique<ProbeDevice>(std::make_shared<Probe>()));
        VERIFY_RESULT(engine.start());
        for (int i = 1; i < kMaxHands; ++i)
            VERIFY_RESULT(engine.addDevice(std::make_unique<ProbeDevice>(std::make_shared<Probe>())));
        const auto refused = engine.addDevice(std::make_unique<ProbeDevice>(std::make_shared<Probe>()));
        QVERIFY(!refused);
        COMPARE_CONTAINS(refused.error().text, "remove a device first");
        QVERIFY(engine.running());
    }

    void whatCannotBeOpenedLeavesTheOtherClosed() {
        TwoOnAPlate two;
        QVERIFY(two.start());
        const auto unplugged = std::make_shared<Probe>();
        unplugged->refusesToOpen = true;
        const auto added = two.engine.addDevice(std::make_unique<ProbeDevice>(unplugged));
        QVERIFY(!added);
        QVERIFY(!two.engine.running());
        QVERIFY(!two.probes[0]->isOpen && !two.probes[1]->isOpen);
        VERIFY_RESULT(two.engine.removeDevice(2));
        VERIFY_RESULT(two.engine.start());
    }

    /// The one that does not come back is given up; the other goes on with the next start.
    void aStuckDeviceIsGivenUpAlone() {
        TwoOnAPlate two;
        QVERIFY(two.start());
        two.probes[1]->hangs = true;
        QVERIFY(eventually([&] { return two.probes[1]->hanging.load(); }));
        const auto stopped = two.engine.stop();
        QVERIFY(!stopped);
        COMPARE_CONTAINS(stopped.error().text, "Right did not come back");
        QVERIFY(two.probes[1]->stopped);
        QVERIFY(!two.probes[0]->stopped);
        VERIFY_RESULT(two.engine.removeDevice(1));
        VERIFY_RESULT(two.engine.start());
        QVERIFY(two.presses(0));
        two.probes[1]->hangs = false;
        QVERIFY(eventually([&] { return !two.probes[1]->hanging; }));
    }
};

TACTUM_TEST(TestSeveralHands)

} // namespace test_several_hands

#include "test_several_hands.moc"
