#include "core/control/oscillation_detector.h"

#include <algorithm>

namespace tactum {
namespace {
constexpr double kSlowest = 1 / (2 * 18.0), kFastest = 1 / (2 * 400.0); ///< s, a half swing
constexpr double kSwing = 1.6e-4; ///< m, peak to peak: sampling cuts the peaks of 0.2 mm off
constexpr double kTurn = 0.5;     ///< of the swing before, that the finger must come back to have turned
constexpr int kEnough = 4;        ///< half swings: 100 ms at 20 Hz
} // namespace

/// The swing that ended with a turn counts if it was as fast and as wide as one of a limit cycle.
void OscillationDetector::Axis::turn(double swing) noexcept {
    const bool fast = sinceTurn >= kFastest && sinceTurn <= kSlowest;
    const bool even = lastSwing == 0 || (swing < 3 * lastSwing && lastSwing < 3 * swing);
    halfSwings = fast && swing >= kSwing ? (even ? halfSwings + 1 : 1) : 0;
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
    if (sinceTurn > kSlowest) halfSwings = 0;
    const double back = std::max(0.5 * kSwing, std::min(kTurn * lastSwing, 2 * kSwing));
    if (direction >= 0 && x < high - back) {
        turn(high - low);
        direction = -1;
        low = x;
    } else if (direction <= 0 && x > low + back) {
        turn(high - low);
        direction = 1;
        high = x;
    }
    if (direction >= 0) high = std::max(high, x);
    if (direction <= 0) low = std::min(low, x);
    if (halfSwings < kEnough) return false;
    halfSwings = 0;
    return true;
}

bool OscillationDetector::operator()(const Vec3& position, double dt) noexcept {
    bool found = false;
    for (int i = 0; i < 3; ++i)
        found |= axes_[std::size_t(i)].add(position[i], dt);
    return found;
}

} // namespace tactum
