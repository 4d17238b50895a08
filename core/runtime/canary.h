// Tells the machine's delays from our own: a thread that goes before the servo and does nothing.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "core/base/result.h"
#include "core/loop/realtime_thread.h"

namespace tactum {

/// Sleeps and wakes at 1 kHz with a higher priority than the loops, on the processor of the servo. When it
/// wakes late too, the kernel, the hypervisor or the firmware had the processor, and no program could have
/// been in time. Without SCHED_FIFO it is an ordinary thread like the servo, and as often late.
/// Thread of start() and stop(): any but real time.
class Canary {
public:
    Canary() = default;
    ~Canary() { stop(); }
    Canary(const Canary&) = delete;
    Canary& operator=(const Canary&) = delete;

    Result<void> start();
    void stop();

    /// The servo runs here. Thread: the servo's.
    void follow(int processor) noexcept { processor_.store(processor, std::memory_order_relaxed); }
    /// Whether it was late at some moment from `begin` to `end`, ns of CLOCK_MONOTONIC.
    /// Thread: real time.
    bool wasLate(std::int64_t begin, std::int64_t end) const noexcept;

private:
    void sing() noexcept;

    RealtimeThread thread_;
    std::atomic<bool> stop_{false};
    std::atomic<int> processor_{-1};
    struct Delay {
        std::atomic<std::int64_t> from{0}, until{0}; ///< ns
    };
    std::array<Delay, 16> delays_; ///< the newest ones; delays come in bursts
};

} // namespace tactum
