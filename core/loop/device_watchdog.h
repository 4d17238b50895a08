// Who takes the force away when nobody else can: the program was killed, crashed or stands still.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <sys/types.h>

#include "core/base/result.h"
#include "core/port/haptic_device.h"

namespace tactum {

/// A servo that has not ticked for so long has the device stopped behind its back. Unit: ms.
inline constexpr int kWatchdogPatience = 10;

/// A device watchdog that has not looked for so long is dead or stopped itself. Unit: s.
inline constexpr double kWatchdogSilence = 0.5;

/// A forked process that stops the device (HapticDevice::emergencyStop) when the program has died, of
/// whatever signal, and when the servo does not tick for kWatchdogPatience: blocked, stopped, or busy with
/// writing the memory of a crash to disk. A signal handler could do no more, and cannot see SIGKILL. Fork
/// first, start the loops after: the child has only the thread that forked. Who kills the device watchdog
/// alone (the kernel does, when memory is short) leaves nobody to do that: so it counts its looks, and the
/// servo watches them. Thread of its members: any but real time, where they do not say otherwise.
class DeviceWatchdog {
public:
    DeviceWatchdog() = default;
    ~DeviceWatchdog() { stop(); }
    DeviceWatchdog(const DeviceWatchdog&) = delete;
    DeviceWatchdog& operator=(const DeviceWatchdog&) = delete;

    /// The device is open; it outlives the device watchdog or stop().
    Result<void> start(HapticDevice& device);
    /// Ends the watch without stopping the device. Safe to call twice.
    void stop();

    /// The servo is alive. Until the first beat, and after rest(), nobody waits for the next one.
    /// Thread: real time.
    void beat() noexcept {
        if (shared_) raise(shared_->beats);
    }
    /// The servo ends its work in order.
    void rest() noexcept {
        if (shared_) shared_->beats.store(0, std::memory_order_relaxed);
    }
    /// How often the child has looked; for ever 0 without one. Thread: real time.
    std::uint64_t looks() const noexcept {
        return shared_ ? shared_->looks.load(std::memory_order_relaxed) : 0;
    }
    /// Whether a device is being guarded. Thread: real time.
    bool guards() const noexcept { return shared_ != nullptr; }

    /// What both processes see.
    struct Shared {
        std::atomic<std::uint64_t> beats{0}; ///< of the servo; 0: nobody waits for the next one
        std::atomic<std::uint64_t> looks{0}; ///< of the child
    };
    /// Of a counter with one writer.
    static void raise(std::atomic<std::uint64_t>& counter) noexcept {
        counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }

private:
    pid_t child_ = -1;
    int lifeline_ = -1;        ///< its end of file tells the child of our death
    Shared* shared_ = nullptr; ///< mapped in both
};

/// Whether the device watchdog still looks, tick by tick. Thread: real time.
class WatchdogCheck {
public:
    /// `dt`: s since the last call. A tick that came late tells little of the device watchdog, which came
    /// late too.
    bool isDead(const DeviceWatchdog& watchdog, double dt) noexcept {
        constexpr double kLongest = 1e-3 * kWatchdogPatience;
        const std::uint64_t looks = watchdog.looks();
        silent_ = looks == seen_ && watchdog.guards() ? silent_ + std::min(dt, kLongest) : 0;
        seen_ = looks;
        return silent_ > kWatchdogSilence;
    }

private:
    std::uint64_t seen_ = 0;
    double silent_ = 0; ///< s
};

} // namespace tactum
