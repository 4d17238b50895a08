// Which bodies are near each other and where they touch. For this folder.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/dynamics/articulation.h"
#include "core/dynamics/touch.h"

namespace tactum {

struct Touching {
    int a = 0, b = 0; ///< of Mechanism::touchables
    int place = 0;    ///< which of the two bodies' places
    TouchPoint at;
    Vec3 onA = Vec3::Zero(); ///< the same point in the frame of a, by which it is known again
    double rate = 0;         ///< m/s at which the gap grows
    /// What is round touches elsewhere as it goes. In the middle of the step: the normal, where it acts on a
    /// and on b as they are now, and what the gap grows faster along it.
    Vec3 normal = Vec3::UnitY(), onAThen = Vec3::Zero(), onBThen = Vec3::Zero();
    double turning = 0;        ///< m/s
    double bend = 0;           ///< m/s^2
    Vec3 force = Vec3::Zero(); ///< on b, N, world frame: of the last step, to begin with
};

/// m/s: what a body that rests gains in two steps along the normal of a place.
inline double fallsIn(const Touching& touching, double dt) noexcept {
    return 2 * std::max(0.0, -touching.bend) * dt;
}

/// Thread: one at a time; all but the constructor real time.
class Contacts {
public:
    explicit Contacts(const Mechanism& mechanism);

    /// All places that are no more than a step apart. The articulation knows velocities and accelerations.
    void find(const Articulation& articulation, double dt) noexcept;
    std::vector<Touching>& all() noexcept { return now_; }
    const std::vector<Touching>& all() const noexcept { return now_; }
    /// What the places of the last step pushed is not known any more.
    void forget() noexcept;
    bool empty() const noexcept { return mechanism_.touchables.empty(); }
    /// Places that there was no room for, since the beginning.
    std::uint64_t leftOut() const noexcept { return leftOut_; }

private:
    struct Box {
        Vec3 low, high;
        int touchable = 0;
    };

    void box(const Articulation& articulation, double dt, Box& box) const noexcept;
    void touch(const Articulation& articulation, int a, int b, double dt) noexcept;
    void lookAhead(const Articulation& articulation, std::span<Touching> places, double dt) const noexcept;
    Vec3 accelerationAt(const Articulation& articulation, int link, const Vec3& point) const noexcept;
    void remember() noexcept;

    const Mechanism& mechanism_;
    std::vector<Box> boxes_; ///< by their lowest x: nearly sorted from step to step
    std::vector<Pose> poses_;
    std::vector<Touching> now_, before_;
    TouchScratch scratch_;
    std::uint64_t leftOut_ = 0;
};

} // namespace tactum
