// Whether the device gets force: every reason to take it away, and how it comes back.
#include <cmath>
#include <functional>

#include <QTest>

#include "core/safety/guard.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_guard {

using namespace tactum;

namespace {

constexpr double kMaxForce = 8, kTripSpeed = 1.5;

GuardInput calm() {
    return {.armed = true, .answered = true};
}

/// A guard whose forces are on.
Guard running() {
    Guard guard(kMaxForce, kTripSpeed);
    for (int i = 0; i < 1000; ++i)
        guard(calm());
    return guard;
}

struct Case {
    const char* name;
    Withheld why;
    std::function<void(GuardInput&)> change;
    int ticks = 1; ///< that it takes
};

const std::vector<Case>& faults() {
    static const std::vector<Case> all{
        {"device lost", Withheld::DeviceLost, [](GuardInput& tick) { tick.deviceLost = true; }},
        {"let go", Withheld::TooFast, [](GuardInput& tick) { tick.speed = 1.01 * kTripSpeed; }},
        {"jump", Withheld::ForceJump, [](GuardInput& tick) { tick.sudden = 1.01 * kForceJump * kMaxForce; }},
        {"not finite", Withheld::NotFinite, [](GuardInput& tick) { tick.finite = false; }},
        {"no guardian", Withheld::Unguarded, [](GuardInput& tick) { tick.unguarded = true; }},
        {"late", Withheld::Late, [](GuardInput& tick) { tick.late = true; }, kLateTicks + 1}};
    return all;
}

const std::vector<Case>& pauses() {
    static const std::vector<Case> all{
        {"dead man", Withheld::DeadMan, [](GuardInput& tick) { tick.held = false; }},
        {"stall", Withheld::Stall, [](GuardInput& tick) { tick.dt = 1.01 * kStall; }},
        {"stale", Withheld::Stall, [](GuardInput& tick) { tick.unread = 1.01 * kStall; }},
        {"stop button", Withheld::Stopped, [](GuardInput& tick) { tick.stopped = true; }},
        {"silence", Withheld::ProxySilent, [](GuardInput& tick) { tick.answered = false; }}};
    return all;
}

} // namespace

class TestGuard : public QObject {
    Q_OBJECT

private slots:
    /// A spring that stiffens under load gives energy.
    void underLoadItComesMoreSlowly() {
        for (const double load : {1.0, 5.0, 20.0, 100.0}) {
            Guard guard(kMaxForce, kTripSpeed);
            while (guard.gain() == 0)
                guard(calm());
            GuardInput pressed = calm();
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
        Guard guard(kMaxForce, kTripSpeed);
        QCOMPARE(guard.withheld(), Withheld::NotArmed);
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
        QCOMPARE(guard.withheld(), Withheld::Nothing);
    }

    void strongForceIsWaitedFor() {
        Guard guard(kMaxForce, kTripSpeed);
        GuardInput pressed = calm();
        pressed.wanted = 1.01 * kSmallForce;
        for (int i = 0; i < 1000; ++i)
            QCOMPARE(guard(pressed), 0.0);
        QCOMPARE(guard.withheld(), Withheld::Settling);
    }

    void faultStaysUntilArmedAnew_data() {
        QTest::addColumn<int>("fault");
        for (std::size_t i = 0; i < faults().size(); ++i)
            QTest::newRow(faults()[i].name) << int(i);
    }

    void faultStaysUntilArmedAnew() {
        QFETCH(int, fault);
        const Case& what = faults()[std::size_t(fault)];
        Guard guard = running();
        GuardInput bad = calm();
        what.change(bad);
        for (int i = 1; i < what.ticks; ++i)
            QCOMPARE_GT(guard(bad), 0);
        QCOMPARE(guard(bad), 0.0);
        for (int i = 0; i < 2000; ++i)
            QCOMPARE(guard(calm()), 0.0); // it is over, and still no force
        QCOMPARE(guard.withheld(), what.why);
        QVERIFY(isFault(guard.withheld()));
        QCOMPARE(guard.faults(), 1u);
        GuardInput off = calm();
        off.armed = false;
        guard(off);
        QCOMPARE(guard.withheld(), Withheld::NotArmed);
        for (int i = 0; i < 1000; ++i)
            guard(calm());
        QCOMPARE(guard.gain(), 1.0);
    }

    /// What is just allowed is no fault, and without force there is nothing to take away.
    void nothingElseIsAFault() {
        Guard guard = running();
        GuardInput hard = calm();
        hard.speed = 0.99 * kTripSpeed;
        hard.sudden = 0.99 * kForceJump * kMaxForce;
        for (int i = 0; i < 1000; ++i) {
            hard.late = i % (kLateTicks + 1) != 0;
            QCOMPARE(guard(hard), 1.0);
        }
        Guard off(kMaxForce, kTripSpeed);
        GuardInput fast = calm();
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
        Guard guard = running();
        GuardInput tick = calm();
        what.change(tick);
        QCOMPARE(guard(tick), 0.0);
        QCOMPARE(guard.withheld(), what.why);
        QCOMPARE(guard.faults(), 0u);
        QCOMPARE(guard(calm()), 0.0); // not at once
        QCOMPARE(guard.withheld(), Withheld::Settling);
        for (int i = 0; i < 1000; ++i)
            guard(calm());
        QCOMPARE(guard.gain(), 1.0);
    }

    /// Only where nobody knows which way the finger went.
    void proxyBeginsAtTheFinger() {
        Guard guard = running();
        const std::uint32_t before = guard.anchoring();
        GuardInput tick = calm();
        tick.dt = 0.02;
        guard(tick);
        QCOMPARE(guard.anchoring(), before);
        tick.dt = 1;
        guard(tick);
        QCOMPARE(guard.anchoring(), before + 1);
        tick = calm();
        tick.deviceLost = true;
        guard(tick);
        QCOMPARE(guard.anchoring(), before + 2);
        guard.begin();
        QCOMPARE(guard.anchoring(), before + 3);
        QCOMPARE(guard.gain(), 0.0);
    }
};

TACTUM_TEST(TestGuard)

} // namespace test_guard

#include "test_guard.moc"
