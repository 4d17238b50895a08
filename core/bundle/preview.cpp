#include "core/bundle/preview.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/files/images/write_png.h"
#include "core/surface/smooth_normals.h"

namespace tactum {
namespace {

// World axes as the picture has them: x right, y up, z toward the eye. 35 degrees around y, 25 down.
Mat3 viewRotation() {
    return (Eigen::AngleAxisd(0.436, Vec3::UnitX()) * Eigen::AngleAxisd(-0.611, Vec3::UnitY()))
        .toRotationMatrix();
}

/// How bright it is where it has a normal, as the picture has it; its two sides look alike.
double lightOn(const Vec3& n) {
    static const Vec3 kLamp = Vec3(-0.3, 0.6, 0.74).normalized();
    return 0.15 + 0.85 * std::abs(n.dot(kLamp));
}

struct Corner {
    Vec3 place;  ///< in pixels, z toward the eye
    Vec3 normal; ///< as the picture has it; of any length
};

/// Light values from 0 to 1, and how near to the eye each pixel's surface is.
class Picture {
public:
    Picture(int width, int height)
        : width_(width), height_(height), colour_(std::size_t(width) * std::size_t(height), kBackground),
          depth_(colour_.size(), -std::numeric_limits<double>::infinity()) {}

    void draw(const std::array<Corner, 3>& corners, const Eigen::Vector3d& colour) {
        const std::array<Vec3, 3> t{corners[0].place, corners[1].place, corners[2].place};
        const double area = cross(t[1] - t[0], t[2] - t[0]);
        if (std::abs(area) < 1e-12) return;
        const auto [left, right] = range(t, 0, width_);
        const auto [top, bottom] = range(t, 1, height_);
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= right; ++x) {
                const Vec3 p(x + 0.5, y + 0.5, 0);
                const double b = cross(p - t[0], t[2] - t[0]) / area, c = cross(t[1] - t[0], p - t[0]) / area;
                if (b < 0 || c < 0 || b + c > 1) continue;
                const auto between = [&](auto Corner::*what) {
                    return ((1 - b - c) * corners[0].*what + b * corners[1].*what + c * corners[2].*what)
                        .eval();
                };
                put(x, y, between(&Corner::place).z(),
                    lightOn(between(&Corner::normal).normalized()) * colour);
            }
    }

    std::vector<std::uint16_t> values() const {
        std::vector<std::uint16_t> values;
        for (const Eigen::Vector3d& light : colour_)
            for (const double value : light) // from linear light to what a screen expects
                values.push_back(
                    std::uint16_t(std::lround(65535 * std::pow(std::clamp(value, 0.0, 1.0), 1 / 2.2))));
        return values;
    }

private:
    static inline const Eigen::Vector3d kBackground{0.035, 0.04, 0.05};

    static double cross(const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); }
    static std::pair<int, int> range(const std::array<Vec3, 3>& t, int axis, int size) {
        const auto [low, high] = std::minmax({t[0][axis], t[1][axis], t[2][axis]});
        return {int(std::clamp(low - 1, 0.0, double(size))),
                int(std::clamp(high + 1, -1.0, double(size - 1)))};
    }
    void put(int x, int y, double z, const Eigen::Vector3d& colour) {
        const std::size_t pixel = std::size_t(y) * std::size_t(width_) + std::size_t(x);
        if (z <= depth_[pixel]) return;
        depth_[pixel] = z;
        colour_[pixel] = colour;
    }

    int width_, height_;
    std::vector<Eigen::Vector3d> colour_;
    std::vector<double> depth_;
};

/// Three to a triangle, as it feels or as the file has them; empty where facets are flat.
std::vector<std::span<const Eigen::Vector3f>>
normalsOf(const SceneObject& object, std::vector<std::shared_ptr<const SmoothNormals>>& made) {
    std::vector<std::span<const Eigen::Vector3f>> normals;
    for (const Surface& surface : object.surfaces) {
        std::shared_ptr<const SmoothNormals> of;
        if (const auto compiled = compileNormals(surface.shading, object.geometry, made)) of = *compiled;
        normals.push_back(of ? of->corners : std::span(object.geometry->cornerNormals));
        if (of) made.push_back(of);
    }
    return normals;
}

} // namespace

Preview::Preview(const Scene& scene, int width, int height)
    : width_(width), height_(height), turn_(viewRotation()) {
    Bounds seen;
    for (const SceneObject& object : scene.objects)
        if (object.visible)
            for (const Vec3& p : object.geometry->positions)
                seen.add(turn_ * object.pose.apply(p));
    if (seen.empty()) return;
    centre_ = seen.centre();
    const Vec3 size = (seen.high - seen.low).cwiseMax(1e-9);
    scale_ = 0.9 * std::min(width / size.x(), height / size.y());
}

Vec3 Preview::pixel(const Vec3& world) const {
    const Vec3 p = scale_ * (turn_ * world - centre_);
    return {width_ / 2.0 + p.x(), height_ / 2.0 - p.y(), p.z()};
}

std::vector<std::uint16_t> Preview::draw(const Scene& scene) const {
    Picture picture(width_, height_);
    for (const SceneObject& object : scene.objects) {
        if (!object.visible) continue;
        const TriangleSoup& soup = *object.geometry;
        std::vector<std::shared_ptr<const SmoothNormals>> made;
        const auto normals = normalsOf(object, made);
        for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
            const Surface& surface = object.surfaces[soup.surfaceOf[f]];
            if (!surface.visible) continue;
            std::array<Vec3, 3> places;
            for (std::size_t i = 0; i < 3; ++i)
                places[i] = object.pose.apply(soup.positions[soup.triangles[f][i]]);
            const Vec3 flat = (places[1] - places[0]).cross(places[2] - places[0]);
            if (flat.norm() == 0) continue;
            const auto smooth = normals[soup.surfaceOf[f]];
            std::array<Corner, 3> corners;
            for (std::size_t i = 0; i < 3; ++i) {
                const Vec3 normal = smooth.empty()
                                        ? flat.normalized()
                                        : object.pose.rotate(smooth[3 * f + i].cast<double>().eval());
                corners[i] = {pixel(places[i]), turn_ * normal};
            }
            picture.draw(corners, surface.colour.cast<double>());
        }
    }
    return picture.values();
}

std::string previewOf(const Scene& scene, int width, int height) {
    return encodePng(width, height, 3, 8, Preview(scene, width, height).draw(scene));
}

} // namespace tactum
