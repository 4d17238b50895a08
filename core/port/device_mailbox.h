// Between the servo and a driver that talks to its device from another thread or process.
#pragma once

#include <algorithm>
#include <atomic>

#include "core/base/clock.h"
#include "core/base/futex.h"
#include "core/base/wait_free.h"
#include "core/port/haptic_device.h"

namespace tactum {

/// A reading that is older is none: the other side does not tick. Younger ones may be taken twice, for two
/// clocks of the same rate beat against each other: they say when they were measured. Unit: ns.
inline constexpr std::int64_t kOldestReading = 5'000'000;
/// A command that is older is taken away, over the second time, so that nobody is thrown. Unit: ns.
inline constexpr std::int64_t kOldestCommand = 10'000'000, kCommandFade = 200'000'000;

/// How much of a command of this age (ns) still goes to the device: 1 to 0. Thread: real time.
inline double partLeft(std::int64_t age) noexcept {
    return std::clamp(1 - double(age - kOldestCommand) / double(kCommandFade), 0.0, 1.0);
}

/// The newest command one way, the newest reading the other, each with its time; wait-free, and fit for
/// memory that processes share. `now` is of monotonicNanoseconds(). Thread: real time; the servo's members on
/// one thread, the driver's on one other.
class DeviceMailbox {
public:
    // The servo's side.

    void command(const Vec3& force, std::int64_t now, const HandleCommand& handle = {}) noexcept {
        commands_.write({force, now, handle});
    }
    /// The command that answers the newest reading: awaitAnswer() wakes.
    void answer(const Vec3& force, std::int64_t now, const HandleCommand& handle = {}) noexcept {
        command(force, now, handle);
        answers_.fetch_add(1, std::memory_order_release);
        wakeAll(answers_);
    }
    /// Not valid when there is none that is young enough.
    DeviceSample newest(std::int64_t now) noexcept {
        const Reading& last = readings_.read();
        DeviceSample sample = last.sample;
        sample.valid = sample.valid && now - last.at <= kOldestReading;
        sample.at = last.at;
        handle_ = last.handle;
        return sample;
    }

    /// Of the reading that newest() gave.
    const HandleReading& handle() const noexcept { return handle_; }

    /// Until there is a reading that no earlier call knew of, or until a moment in ns. Thread: the servo's,
    /// outside every RealtimeScope.
    void awaitReading(std::int64_t until) noexcept { known_ = waitForChange(count_, known_, until); }

    /// Every command until now counts for nothing. Thread: any, also a signal handler and a forked child.
    void stop(std::int64_t now) noexcept { stopped_.store(now, std::memory_order_relaxed); }

    // The driver's side.

    /// What the device gets now: fades when no command follows. Neither limited nor known to be finite.
    Vec3 force(std::int64_t now) noexcept {
        const Command& last = commands_.read();
        if (last.at <= stopped_.load(std::memory_order_relaxed)) return Vec3::Zero();
        return partLeft(now - last.at) * last.force;
    }
    /// The same for what is no force.
    HandleCommand handleForce(std::int64_t now) noexcept {
        const Command& last = commands_.read();
        if (last.at <= stopped_.load(std::memory_order_relaxed)) return {};
        const double left = partLeft(now - last.at);
        return {left * last.handle.torque, left * last.handle.pinch};
    }
    void measured(const DeviceSample& sample, std::int64_t now, const HandleReading& handle = {}) noexcept {
        answered_ = answers_.load(std::memory_order_acquire);
        readings_.write({sample, now, handle});
        count_.fetch_add(1, std::memory_order_release);
        wakeAll(count_);
    }
    /// Until an answer comes after the newest measured(), or until a moment in ns. One that belongs to the
    /// reading before and is late counts, once. Thread: the driver's, outside every RealtimeScope.
    void awaitAnswer(std::int64_t until) noexcept { waitForChange(answers_, answered_, until); }

private:
    struct Command {
        Vec3 force = Vec3::Zero();
        std::int64_t at = 0;
        HandleCommand handle;
    };
    struct Reading {
        DeviceSample sample;
        std::int64_t at = 0;
        HandleReading handle;
    };
    TripleBuffer<Command> commands_;
    TripleBuffer<Reading> readings_;
    std::atomic<std::int64_t> stopped_{0};
    FutexWord count_{0};      ///< of readings
    std::uint32_t known_ = 0; ///< of them, to awaitReading()
    HandleReading handle_;    ///< the servo's
    FutexWord answers_{0};
    std::uint32_t answered_ = 0; ///< of them, when the newest reading came
};

} // namespace tactum
