// The degradation controller: on machines that are formulas, and its lower rungs on a real surface.
#include <QTest>

#include "core/haptics/degradation.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_degradation {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kBudget = 0.8e-3;

/// A machine whose steps take a time that depends on the fidelity.
struct Machine {
    std::array<double, 4> took{}; ///< s, by fidelity
    DegradationController ladder{kBudget};
    double now = 0;
    int changes = 0;

    void run(double seconds) {
        for (const double end = now + seconds; now < end; now += 1e-3) {
            const Fidelity before = ladder.fidelity();
            changes += ladder(now, took[std::size_t(before)]) != before;
        }
    }
};

} // namespace

class TestDegradation : public QObject {
    Q_OBJECT

private slots:
    void nothingIsLeftOutWhereThereIsTime() {
        Machine machine{.took = {0.79e-3, 0.7e-3, 0.6e-3, 0.5e-3}};
        machine.run(10);
        QCOMPARE(machine.ladder.fidelity(), Fidelity::Full);
        QCOMPARE(machine.ladder.stepsDown(), 0u);
    }

    void oneSlowStepIsNoReason() {
        Machine machine;
        for (int i = 0; i < 1000; ++i) {
            machine.took.fill(i % 100 == 50 ? 20 * kBudget : 0.1 * kBudget);
            machine.run(1e-3);
        }
        QCOMPARE(machine.ladder.stepsDown(), 0u);
    }

    void goesDownAsFarAsItHasTo_data() {
        QTest::addColumn<double>("plainTakes");
        QTest::addColumn<int>("fidelity");
        QTest::newRow("texture is too much") << 0.1e-3 << int(Fidelity::NoTexture);
        QTest::newRow("shading too") << 0.5e-3 << int(Fidelity::NoShading);
        QTest::newRow("everything is") << 3e-3 << int(Fidelity::PlaneOnly);
    }

    void goesDownAsFarAsItHasTo() {
        QFETCH(double, plainTakes);
        QFETCH(int, fidelity);
        // Each level costs half a millisecond more than the one below.
        Machine machine{.took = {plainTakes + 1.1e-3, plainTakes + 0.5e-3, plainTakes, 0.05e-3}};
        machine.run(0.2);
        QCOMPARE(int(machine.ladder.fidelity()), fidelity);
        QCOMPARE(int(machine.ladder.stepsDown()), fidelity);
    }

    void comesBackByItself() {
        Machine machine{.took = {2e-3, 2e-3, 2e-3, 2e-3}};
        machine.run(0.3);
        QCOMPARE(machine.ladder.fidelity(), kMinFidelity);
        machine.took.fill(0.1e-3);
        machine.run(2.5);
        QCOMPARE(machine.ladder.fidelity(), Fidelity::Full);
    }

    void doesNotFlutter() {
        // Without texture there is half of the time to spare, with it there is none.
        Machine machine{.took = {2e-3, 0.1e-3, 0.1e-3, 0.1e-3}};
        machine.run(120);
        QCOMPARE_LT(machine.changes, 30);
    }

    void aLevelThatJustFitsIsKept() {
        Machine machine{.took = {1e-3, 0.6e-3, 0.1e-3, 0.1e-3}};
        machine.run(16);
        QCOMPARE(machine.changes, 1);
        machine.run(600); // now and then the better one is tried
        QCOMPARE(machine.ladder.fidelity(), Fidelity::NoTexture);
        QCOMPARE_LT(machine.changes, 12);
    }

    void whatAnotherProgramTookComesBack() {
        Machine machine{.took = {0.6e-3, 0.45e-3, 0.45e-3, 0.45e-3}};
        const auto usual = machine.took;
        machine.run(1);
        machine.took.fill(1e-3);
        machine.run(0.2);
        QCOMPARE(machine.ladder.fidelity(), kMinFidelity);
        machine.took = usual;
        machine.run(60);
        QCOMPARE(machine.ladder.fidelity(), Fidelity::Full);
    }

    void whatIsLeftOutIsNotFelt() {
        Scene scene = sceneOf(ball(0.03, 2), frictionless());
        scene.objects[0].surfaces[0].shading.on = true;
        const auto world = compile(scene).value();
        Hand hand(world);
        hand.to({0.008, 0.003, 0.04});
        hand.go({0.006, 0.002, 0.027}, 0.05);
        const auto feltAt = [&](Fidelity fidelity) {
            SimState state = hand.state;
            hapticStep(*world, state, {hand.finger(), Vec3::Zero(), false, fidelity}, kMillisecond);
            return state.proxy.feltCount;
        };
        QCOMPARE_GT(feltAt(Fidelity::Full), 0);
        QCOMPARE_GT(feltAt(Fidelity::NoTexture), 0);
        QCOMPARE(feltAt(Fidelity::NoShading), 0);
        QCOMPARE(feltAt(Fidelity::PlaneOnly), 0);
    }

    void withFewRoundsTheProxyComesAfterAndStaysOutside() {
        // A finger that jumps under rough ground sends the proxy on a long way over many facets.
        const Hand start(worldOf(eggCrate(0.02, 120, 0.001, 0.003), frictionless()));
        const auto roundsAndDrift = [&](Fidelity fidelity) {
            SimState state;
            const auto step = [&](const Vec3& finger) {
                return hapticStep(start.world(), state, {finger, Vec3::Zero(), false, fidelity},
                                  kMillisecond);
            };
            step({-0.0101, 0.0003, 0.004});
            step({-0.0101, 0.0003, -0.004});
            int most = 0;
            HapticOutput output;
            for (int i = 0; i < 200; ++i) {
                output = step({0.0042, 0.0017, -0.004});
                most = std::max(most, output.report.rounds);
            }
            // Of the many places where it may rest this is one: with all rounds it does not go on from there.
            fidelity = Fidelity::Full;
            const Vec3 rested = output.proxy;
            for (int i = 0; i < 100; ++i)
                output = step({0.0042, 0.0017, -0.004});
            return std::pair(most, (output.proxy - rested).norm());
        };
        const auto full = roundsAndDrift(Fidelity::Full), few = roundsAndDrift(Fidelity::PlaneOnly);
        QCOMPARE_GT(full.first, kFewRounds);
        QCOMPARE(few.first, kFewRounds);
        QVERIFY2(full.second < 1e-7 && few.second < 1e-7, "it comes to a place of rest in the end");
    }
};

TACTUM_TEST(TestDegradation)

} // namespace test_degradation

#include "test_degradation.moc"
