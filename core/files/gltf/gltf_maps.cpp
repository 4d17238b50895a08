#include "core/files/gltf/gltf_maps.h"

#include <algorithm>
#include <cmath>

#include "core/files/images/write_png.h"
#include "core/surface/texture_stack.h"

namespace tactum {
namespace {

/// From -1 to 1.
std::uint16_t channel(double x) {
    return std::uint16_t(std::lround(65535 * std::clamp(0.5 + 0.5 * x, 0.0, 1.0)));
}

/// m per texel of one row or column: from neighbour to neighbour, at an edge from the texel itself.
template <class HeightAt> double slopeAt(int i, int count, double pitch, const HeightAt& heightAt) {
    const int before = std::max(i - 1, 0), after = std::min(i + 1, count - 1);
    return before == after ? 0 : (heightAt(after) - heightAt(before)) / ((after - before) * pitch);
}

/// The directions in which u and v rise, summed over the triangles around a vertex.
struct Frame {
    Vec3 u = Vec3::Zero(), v = Vec3::Zero();
};

void addTriangle(const DrawnMesh& mesh, const std::uint32_t* t, std::vector<Frame>& frames) {
    const auto place = [&](int i) -> Vec3 { return mesh.positions[t[i]].cast<double>(); };
    const auto uv = [&](int i) -> Eigen::Vector2d { return mesh.trueUvs[t[i]].cast<double>(); };
    const Vec3 b = place(1) - place(0), c = place(2) - place(0);
    const Eigen::Vector2d p = uv(1) - uv(0), q = uv(2) - uv(0);
    const double area = p.x() * q.y() - p.y() * q.x();
    const Vec3 alongU = (b * q.y() - c * p.y()) / area, alongV = (c * p.x() - b * q.x()) / area;
    if (!alongU.allFinite() || !alongV.allFinite()) return; // no area in texture coordinates
    const double weight = b.cross(c).norm();
    for (int i = 0; i < 3; ++i) {
        frames[t[i]].u += weight * alongU.normalized();
        frames[t[i]].v += weight * alongV.normalized();
    }
}

/// Where the coordinates say nothing, any direction along the surface.
Eigen::Vector4f tangentOf(const Frame& frame, const Vec3& normal) {
    Vec3 along = frame.u - frame.u.dot(normal) * normal;
    if (!(along.norm() > 1e-6 * frame.u.norm())) along = normal.unitOrthogonal();
    along.normalize();
    if (!along.allFinite()) along = Vec3::UnitX();
    const float side = normal.cross(along).dot(frame.v) < 0 ? -1.0F : 1.0F;
    return {float(along.x()), float(along.y()), float(along.z()), side};
}

bool liesOnUvs(const TextureLayer& layer) {
    return usesUvs(layer.pattern) && (!layer.mask || usesUvs(*layer.mask));
}

/// The first surface whose picture is that of this one, but for rounding: often only colours differ.
Index firstLike(const SceneObject& object, Index surface) {
    const auto& layers = object.surfaces[surface].layers;
    if (object.geometry->cornerUvs.empty() ||
        !std::ranges::all_of(layers, [](auto& layer) { return liesOnUvs(layer); }))
        return surface;
    const UvCanvas canvas = uvRectangleOf(*object.geometry, surface);
    const double metres = metresPerUvOf(*object.geometry, surface);
    for (Index other = 0; other < surface; ++other) {
        if (!(object.surfaces[other].layers == layers)) continue;
        const UvCanvas its = uvRectangleOf(*object.geometry, other);
        if (its.low == canvas.low && its.size == canvas.size &&
            std::abs(metresPerUvOf(*object.geometry, other) - metres) <= 1e-6 * metres)
            return other;
    }
    return surface;
}

} // namespace

const FlatPicture& SurfaceMaps::height(const SceneObject& object, Index asked) {
    const Index surface = firstLike(object, asked);
    const auto [found, isNew] = heights_.try_emplace({&object, surface});
    if (isNew) found->second = flattenHeight(object, surface, how_);
    return found->second;
}

FlatPicture SurfaceMaps::felt(const SceneObject& object, Index surface, double Material::*value) const {
    return flattenFelt(object, surface, value, how_);
}

std::string SurfaceMaps::normalsPng(const SceneObject& object, Index surface) {
    const FlatPicture& picture = height(object, surface);
    const double metres = metresPerUvOf(*object.geometry, firstLike(object, surface));
    if (!picture.image || metres <= 0) return {};
    const auto& level = picture.image->level(0);
    const auto heightAt = [&](int x, int y) {
        return picture.low + picture.image->texel(level, x, y) * (picture.high - picture.low);
    };
    const double pitchX = metres * picture.canvas.size.x() / level.width,
                 pitchY = metres * picture.canvas.size.y() / level.height;
    std::vector<std::uint16_t> values;
    values.reserve(3 * picture.canvas.texels());
    for (int y = level.height; y-- > 0;) // its first row is the lowest
        for (int x = 0; x < level.width; ++x) {
            const Vec3 normal =
                Vec3(-slopeAt(x, level.width, pitchX, [&](int i) { return heightAt(i, y); }),
                     -slopeAt(y, level.height, pitchY, [&](int i) { return heightAt(x, i); }), 1)
                    .normalized();
            for (const double value : normal)
                values.push_back(channel(value));
        }
    return encodePng(level.width, level.height, 3, 8, values, how_.progress);
}

bool canShowBumps(const SceneObject& object) {
    const auto hasHeight = [](const Surface& surface) {
        return std::ranges::any_of(surface.layers, [](const TextureLayer& layer) {
            return layer.enabled && layer.target == TextureTarget::Height;
        });
    };
    return object.geometry && !object.geometry->cornerNormals.empty() &&
           !object.geometry->cornerUvs.empty() && std::ranges::any_of(object.surfaces, hasHeight);
}

std::vector<Eigen::Vector4f> tangentsOf(const DrawnMesh& mesh) {
    std::vector<Frame> frames(mesh.positions.size());
    for (const DrawnPart& part : mesh.parts)
        for (std::size_t i = 0; part.corners == 3 && i + 2 < part.vertices.size(); i += 3)
            addTriangle(mesh, part.vertices.data() + i, frames);
    std::vector<Eigen::Vector4f> tangents;
    tangents.reserve(frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i)
        tangents.push_back(tangentOf(frames[i], mesh.normals[i].cast<double>()));
    return tangents;
}

} // namespace tactum
