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
#include "core/surface/texture_feel.h"

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
    Vec3 inBody; ///< body frame, m
    Vec3 normal; ///< body frame; of any length
};

/// A triangle of an object, as the picture has it.
struct Facet {
    std::array<Corner, 3> corners;
    Mat3 turn; ///< from the body frame to the picture's
    Eigen::Vector3d colour;
    const TriangleSoup& soup;
    Index index;
    const TextureStack* texture; ///< null: it is plain
    double finest;               ///< m: what is finer is not seen

    /// What it looks like where the corners weigh so much.
    Eigen::Vector3d light(const Vec3& weights) const {
        Vec3 normal = Vec3::Zero();
        for (std::size_t i = 0; i < 3; ++i)
            normal += weights[Eigen::Index(i)] * corners[i].normal;
        normal.normalize();
        if (texture) {
            const Triangle triangle{corners[0].inBody, corners[1].inBody, corners[2].inBody};
            const Vec3 place = weights[0] * triangle.a + weights[1] * triangle.b + weights[2] * triangle.c;
            const auto at = texturePointOn(soup, index, triangle, {place, weights}, normal);
            normal = bumpedNormal(normal, feel(*texture, at, finest).slope);
        }
        return lightOn(turn * normal) * colour;
    }
};

/// Light values from 0 to 1, and how near to the eye each pixel's surface is.
class Picture {
public:
    Picture(int width, int height)
        : width_(width), height_(height), colour_(std::size_t(width) * std::size_t(height), kBackground),
          depth_(colour_.size(), -std::numeric_limits<double>::infinity()) {}

    void draw(const Facet& facet) {
        const std::array<Vec3, 3> t{facet.corners[0].place, facet.corners[1].place, facet.corners[2].place};
        const double area = cross(t[1] - t[0], t[2] - t[0]);
        if (std::abs(area) < 1e-12) return;
        const auto [left, right] = range(t, 0, width_);
        const auto [top, bottom] = range(t, 1, height_);
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= right; ++x) {
                const Vec3 p(x + 0.5, y + 0.5, 0);
                const double b = cross(p - t[0], t[2] - t[0]) / area, c = cross(t[1] - t[0], p - t[0]) / area;
                if (b < 0 || c < 0 || b + c > 1) continue;
                const double z = (1 - b - c) * t[0].z() + b * t[1].z() + c * t[2].z();
                if (isNearest(x, y, z)) put(x, y, z, facet.light({1 - b - c, b, c}));
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
    std::size_t pixelAt(int x, int y) const { return std::size_t(y) * std::size_t(width_) + std::size_t(x); }
    bool isNearest(int x, int y, double z) const { return z > depth_[pixelAt(x, y)]; }
    void put(int x, int y, double z, const Eigen::Vector3d& colour) {
        depth_[pixelAt(x, y)] = z;
        colour_[pixelAt(x, y)] = colour;
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
        std::vector<std::shared_ptr<const TextureStack>> textures;
        for (std::size_t i = 0; i < object.surfaces.size(); ++i)
            textures.push_back(
                compileTextures(object.surfaces[i].layers, object.geometry, Index(i), textures));
        for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
            const Surface& surface = object.surfaces[soup.surfaceOf[f]];
            if (!surface.visible) continue;
            const auto& triangle = soup.triangles[f];
            const auto at = [&](std::size_t corner) { return soup.positions[triangle[corner]]; };
            const Vec3 flat = (at(1) - at(0)).cross(at(2) - at(0));
            if (flat.norm() == 0) continue;
            const auto smooth = normals[soup.surfaceOf[f]];
            std::array<Corner, 3> corners;
            for (std::size_t i = 0; i < 3; ++i)
                corners[i] = {pixel(object.pose.apply(at(i))), at(i),
                              smooth.empty() ? flat.normalized() : smooth[3 * f + i].cast<double>().eval()};
            picture.draw({corners, turn_ * object.pose.rotation.toRotationMatrix(),
                          surface.colour.cast<double>(), soup, Index(f), textures[soup.surfaceOf[f]].get(),
                          0.5 / scale_}); // half a pixel
        }
    }
    return picture.values();
}

std::string previewOf(const Scene& scene, int width, int height) {
    return encodePng(width, height, 3, 8, Preview(scene, width, height).draw(scene));
}

} // namespace tactum
