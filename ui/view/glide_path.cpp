#include "ui/view/glide_path.h"

#include <algorithm>

namespace tactum {

namespace {

constexpr int kArcSteps = 12;

/// From one direction to another along the great circle; opposite ones go over the top.
Vec3 between(const Vec3& a, const Vec3& b, double part) {
    return Quat::Identity().slerp(part, turnOnto(a, b)) * a;
}

Vec3 directionFrom(const Vec3& centre, const Vec3& p) {
    const Vec3 d = p - centre;
    return d.norm() > 1e-12 ? Vec3(d.normalized()) : Vec3::UnitY();
}

} // namespace

double GlidePath::length() const {
    double sum = 0;
    for (std::size_t i = 1; i < points_.size(); ++i)
        sum += (points_[i] - points_[i - 1]).norm();
    return sum;
}

Vec3 GlidePath::at(double part) const {
    double rest = std::clamp(part, 0.0, 1.0) * length();
    for (std::size_t i = 1; i < points_.size(); ++i) {
        const double piece = (points_[i] - points_[i - 1]).norm();
        if (rest < piece) return points_[i - 1] + rest / piece * (points_[i] - points_[i - 1]);
        rest -= piece;
    }
    return points_.back();
}

GlidePath planGlide(const Vec3& from, const Vec3& hover, const Vec3& target, const Bounds& box,
                    const IsFree& isFree) {
    if (isFree(from, hover)) return GlidePath({from, hover, target});
    const Vec3 centre = box.centre();
    const Vec3 start = directionFrom(centre, from), end = directionFrom(centre, hover);
    const double radius = 0.6 * box.diagonal();
    std::vector<Vec3> points{from};
    for (int i = 0; i <= kArcSteps; ++i)
        points.push_back(centre + radius * between(start, end, double(i) / kArcSteps));
    points.insert(points.end(), {hover, target});
    return GlidePath(std::move(points));
}

} // namespace tactum
