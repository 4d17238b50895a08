// What is said of the stiffness ceiling, of late ticks and of what is left out, and when another ceiling is
// shown.
//
// What would show that a test here is wrong: each reason is brought about by the one figure that it names.
#include <QTest>

#include "core/safety/inhibit_words.h"
#include "core/scene/primitives.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/engine/health_words.h"
#include "ui/engine/steady_ceiling.h"

namespace test_stiffness_words {

using namespace tactum;

class TestStiffnessWords : public QObject {
    Q_OBJECT

private slots:
    void whatLimitsTheStiffnessIsSaid() {
        DeviceInfo device;
        ServoTelemetry servo;
        const CeilingNow promised = ceilingNow(servo, device); // before the first tick
        QCOMPARE_GT(promised.value, 0);
        COMPARE_CONTAINS(promised.reason, QStringLiteral("damping"));
        servo.ceiling = {0.5 * promised.value, CeilingReason::Damping};
        COMPARE_CONTAINS(ceilingNow(servo, device).reason, QStringLiteral("late"));
        QCOMPARE(ceilingNow(servo, device).value, 0.5 * promised.value);
        servo.stiffnessScale = 0.25;
        COMPARE_CONTAINS(ceilingNow(servo, device).reason, QStringLiteral("oscillation"));
        QCOMPARE(ceilingNow(servo, device).value, 0.125 * promised.value);
        device.maxStiffness = 100;
        servo.stiffnessScale = 1;
        servo.ceiling = {100, CeilingReason::Maker};
        COMPARE_CONTAINS(ceilingNow(servo, device).reason, QStringLiteral("maker"));
        servo.ceiling = {100, CeilingReason::Hand};
        COMPARE_CONTAINS(ceilingNow(servo, device).reason, QStringLiteral("hand bears"));
        servo.doubted = true;
        COMPARE_CONTAINS(ceilingNow(servo, device).reason, QStringLiteral("lighter than chosen"));
        device.maxStiffness = 0;
        device.dryFriction = 1e-6;
        device.positionResolution = 1e-6;
        servo = {};
        COMPARE_CONTAINS(ceilingNow(servo, device).reason, QStringLiteral("resolution"));
    }

    void theCeilingFallsWithTheScale() {
        DeviceInfo device;
        device.damping = 4;
        ServoTelemetry servo;
        const CeilingNow one = ceilingNow(servo, device);
        servo.frame.scale = 4;
        QCOMPARE(ceilingNow(servo, device).value, one.value / 4);
        // What the servo says is of the scene already, and no reason to speak of a late one.
        servo.ceiling = {one.value / 4, CeilingReason::Damping};
        QCOMPARE(ceilingNow(servo, device).value, one.value / 4);
        QCOMPARE(ceilingNow(servo, device).reason, one.reason);
    }

    void theCeilingStandsStillWhereTheMachineJitters() {
        const CeilingNow whole{2000, QStringLiteral("limited by the damping")};
        const auto late = [](double value) {
            return CeilingNow{value, QStringLiteral("limited by a late servo"), true};
        };
        SteadyCeiling steady;
        double time = 0;
        const auto follow = [&](const CeilingNow& now, double seconds) {
            int moves = 0;
            for (int i = 0; i < std::lround(seconds * 60); ++i)
                moves += steady.follow(now, time += 1.0 / 60);
            return moves;
        };
        QCOMPARE(follow(whole, 0.5), 0);
        QCOMPARE(steady.shown().value, 2000.0);
        // Bursts, and what comes back after each.
        for (int burst = 0; burst < 10; ++burst) {
            QCOMPARE(follow(late(700), 0.1) + follow(late(1400), 0.4) + follow(whole, 0.2), 0);
            QCOMPARE(steady.shown().value, 2000.0);
        }
        // What lasts is shown: the most of it, and why.
        QCOMPARE(follow(late(900), 0.5) + follow(late(1000), 0.7), 1);
        QCOMPARE(steady.shown().value, 1000.0);
        COMPARE_CONTAINS(steady.shown().reason, QStringLiteral("late"));
        QCOMPARE(follow(late(1030), 5), 0); // the same, as far as anybody sees
        QCOMPARE(follow(late(1500), 2), 0);
        QCOMPARE(follow(whole, 1.2), 1); // and comes back as far as it lasted
        QCOMPARE(steady.shown().value, 1500.0);
        QCOMPARE(follow(whole, 3.2), 1);
        QCOMPARE(steady.shown().value, 2000.0);
        QVERIFY(!steady.shown().late);
        // What a person does is shown at once, and is no news.
        QCOMPARE(follow({600, QStringLiteral("limited by the damping of the surface")}, 0.02), 0);
        QCOMPARE(steady.shown().value, 600.0);
    }

    // On both sides of five in a hundred, of one second and of three.
    void itMovesWhereItWasSaid() {
        const auto late = [](double value) { return CeilingNow{value, QStringLiteral("late"), true}; };
        const auto movedBy = [&](double value, double seconds) {
            SteadyCeiling steady;
            (void)steady.follow(late(1000), 0);
            bool moved = steady.follow(late(value), 10);
            moved = steady.follow(late(value), 10 + seconds) || moved;
            return moved ? steady.shown().value : 0;
        };
        QCOMPARE_EQ(movedBy(951, 60), 0); // 5 % are not seen
        QCOMPARE_EQ(movedBy(1049, 60), 0);
        QCOMPARE_EQ(movedBy(949, 0.99), 0);
        QCOMPARE_EQ(movedBy(949, 1.01), 949);
        QCOMPARE_EQ(movedBy(1051, 2.99), 0);
        QCOMPARE_EQ(movedBy(1051, 3.01), 1051);
        // From one side to the other it begins anew.
        SteadyCeiling steady;
        (void)steady.follow(late(1000), 0);
        QVERIFY(!steady.follow(late(1200), 1));
        QVERIFY(!steady.follow(late(800), 3.5));
        QVERIFY(!steady.follow(late(800), 4.4));
        QVERIFY(steady.follow(late(800), 4.6));
        steady.forget();
        QCOMPARE_EQ(steady.shown().value, 0);
        QVERIFY(!steady.follow(late(300), 5)); // another device: at once, and no news
        QCOMPARE_EQ(steady.shown().value, 300);
    }

    // What is as stiff, but for another reason, is shown when it has lasted, and is no news.
    void anotherReasonIsNoNews() {
        SteadyCeiling steady;
        (void)steady.follow({1000, QStringLiteral("device")}, 0);
        const CeilingNow late{1001, QStringLiteral("late"), true};
        for (double time = 1; time < 3.9; time += 0.1)
            QVERIFY(!steady.follow(late, time));
        QCOMPARE(steady.shown().reason, QStringLiteral("device"));
        QVERIFY(!steady.follow(late, 4.1));
        QCOMPARE(steady.shown().reason, QStringLiteral("late"));
    }

    void whatTheGuardDidIsThreeSentences() {
        for (const InhibitWords& words : kInhibitWords) {
            const QString said = guardSentences(words.why);
            COMPARE_BEGINS(said, QString::fromUtf8(words.what));
            COMPARE_CONTAINS(said, QString::fromUtf8(words.done));
            COMPARE_CONTAINS(said, QString::fromUtf8(words.remedy));
            QVERIFY2(said.endsWith(u'.') && !said.contains(QStringLiteral("  ")), qPrintable(said));
        }
    }

    void whatIsLeftOutIsNamed() {
        const auto words = [](Fidelity fidelity) { return fidelityWords(fidelity); };
        QCOMPARE(words(Fidelity::Full), QStringLiteral("Nothing is left out."));
        COMPARE_BEGINS(words(Fidelity::NoTexture), QStringLiteral("Textures are left out"));
        COMPARE_BEGINS(words(Fidelity::NoShading), QStringLiteral("Textures and force shading"));
        COMPARE_BEGINS(words(Fidelity::PlaneOnly), QStringLiteral("Only the nearest planes"));
    }

    void lateTicksHaveAnOwner() {
        ServoTelemetry servo;
        servo.misses = 15;
        servo.machineMisses = 12;
        QCOMPARE(lateWords(servo), QStringLiteral("3 of our own, 12 of the machine's"));
        QCOMPARE(lateWords(servo, true), QStringLiteral("15 so far"));
    }

    void theStiffestIsOfWhatIsShown() {
        QCOMPARE_EQ(stiffestOf(Scene()).value, 0);
        Scene scene = sceneOf(Primitive::Box);
        scene.objects[0].surfaces[0].material.stiffness = 700;
        scene.objects[0].surfaces[0].name = "lid";
        scene.objects.push_back(scene.objects[0]);
        scene.objects[1].surfaces[0].material.stiffness = 900;
        scene.objects[1].surfaces[0].name = "ground";
        QCOMPARE_EQ(stiffestOf(scene).value, 900);
        QCOMPARE(stiffestOf(scene).name, QStringLiteral("ground"));
        scene.objects[1].visible = false;
        QCOMPARE_EQ(stiffestOf(scene).value, 700);
        QCOMPARE(stiffestOf(scene).name, QStringLiteral("lid"));
    }
};

TACTUM_TEST(TestStiffnessWords)

} // namespace test_stiffness_words

#include "test_stiffness_words.moc"
