// Who stops the device when its own process cannot: it was killed, crashed or stands still.
#pragma once

#include <atomic>
#include <cstdint>
#include <sys/types.h>

#include "core/base/result.h"
#include "core/control/haptic_device.h"

namespace tactum {

/// A forked process that calls HapticDevice::emergencyStop() when this one has died, of whatever signal, and
/// when its loop does not tick for kOldestCommand. What core/runtime/guardian.h is for the servo, without
/// what a servo needs to know of it. Fork first, start the loop after: the child has only the thread that
/// forked. Thread of its members: any but real time, where they do not say otherwise.
class Keeper {
public:
    Keeper() = default;
    ~Keeper() { stop(); }
    Keeper(const Keeper&) = delete;
    Keeper& operator=(const Keeper&) = delete;

    /// The device is open; it outlives the keeper or stop().
    Result<void> start(HapticDevice& device);
    /// Ends the watch without stopping the device. Safe to call twice.
    void stop();
    /// The loop ticks; 0: it ended its work in order. Thread: real time.
    void beat(std::int64_t now) noexcept {
        if (beat_) beat_->store(now, std::memory_order_relaxed);
    }

private:
    pid_t child_ = -1;
    int lifeline_ = -1;                         ///< its end of file tells the child of our death
    std::atomic<std::int64_t>* beat_ = nullptr; ///< of the last tick, mapped in both
};

} // namespace tactum
