#include "tests/benchmarks/friction_judge.h"

#include <algorithm>
#include <array>

namespace tactum::bench {

namespace {

constexpr int kSteady = 4;                       // steps
constexpr double kSlowest = 0.7, kFastest = 1.3; // of the finger's pace
constexpr double kSameLean = 1e-9;               // rad; rounding is far below

/// Looks for what is nearest to p on one triangle after the other.
class NearestSearch {
public:
    explicit NearestSearch(const Vec3& p) : p_(p) {}

    void look(std::size_t triangle, const std::array<Vec3, 3>& corner) {
        triangle_ = triangle;
        const auto& [a, b, c] = corner;
        const Vec3 n = (b - a).cross(c - a), foot = p_ - n * (n.dot(p_ - a) / n.squaredNorm());
        const auto isLeft = [&](const Vec3& from, const Vec3& to) {
            return n.dot((to - from).cross(foot - from)) > 0;
        };
        if (isLeft(a, b) && isLeft(b, c) && isLeft(c, a)) return take(foot, "face");
        lookAtEdge(a, b);
        lookAtEdge(b, c);
        lookAtEdge(c, a);
    }
    const NearestPlace& found() const { return found_; }

private:
    void lookAtEdge(const Vec3& a, const Vec3& b) {
        const double along = (p_ - a).dot(b - a), length2 = (b - a).squaredNorm();
        if (along <= 0) return take(a, "corner");
        if (along >= length2) return take(b, "corner");
        take(a + (b - a) * (along / length2), "edge");
    }
    void take(const Vec3& point, const char* on) {
        const double distance = (p_ - point).norm();
        if (distance < found_.distance) found_ = {point, distance, triangle_, on};
    }

    Vec3 p_;
    std::size_t triangle_ = 0;
    NearestPlace found_;
};

} // namespace

NearestPlace nearestPlace(const test::TriangleGrid& grid, const Vec3& p, double reach) {
    const TriangleSoup& soup = grid.soup();
    for (;; reach *= 2) {
        NearestSearch search(p);
        grid.near(p, reach, [&](Index i) {
            const auto& t = soup.triangles[i];
            search.look(i, {soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]});
        });
        if (search.found().distance <= reach) return search.found();
    }
}

JudgedStep FrictionJudge::judge(const SlideStep& step) {
    JudgedStep judged;
    judged.touched = nearestPlace(grid_, step.proxy, 1.1 * radius_);
    judged.gap = judged.touched.distance - radius_;
    const Vec3 normal = (step.proxy - judged.touched.point) / judged.touched.distance;
    const Vec3 force = step.proxy - step.finger, way = step.proxy - before_.proxy;
    const double pressing = force.dot(normal);
    judged.ratio = (force - pressing * normal).norm() / pressing;
    judged.pace = way.norm() / (step.finger - before_.finger).norm();
    const bool goesAlong = judged.pace >= kSlowest && judged.pace <= kFastest;
    const bool intoAFold = way.dot(normal - normalBefore_) < -kSameLean * way.norm();
    const bool goesOn = step.slips && step.planes == 1 && goesAlong && !intoAFold;
    steady_ = goesOn ? steady_ + 1 : 0;
    judged.isSteady = steady_ >= kSteady;
    before_ = step;
    normalBefore_ = normal;
    return judged;
}

} // namespace tactum::bench
