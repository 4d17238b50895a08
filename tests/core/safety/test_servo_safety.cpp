// What a servo tick takes for a fault, what for none, and what it holds back.
#include <cmath>
#include <functional>
#include <vector>

#include <QTest>

#include "tests/core/safety/held_servo.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_servo_safety {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Slowly into a wall of 2000 N/m, until it pushes with so many newtons.
void pressTo(Held& held, double depth, double force) {
    held.model = wall(2000);
    held.rest({0, 0, 0});
    for (double z = 0; z > -depth; z -= 1e-5)
        held.tick({0, 0, z});
    COMPARE_NEAR(held.tick({0, 0, -depth}).z(), force, 1e-9, "N");
}

/// What happens to a servo whose finger is held 1 mm deep in a wall of 2000 N/m, from one tick on.
struct Trouble {
    const char* name;
    InhibitReason why;
    std::function<void(ServoInput&, ServoSettings&, LocalContactModel&)> brings;
    int borne = 0; ///< ticks of it that change nothing
};

const std::vector<Trouble>& troubles() {
    using Input = ServoInput;
    using Settings = ServoSettings;
    using Model = LocalContactModel;
    static const std::vector<Trouble> all{
        {"switched off", InhibitReason::NotArmed, [](Input&, Settings& s, Model&) { s.armed = false; }},
        {"nobody holds the button", InhibitReason::DeadMan,
         [](Input&, Settings& s, Model&) { s.deadMan = 1; }},
        {"the clutch", InhibitReason::Clutched, [](Input& i, Settings&, Model&) { i.clutched = true; }},
        {"the stop button", InhibitReason::Stopped,
         [](Input& i, Settings&, Model&) { i.sample.stopped = true; }},
        {"a tick that took long", InhibitReason::Stall,
         [](Input& i, Settings&, Model&) { i.dt = 1.1 * kStall; }},
        {"nothing new from the device", InhibitReason::Stall,
         [](Input& i, Settings&, Model&) { i.apart = 0; }, int(kStall / kTick) - 1},
        {"nothing from the device", InhibitReason::Stall,
         [](Input& i, Settings&, Model&) { i.sample.valid = false; }, int(kStall / kTick) - 1},
        {"what cannot be true", InhibitReason::DeviceLost,
         [](Input& i, Settings&, Model&) { i.sample.position.x() = std::nan(""); }, kBadSamplesToLoss - 1},
        {"nobody at the guard", InhibitReason::Unguarded,
         [](Input& i, Settings&, Model&) { i.unguarded = true; }},
        {"a model that is none", InhibitReason::ProxySilent,
         [](Input&, Settings&, Model& m) { m.valid = false; }},
        {"a model of another finger", InhibitReason::ProxySilent,
         [](Input&, Settings&, Model& m) { ++m.anchoring; }},
        {"no newer model", InhibitReason::ProxySilent, [](Input& i, Settings&, Model&) { i.fresh = false; },
         int(kModelPatience / kTick) - 1},
        {"faster than a hand", InhibitReason::TooFast,
         [](Input& i, Settings&, Model&) { i.sample.position.z() -= 1.7e-3; }},
    };
    return all;
}

} // namespace

class TestServoSafety : public QObject {
    Q_OBJECT

private slots:
    void aLimitCycleHalvesTheStiffness_data() {
        QTest::addColumn<bool>("knowsBetter");
        QTest::newRow("below the ceiling") << false;
        QTest::newRow("whatever the ceiling is") << true;
    }

    /// A finger that is shaken while it presses: noticed within a tenth of a second, and over the next 50 ms
    /// the surface is half as stiff, and damps half as much, in the force as well.
    void aLimitCycleHalvesTheStiffness() {
        QFETCH(bool, knowsBetter);
        constexpr double kDepth = 3e-3, kStiffness = 600, kDamping = 0.4;
        Held held;
        held.settings.overrideCeiling = knowsBetter;
        held.model = wall(kStiffness);
        held.model.damping = kDamping;
        held.rest({0, 0, 0.01}); // until the forces have come back
        held.go(0.01, -kDepth);
        held.rest({0, 0, -kDepth});
        QCOMPARE(held.state.schedule.scale(), 1.0);
        QCOMPARE(held.state.transition.rendered().damping, kDamping);
        const double before = held.output.force.z();
        COMPARE_NEAR(before, kStiffness * kDepth, 1e-6, "N");

        int shaken = 0;
        for (; shaken < 100 && held.state.schedule.oscillations() == 0; ++shaken)
            held.tick({0, 0, -kDepth + 5e-4 * std::sin(2 * M_PI * 50 * shaken * kTick)});
        QCOMPARE(held.state.schedule.oscillations(), std::uint64_t(1));
        for (int i = 0; i < 51; ++i) { // over 50 ms, not at once
            const double calm = held.state.schedule.scale();
            held.tick({0, 0, -kDepth});
            QCOMPARE_LE(calm - held.state.schedule.scale(), 0.5 * kTick / 0.05 + 1e-12);
        }
        QCOMPARE_LE(held.state.schedule.scale(), 0.5 + 1e-9);
        QVERIFY2(held.output.force.z() <= 0.5 * before + 1e-6,
                 qPrintable(QString::number(held.output.force.z())));
        QCOMPARE_LE(held.state.transition.rendered().damping, 0.5 * kDamping + 1e-9);

        // What the swing has given before it was noticed softens a little more.
        const double softened = held.state.schedule.scale();
        QCOMPARE_GT(softened, 0.48);
        held.rest({0, 0, -kDepth}, 5000); // under load it does not come back
        QCOMPARE(held.state.schedule.scale(), softened);
        held.go(-kDepth, 0.01);
        held.rest({0, 0, 0.01}, 3000); // in free motion it does
        QCOMPARE(held.state.schedule.scale(), 1.0);
    }

    /// However long it is shaken, something is left.
    void aLimitCycleWithoutEndLeavesAThirtySecond() {
        Held held;
        held.model = wall(600);
        held.rest({0, 0, 0.01});
        held.go(0.01, -3e-3);
        for (int i = 0; i < 3000; ++i)
            held.tick({0, 0, -3e-3 + 5e-4 * std::sin(2 * M_PI * 50 * i * kTick)});
        QCOMPARE_GE(held.state.schedule.oscillations(), 10u);
        QCOMPARE(held.state.schedule.scale(), 1.0 / 32);
    }

    /// Under load neither a person who knows better nor a machine that is in time again changes at once what
    /// is felt; who lets go and comes back feels it. Where no force goes out there is nothing to wait for.
    void aHigherCeilingWaitsForTheNextContact() {
        constexpr double kDepth = 3e-3, kStiff = 2000;
        const auto ceilingAt = [](double period) {
            LoopFigures loop = loopFigures(Held::info());
            loop.period = period;
            return safeStiffness(loop).value;
        };
        QCOMPARE_GT(ceilingAt(1e-3), 1.5 * ceilingAt(4e-3));
        for (const bool person : {false, true}) {
            Held held;
            held.settings.overrideCeiling = false;
            held.settings.period = person ? 0 : 4e-3;
            held.model = wall(kStiff);
            held.rest({0, 0, 0.01});
            held.go(0.01, -kDepth);
            held.rest({0, 0, -kDepth});
            const double low = ceilingAt(person ? 1e-3 : 4e-3), high = person ? kStiff : ceilingAt(1e-3);
            QCOMPARE(held.state.schedule.ceiling().value, low);
            QVERIFY(std::abs(held.output.force.z() - low * kDepth) < 1e-6);
            held.settings.period = 0;
            held.settings.overrideCeiling = person;
            Vec3 last = held.output.force;
            for (int i = 0; i < 100; ++i) {
                const Vec3 force = held.tick({0, 0, -kDepth});
                QCOMPARE_LE((force - last).norm(), kEditRate * kTick * 1.01);
                last = force;
            }
            if (person) QVERIFY(std::abs(last.z() - low * kDepth) < 1e-6);
            held.go(-kDepth, 0.01);
            held.go(0.01, -kDepth);
            held.rest({0, 0, -kDepth});
            QVERIFY2(std::abs(held.output.force.z() - high * kDepth) < 1e-6,
                     qPrintable(QString("%1 N instead of %2").arg(held.output.force.z()).arg(high * kDepth)));
        }
        Held off;
        off.settings.armed = off.settings.overrideCeiling = false;
        off.model = wall(kStiff);
        off.rest({0, 0, -kDepth}, 100);
        off.settings.overrideCeiling = true;
        off.tick({0, 0, -kDepth});
        QVERIFY(off.state.schedule.overriding());
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
        QCOMPARE_LE(std::abs(held.output.force.z() - info.continuousForce), 0.01 * info.continuousForce);
        QCOMPARE_LE(highest, 1.01);
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// A driver that hangs says the same again and again: the finger may be anywhere by now. It was no fault
    /// when it wakes up; the force comes back as after any pause.
    void aReadingThatRepeatsIsAStall() {
        const Vec3 finger(0, 0, -0.001);
        Held held;
        pressTo(held, 0.001, 2);
        held.repeats = true;
        int pushed = 0; // ticks
        while (pushed < 100 && !held.tick(finger).isZero(0))
            ++pushed;
        QVERIFY2(pushed * kTick <= kStall && (pushed + 1) * kTick >= kStall - 1e-9,
                 qPrintable(QString("%1 ms instead of %2").arg(1e3 * pushed * kTick).arg(1e3 * kStall)));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::Stall);
        held.rest(finger, 200);
        QVERIFY(held.output.force.isZero(0));
        held.repeats = false;
        const double change = largestChange(held, finger, Vec3::Zero());
        QCOMPARE_LE(change, 0.06);
        QVERIFY(std::abs(held.tick(finger).z() - 2) < 1e-6);
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// A driver at a quarter of the servo's pace has nothing new in three ticks of four: the force goes on,
    /// and the finger is as fast as it is.
    void aSlowDriverIsNoStall() {
        constexpr double kSpeed = 0.05;
        constexpr int kPeriod = 4; // ticks
        Held held;
        held.model = wall(400);
        held.rest({0, 0, 0});
        double read = 0, least = 1e9;
        for (int i = 1; i <= 400; ++i) {
            held.repeats = i % kPeriod != 0;
            if (!held.repeats) read = -kSpeed * i * kTick;
            // A new reading was measured a whole period after the one before.
            DeviceSample sample;
            sample.position = {0, 0, read};
            sample.valid = true;
            held.model.anchoring = held.state.gate.anchoring();
            held.output = servoStep(
                held.state, held.settings,
                {.sample = sample, .dt = kTick, .apart = held.repeats ? 0 : kPeriod * kTick, .fresh = true},
                held.model);
            if (i < 40) continue;
            least = std::min(least, held.output.force.z());
            const double speed = -held.output.finger.velocity.z();
            QVERIFY2(std::abs(speed - kSpeed) < 1e-9,
                     qPrintable(QString("tick %1: %2 m/s instead of %3").arg(i).arg(speed).arg(kSpeed)));
        }
        QCOMPARE_GT(least, 0.5);
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::Nothing);
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// Nobody was shaken by a surface while no force went out; and who was put elsewhere did not swing there.
    void whatNoForceShookIsNoLimitCycle() {
        Held off;
        off.settings.armed = false;
        off.model = wall(1000);
        for (int i = 0; i < 1000; ++i)
            off.tick({0, 0, -3e-3 + 5e-4 * std::sin(2 * M_PI * 50 * i * kTick)});
        QCOMPARE(off.state.schedule.oscillations(), 0u);
        QCOMPARE(off.state.schedule.scale(), 1.0);

        Held put;
        put.model = wall(1000);
        put.rest({0, 0, 0.01});
        for (int i = 0; i < 1000; ++i) {
            DeviceSample sample;
            sample.position = {0, 0, 0.01 + 5e-4 * (i / 10 % 2)};
            sample.valid = true;
            sample.jumped = i % 10 == 0;
            put.model.anchoring = put.state.gate.anchoring();
            put.output = servoStep(put.state, put.settings, {.sample = sample, .fresh = true}, put.model);
        }
        QCOMPARE(put.state.schedule.oscillations(), 0u);
        QCOMPARE(put.state.schedule.scale(), 1.0);
    }

    void whatTakesTheForceAway_data() {
        QTest::addColumn<int>("number");
        for (std::size_t i = 0; i < troubles().size(); ++i)
            QTest::addRow("%s", troubles()[i].name) << int(i);
    }

    /// At once, or as soon as it is more than may happen; before that nothing of the force changes. When it
    /// is over, what is a pause gives the force back by itself and slowly, what is a fault waits for the
    /// person.
    void whatTakesTheForceAway() {
        QFETCH(int, number);
        const Trouble& trouble = troubles()[std::size_t(number)];
        constexpr double kForce = 2;
        const Vec3 finger(0, 0, -0.001);
        Held held;
        pressTo(held, 0.001, kForce);
        const std::uint32_t anchoring = held.state.gate.anchoring();
        ServoSettings settings = held.settings;
        const auto tick = [&](bool troubled) {
            ServoInput input;
            input.fresh = true;
            input.sample.position = finger;
            input.sample.valid = true;
            LocalContactModel model = held.model;
            model.anchoring = held.state.gate.anchoring();
            settings = held.settings;
            if (troubled) trouble.brings(input, settings, model);
            return servoStep(held.state, settings, input, model).force;
        };
        for (int i = 0; i < trouble.borne; ++i) {
            const Vec3 force = tick(true);
            QVERIFY2((force - Vec3(0, 0, kForce)).norm() < 1e-9,
                     qPrintable(QString("tick %1: %2 N instead of %3").arg(i).arg(force.z()).arg(kForce)));
        }
        int more = 0; // the sum of many ticks is a rounding more or less than their time
        while (more < 2 && !tick(true).isZero(0))
            ++more;
        QVERIFY2(more < 2, qPrintable(QString("%1 ticks of it and still a force").arg(trouble.borne + more)));
        QVERIFY2(more == 0 || trouble.borne > 8, qPrintable(QString::number(more)));
        QVERIFY2(held.state.gate.inhibit() == trouble.why, qPrintable(QString("reason %1 instead of %2")
                                                                          .arg(int(held.state.gate.inhibit()))
                                                                          .arg(int(trouble.why))));
        for (int i = 0; i < 200; ++i)
            QVERIFY(tick(true).isZero(0));
        QCOMPARE(held.state.gate.faults(), isFault(trouble.why) ? 1u : 0u);
        QCOMPARE(held.state.gate.anchoring() != anchoring, trouble.why == InhibitReason::DeviceLost);

        Vec3 last = Vec3::Zero();
        for (int i = 0; i < 3000; ++i) {
            const Vec3 force = tick(false);
            QCOMPARE_LE((force - last).norm(), 0.06);
            last = force;
        }
        QCOMPARE(held.state.gate.inhibit(), isFault(trouble.why) ? trouble.why : InhibitReason::Nothing);
        const double expected = isFault(trouble.why) ? 0 : kForce;
        QVERIFY2(std::abs(last.z() - expected) < 1e-6,
                 qPrintable(QString("%1 N instead of %2").arg(last.z()).arg(expected)));
    }

    /// Nobody knows how it came there: the proxy begins anew at the finger, and the force from nothing.
    void aFingerThatIsPutElsewhereIsMetAnew() {
        Held held;
        pressTo(held, 0.001, 2);
        const std::uint32_t anchoring = held.state.gate.anchoring();
        const auto tick = [&](const Vec3& finger, bool jumped, bool answers) {
            ServoInput input;
            input.fresh = true;
            input.sample.position = finger;
            input.sample.valid = true;
            input.sample.jumped = jumped;
            LocalContactModel model = held.model;
            model.anchoring = answers ? held.state.gate.anchoring() : anchoring;
            return servoStep(held.state, held.settings, input, model).force;
        };
        const Vec3 there(0.1, 0.2, -0.002);
        QVERIFY(tick(there, true, false).isZero(0));
        QVERIFY(held.state.gate.anchoring() != anchoring);
        for (int i = 0; i < 100; ++i) // as long as the proxy answers for the place before
            QVERIFY(tick(there, false, false).isZero(0));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::ProxySilent);
        Vec3 last = Vec3::Zero();
        for (int i = 0; i < 3000; ++i) {
            const Vec3 force = tick(there, false, true);
            QCOMPARE_LE((force - last).norm(), 0.06);
            last = force;
        }
        QVERIFY2(std::abs(last.z() - 4) < 1e-6, qPrintable(QString("%1 N instead of 4").arg(last.z())));
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// While the force comes back the finger is braked in what it touches, with less and less; the air never
    /// brakes it, and the device's limit is that of what goes out.
    void aForceThatComesBackBrakesOnlyInTouch() {
        constexpr double kSpeed = 0.05, kDepth = 1e-4, kStiff = 1000;
        for (const bool touches : {false, true}) {
            Held held;
            held.model = wall(kStiff);
            int rising = 0;
            for (int i = 0; i < 1000; ++i) {
                const Vec3 force = held.tick({kSpeed * i * kTick, 0, touches ? -kDepth : 0.01});
                const double gain = held.state.gate.gain();
                if (i < 60 || gain == 0) continue; // until the speed is known
                rising += gain < 1;
                // Along the wall it is free: it has no friction.
                COMPARE_NEAR(force.x(), 0, 1e-9, "N");
                QCOMPARE_LE(force.z(), (touches ? gain * kStiff * kDepth : 0) + 1e-6);
            }
            QCOMPARE_GE(rising, 200);
        }
        // Into the wall it is braked, by no more than the bounds of AddedDamping.
        Held into;
        into.model = wall(kStiff);
        into.rest({0, 0, 0}, 30);
        QCOMPARE(into.state.gate.state(), GateState::Rising);
        double braked = 0;
        for (int i = 1; i <= 100; ++i) {
            const Vec3 force = into.tick({0, 0, -kSpeed * i * kTick});
            const double brake = force.z() - into.state.gate.gain() * kStiff * kSpeed * i * kTick;
            COMPARE_NEAR(brake, into.state.damper.added(), 1e-9, "N");
            QCOMPARE_LE(brake, into.state.gate.arrivalDamping() * kSpeed + 0.01);
            braked = std::max(braked, brake);
        }
        QCOMPARE_GT(braked, 0.2);
        // Three times as deep as the device can push: the limit is that of what goes out, not of what is
        // asked.
        Held deep;
        deep.model = wall(kStiff);
        deep.rest({0, 0, 0}, 30);
        QVERIFY(deep.state.gate.gain() > 0);
        for (int i = 0; i <= 200; ++i)
            deep.tick({0, 0, -3e-4 * i});
        int rising = 0;
        for (int i = 0; i < 8000; ++i) {
            const double force = deep.tick({0, 0, -0.06}).z(), gain = deep.state.gate.gain();
            if (i < 50) continue; // until it rests
            rising += gain < 1;
            const double expected = std::min(gain * kStiff * 0.06, Held::info().maxForce);
            QVERIFY2(
                std::abs(force - expected) < 1e-6,
                qPrintable(QString("%1 N instead of %2 at a gain of %3").arg(force).arg(expected).arg(gain)));
        }
        QCOMPARE_GE(rising, 1000);
        QCOMPARE(deep.output.force.z(), Held::info().maxForce);
    }

    void aModelWithoutASpeedIsAFault() {
        Held held;
        held.model = wall(800);
        held.rest({0, 0, -0.001});
        held.model.velocity = Vec3::Constant(std::nan(""));
        const Vec3 force = held.tick({0, 0, -0.001});
        QCOMPARE_EQ(force, Vec3(0, 0, 0));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::NotFinite);
    }

    void deadManSwitch() {
        Held held;
        held.settings.deadMan = 2;
        held.model = wall(1000);
        held.buttons = 2; // stuck since the device came: nobody holds it
        held.rest({0, 0, -0.001});
        QCOMPARE_EQ(held.tick({0, 0, -0.001}), Vec3(0, 0, 0));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::DeadMan);
        held.buttons = 0;
        held.rest({0, 0, -0.001});
        QCOMPARE_EQ(held.tick({0, 0, -0.001}), Vec3(0, 0, 0));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::DeadMan);
        held.buttons = 2;
        held.rest({0, 0, -0.001});
        QCOMPARE_GT(held.tick({0, 0, -0.001}).z(), 0.9);
        held.buttons = 1;
        QCOMPARE_EQ(held.tick({0, 0, -0.001}), Vec3(0, 0, 0));
    }

    /// A button that is held while the cable goes in and out may be stuck by now.
    void aDeviceThatComesBackMustLetItsButtonGo() {
        Held held;
        held.settings.deadMan = 1;
        held.model = wall(1000);
        held.rest({0, 0, -0.001}, 10);
        held.buttons = 1;
        held.rest({0, 0, -0.001});
        QCOMPARE_GT(held.tick({0, 0, -0.001}).z(), 0.9);
        for (int i = 0; i < kBadSamplesToLoss; ++i)
            held.tick(Vec3::Constant(std::nan("")));
        held.settings.armed = false;
        held.rest({0, 0, -0.001}, 10);
        held.settings.armed = true;
        held.rest({0, 0, -0.001});
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::DeadMan);
        held.buttons = 0;
        held.tick({0, 0, -0.001});
        held.buttons = 1;
        held.rest({0, 0, -0.001});
        QCOMPARE_GT(held.tick({0, 0, -0.001}).z(), 0.9);
    }

    /// The servo loop sends nothing but zero after a stall: the force of before it has done no work.
    void whatAStallKeptBackIsNoEnergy() {
        Held held;
        held.model = wall(10000);
        held.rest({0, 0, 0});
        for (int i = 0; i <= 180; ++i)
            held.tick({0, 0, -1e-5 * i});
        QCOMPARE_GT(held.tick({0, 0, -0.0018}).z(), 17);
        held.tick({0, 0, -0.0018}, 0.05);
        held.tick({0, 0, 0.0007});
        QCOMPARE_LE(held.state.passivity.energy(), 0);
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
            QCOMPARE(held.state.gate.faults(), 0u);
            QCOMPARE_GT(held.tick({0, 0, -0.006}).z(), 10);
        }
    }

    /// An anchor that jumps to the other side of the finger, as far as before, and no newer model tells why.
    void aForceThatTurnsAroundIsAFault() {
        Held held;
        pressTo(held, 0.004, 8);
        held.fresh = false;
        held.model.plane[0] = {-Vec3::UnitZ(), 0.008};
        QCOMPARE_EQ(held.tick({0, 0, -0.004}), Vec3(0, 0, 0));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::ForceJump);
    }

    /// The proxy fell off a rim to the other side of the finger: what pushed fades, what is there comes with
    /// 15 mm/s.
    void aProxyThatFellToTheOtherSideIsMetAsARestartIs() {
        Held held;
        pressTo(held, 0.004, 8);
        held.model.plane[0] = {-Vec3::UnitZ(), 0.008};
        const Vec3 at_W(0, 0, -0.004);
        const Vec3 met = held.tick(at_W);
        COMPARE_NEAR(met.z(), 8 - kSurfaceRate * kTick, 1e-6, "N");
        const double change = largestChange(held, at_W, met);
        QCOMPARE_LE(change, kSurfaceRate * kTick * 1.01);
        COMPARE_NEAR(held.tick(at_W).z(), -8, 1e-6, "N");
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// From one pocket into another whose force leads 60 degrees aside: what pushed along it stays.
    void aForceThatTurnsKeepsWhatPushedThatWay() {
        Held held;
        pressTo(held, 0.009, 18);
        const Vec3 at_W(0, 0, -0.009);
        const Vec3 aside(std::sqrt(0.75), 0, 0.5);
        held.model.plane[0] = {aside, 0.009 + aside.dot(at_W)};
        const Vec3 met = held.tick(at_W);
        QVERIFY2((met - 9 * aside).norm() < 1e-6, qPrintable(QString::number(met.norm())));
        largestChange(held, at_W, met);
        COMPARE_NEAR(held.tick(at_W), 18 * aside, 1e-6, "N");
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// A wall that was found late is still on its way back when the proxy falls to the other side of the
    /// finger, where nothing touches: what the wall was off by would press the finger into that.
    void whatIsLeftTakesItsOffsetWithIt() {
        Held held;
        held.model = wall(2000);
        held.model.planes = 0;
        held.rest({0, 0, -0.004});
        held.model.planes = 1;
        for (double z = -0.004; z > -0.012; z -= 1e-3)
            held.tick({0, 0, z});
        QVERIFY(held.state.transition.easing());
        const double before = held.tick({0, 0, -0.012}).z();
        QVERIFY2(before > 12 && before < 20, qPrintable(QString::number(before)));
        held.model.plane[0] = {-Vec3::UnitZ(), 0.01};
        // It goes the way that all goes which is gone, and pushes the finger into nothing.
        double last = before + 1, lowest = 1e9;
        for (int i = 0; i < 200; ++i) {
            const double felt = held.tick({0, 0, -0.012}).z();
            QCOMPARE_LE(felt, last + 1e-9);
            QCOMPARE_LE(last - felt, 2.3); // with what braked the finger on its way in
            last = felt;
            lowest = std::min(lowest, felt);
        }
        QCOMPARE(last, 0.0);
        QCOMPARE(lowest, 0.0);
        QVERIFY(!held.state.transition.easing());
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// Nearly all of a strong push is gone, and the little that is left leads the other way.
    void aSmallForceTheOtherWayComesAfterwards() {
        Held held;
        pressTo(held, 0.009, 18);
        held.model.plane[0] = {-Vec3::UnitZ(), 0.009 + 1e-4};
        Vec3 last = held.tick({0, 0, -0.009});
        COMPARE_NEAR(last.z(), 18 - kSurfaceRate * kTick, 1e-6, "N");
        QCOMPARE_LE(largestChange(held, {0, 0, -0.009}, last), kSurfaceRate * kTick * 1.01);
        COMPARE_NEAR(held.tick({0, 0, -0.009}).z(), -0.2, 1e-6, "N");
        QCOMPARE(held.state.gate.faults(), 0u);
    }

    /// The finger goes in at 0.8 m/s when what it is in begins to brake it.
    void aDampingThatJumpsIsAFault() {
        Held held;
        held.model = wall(200);
        held.rest({0, 0, 0.01});
        double z = 0.01;
        for (; z > -0.01; z -= 0.8 * kTick)
            held.tick({0, 0, z});
        QCOMPARE(held.state.gate.faults(), 0u);
        held.model.damping = 20;
        QCOMPARE_EQ(held.tick({0, 0, z}), Vec3(0, 0, 0));
        QCOMPARE(held.state.gate.inhibit(), InhibitReason::ForceJump);
    }

    /// Off an edge: what pushed is not there any more. A strong push fades, a weak one just ends.
    void aForceThatIsGoneIsNoFault() {
        for (const double depth : {0.009, 0.0025}) {
            Held held;
            pressTo(held, depth, 2000 * depth);
            held.model.planes = 0;
            const Vec3 next = held.tick({0, 0, -depth});
            if (2000 * depth > kMaxTurn * Held::info().maxForce)
                COMPARE_NEAR(next.z(), 2000 * depth - kSurfaceRate * kTick, 1e-6, "N");
            else
                QCOMPARE_EQ(next, Vec3(0, 0, 0));
            for (int i = 0; i < 100; ++i)
                held.tick({0, 0, -depth});
            QCOMPARE_EQ(held.tick({0, 0, -depth}), Vec3(0, 0, 0));
            QCOMPARE(held.state.gate.faults(), 0u);
        }
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
        QCOMPARE(held.state.gate.faults(), 0u);
        QCOMPARE_GT(held.tick({0, 0, -0.006}).z(), 10);
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
        QCOMPARE(held.state.gate.faults(), 0u);
        QCOMPARE_LE(change, kSurfaceRate * kTick * 1.01);
        QCOMPARE_GT(held.tick({0, 0, -0.006}).z(), 17.9);
    }
};

TACTUM_TEST(TestServoSafety)

} // namespace test_servo_safety

#include "test_servo_safety.moc"
