#include "tests/benchmarks/strokes.h"

#include <array>

#include "tests/benchmarks/friction_judge.h"
#include "tests/support/soups.h"

namespace tactum::bench {

namespace {

constexpr std::array kSpeeds{0.05, 0.1, 0.15, 0.2};
constexpr std::array kDepths{1e-3, 2.5e-3, 5e-3};
constexpr double kPeriod = 1e-3;
constexpr double kFar = 0.2;       // m, farther from the centre than any mesh of 0.2 m
constexpr double kBegin = 6e-3;    // m, beside the surface: room for the largest proxy
constexpr double kNear = 1e-5;     // m, that is near enough to it
constexpr double kHover = 3e-3;    // m
constexpr double kStride = 1e-4;   // m
constexpr double kSmoothed = 5e-3; // m, of way: a finger does not follow each facet
constexpr double kFold = 0.995;    // cosine of a turn that no edge makes in a stride
constexpr std::size_t kStrides = 200;

/// Goes along a surface a little above it and turns aside where it comes into a fold.
class Guide {
public:
    Guide(const test::TriangleGrid& grid, test::Rng& rng) : grid_(grid), rng_(rng) {
        comeNear();
        away_ = inward_ = (place_ - under_.point) / under_.distance;
        begin_ = place_;
        place_ = under_.point + kHover * away_;
        heading_ = test::direction(rng_);
    }

    const Vec3& begin() const { return begin_; }
    Vec3 fingerAt(double depth) const { return place_ - (kHover + depth) * inward_.normalized(); }

    void goOn() {
        const Vec3 along = (heading_ - away_ * away_.dot(heading_)).normalized();
        const Vec3 next = place_ + kStride * along;
        const NearestPlace under = nearestPlace(grid_, next, 1.1 * kHover);
        const Vec3 away = (next - under.point) / under.distance;
        if (away.dot(away_) < kFold) {
            heading_ = test::direction(rng_);
            return;
        }
        place_ = under.point + kHover * away;
        away_ = away;
        heading_ = along;
        inward_ += kStride / kSmoothed * (away_ - inward_);
    }

private:
    // From afar, straight toward some corner of the mesh, by as much as is free for certain.
    void comeNear() {
        const auto& corners = grid_.soup().positions;
        place_ = kFar * test::direction(rng_);
        const Vec3 way = (corners[rng_() % corners.size()] - place_).normalized();
        for (under_ = nearestPlace(grid_, place_, kFar); under_.distance > kBegin + kNear;
             under_ = nearestPlace(grid_, place_, under_.distance))
            place_ += (under_.distance - kBegin) * way;
    }

    const test::TriangleGrid& grid_;
    test::Rng& rng_;
    NearestPlace under_;
    Vec3 begin_, place_, heading_;
    Vec3 away_;   ///< from the surface to the guide
    Vec3 inward_; ///< the same, smoothed
};

} // namespace

Stroke strokeOver(const test::TriangleGrid& grid, int number, std::size_t rows) {
    test::Rng rng(std::uint64_t(number) + 1);
    Guide guide(grid, rng);
    const std::size_t kind = std::size_t(number);
    Stroke stroke{kSpeeds[kind % kSpeeds.size()], kDepths[kind / kSpeeds.size() % kDepths.size()], {}, 0};
    const double step = stroke.speed * kPeriod;
    Vec3 finger = guide.begin();
    const auto follow = [&] {
        for (Vec3 way = guide.fingerAt(stroke.depth) - finger; way.norm() >= step;
             way = guide.fingerAt(stroke.depth) - finger)
            stroke.finger.push_back(finger += step * way.normalized());
    };
    follow();
    stroke.approach = stroke.finger.size();
    // Where no way leads on it stays.
    for (std::size_t i = 0; i < kStrides * rows && stroke.finger.size() < stroke.approach + rows; ++i) {
        guide.goOn();
        follow();
    }
    stroke.finger.resize(stroke.approach + rows, finger);
    return stroke;
}

} // namespace tactum::bench
