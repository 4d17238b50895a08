#include "device/recorded_hand.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace tactum {
namespace {

/// What the display and the limiter take for the force that nobody feels. N
constexpr double kShownForce = 8;
constexpr double kGrip = 1e5;       ///< N s/m: it goes its way whatever it meets, and no stiffness shakes it
constexpr double kFastestRead = 20; ///< m/s: nobody holds it

bool risesTo(const RecordedPoint& a, const RecordedPoint& b) {
    return a.t < b.t;
}
bool isFinite(const RecordedPoint& point) {
    return std::isfinite(point.t) && point.position.allFinite();
}

} // namespace

RecordedHand::RecordedHand(std::vector<RecordedPoint> points, Playback playback)
    : points_(std::move(points)), playback_(playback) {}

DeviceInfo RecordedHand::info() const {
    double reach = 0;
    for (const RecordedPoint& point : points_)
        reach = std::max(reach, point.position.norm());
    return {.name = "Recorded hand",
            .maxForce = kShownForce,
            .workspaceRadius = reach,
            .rate = 1000,
            .damping = kGrip,
            .tripSpeed = kFastestRead,
            .measuresVelocity = true};
}

Result<void> RecordedHand::open() {
    if (points_.empty()) return inputError("The recording holds no point: record or choose another one.");
    if (!std::all_of(points_.begin(), points_.end(), isFinite))
        return inputError("The recording holds a number that is not finite: record it again.");
    if (std::adjacent_find(points_.begin(), points_.end(), std::not_fn(risesTo)) != points_.end())
        return inputError("The recording's time does not rise from point to point: sort it by time.");
    elapsed_ = 0;
    rewound_ = true;
    return {};
}

void RecordedHand::close() {}

DeviceSample RecordedHand::exchange(const DeviceCommand&, double dt) noexcept {
    const double before = playedTime();
    if (!std::exchange(rewound_, false)) elapsed_ += dt;
    const double t = playedTime();
    const bool jumped = t < before;
    const auto next =
        std::upper_bound(points_.begin(), points_.end(), t,
                         [](double time, const RecordedPoint& point) { return time < point.t; });
    if (next == points_.end()) return {.position = points_.back().position, .valid = true, .jumped = jumped};

    const RecordedPoint &from = *std::prev(next), &to = *next;
    const Vec3 velocity = (to.position - from.position) / (to.t - from.t);
    return {.position = from.position + (t - from.t) * velocity,
            .velocity = velocity,
            .valid = true,
            .jumped = jumped};
}

/// Never before the first point.
double RecordedHand::playedTime() const noexcept {
    const double first = points_.front().t, length = points_.back().t - first;
    if (playback_ == Playback::Looped && length > 0) return first + std::fmod(elapsed_, length);
    return first + elapsed_;
}

} // namespace tactum
