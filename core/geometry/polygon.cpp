#include "core/geometry/polygon.h"

#include <algorithm>
#include <numeric>

namespace tactum {
namespace {

constexpr std::size_t kWorkBound = 20'000'000;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

} // namespace

Vec3 newellNormal(std::span<const Vec3> corners) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec3 a = corners[i] - corners[0];
        const Vec3 b = corners[(i + 1) % corners.size()] - corners[0];
        sum += a.cross(b);
    }
    return sum;
}

const std::vector<std::array<Index, 3>>& PolygonCutter::cut(std::span<const Vec3> corners) {
    triangles_.clear();
    gaveUp_ = false;
    dropRepeatedCorners(corners);
    if (ring_.empty()) return triangles_;
    if (ring_.size() < 3)
        triangles_.push_back({ring_[0], ring_.back(), ring_.back()});
    else if (ring_.size() == 3)
        triangles_.push_back({ring_[0], ring_[1], ring_[2]});
    else if (!project(corners))
        fan(0);
    else if (ring_.size() == 4)
        cutQuad(corners);
    else
        clipEars();
    return triangles_;
}

void PolygonCutter::dropRepeatedCorners(std::span<const Vec3> corners) {
    ring_.clear();
    for (Index i = 0; i < corners.size(); ++i)
        if (ring_.empty() || corners[i] != corners[ring_.back()]) ring_.push_back(i);
    while (ring_.size() > 1 && corners[ring_.back()] == corners[ring_.front()])
        ring_.pop_back();
}

/// False when the polygon has no plane: all corners on one line, or lobes that cancel out. Links the ring
/// anyway, so that it can be fanned.
bool PolygonCutter::project(std::span<const Vec3> corners) {
    const std::size_t n = ring_.size();
    next_.resize(n);
    previous_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        next_[i] = (i + 1) % n;
        previous_[i] = (i + n - 1) % n;
    }
    flat_.resize(n);
    const Vec3 origin = corners[ring_[0]];
    Vec3 normal = Vec3::Zero();
    double reach = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 a = corners[ring_[i]] - origin;
        normal += a.cross(corners[ring_[next_[i]]] - origin);
        reach = std::max(reach, a.squaredNorm());
    }
    flatness_ = 1e-15 * reach;
    if (!(normal.norm() > flatness_)) return false;
    const Vec3 u = normal.unitOrthogonal(), v = normal.normalized().cross(u);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 a = corners[ring_[i]] - origin;
        flat_[i] = {u.dot(a), v.dot(a)};
    }
    return true;
}

double PolygonCutter::turn(std::size_t a, std::size_t b, std::size_t c) const {
    return cross(flat_[b] - flat_[a], flat_[c] - flat_[a]);
}

/// Along the diagonal that lies inside; along the shorter one when both do.
void PolygonCutter::cutQuad(std::span<const Vec3> corners) {
    const double worst02 = std::min(turn(0, 1, 2), turn(0, 2, 3));
    const double worst13 = std::min(turn(0, 1, 3), turn(1, 2, 3));
    const double length02 = (corners[ring_[2]] - corners[ring_[0]]).squaredNorm();
    const double length13 = (corners[ring_[3]] - corners[ring_[1]]).squaredNorm();
    const bool bothInside = worst02 > flatness_ && worst13 > flatness_;
    if (bothInside ? length02 <= length13 : worst02 >= worst13) {
        triangles_.push_back({ring_[0], ring_[1], ring_[2]});
        triangles_.push_back({ring_[0], ring_[2], ring_[3]});
    } else {
        triangles_.push_back({ring_[0], ring_[1], ring_[3]});
        triangles_.push_back({ring_[1], ring_[2], ring_[3]});
    }
}

void PolygonCutter::classify(std::size_t i) {
    reflex_[i] = !(turn(previous_[i], i, next_[i]) > flatness_);
}

void PolygonCutter::clipEars() {
    const std::size_t n = ring_.size();
    budget_ = kWorkBound;
    reflex_.assign(n, 0);
    reflexes_.clear();
    for (std::size_t i = 0; i < n; ++i) {
        classify(i);
        if (reflex_[i]) reflexes_.push_back(i);
    }
    std::size_t at = 0;
    for (std::size_t left = n; left > 3; --left) {
        const std::size_t ear = anyEar(at, left);
        if (gaveUp_) return fan(at);
        clip(ear);
        at = next_[next_[ear]]; // skipping one spreads the cuts: better shaped than a fan
        while (!reflexes_.empty() && !reflex_[reflexes_.back()])
            reflexes_.pop_back();
    }
    fan(at);
}

/// The first ear from `start` on; where there is none (the outline crosses or touches itself) the first
/// corner that nothing lies strictly inside of, then the first convex one, then any.
std::size_t PolygonCutter::anyEar(std::size_t start, std::size_t left) {
    for (Blocking blocking : {Blocking::Touching, Blocking::Inside}) {
        std::size_t i = start;
        for (std::size_t k = 0; k < left && !gaveUp_; ++k, i = next_[i])
            if (isEar(i, blocking)) return i;
    }
    std::size_t i = start;
    for (std::size_t k = 0; k < left; ++k, i = next_[i])
        if (!reflex_[i]) return i;
    return start;
}

bool PolygonCutter::isEar(std::size_t i, Blocking blocking) {
    if (reflex_[i]) return false;
    const std::size_t a = previous_[i], c = next_[i];
    const double slack = blocking == Blocking::Touching ? -flatness_ : flatness_;
    if (budget_ < reflexes_.size()) gaveUp_ = true;
    if (gaveUp_) return false;
    budget_ -= reflexes_.size();
    return std::none_of(reflexes_.begin(), reflexes_.end(), [&](std::size_t q) {
        if (!reflex_[q] || q == a || q == c) return false;
        return turn(a, i, q) > slack && turn(i, c, q) > slack && turn(c, a, q) > slack;
    });
}

void PolygonCutter::clip(std::size_t i) {
    const std::size_t a = previous_[i], c = next_[i];
    triangles_.push_back({ring_[a], ring_[i], ring_[c]});
    next_[a] = c;
    previous_[c] = a;
    reflex_[i] = 0;
    for (std::size_t corner : {a, c}) {
        const bool wasReflex = reflex_[corner];
        classify(corner);
        if (reflex_[corner] && !wasReflex) reflexes_.push_back(corner); // only in outlines that cross
    }
}

/// All that is left, from one corner.
void PolygonCutter::fan(std::size_t start) {
    for (std::size_t i = next_[start]; next_[i] != start; i = next_[i])
        triangles_.push_back({ring_[start], ring_[i], ring_[next_[i]]});
}

} // namespace tactum
