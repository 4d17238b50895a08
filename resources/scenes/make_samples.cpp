// Writes the sample scene and a finger that touches it: make-samples FOLDER.
//
// The teapot is ours, from formulas: body, lid and table are B-spline profiles turned about the z axis, spout
// and handle are circles swept along B-splines. Every part is a closed surface of its own. Unit: metre, z up
// in the formulas, the top of the table at z = 0. The files in this folder are what this program writes; a
// test compares them.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>
#include <vector>

#include "core/base/vec.h"

namespace {

using tactum::Vec3;
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

/// A closed surface, round in v: rings of points from one pole to the other.
struct Part {
    std::string name;
    Eigen::Vector3f colour;
    std::size_t rings, segments;
    std::function<Vec3(double u, double v)> point; ///< u, v: 0 to 1; all v are one point at u = 0 and u = 1

    Vec3 normal(double u, double v) const {
        const double h = 1e-3;
        const Vec3 along = point(std::min(u + h, 1.0), v) - point(std::max(u - h, 0.0), v);
        const Vec3 around = point(u, v + h) - point(u, v - h);
        return around.cross(along).normalized();
    }
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

Part body() {
    return turned("body", {0.22f, 0.46f, 0.52f}, 40, 56,
                  {rz(0, 0.6), rz(12, 0.6), rz(21, 0.3), rz(23.5, 1.0), rz(22.5, 4), rz(29, 8), rz(41, 18),
                   rz(42, 36), rz(34, 49), rz(26, 53.5), rz(26, 56.5), rz(24.8, 58.2), rz(23, 57.5),
                   rz(21, 53.5), rz(12, 53), rz(0, 53)});
}

Part lid() {
    return turned("lid", {0.78f, 0.40f, 0.24f}, 32, 40,
                  {rz(0, 54.5), rz(12, 54.5), rz(20, 54.5), rz(23.4, 56), rz(23.2, 59.5), rz(17, 64.5),
                   rz(8, 67.2), rz(3.4, 68), rz(2.8, 70.5), rz(6.5, 72), rz(8, 75.5), rz(6, 79), rz(2.5, 80),
                   rz(0, 80)});
}

Part spout() {
    return swept("spout", {0.20f, 0.42f, 0.48f}, 36, 22,
                 {rz(28, 22), rz(40, 21), rz(49, 26), rz(53, 40), rz(57, 50), rz(65, 56)},
                 {rz(0, 0), rz(0, 5), rz(0, 10), rz(12, 10.5), rz(35, 8.5), rz(60, 6), rz(85, 5), rz(98, 5.2),
                  rz(101, 5.2), rz(101.5, 4.6), rz(99, 4), rz(92, 3.7), rz(85, 3.5), rz(84, 2), rz(84, 0)});
}

Part handle() {
    return swept("handle", {0.50f, 0.31f, 0.17f}, 40, 16,
                 {rz(-28, 45), rz(-42, 50), rz(-60, 49), rz(-64, 33), rz(-54, 19), rz(-30, 16)},
                 {rz(0, 0), rz(0, 2), rz(0, 5), rz(20, 4.6), rz(50, 4), rz(80, 4.6), rz(100, 5), rz(100, 2),
                  rz(100, 0)});
}

Part table() {
    return turned("table", {0.74f, 0.67f, 0.57f}, 14, 60,
                  {rz(0, -8), rz(50, -8), rz(92, -8), rz(99, -7.5), rz(100.5, -4), rz(99, -0.2), rz(93, 0),
                   rz(50, 0), rz(0, 0)});
}

/// With so many decimals, of any number that is smaller than a million; the same in every locale.
std::string fixed(double value, int decimals) {
    const auto scale = std::int64_t(std::llround(std::pow(10.0, decimals)));
    const std::int64_t whole = std::llround(value * double(scale));
    std::string digits = std::to_string(std::abs(whole) % scale);
    digits.insert(0, std::size_t(decimals) - digits.size(), '0');
    return (whole < 0 ? "-" : "") + std::to_string(std::abs(whole) / scale) + "." + digits;
}

std::string fixed(const Vec3& p, int decimals, const char* separator) {
    return fixed(p.x(), decimals) + separator + fixed(p.y(), decimals) + separator + fixed(p.z(), decimals);
}

// The formulas stand on z; files and the view stand on y, as glTF does.
Vec3 yUp(const Vec3& p) {
    return {p.x(), p.z(), -p.y()};
}

class ObjWriter {
public:
    explicit ObjWriter(const std::filesystem::path& folder)
        : obj_(folder / "teapot.obj", std::ios::binary), mtl_(folder / "teapot.mtl", std::ios::binary) {
        obj_ << "# A teapot on a table: metres, y up. Written by make-samples.\nmtllib teapot.mtl\n";
        mtl_ << "# The colours of teapot.obj. Written by make-samples.\n";
    }

    void startObject(const char* name) { obj_ << "o " << name << "\n"; }

    void write(const Part& part) {
        mtl_ << "newmtl " << part.name << "\nKd " << fixed(part.colour.cast<double>(), 2, " ") << "\n";
        obj_ << "g " << part.name << "\nusemtl " << part.name << "\n";
        for (std::size_t i = 0; i <= part.rings; ++i)
            for (std::size_t k = 0; k < pointsOf(part, i); ++k) {
                const double u = double(i) / double(part.rings), v = double(k) / double(part.segments);
                const bool pole = pointsOf(part, i) == 1;
                const double inside = std::clamp(u, 1e-3, 1 - 1e-3); // where a normal can be found
                obj_ << "v " << fixed(yUp(part.point(u, v)), 6, " ") << "\nvn "
                     << fixed(yUp(pole ? poleNormal(part, inside) : part.normal(u, v)), 4, " ") << "\n";
            }
        for (std::size_t i = 0; i < part.rings; ++i)
            writeBand(part, i);
        first_ += 2 + (part.rings - 1) * part.segments;
    }

    bool good() { return obj_.flush().good() && mtl_.flush().good(); }

private:
    static std::size_t pointsOf(const Part& part, std::size_t ring) {
        return ring == 0 || ring == part.rings ? 1 : part.segments;
    }
    static Vec3 poleNormal(const Part& part, double u) {
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = 0; k < part.segments; ++k)
            sum += part.normal(u, double(k) / double(part.segments));
        return sum.normalized();
    }

    void writeBand(const Part& part, std::size_t ring) {
        for (std::size_t k = 0; k < part.segments; ++k) {
            const std::size_t a = number(part, ring, k), b = number(part, ring, k + 1);
            const std::size_t c = number(part, ring + 1, k + 1), d = number(part, ring + 1, k);
            if (a != b) writeTriangle(a, b, c);
            if (c != d) writeTriangle(a, c, d);
        }
    }
    std::size_t number(const Part& part, std::size_t ring, std::size_t k) const {
        if (ring == 0) return first_;
        const std::size_t before = first_ + 1 + (ring - 1) * part.segments;
        return ring == part.rings ? before : before + k % part.segments;
    }
    void writeTriangle(std::size_t a, std::size_t b, std::size_t c) {
        obj_ << "f " << a << "//" << a << " " << b << "//" << b << " " << c << "//" << c << "\n";
    }

    std::ofstream obj_, mtl_;
    std::size_t first_ = 1;
};

/// Where the finger is at a time: on a part, at a depth under its surface (negative: above it).
struct Key {
    double t; ///< s
    const Part* part;
    double u, v;
    double depth; ///< mm
};

Vec3 fingerAt(const Part& part, double u, double v, double depth) {
    return part.point(u, v) - 1e-3 * depth * part.normal(u, v);
}

/// Along the surface between keys of one part, straight through the air between keys of two.
Vec3 finger(const std::vector<Key>& keys, double t) {
    const auto next =
        std::find_if(keys.begin() + 1, keys.end() - 1, [&](const Key& key) { return key.t >= t; });
    const Key &a = *(next - 1), &b = *next;
    const double x = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0), s = x * x * (3 - 2 * x);
    if (a.part != b.part)
        return (1 - s) * fingerAt(*a.part, a.u, a.v, a.depth) + s * fingerAt(*b.part, b.u, b.v, b.depth);
    return fingerAt(*a.part, std::lerp(a.u, b.u, s), std::lerp(a.v, b.v, s), std::lerp(a.depth, b.depth, s));
}

/// Approach, press the body and release, stroke it, stroke the lid, stroke the spout, press, leave. 8 s at 1
/// kHz.
bool writeFinger(const std::filesystem::path& file) {
    const Part pot = body(), cover = lid(), snout = spout();
    const std::vector<Key> keys{
        {0.0, &pot, 0.48, 0.72, -50},   {0.7, &pot, 0.48, 0.72, 0},     {1.0, &pot, 0.48, 0.72, 4},
        {1.3, &pot, 0.48, 0.72, 1.5},   {2.0, &pot, 0.44, 0.84, 3},     {2.8, &pot, 0.60, 0.92, 2.5},
        {3.1, &pot, 0.60, 0.92, -12},   {3.6, &cover, 0.44, 0.92, -12}, {3.8, &cover, 0.44, 0.92, 2},
        {4.6, &cover, 0.46, 0.58, 4},   {5.2, &cover, 0.40, 0.85, 3},   {5.4, &cover, 0.40, 0.90, -12},
        {5.9, &snout, 0.45, 0.62, -12}, {6.1, &snout, 0.45, 0.62, 2},   {6.8, &snout, 0.58, 0.56, 3},
        {7.2, &snout, 0.54, 0.60, 4},   {7.5, &snout, 0.53, 0.60, 0},   {8.0, &snout, 0.53, 0.60, -40}};
    std::ofstream out(file, std::ios::binary);
    out << "t,x,y,z\n";
    for (int row = 0; row <= 8000; ++row) {
        const double t = row * 1e-3;
        out << fixed(t, 3) << "," << fixed(yUp(finger(keys, t)), 7, ",") << "\n";
    }
    return out.flush().good();
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: make-samples FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    ObjWriter obj(folder);
    obj.startObject("teapot");
    for (const Part& part : {body(), lid(), spout(), handle()})
        obj.write(part);
    obj.startObject("table");
    obj.write(table());
    if (obj.good() && writeFinger(folder / "teapot-finger.csv")) return 0;
    std::cerr << "make-samples: cannot write into " << folder
              << "; check the folder and the space on its disk\n";
    return 3;
}
