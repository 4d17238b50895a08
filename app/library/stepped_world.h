// A World that is stepped by one thread while another one makes the next.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include <tactum/step.h>

#include "core/base/wait_free.h"
#include "core/haptics/haptic_step.h"

namespace tactum::library {

class SteppedWorld {
public:
    /// Thread: any but real time, before all others.
    explicit SteppedWorld(std::shared_ptr<const ::tactum::World> first);

    /// What tactum::World::step() promises; without a velocity that of the way. Thread: real time, one at a
    /// time.
    Step step(const Vec3& finger, const Vec3* velocity, double dt) noexcept;
    /// Thread: as step().
    void restart(double time) noexcept;
    double time() const noexcept { return time_; }

    /// One of the next steps takes it, and the one before comes back to die here. Thread: any but real time,
    /// one at a time.
    void offer(std::shared_ptr<const ::tactum::World> world);
    /// The one that was offered last. Thread: as offer().
    const ::tactum::World& newest() const { return *kept_.back(); }

private:
    void takeOver() noexcept;
    Step report(const HapticOutput& output) const noexcept;
    void release(const ::tactum::World* world);

    // Whoever offers.
    std::vector<std::shared_ptr<const ::tactum::World>> kept_; ///< that a step may still see, oldest first
    // Across.
    std::atomic<const ::tactum::World*> next_{nullptr};
    SpscQueue<const ::tactum::World*, 4> retired_;
    // Whoever steps.
    const ::tactum::World* world_;
    std::unique_ptr<SimState> state_ = std::make_unique<SimState>(); ///< large
    bool begun_ = false;                                             ///< there was a step before
    ::tactum::Vec3 before_ = ::tactum::Vec3::Zero();                 ///< the finger of it
    double time_ = 0;
};

} // namespace tactum::library
