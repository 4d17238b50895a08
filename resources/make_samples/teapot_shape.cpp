#include "resources/make_samples/teapot_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactum::samples {
namespace {

using Controls = std::vector<Vec3>;
constexpr double kTurn = 2 * std::numbers::pi;

/// A clamped uniform cubic B-spline through its first and last control point, walked at even speed, but
/// slower where it bends: one radian takes as long as the length `bend`.
class Curve {
public:
    Curve(Controls controls, double bend) : controls_(std::move(controls)) {
        const Vec3 before = 2 * controls_[0] - controls_[1];
        const Vec3 after = 2 * controls_.back() - controls_.end()[-2];
        controls_.insert(controls_.begin(), before);
        controls_.push_back(after);
        lengths_.push_back(0);
        Vec3 last = spline(0), lastStep = spline(1.0 / kSteps) - last;
        for (std::size_t i = 1; i <= kSteps; ++i) {
            const Vec3 p = spline(double(i) / kSteps), step = p - last;
            const double angle = std::atan2(step.cross(lastStep).norm(), step.dot(lastStep));
            lengths_.push_back(lengths_.back() + step.norm() + bend * angle);
            last = p;
            lastStep = step;
        }
    }

    /// The point after the fraction `s`, 0 to 1, of the way.
    Vec3 at(double s) const {
        const double wanted = std::clamp(s, 0.0, 1.0) * lengths_.back();
        const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, wanted);
        const double low = *(above - 1), part = (wanted - low) / (*above - low);
        return spline((double(above - lengths_.begin() - 1) + part) / kSteps);
    }
    Vec3 direction(double s) const {
        const double inside = std::clamp(s, 1e-4, 1 - 1e-4);
        return (at(inside + 1e-4) - at(inside - 1e-4)).normalized();
    }

private:
    static constexpr std::size_t kSteps = 4000;

    Vec3 spline(double t) const {
        const double scaled = t * double(controls_.size() - 3);
        const std::size_t i = std::min(std::size_t(scaled), controls_.size() - 4);
        const double u = scaled - double(i), v = 1 - u;
        return (v * v * v * controls_[i] + (3 * u * u * u - 6 * u * u + 4) * controls_[i + 1] +
                (3 * v * v * v - 6 * v * v + 4) * controls_[i + 2] + u * u * u * controls_[i + 3]) /
               6;
    }

    Controls controls_;
    std::vector<double> lengths_; ///< up to each step
};

/// A profile (x: radius, z: height; millimetres) turned about the z axis. From bottom to top.
Part turned(std::string name, Eigen::Vector3f colour, std::size_t rings, std::size_t segments,
            Controls profile) {
    for (Vec3& p : profile)
        p *= 1e-3;
    return {std::move(name), colour, rings, segments,
            [curve = Curve(std::move(profile), 0.006)](double u, double v) {
                const Vec3 p = curve.at(u);
                return Vec3(p.x() * std::cos(kTurn * v), p.x() * std::sin(kTurn * v), p.z());
            }};
}

/// A tube in the xz plane around `path`; `section` gives for each u where on the path (x: percent) and how
/// wide (z: radius, millimetres).
Part swept(std::string name, Eigen::Vector3f colour, std::size_t rings, std::size_t segments, Controls path,
           Controls section) {
    for (Vec3& p : path)
        p *= 1e-3;
    return {std::move(name), colour, rings, segments,
            [centre = Curve(std::move(path), 0), width = Curve(std::move(section), 8)](double u, double v) {
                const Vec3 w = width.at(u);
                const double along = w.x() / 100;
                const Vec3 ahead = centre.direction(along);
                const Vec3 beside = Vec3::UnitY(), above = ahead.cross(beside);
                // Beyond its ends the path goes straight on.
                const Vec3 c = centre.at(along) + ahead * 0.06 * (along - std::clamp(along, 0.0, 1.0));
                return Vec3(c + 1e-3 * w.z() * (std::cos(kTurn * v) * beside + std::sin(kTurn * v) * above));
            }};
}

Vec3 rz(double r, double z) {
    return {r, 0, z};
}

} // namespace

Vec3 Part::normal(double u, double v) const {
    const double h = 1e-3;
    const Vec3 along = point(std::min(u + h, 1.0), v) - point(std::max(u - h, 0.0), v);
    const Vec3 around = point(u, v + h) - point(u, v - h);
    return around.cross(along).normalized();
}

Vec3 Part::poleNormal(double u) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 0; k < segments; ++k)
        sum += normal(u, double(k) / double(segments));
    return sum.normalized();
}

Vec3 Part::normalAt(std::size_t ring, std::size_t k) const {
    const double u = std::clamp(double(ring) / double(rings), 1e-3, 1 - 1e-3); // where one can be found
    return pointsOf(ring) == 1 ? poleNormal(u)
                               : normal(double(ring) / double(rings), double(k) / double(segments));
}

std::size_t Part::numberOf(std::size_t ring, std::size_t k) const {
    if (ring == 0) return 0;
    const std::size_t before = 1 + (ring - 1) * segments;
    return ring == rings ? before : before + k % segments;
}

std::vector<std::array<std::size_t, 3>> Part::triangles() const {
    std::vector<std::array<std::size_t, 3>> all;
    for (std::size_t i = 0; i < rings; ++i)
        for (std::size_t k = 0; k < segments; ++k) {
            const std::size_t a = numberOf(i, k), b = numberOf(i, k + 1);
            const std::size_t c = numberOf(i + 1, k + 1), d = numberOf(i + 1, k);
            if (a != b) all.push_back({a, b, c});
            if (c != d) all.push_back({a, c, d});
        }
    return all;
}

Part teapotBody() {
    return turned("body", {0.22f, 0.46f, 0.52f}, 40, 56,
                  {rz(0, 0.6), rz(12, 0.6), rz(21, 0.3), rz(23.5, 1.0), rz(22.5, 4), rz(29, 8), rz(41, 18),
                   rz(42, 36), rz(34, 49), rz(26, 53.5), rz(26, 56.5), rz(24.8, 58.2), rz(23, 57.5),
                   rz(21, 53.5), rz(12, 53), rz(0, 53)});
}

Part teapotLid() {
    return turned("lid", {0.78f, 0.40f, 0.24f}, 32, 40,
                  {rz(0, 54.5), rz(12, 54.5), rz(20, 54.5), rz(23.4, 56), rz(23.2, 59.5), rz(17, 64.5),
                   rz(8, 67.2), rz(3.4, 68), rz(2.8, 70.5), rz(6.5, 72), rz(8, 75.5), rz(6, 79), rz(2.5, 80),
                   rz(0, 80)});
}

Part teapotSpout() {
    return swept("spout", {0.20f, 0.42f, 0.48f}, 36, 22,
                 {rz(28, 22), rz(40, 21), rz(49, 26), rz(53, 40), rz(57, 50), rz(65, 56)},
                 {rz(0, 0), rz(0, 5), rz(0, 10), rz(12, 10.5), rz(35, 8.5), rz(60, 6), rz(85, 5), rz(98, 5.2),
                  rz(101, 5.2), rz(101.5, 4.6), rz(99, 4), rz(92, 3.7), rz(85, 3.5), rz(84, 2), rz(84, 0)});
}

Part teapotHandle() {
    return swept("handle", {0.50f, 0.31f, 0.17f}, 40, 16,
                 {rz(-28, 45), rz(-42, 50), rz(-60, 49), rz(-64, 33), rz(-54, 19), rz(-30, 16)},
                 {rz(0, 0), rz(0, 2), rz(0, 5), rz(20, 4.6), rz(50, 4), rz(80, 4.6), rz(100, 5), rz(100, 2),
                  rz(100, 0)});
}

Part teapotTable() {
    return turned("table", {0.74f, 0.67f, 0.57f}, 14, 60,
                  {rz(0, -8), rz(50, -8), rz(92, -8), rz(99, -7.5), rz(100.5, -4), rz(99, -0.2), rz(93, 0),
                   rz(50, 0), rz(0, 0)});
}

} // namespace tactum::samples
