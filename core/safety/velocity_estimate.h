// How fast the finger goes, from positions that were counted.
#pragma once

#include <array>

#include "core/base/vec.h"

namespace tactum {

/// Janabi-Sharifi's adaptive window: of each axis the longest of the last readings that one line passes
/// within `resolution`; its slope. At speed that is the newest difference, without a filter's delay, at rest
/// it is nearly nothing, where a difference would shake. SI. Thread: real time.
class VelocityEstimate {
public:
    /// `resolution` in m, of the readings; 0: they are exact, and the newest difference is taken.
    explicit VelocityEstimate(double resolution) noexcept : resolution_(resolution) {}

    /// The velocity with this reading, `dt` s after the last one. A reading that `jumped` begins anew.
    Vec3 operator()(const Vec3& position, bool jumped, double dt) noexcept;

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.resolution_, self.past_);
        visit.index(self.length_, kWindow + 2);
    }

private:
    static constexpr int kWindow = 16;

    struct Reading {
        Vec3 position = Vec3::Zero();
        double age = 0; ///< s before the newest
        static void fields(auto& visit, auto& self) { visit(self.position, self.age); }
    };
    double slope(int axis) const noexcept;
    bool fits(int axis, int length, double slope) const noexcept;

    double resolution_;
    std::array<Reading, kWindow + 1> past_{}; ///< newest first
    int length_ = 0;                          ///< readings in past_
};

} // namespace tactum
