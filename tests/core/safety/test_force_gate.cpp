// Whether the device gets force: every reason to take it away, and how it comes back.
#include <cmath>
#include <functional>

#include <QTest>

#include "core/safety/force_gate.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_force_gate {

using namespace tactum;

namespace {

constexpr double kTripSpeed = 1.5;

GateInput calm() {
    return {.armed = true, .answered = true};
}

/// A guard whose forces are on.
ForceGate running() {
    ForceGate guard(kTripSpeed);
    for (int i = 0; i < 1000; ++i)
        guard(calm());
    return guard;
}

struct Case {
    const char* name;
    InhibitReason why;
    std::function<void(GateInput&)> change;
    int ticks = 1; ///< that it takes
};

const std::vector<Case>& faults() {
    static const std::vector<Case> all{
        {"device lost", InhibitReason::DeviceLost, [](GateInput& tick) { tick.deviceLost = true; }},
        {"let go", InhibitReason::TooFast, [](GateInput& tick) { tick.speed = 1.01 * kTripSpeed; }},
        {"nothing from the device", InhibitReason::DeviceLost,
         [](GateInput& tick) { tick.unread = 1.01 * kLostAfter; }},
        {"not finite", InhibitReason::NotFinite, [](GateInput& tick) { tick.finite = false; }},
        {"no device watchdog", InhibitReason::Unguarded, [](GateInput& tick) { tick.unguarded = true; }}};
    return all;
}

const std::vector<Case>& pauses() {
    static const std::vector<Case> all{
        {"dead man", InhibitReason::DeadMan, [](GateInput& tick) { tick.held = false; }},
        {"stall", InhibitReason::Stall, [](GateInput& tick) { tick.dt = 1.01 * kStall; }},
        {"stale", InhibitReason::Stall, [](GateInput& tick) { tick.unread = 1.01 * kStall; }},
        {"stale for long", InhibitReason::Stall, [](GateInput& tick) { tick.unread = 0.99 * kLostAfter; }},
        {"stop button", InhibitReason::Stopped, [](GateInput& tick) { tick.stopped = true; }},
        {"silence", InhibitReason::ProxySilent, [](GateInput& tick) { tick.answered = false; }}};
    return all;
}

} // namespace

class TestForceGate : public QObject {
    Q_OBJECT

private slots:
    /// A spring that stiffens under load gives energy.
    void underLoadItComesMoreSlowly() {
        for (const double load : {1.0, 5.0, 20.0, 100.0}) {
            ForceGate guard(kTripSpeed);
            while (guard.gain() == 0)
                guard(calm());
            GateInput pressed = calm();
            pressed.wanted = load;
            double seconds = 0;
            while (guard.gain() < 1) {
                const double before = guard.gain();
                QCOMPARE_LE(load * (guard(pressed) - before), kRiseRate * pressed.dt * (1 + 1e-9));
                seconds += pressed.dt;
            }
            COMPARE_NEAR(seconds, std::max(kRise, (1 - kFirstGain) * load / kRiseRate), 2e-3, "s");
        }
    }

    void forceComesGently() {
        ForceGate guard(kTripSpeed);
        QCOMPARE(guard.inhibit(), InhibitReason::NotArmed);
        double last = 0;
        for (int i = 1; i <= 800; ++i) {
            const double gain = guard(calm());
            const double t = 1e-3 * i;
            if (t < kSmallForceTime - 1e-9) QCOMPARE(gain, 0.0);
            if (gain > 0) QCOMPARE_LE(gain, kFirstGain + (t - kSmallForceTime) / kRise + 1e-9);
            QCOMPARE_GE(gain, last);
            COMPARE_NEAR(guard.arrivalDamping(),
                         gain > 0 ? kArrivalDamping * (1 - gain) / (1 - kFirstGain) : 0, 1e-12, "N s/m");
            last = gain;
        }
        QCOMPARE(last, 1.0);
        QCOMPARE(guard.inhibit(), InhibitReason::Nothing);
    }

    void strongForceIsWaitedFor() {
        ForceGate guard(kTripSpeed);
        GateInput pressed = calm();
        pressed.wanted = 1.01 * kSmallForce;
        for (int i = 0; i < 1000; ++i)
            QCOMPARE(guard(pressed), 0.0);
        QCOMPARE(guard.inhibit(), InhibitReason::Settling);
    }

    void faultStaysUntilArmedAnew_data() {
        QTest::addColumn<int>("fault");
        for (std::size_t i = 0; i < faults().size(); ++i)
            QTest::newRow(faults()[i].name) << int(i);
    }

    void faultStaysUntilArmedAnew() {
        QFETCH(int, fault);
        const Case& what = faults()[std::size_t(fault)];
        ForceGate guard = running();
        GateInput bad = calm();
        what.change(bad);
        for (int i = 1; i < what.ticks; ++i)
            QCOMPARE_GT(guard(bad), 0);
        QCOMPARE(guard(bad), 0.0);
        for (int i = 0; i < 2000; ++i)
            QCOMPARE(guard(calm()), 0.0); // it is over, and still no force
        QCOMPARE(guard.inhibit(), what.why);
        QVERIFY(isFault(guard.inhibit()));
        QCOMPARE(guard.faults(), 1u);
        GateInput off = calm();
        off.armed = false;
        guard(off);
        QCOMPARE(guard.inhibit(), InhibitReason::NotArmed);
        for (int i = 0; i < 1000; ++i)
            guard(calm());
        QCOMPARE(guard.gain(), 1.0);
    }

    /// Nobody answers for it any more: it goes over 0.3 s, and comes back from where it is.
    void itFadesWhereThatIsAskedFor() {
        ForceGate guard = running();
        GateInput fading = calm();
        fading.armed = false;
        fading.fading = true;
        double last = 1;
        for (int i = 1; i < int(1e3 * kFadeAway); ++i) {
            COMPARE_NEAR(guard(fading), 1 - 1e-3 * i / kFadeAway, 1e-9, "");
            QCOMPARE_LT(guard.gain(), last);
            QCOMPARE(guard.inhibit(), InhibitReason::NotArmed);
            last = guard.gain();
        }
        for (int i = 0; i < 3; ++i)
            guard(fading);
        QCOMPARE_EQ(guard.gain(), 0);
        QCOMPARE_EQ(int(guard.state()), int(GateState::Off));

        ForceGate again = running();
        for (int i = 0; i < 100; ++i)
            again(fading);
        const double left = again.gain();
        QCOMPARE_GT(again(calm()), left);
        QCOMPARE_LT(again.gain(), left + 0.01);

        ForceGate stopped = running();
        stopped(fading);
        GateInput off = calm();
        off.armed = false;
        QCOMPARE_EQ(stopped(off), 0); // who stops does not wait for it
        for (const Case& pause : pauses()) {
            ForceGate paused = running();
            GateInput both = fading;
            pause.change(both);
            QCOMPARE_EQ(paused(both), 0);
            QCOMPARE(paused.inhibit(), pause.why); // that it ended too soon is told
            QCOMPARE_EQ(paused(both), 0);
            QCOMPARE(paused.inhibit(), InhibitReason::NotArmed);
            QCOMPARE_EQ(int(paused.state()), int(GateState::Off));
        }
    }

    /// What is just allowed is no fault, and without force there is nothing to take away.
    void nothingElseIsAFault() {
        ForceGate guard = running();
        GateInput hard = calm();
        hard.speed = 0.99 * kTripSpeed;
        hard.unread = 0.99 * kStall;
        for (int i = 0; i < 1000; ++i)
            QCOMPARE(guard(hard), 1.0);
        ForceGate off(kTripSpeed);
        GateInput fast = calm();
        fast.speed = 10 * kTripSpeed;
        off(fast);
        QCOMPARE(off.faults(), 0u);
    }

    void pauseEndsByItself_data() {
        QTest::addColumn<int>("pause");
        for (std::size_t i = 0; i < pauses().size(); ++i)
            QTest::newRow(pauses()[i].name) << int(i);
    }

    void pauseEndsByItself() {
        QFETCH(int, pause);
        const Case& what = pauses()[std::size_t(pause)];
        ForceGate guard = running();
        GateInput tick = calm();
        what.change(tick);
        QCOMPARE(guard(tick), 0.0);
        QCOMPARE(guard.inhibit(), what.why);
        QCOMPARE(guard.faults(), 0u);
        QCOMPARE(guard(calm()), 0.0); // not at once
        QCOMPARE(guard.inhibit(), InhibitReason::Settling);
        for (int i = 0; i < 1000; ++i)
            guard(calm());
        QCOMPARE(guard.gain(), 1.0);
    }

    /// The states follow each other as the header says, and each has its reason.
    void statesFollowEachOther() {
        ForceGate gate(kTripSpeed);
        QCOMPARE(gate.state(), GateState::Off);
        gate(calm());
        QCOMPARE(gate.state(), GateState::Settling);
        while (gate.gain() == 0)
            gate(calm());
        QCOMPARE(gate.state(), GateState::Rising);
        QCOMPARE(gate.inhibit(), InhibitReason::Rising);
        while (gate.gain() < 1)
            gate(calm());
        QCOMPARE(gate.state(), GateState::On);
        QCOMPARE(gate.inhibit(), InhibitReason::Nothing);
        gate.latch(InhibitReason::ForceJump);
        QCOMPARE(gate.state(), GateState::Latched);
        QCOMPARE(gate.gain(), 0.0);
        QCOMPARE(gate(calm()), 0.0);
        QCOMPARE(gate.inhibit(), InhibitReason::ForceJump);
        GateInput off = calm();
        off.armed = false;
        gate(off);
        QCOMPARE(gate.state(), GateState::Off);
        QCOMPARE(gate.inhibit(), InhibitReason::NotArmed);
    }

    /// Only where nobody knows which way the finger went.
    void proxyBeginsAtTheFinger() {
        ForceGate guard = running();
        const std::uint32_t before = guard.anchoring();
        GateInput tick = calm();
        tick.dt = 0.02;
        guard(tick);
        QCOMPARE(guard.anchoring(), before);
        tick = calm();
        tick.deviceLost = true;
        guard(tick);
        QCOMPARE(guard.anchoring(), before + 1);
        guard.begin();
        QCOMPARE(guard.anchoring(), before + 2);
        QCOMPARE(guard.gain(), 0.0);
    }
};

TACTUM_TEST(TestForceGate)

} // namespace test_force_gate

#include "test_force_gate.moc"
