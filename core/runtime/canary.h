// Tells the machine's delays from our own: a thread that goes before the servo and does nothing.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "core/base/result.h"
#include "core/loop/realtime_thread.h"

namespace tactum {

/// Sleeps and wakes more often than the servo, with a higher priority, on the same processor. When it wakes
/// late too, the kernel, the hypervisor or the firmware had the processor, and no program could have been in
/// time. Without SCHED_FIFO it is an ordinary thread like the servo, and as often late.
/// Thread of start() and stop(): any but real time.
class Canary {
public:
    /// In each period of the servo.
    static constexpr double kBeats = 2;
    /// A beat that is so much later than due is noted, in periods of the servo; some tens of microseconds are
    /// nothing at 1 kHz. Absences come in pieces, and so small ones count too.
    static constexpr double kNoted = 0.1;
    /// Between two pieces nobody but the canary may have run: when a beat was so much later than due and the
    /// next one is noted too, what lies between them counts as well. In periods of the servo.
    static constexpr double kTorn = 0.25;

    Canary() = default;
    ~Canary() { stop(); }
    Canary(const Canary&) = delete;
    Canary& operator=(const Canary&) = delete;

    /// `servoRate` in Hz, > 0.
    Result<void> start(double servoRate);
    void stop();

    /// The servo runs here. Thread: the servo's.
    void follow(int processor) noexcept { processor_.store(processor, std::memory_order_relaxed); }
    /// Whether the machine was away while the servo was late: from when it was `due` until it `woke`, in ns
    /// of CLOCK_MONOTONIC. Of a servo that was `asleep` by then it is enough that the canary was seen late by
    /// kTorn, and by 0.1 ms at least: absences in pieces may be longer than what the canary sees of them. One
    /// that worked on was late because of the machine only if that was away all the while, but for the part
    /// of a beat in which the canary was not due. Thread: real time.
    bool explains(std::int64_t due, std::int64_t woke, bool asleep) const noexcept;

private:
    void sing(double servoRate) noexcept;

    RealtimeThread thread_;
    double period_ = 1e6; ///< ns, of the servo
    std::atomic<bool> stop_{false};
    std::atomic<int> processor_{-1};
    struct Delay {
        std::atomic<std::int64_t> from{0}, until{0}; ///< ns
    };
    std::array<Delay, 16> delays_; ///< the newest ones; delays come in bursts
};

} // namespace tactum
