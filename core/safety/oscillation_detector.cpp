#include "core/safety/oscillation_detector.h"

#include <algorithm>
#include <numbers>

namespace tactum {
namespace {
constexpr double kSlowest = 1 / (2 * 18.0), kFastest = 1 / (2 * 550.0); ///< s, a half swing
constexpr double kLonger = 1.3;   ///< that one half may be than the mean: bounces dwell above
constexpr double kWide = 2e-4;    ///< m, from end to end: what must be noticed
constexpr double kCount = 6e-5;   ///< m: what a device's counts take of that at most
constexpr double kSwing = 1.1e-4; ///< m: sampling takes as much of the fastest ones
constexpr double kTurn = 0.3;     ///< of the swing before, that the finger must come back to have turned
constexpr double kUneven = 2.1;   ///< that one half swing may be wider than the one before
/// Of the widest that counts: what becomes narrower than that dies away by itself.
constexpr double kHeld = 0.6;
constexpr int kEnough = 3;               ///< half swings: 90 ms at 20 Hz
constexpr double kLongEnough = 1.0 / 16; ///< s

/// How wide the swing of a limit cycle is at least when it is read every `dt`. Between two readings a bounce,
/// which turns the most sharply, goes on for dt / 2 with its largest speed. So of slow swings little is lost:
/// two counts of a coarse device, which grooves make at a fast stroke, are then too few.
double leastSwing(double half, double dt) noexcept {
    constexpr double kBounce = std::numbers::pi / 4;
    return std::max(kSwing, kWide * (1 - kBounce * dt / half) - kCount);
}

} // namespace

/// The swing that ended with a turn counts if it was as fast and as wide as one of a limit cycle.
void OscillationDetector::Axis::turn(double swing, double dt) noexcept {
    const bool fast = sinceTurn >= kFastest && sinceTurn <= kLonger * kSlowest;
    const bool even = swing < kUneven * lastSwing && swing >= kHeld * widest;
    const bool wide = fast && swing >= leastSwing(sinceTurn, dt);
    if (!wide || !even) {
        halfSwings = 0;
        widest = lasted = 0;
    }
    if (wide) {
        ++halfSwings;
        widest = std::max(widest, swing);
        lasted += sinceTurn;
    }
    lastSwing = swing;
    sinceTurn = 0;
}

bool OscillationDetector::Axis::add(double x, double dt) noexcept {
    sinceTurn += dt;
    if (!begun) {
        low = high = x;
        begun = true;
        return false;
    }
    const double back = std::clamp(kTurn * lastSwing, 0.5 * kSwing, 2 * kSwing);
    if (direction >= 0 && x < high - back) {
        turn(high - low, dt);
        direction = -1;
        low = x;
    } else if (direction <= 0 && x > low + back) {
        turn(high - low, dt);
        direction = 1;
        high = x;
    }
    if (direction >= 0) high = std::max(high, x);
    if (direction <= 0) low = std::min(low, x);
    if (halfSwings < kEnough || lasted < kLongEnough || lasted > halfSwings * kSlowest) return false;
    halfSwings = 0;
    widest = lasted = 0;
    return true;
}

// A swing that ends at what is no number would never end.
bool OscillationDetector::operator()(const Vec3& position, double dt) noexcept {
    if (!position.allFinite()) return false;
    bool found = false;
    for (int i = 0; i < 3; ++i)
        found |= axes_[std::size_t(i)].add(position[i], dt);
    return found;
}

} // namespace tactum
