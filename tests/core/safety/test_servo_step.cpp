// One servo tick: whatever comes in, the force is finite and within the limit; changes in contact are eased.
#include <cmath>
#include <limits>
#include <random>

#include <QTest>

#include "tests/core/safety/held_servo.h"
#include "tests/support/compare.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_servo_step {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Any magnitude, now and then no number at all.
double anyNumber(std::mt19937_64& random) {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr double kSpecial[] = {0.0,          -0.0,  kInfinity, -kInfinity,
                                          std::nan(""), 1e308, -1e308,    5e-324};
    if (random() % 16 == 0) return kSpecial[random() % std::size(kSpecial)];
    const double exponent = std::uniform_real_distribution(-12.0, random() % 64 == 0 ? 308.0 : 1.0)(random);
    return std::pow(10.0, exponent) * (random() % 2 ? 1 : -1);
}

Vec3 anyVector(std::mt19937_64& random) {
    return {anyNumber(random), anyNumber(random), anyNumber(random)};
}

LocalContactModel anyModel(std::mt19937_64& random, std::uint32_t anchoring) {
    LocalContactModel model;
    model.proxy = anyVector(random);
    model.planes = int(random() % (kMaxModelPlanes + 1));
    for (int i = 0; i < model.planes; ++i) {
        model.plane[std::size_t(i)] = {
            random() % 8 ? Vec3(anyVector(random).normalized()) : anyVector(random), anyNumber(random)};
        model.friction[std::size_t(i)] = {anyNumber(random), anyNumber(random)};
    }
    model.stiffness = anyNumber(random);
    model.damping = anyNumber(random);
    model.velocity = anyVector(random);
    model.valid = random() % 8 != 0;
    model.revision = random() % 3;
    model.restarts = std::uint32_t(random() % 3);
    model.anchoring = anchoring;
    return model;
}

} // namespace

class TestServoStep : public QObject {
    Q_OBJECT

private slots:
    /// A tap: the finger comes from free space into a wall that is stiffer than the device bears.
    void aWallIsMetNoStifferThanTheCeiling() {
        Held held;
        held.settings.overrideCeiling = false;
        held.model = wall(10000);
        held.rest({0, 0, 0.01});
        QCOMPARE_EQ(held.state.gate.gain(), 1);
        for (int i = 0; i < 100; ++i) {
            held.tick({0, 0, -3e-4 * i});
            QVERIFY2(held.state.transition.rendered().stiffness <= held.state.schedule.ceiling().value,
                     qPrintable(
                         QString("tick %1: %2 N/m").arg(i).arg(held.state.transition.rendered().stiffness)));
        }
    }

    /// TACTUM_SEEDS=10000 makes it 10^7.
    void forceIsAlwaysFiniteAndWithinTheLimit() {
        const int times = 1000 * repeats("TACTUM_SEEDS", longOnly(500));
        std::mt19937_64 random(8);
        DeviceInfo info;
        info.maxForce = 8;
        info.continuousForce = 2;
        info.positionResolution = 50e-6;
        ServoState state(info);
        ServoSettings settings;
        LocalContactModel model;
        int pushed = 0;
        for (int i = 0; i < times; ++i) {
            // Now and then all is well for a while, so that there is something to spoil.
            const bool wild = i % 2000 > 1500 && random() % 4 == 0;
            settings.armed = i % 2000 != 0;
            DeviceSample sample;
            sample.position = wild ? anyVector(random) : Vec3(0, 0, -1e-3);
            sample.velocity = wild ? anyVector(random) : Vec3::Zero();
            sample.jumped = wild && random() % 8 == 0;
            sample.valid = !wild || random() % 4 != 0;
            model = wild ? anyModel(random, state.gate.anchoring()) : wall(800);
            if (!wild) model.anchoring = state.gate.anchoring();
            const double dt = wild && random() % 8 == 0 ? std::abs(anyNumber(random)) : kTick;
            const ServoOutput output = servoStep(state, settings,
                                                 {.sample = sample,
                                                  .dt = dt,
                                                  .apart = random() % 8 ? dt : 0,
                                                  .late = random() % 32 == 0,
                                                  .fresh = random() % 4 != 0,
                                                  .outside_D = wild ? anyVector(random) : Vec3::Zero()},
                                                 model);
            if (!output.force.allFinite()) QFAIL(qPrintable(QString("not finite at %1").arg(i)));
            if (output.force.norm() > info.maxForce) QFAIL(qPrintable(QString("too strong at %1").arg(i)));
            pushed += !output.force.isZero(0);
        }
        QCOMPARE_GT(pushed, times / 10);
        // Nothing of it stays: it works again when all is well.
        Vec3 force = Vec3::Zero();
        for (int i = 0; i < 3000; ++i) {
            settings.armed = i > 10;
            DeviceSample sample;
            sample.position = {0, 0, -1e-3};
            sample.valid = true;
            model = wall(800);
            model.anchoring = state.gate.anchoring();
            force = servoStep(state, settings, {.sample = sample, .dt = kTick, .fresh = true}, model).force;
        }
        QCOMPARE_GT(force.z(), 0.1);
    }

    /// It comes step by step, is all there, and goes with the force itself.
    void whatOthersAddComesAndGoes() {
        Held held;
        held.model = wall(800); // which is not touched
        held.rest({0, 0, 0.01});
        held.outside = Vec3(1, 0, 2);
        Vec3 last = Vec3::Zero();
        for (int i = 0; i < 100; ++i) {
            const Vec3 force = held.tick({0, 0, 0.01});
            QCOMPARE_LT((force - last).norm(), kOutsideRate * kTick * Held::info().maxForce + 1e-12);
            last = force;
        }
        COMPARE_NEAR(last, held.outside, 1e-12, "N");
        held.settings.armed = false;
        COMPARE_NEAR(held.tick({0, 0, 0.01}), Vec3::Zero().eval(), 1e-300, "N");
        held.settings.armed = true;
        held.outside = Vec3::Zero();
        held.rest({0, 0, 0.01});
        COMPARE_NEAR(held.output.force, Vec3::Zero().eval(), 1e-300, "N");
    }

    /// However much is asked for: the device's limit is that of all together.
    void whatOthersAddIsUnderTheLimit() {
        Held held;
        held.model = wall(800);
        held.rest({0, 0, 0.01});
        held.go(0.01, -0.01); // 8 N
        held.outside = Vec3(0, 0, 1000);
        for (int i = 0; i < 500; ++i)
            QCOMPARE_LT(held.tick({0, 0, -0.01}).norm(), Held::info().maxForce + 1e-9);
        COMPARE_NEAR(held.output.force.z(), Held::info().maxForce, 1e-9, "N");
    }

    /// A hand that is pushed along gets little power from it, and one that goes against it all of the force.
    void whatOthersAddGivesLittlePower() {
        const double speed = 0.2, most = kOutsidePower / speed;
        for (const double way : {1.0, -1.0}) {
            Held held;
            held.model = wall(800); // which is not touched
            held.rest({0, 0, 0.1});
            held.outside = Vec3(0, 0, 2);
            for (int i = 0; i < 500; ++i)
                held.tick({0, 0, 0.1 + way * speed * kTick * i});
            COMPARE_NEAR(held.output.force.z(), way > 0 ? most : 2.0, 0.01, "N");
        }
    }

    /// Whoever was silent, the servo or the device, the finger may have gone around what it touched.
    void afterALongSilenceTheProxyBeginsAtTheFinger() {
        for (const double silence : {0.4, 0.9})
            for (const bool ofTheServo : {true, false}) {
                Held held;
                held.model = wall(800);
                held.rest({0, 0, 0.01});
                const std::uint32_t before = held.state.gate.anchoring();
                held.repeats = !ofTheServo;
                for (int i = 0; !ofTheServo && i * kTick < silence; ++i)
                    held.tick({0, 0, 0.01});
                held.repeats = false;
                held.tick({0, 0, 0.012}, ofTheServo ? silence : kTick);
                QCOMPARE(held.state.gate.anchoring() - before, silence > 0.5 ? 1u : 0u);
                held.rest({0, 0, 0.012});
                QCOMPARE(held.state.gate.anchoring() - before, silence > 0.5 ? 1u : 0u);
            }
    }

    /// Held still first, so that all of it is there, and then let go along it: never more than that power.
    void whatOthersAddThrowsNobody() {
        Held held;
        held.model = wall(800); // which is not touched
        held.rest({0, 0, 0.1});
        held.outside = Vec3(0, 0, 5);
        for (int i = 0; i < 200; ++i)
            held.tick({0, 0, 0.1});
        COMPARE_NEAR(held.output.force.z(), 5.0, 1e-9, "N");
        for (int i = 1; i < 300; ++i) {
            held.tick({0, 0, 0.1 + 0.3 * kTick * i});
            const double speed = held.state.check.believed().velocity.z();
            QCOMPARE_LE(held.output.force.z() * speed, kOutsidePower * 1.001);
        }
    }

    /// For 0.1 s it is what was asked for, after another 0.1 s nothing.
    void whatIsNotAskedForAgainFades() {
        const OutsidePush push{Vec3(0, 0, 2), 1'000'000'000};
        const auto after = [&](double seconds) {
            return wantedOf(push, push.at + std::int64_t(1e9 * seconds)).z();
        };
        COMPARE_NEAR(after(0), 2.0, 1e-12, "N");
        COMPARE_NEAR(after(0.1), 2.0, 1e-6, "N");
        COMPARE_NEAR(after(0.15), 1.0, 1e-6, "N");
        QCOMPARE_EQ(after(0.2), 0.0);
        QCOMPARE_EQ(after(1e6), 0.0);
        QCOMPARE_EQ(wantedOf({}, 1).norm(), 0.0);
        QCOMPARE_EQ(wantedOf({Vec3(0, 0, std::nan("")), 1}, 1).norm(), 0.0);
    }

    void editsAreContinuous_data() {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<double>("friction");
        QTest::addColumn<double>("tilt");
        QTest::newRow("stiffer") << 2500.0 << 0.5 << 0.0;
        QTest::newRow("softer") << 300.0 << 0.5 << 0.0;
        QTest::newRow("without friction") << 1000.0 << 0.0 << 0.0;
        QTest::newRow("tilted by a texture") << 1000.0 << 0.0 << 0.3;
    }

    /// A finger pressed in 3 mm and held aside by friction.
    void editsAreContinuous() {
        QFETCH(double, stiffness);
        QFETCH(double, friction);
        QFETCH(double, tilt);
        const Vec3 finger(0.001, 0, -0.003);
        Held held;
        held.model = wall(1000, 0.5);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 300; ++i)
            held.tick(finger * (i / 300.0));
        const Vec3 before = held.tick(finger);
        COMPARE_NEAR(before.z(), 3, 1e-6, "N");
        COMPARE_NEAR(before.x(), -1, 1e-6, "N");
        held.model = wall(stiffness, friction);
        held.model.plane[0].normal = Vec3(std::sin(tilt), 0, std::cos(tilt));
        ++held.model.revision;
        const double change = largestChange(held, finger, before);
        QCOMPARE_LE(change, 0.05);
        const Vec3 after = held.tick(finger);
        const Vec3 wanted = contactModelForce(held.model, finger, Vec3::Zero());
        QVERIFY2((after - wanted).norm() < 1e-6, qPrintable(QString("%1 %2").arg(after.x()).arg(wanted.x())));
    }

    void sceneThatIsGoneFades() {
        Held held;
        held.model = wall(1000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 300; ++i)
            held.tick({0, 0, -1e-5 * i});
        const Vec3 before = held.tick({0, 0, -0.003});
        held.model.planes = 0;
        ++held.model.restarts;
        const double change = largestChange(held, {0, 0, -0.003}, before);
        QCOMPARE_LE(change, 0.06);
        QCOMPARE_EQ(held.tick({0, 0, -0.003}), Vec3(0, 0, 0));
    }

    /// What is being left is no stiffer than the device bears either, when that becomes less.
    void whatIsBeingLeftKeepsToTheCeiling() {
        const Vec3 finger(0, 0, -0.004);
        Held held;
        held.settings.overrideCeiling = false;
        held.model = wall(5000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 300; ++i)
            held.tick(finger * (i / 300.0));
        held.model.planes = 0;
        ++held.model.restarts;
        held.tick(finger);
        QVERIFY(held.state.transition.easing());
        QCOMPARE_GT(held.state.transition.rendered().stiffness, 900);
        held.settings.period = 5e-3;
        for (int i = 0; i < 20; ++i)
            held.tick(finger);
        QVERIFY(held.state.transition.easing());
        QVERIFY2(held.state.transition.rendered().stiffness <= held.state.schedule.ceiling().value,
                 qPrintable(QString("%1 N/m of %2")
                                .arg(held.state.transition.rendered().stiffness)
                                .arg(held.state.schedule.ceiling().value)));
    }

    /// The author's wish is bounded as the stiffness is, unless the person knows better.
    void dampingIsBoundedToo() {
        for (const bool knowsBetter : {false, true}) {
            Held held;
            held.settings.overrideCeiling = knowsBetter;
            held.model = wall(100);
            held.model.damping = 20;
            held.rest({0, 0, -0.001});
            const double most = held.state.schedule.ceiling().damping;
            QCOMPARE_GT(most, 0.1);
            QCOMPARE_LT(most, 2);
            QCOMPARE(held.state.transition.rendered().damping, knowsBetter ? 20.0 : most);
        }
    }

    /// A scene at another scale, turned and moved is to the hand what a scene of its own measure would be.
    void theHandMeetsTheSceneInItsOwnMeasure() {
        Held there, here;
        there.frame = {4, {3, -1, 2}, {0.5, -1, 2}};
        there.model = wall(200, 0.4);
        there.model.damping = 0.5;
        here.model = wall(800, 0.4);
        here.model.damping = 2;
        here.model.plane[0].normal = there.frame.turnedBack(Vec3::UnitZ());
        here.model.proxy = there.frame.pointInDevice(Vec3::Zero());
        for (Held* held : {&there, &here})
            held->rest(here.model.proxy);
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> step(-1e-5, 1e-5);
        Vec3 finger = here.model.proxy;
        double strongest = 0;
        for (int i = 0; i < 3000; ++i) {
            finger += Vec3(step(random), step(random), step(random)) - 1e-6 * here.model.plane[0].normal;
            const Vec3 one = there.tick(finger), other = here.tick(finger);
            strongest = std::max(strongest, other.norm());
            QVERIFY2((one - other).norm() < 1e-9, qPrintable(QString("tick %1").arg(i)));
            COMPARE_NEAR(there.output.finger.position, there.frame.pointInWorld(finger), 1e-15, "m");
            COMPARE_NEAR(there.output.finger.velocity, there.frame.wayInWorld(here.output.finger.velocity),
                         1e-9, "m/s");
        }
        QCOMPARE_GT(strongest, 1);
    }

    /// The ceiling is the hand's, whatever the scale.
    void theCeilingHoldsInTheHandsMeasure() {
        Held held;
        held.settings.overrideCeiling = false;
        held.frame.scale = 10;
        held.model = wall(3000);
        held.rest({0, 0, 0.01});
        for (int i = 0; i < 100; ++i) {
            held.tick({0, 0, -3e-5 * i});
            QCOMPARE_LE(held.state.transition.rendered().stiffness, held.state.schedule.ceiling().value);
        }
    }

    void underTheClutchNothingPushes() {
        Held held;
        held.model = wall(1000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 100; ++i)
            held.tick({0, 0, -1e-5 * i});
        QCOMPARE_GT(held.tick({0, 0, -0.001}).z(), 0.9);
        held.clutched = true;
        QCOMPARE_EQ(held.tick({0, 0, -0.001}), Vec3(0, 0, 0));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::Clutched);
        QCOMPARE(held.state.gate.faults(), 0u);
        for (int i = 1; i <= 100; ++i) { // the handle moves, the finger does not
            held.frame.offset.z() -= 1e-4;
            held.tick({0, 0, -0.001 + 1e-4 * i});
            QCOMPARE_EQ(held.output.finger.velocity, Vec3(0, 0, 0));
            COMPARE_NEAR(held.output.finger.position, Vec3(0, 0, -0.001), 1e-12, "m");
        }
        held.clutched = false;
        Vec3 last = Vec3::Zero();
        for (int i = 0; i < 3000; ++i) {
            const Vec3 force = held.tick({0, 0, 0.009});
            COMPARE_NEAR(force, last, 0.05, "N");
            last = force;
        }
        QCOMPARE_GT(last.z(), 0.9);
    }
};

TACTUM_TEST(TestServoStep)

} // namespace test_servo_step

#include "test_servo_step.moc"
