// A person without any right who holds a surface on a busy machine: what arrives at the device, tick by tick.
// The machine is made busy by others with the same rights, twice as many as it has processors. What would
// show that this is wrong: a device that is asked by itself, or a load that leaves a processor free. A kernel
// without autogroups schedules any session alike, and cannot tell a device watchdog that has one of its own.
#include <csignal>
#include <cstring>

#include <QTest>

#include "core/runtime/local_engine.h"
#include "core/safety/inhibit_words.h"
#include "tests/core/loop/seen_thread.h"
#include "tests/support/compare.h"
#include "tests/support/guarded_hand.h"
#include "tests/support/hand.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_normal_user {

using namespace tactum;
using namespace tactum::test;

namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLeastForce = 0.2; ///< N: held
constexpr double kSettles = 2;      ///< s, until the hand is there and the force has its strength

struct Held {
    bool started = false;
    char granted[160] = {}; ///< as the window says it
    char fault[160] = {};   ///< empty: none
    std::uint64_t faults = 0;
    double seconds = 0, withForce = 0, worstGap = 0;
};

/// Keeps the time.
class TimedHand final : public GuardedHand {
public:
    using GuardedHand::GuardedHand;
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        const Clock::time_point now = Clock::now();
        if (counts.load(std::memory_order_acquire)) {
            const double gap = std::chrono::duration<double>(now - last_).count();
            seconds += gap;
            if (pushed_) withForce += gap;
            worstGap = std::max(worstGap, gap);
        }
        last_ = now;
        pushed_ = command.force.norm() > kLeastForce;
        return GuardedHand::exchange(command, dt);
    }

    std::atomic<bool> counts{false};
    double seconds = 0, withForce = 0, worstGap = 0; ///< since it counts; to be read after the loops

private:
    Clock::time_point last_;
    bool pushed_ = false;
};

/// As a window does, for so long.
void hold(LocalEngine& engine, double seconds) {
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    while (Clock::now() < end) {
        engine.poll();
        for (TracePoint point; engine.popTrace(point);)
            continue;
        std::this_thread::sleep_for(std::chrono::milliseconds(16));
    }
}

Held heldFor(double seconds) {
    Held held;
    const auto target = std::make_shared<HandTarget>();
    target->write({.position = {0, 0, 0.02}, .teleport = true, .sequence = 1});
    auto timed = std::make_unique<TimedHand>(target);
    TimedHand& device = *timed;
    LocalEngine engine(std::move(timed));
    engine.publish(worldOf(sheet(0.1), Material()));
    held.started = engine.start().has_value();
    engine.setArmed(true);
    hold(engine, 0.5 * kSettles);
    target->write({.position = {0, 0, -0.006}, .sequence = 1, .time = 0.3});
    hold(engine, 0.5 * kSettles);
    device.counts.store(true, std::memory_order_release);
    const std::uint64_t before = engine.servo().faults;
    hold(engine, seconds);
    held.faults = engine.servo().faults - before;
    if (isFault(engine.servo().inhibit))
        std::strncpy(held.fault, inhibitWords(engine.servo().inhibit).brief, sizeof held.fault - 1);
    std::strncpy(held.granted, engine.priorityNote().c_str(), sizeof held.granted - 1);
    engine.stop();
    held.seconds = device.seconds;
    held.withForce = device.withForce;
    held.worstGap = device.worstGap;
    return held;
}

/// Processes that never wait, as long as it is there.
class Load {
public:
    explicit Load(unsigned count) {
        for (unsigned i = 0; i < count; ++i) {
            children_.push_back(fork());
            if (children_.back() != 0) continue;
            if (!dropTo(0, 0)) _exit(1);
            for (volatile unsigned spin = 0;;)
                spin = spin + 1;
        }
    }
    ~Load() {
        for (const pid_t child : children_) {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
    }

private:
    std::vector<pid_t> children_;
};

/// In a session of its own, as a program of the desktop, without any right and with nobody to ask for one.
Held heldWithoutRights(double seconds) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    Held held;
    const pid_t child = fork();
    if (child == 0) {
        setsid();
        setenv("DBUS_SYSTEM_BUS_ADDRESS", kNoBus, 1);
        setenv("DBUS_SESSION_BUS_ADDRESS", kNoBus, 1);
        const Held own = dropTo(0, 0) ? heldFor(seconds) : Held{};
        _exit(::write(ends[1], &own, sizeof own) == sizeof own ? 0 : 1);
    }
    close(ends[1]);
    if (::read(ends[0], &held, sizeof held) != sizeof held) held = {};
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return held;
}

} // namespace

class TestNormalUser : public QObject {
    Q_OBJECT

private slots:
    void aSurfaceIsHeldOnABusyMachine() {
        const Load load(2 * std::thread::hardware_concurrency());
        const Held held = heldWithoutRights(longOnly(60));
        QVERIFY2(held.started, "the loops run without a right");
        qInfo("%.1f s, %.2f %% of it with force, worst gap %.1f ms; %s", held.seconds,
              100 * held.withForce / held.seconds, 1e3 * held.worstGap, held.granted);
        QCOMPARE(QByteArray(held.fault), QByteArray());
        QCOMPARE(held.faults, 0u);
        QCOMPARE_GT(held.withForce, 0.99 * held.seconds);
        QCOMPARE_GT(held.seconds, 1.0);
        QVERIFY2(held.granted[0] != 0, "what was granted is said");
    }
};

TACTUM_TEST(TestNormalUser)

} // namespace test_normal_user

#include "test_normal_user.moc"
