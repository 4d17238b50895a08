// Who takes the force away when nobody else can: the program was killed, crashed or stands still.
#pragma once

#include <atomic>
#include <cstdint>
#include <sys/types.h>

#include "core/base/result.h"
#include "core/control/haptic_device.h"

namespace tactum {

/// A servo that has not ticked for so long has the device stopped behind its back. Unit: ms.
inline constexpr int kGuardianPatience = 10;

/// A forked process that stops the device (HapticDevice::emergencyStop) when the program has died, of
/// whatever signal, and when the servo does not tick for kGuardianPatience: blocked, stopped, or busy with
/// writing the memory of a crash to disk. A signal handler could do no more, and cannot see SIGKILL. Fork
/// first, start the loops after: the child has only the thread that forked. Thread of its members but beat()
/// and rest(): any but real time.
class Guardian {
public:
    Guardian() = default;
    ~Guardian() { stop(); }
    Guardian(const Guardian&) = delete;
    Guardian& operator=(const Guardian&) = delete;

    /// The device is open; it outlives the guardian or stop().
    Result<void> start(HapticDevice& device);
    /// Ends the watch without stopping the device. Safe to call twice.
    void stop();

    /// The servo is alive. Until the first beat, and after rest(), nobody waits for the next one.
    /// Thread: real time.
    void beat() noexcept {
        if (pulse_) pulse_->store(pulse_->load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
    /// The servo ends its work in order.
    void rest() noexcept {
        if (pulse_) pulse_->store(0, std::memory_order_relaxed);
    }

private:
    pid_t child_ = -1;
    int lifeline_ = -1;                           ///< its end of file tells the child of our death
    std::atomic<std::uint64_t>* pulse_ = nullptr; ///< in memory that both processes see
};

} // namespace tactum
