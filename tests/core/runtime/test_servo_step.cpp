// One servo tick: whatever comes in, the force is finite and within the limit; changes in contact are eased.
#include <cmath>
#include <limits>
#include <random>

#include <QtTest>

#include "core/runtime/servo_step.h"

using namespace tactum;

namespace {

constexpr double kTick = 1e-3;

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

/// The half-space below z = 0, with a proxy that is on it.
LocalContactModel wall(double stiffness, double friction = 0) {
    LocalContactModel model;
    model.planes = 1;
    model.plane[0] = {Vec3::UnitZ(), 0};
    model.friction[0].coefficient = friction;
    model.stiffness = stiffness;
    model.valid = true;
    return model;
}

/// A servo whose finger stays where the test puts it.
struct Held {
    Held() : state(info()) { settings.armed = settings.overrideCeiling = true; }
    static DeviceInfo info() {
        DeviceInfo info;
        info.maxForce = 20;
        return info;
    }
    Vec3 tick(const Vec3& finger, double dt = kTick) {
        DeviceSample sample;
        sample.position = finger;
        sample.valid = true;
        sample.buttons = buttons;
        model.anchoring = state.guard.anchoring();
        output = servoStep(state, settings,
                           {.sample = sample, .frame = frame, .dt = dt, .fresh = true, .clutched = clutched},
                           model);
        return output.force;
    }
    void rest(const Vec3& finger, int ticks = 1000) {
        for (int i = 0; i < ticks; ++i)
            tick(finger);
    }
    /// As slowly as a hand does.
    void go(double from, double to) {
        for (int i = 0; i <= 200; ++i)
            tick({0, 0, from + (to - from) * i / 200});
    }

    ServoState state;
    ServoSettings settings;
    LocalContactModel model;
    std::uint32_t buttons = 0;
    DeviceFrame frame;
    bool clutched = false;
    ServoOutput output;
};

/// Largest change from tick to tick until nothing changes any more.
double largestChange(Held& held, const Vec3& finger, const Vec3& before) {
    double largest = 0;
    Vec3 last = before;
    for (int i = 0; i < 6000; ++i) {
        const Vec3 force = held.tick(finger);
        largest = std::max(largest, (force - last).norm());
        last = force;
    }
    return largest;
}

int times(int ordinary) {
    return qEnvironmentVariableIsSet("TACTUM_SEEDS") ? 1000 * qEnvironmentVariableIntValue("TACTUM_SEEDS")
                                                     : ordinary;
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
        QVERIFY(held.state.guard.gain() == 1);
        for (int i = 0; i < 100; ++i) {
            held.tick({0, 0, -3e-4 * i});
            QVERIFY2(held.state.ease.rendered().stiffness <= held.state.ceiling.value,
                     qPrintable(QString("tick %1: %2 N/m").arg(i).arg(held.state.ease.rendered().stiffness)));
        }
    }
    /// A finger that is shaken while it presses: noticed within a tenth of a second, and over the next 50 ms
    /// the surface is half as stiff, in the force as well.
    void aLimitCycleHalvesTheStiffness() {
        constexpr double kDepth = 3e-3, kStiffness = 1000;
        Held held;
        held.model = wall(kStiffness);
        held.rest({0, 0, 0.01}); // until the forces have come back
        held.go(0.01, -kDepth);
        held.rest({0, 0, -kDepth});
        QCOMPARE(held.state.calm, 1.0);
        const double before = held.output.force.z();
        QVERIFY(std::abs(before - kStiffness * kDepth) < 1e-6);

        int shaken = 0;
        for (; shaken < 100 && held.state.oscillations == 0; ++shaken)
            held.tick({0, 0, -kDepth + 5e-4 * std::sin(2 * M_PI * 50 * shaken * kTick)});
        QCOMPARE(held.state.oscillations, std::uint64_t(1));
        held.rest({0, 0, -kDepth}, 51);
        QVERIFY2(held.state.calm <= 0.5 + 1e-9, qPrintable(QString::number(held.state.calm)));
        QVERIFY2(held.output.force.z() <= 0.5 * before + 1e-6,
                 qPrintable(QString::number(held.output.force.z())));

        held.rest({0, 0, -kDepth}, 5000); // under load it does not come back
        QCOMPARE(held.state.calm, 0.5);
        held.go(-kDepth, 0.01);
        held.rest({0, 0, 0.01}, 3000); // in free motion it does
        QCOMPARE(held.state.calm, 1.0);
    }

    /// Ten minutes: the motors warm, and the force comes down to what they bear for ever.
    void aPressThatNeverEndsSparesTheMotors() {
        Held held;
        DeviceInfo info = Held::info();
        info.continuousForce = 5;
        held.state = ServoState(info);
        held.model = wall(1000);
        held.rest({0, 0, 0.01});
        held.go(0.01, -0.03);
        QCOMPARE(held.output.force.z(), info.maxForce); // what they bear for a while
        double highest = 0;
        for (int i = 0; i < 600'000; ++i) {
            held.tick({0, 0, -0.03});
            highest = std::max(highest, held.state.heat.heat());
        }
        qInfo("%.3f N, heat up to %.3f", held.output.force.z(), highest);
        QVERIFY(std::abs(held.output.force.z() - info.continuousForce) <= 0.01 * info.continuousForce);
        QVERIFY(highest <= 1.01);
        QCOMPARE(held.state.guard.faults(), 0u);
    }

    void aModelWithoutASpeedIsAFault() {
        Held held;
        held.model = wall(800);
        held.rest({0, 0, -0.001});
        held.model.velocity = Vec3::Constant(std::nan(""));
        const Vec3 force = held.tick({0, 0, -0.001});
        QVERIFY(force.isZero(0));
        QCOMPARE(held.state.guard.withheld(), Withheld::NotFinite);
    }

    /// TACTUM_SEEDS=10000 makes it 10^7.
    void forceIsAlwaysFiniteAndWithinTheLimit() {
        std::mt19937_64 random(8);
        DeviceInfo info;
        info.maxForce = 8;
        info.continuousForce = 2;
        info.positionResolution = 50e-6;
        ServoState state(info);
        ServoSettings settings;
        LocalContactModel model;
        int pushed = 0;
        for (int i = 0, n = times(500'000); i < n; ++i) {
            // Now and then all is well for a while, so that there is something to spoil.
            const bool wild = i % 2000 > 1500 && random() % 4 == 0;
            settings.armed = i % 2000 != 0;
            DeviceSample sample;
            sample.position = wild ? anyVector(random) : Vec3(0, 0, -1e-3);
            sample.velocity = wild ? anyVector(random) : Vec3::Zero();
            sample.jumped = wild && random() % 8 == 0;
            sample.valid = !wild || random() % 4 != 0;
            model = wild ? anyModel(random, state.guard.anchoring()) : wall(800);
            if (!wild) model.anchoring = state.guard.anchoring();
            const double dt = wild && random() % 8 == 0 ? std::abs(anyNumber(random)) : kTick;
            const ServoOutput output = servoStep(
                state, settings,
                {.sample = sample, .dt = dt, .late = random() % 32 == 0, .fresh = random() % 4 != 0}, model);
            if (!output.force.allFinite()) QFAIL(qPrintable(QString("not finite at %1").arg(i)));
            if (output.force.norm() > info.maxForce) QFAIL(qPrintable(QString("too strong at %1").arg(i)));
            pushed += !output.force.isZero(0);
        }
        QVERIFY(pushed > times(500'000) / 10);
        // Nothing of it stays: it works again when all is well.
        Vec3 force = Vec3::Zero();
        for (int i = 0; i < 3000; ++i) {
            settings.armed = i > 10;
            DeviceSample sample;
            sample.position = {0, 0, -1e-3};
            sample.valid = true;
            model = wall(800);
            model.anchoring = state.guard.anchoring();
            force = servoStep(state, settings, {.sample = sample, .dt = kTick, .fresh = true}, model).force;
        }
        QVERIFY2(force.z() > 0.1, qPrintable(QString::number(force.z())));
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
        QVERIFY(std::abs(before.z() - 3) < 1e-6 && std::abs(before.x() + 1) < 1e-6);
        held.model = wall(stiffness, friction);
        held.model.plane[0].normal = Vec3(std::sin(tilt), 0, std::cos(tilt));
        ++held.model.revision;
        const double change = largestChange(held, finger, before);
        QVERIFY2(change <= 0.05, qPrintable(QString::number(change)));
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
        QVERIFY2(change <= 0.06, qPrintable(QString::number(change)));
        QVERIFY(held.tick({0, 0, -0.003}).isZero(0));
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
        QVERIFY(held.state.ease.easing() && held.state.ease.rendered().stiffness > 900);
        held.settings.period = 5e-3;
        for (int i = 0; i < 20; ++i)
            held.tick(finger);
        QVERIFY(held.state.ease.easing());
        QVERIFY2(held.state.ease.rendered().stiffness <= held.state.ceiling.value,
                 qPrintable(QString("%1 N/m of %2")
                                .arg(held.state.ease.rendered().stiffness)
                                .arg(held.state.ceiling.value)));
    }

    void deadManSwitch() {
        Held held;
        held.settings.deadMan = 2;
        held.model = wall(1000);
        held.buttons = 2; // stuck since the device came: nobody holds it
        held.rest({0, 0, -0.001});
        QVERIFY(held.tick({0, 0, -0.001}).isZero(0));
        QCOMPARE(held.state.guard.withheld(), Withheld::DeadMan);
        held.buttons = 0;
        held.rest({0, 0, -0.001});
        QVERIFY(held.tick({0, 0, -0.001}).isZero(0));
        QCOMPARE(held.state.guard.withheld(), Withheld::DeadMan);
        held.buttons = 2;
        held.rest({0, 0, -0.001});
        QVERIFY(held.tick({0, 0, -0.001}).z() > 0.9);
        held.buttons = 1;
        QVERIFY(held.tick({0, 0, -0.001}).isZero(0));
    }

    /// A button that is held while the cable goes in and out may be stuck by now.
    void aDeviceThatComesBackMustLetItsButtonGo() {
        Held held;
        held.settings.deadMan = 1;
        held.model = wall(1000);
        held.rest({0, 0, -0.001}, 10);
        held.buttons = 1;
        held.rest({0, 0, -0.001});
        QVERIFY(held.tick({0, 0, -0.001}).z() > 0.9);
        for (int i = 0; i < kBadSamplesToLoss; ++i)
            held.tick(Vec3::Constant(std::nan("")));
        held.settings.armed = false;
        held.rest({0, 0, -0.001}, 10);
        held.settings.armed = true;
        held.rest({0, 0, -0.001});
        QCOMPARE(held.state.guard.withheld(), Withheld::DeadMan);
        held.buttons = 0;
        held.tick({0, 0, -0.001});
        held.buttons = 1;
        held.rest({0, 0, -0.001});
        QVERIFY(held.tick({0, 0, -0.001}).z() > 0.9);
    }

    /// The servo loop sends nothing but zero after a stall: the force of before it has done no work.
    void whatAStallKeptBackIsNoEnergy() {
        Held held;
        held.model = wall(10000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 180; ++i)
            held.tick({0, 0, -1e-5 * i});
        QVERIFY(held.tick({0, 0, -0.0018}).z() > 17);
        held.tick({0, 0, -0.0018}, 0.05);
        held.tick({0, 0, 0.0007});
        QVERIFY2(held.state.passivity.energy() <= 0,
                 qPrintable(QString::number(held.state.passivity.energy())));
    }

    /// The author's wish is bounded as the stiffness is, unless the person knows better.
    void dampingIsBoundedToo() {
        for (const bool knowsBetter : {false, true}) {
            Held held;
            held.settings.overrideCeiling = knowsBetter;
            held.model = wall(100);
            held.model.damping = 20;
            held.rest({0, 0, -0.001});
            const double most = held.state.ceiling.damping;
            QVERIFY(most > 0.1 && most < 2);
            QCOMPARE(held.state.ease.rendered().damping, knowsBetter ? 20.0 : most);
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
            QVERIFY((there.output.finger.position - there.frame.pointInWorld(finger)).norm() < 1e-15);
            QVERIFY(
                (there.output.finger.velocity - there.frame.wayInWorld(here.output.finger.velocity)).norm() <
                1e-9);
        }
        QVERIFY(strongest > 1);
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
            QVERIFY(held.state.ease.rendered().stiffness <= held.state.ceiling.value);
        }
    }

    void underTheClutchNothingPushes() {
        Held held;
        held.model = wall(1000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 100; ++i)
            held.tick({0, 0, -1e-5 * i});
        QVERIFY(held.tick({0, 0, -0.001}).z() > 0.9);
        held.clutched = true;
        QVERIFY(held.tick({0, 0, -0.001}).isZero(0));
        QCOMPARE(held.state.guard.withheld(), Withheld::Clutched);
        QCOMPARE(held.state.guard.faults(), 0u);
        for (int i = 1; i <= 100; ++i) { // the handle moves, the finger does not
            held.frame.offset.z() -= 1e-4;
            held.tick({0, 0, -0.001 + 1e-4 * i});
            QVERIFY(held.output.finger.velocity.isZero(0));
            QVERIFY((held.output.finger.position - Vec3(0, 0, -0.001)).norm() < 1e-12);
        }
        held.clutched = false;
        Vec3 last = Vec3::Zero();
        for (int i = 0; i < 3000; ++i) {
            const Vec3 force = held.tick({0, 0, 0.009});
            QVERIFY((force - last).norm() < 0.05);
            last = force;
        }
        QVERIFY(last.z() > 0.9);
    }

    /// Sharp edges and hard hits are no fault.
    void hardHitIsNoFault() {
        for (const double speed : {0.3, 1.0, 1.4}) {
            Held held;
            held.model = wall(3000);
            held.model.damping = 20;
            held.rest({0, 0, 0.02});
            for (double z = 0.02; z > -0.006; z -= speed * kTick)
                held.tick({0, 0, z});
            QCOMPARE(held.state.guard.faults(), 0u);
            QVERIFY(held.tick({0, 0, -0.006}).z() > 10);
        }
    }

    /// An anchor that jumps to the other side of the finger: as far as before, the other way.
    void aForceThatTurnsAroundIsAFault() {
        Held held;
        held.model = wall(2000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 400; ++i)
            held.tick({0, 0, -1e-5 * i});
        QVERIFY(std::abs(held.tick({0, 0, -0.004}).z() - 8) < 1e-9);
        held.model.plane[0] = {-Vec3::UnitZ(), 0.008};
        QVERIFY(held.tick({0, 0, -0.004}).isZero(0));
        QCOMPARE(held.state.guard.withheld(), Withheld::ForceJump);
    }

    /// The finger goes in at 0.8 m/s when what it is in begins to brake it.
    void aDampingThatJumpsIsAFault() {
        Held held;
        held.model = wall(200);
        held.rest({0, 0, 0.01});
        double z = 0.01;
        for (; z > -0.01; z -= 0.8 * kTick)
            held.tick({0, 0, z});
        QCOMPARE(held.state.guard.faults(), 0u);
        held.model.damping = 20;
        QVERIFY(held.tick({0, 0, z}).isZero(0));
        QCOMPARE(held.state.guard.withheld(), Withheld::ForceJump);
    }

    /// Off an edge: what pushed is not there any more.
    void aForceThatIsGoneIsNoFault() {
        Held held;
        held.model = wall(2000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 900; ++i)
            held.tick({0, 0, -1e-5 * i});
        QVERIFY(held.tick({0, 0, -0.009}).z() > 17);
        held.model.planes = 0;
        QVERIFY(held.tick({0, 0, -0.009}).isZero(0));
        QCOMPARE(held.state.guard.faults(), 0u);
    }

    /// The proxy finds a surface only once the finger is in it.
    void hitThatIsFoundLateIsNoFault() {
        Held held;
        held.model = wall(3000);
        held.model.damping = 20;
        held.model.planes = 0;
        held.rest({0, 0, 0.0207}); // 0.3 mm deep when it is found
        for (double z = 0.0207; z > -0.006; z -= 1.4 * kTick) {
            held.model.planes = z < 0;
            held.tick({0, 0, z});
        }
        QCOMPARE(held.state.guard.faults(), 0u);
        QVERIFY(held.tick({0, 0, -0.006}).z() > 10);
    }

    /// From a soft surface onto a stiff one, deep in.
    void nextSurfaceIsNoFault() {
        Held held;
        held.model = wall(200);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 600; ++i)
            held.tick({0, 0, -1e-5 * i});
        const Vec3 before = held.tick({0, 0, -0.006});
        held.model.stiffness = 3000;
        const double change = largestChange(held, {0, 0, -0.006}, before);
        QCOMPARE(held.state.guard.faults(), 0u);
        QVERIFY2(change <= kSurfaceRate * kTick * 1.01, qPrintable(QString::number(change)));
        QVERIFY(held.tick({0, 0, -0.006}).z() > 17.9);
    }
};

QTEST_APPLESS_MAIN(TestServoStep)
#include "test_servo_step.moc"
