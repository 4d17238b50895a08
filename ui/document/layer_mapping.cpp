#include "ui/document/layer_mapping.h"

#include <cmath>

namespace tactum {

namespace {

struct Shape {
    Bounds box;
    Vec3 normal = Vec3::Zero(); ///< sum over the area
    double area = 0;            ///< twice
};

Shape shapeOf(const TriangleSoup& soup, Index surface) {
    Shape shape;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (soup.surfaceOf[i] != surface) continue;
        const auto& t = soup.triangles[i];
        const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
        for (const Vec3& p : {a, b, c})
            shape.box.add(p);
        const Vec3 normal = (b - a).cross(c - a);
        shape.normal += normal;
        shape.area += normal.norm();
    }
    return shape;
}

/// z along the normal, y as upright as it can be.
Quat facing(const Vec3& normal) {
    const Vec3 z = normal.normalized();
    const Vec3 up = std::abs(z.y()) < 0.9 ? Vec3::UnitY() : Vec3(-Vec3::UnitZ());
    Mat3 axes;
    axes.col(2) = z;
    axes.col(0) = up.cross(z).normalized();
    axes.col(1) = z.cross(axes.col(0));
    return Quat(axes).normalized();
}

/// Of the corners from the axis of the frame, or from its origin.
double meanDistance(const TriangleSoup& soup, Index surface, const Pose& frame, bool fromAxis) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        if (soup.surfaceOf[i] != surface) continue;
        for (const Index corner : soup.triangles[i]) {
            const Vec3 p = frame.applyInverse(soup.positions[corner]);
            sum += fromAxis ? p.head<2>().norm() : p.norm();
            ++count;
        }
    }
    return count > 0 ? sum / count : 0;
}

} // namespace

TexturePattern fitted(TexturePattern pattern, const TriangleSoup& soup, Index surface) {
    constexpr double kOneSided = 0.3; // a surface that looks to all sides has no normal to look along
    if (usesUvs(pattern)) return pattern;
    const Shape shape = shapeOf(soup, surface);
    if (shape.box.empty()) return pattern;
    pattern.frame = {Quat::Identity(), shape.box.centre()};
    switch (pattern.mapping) {
    case TextureMapping::Planar:
        if (shape.normal.norm() > kOneSided * shape.area) pattern.frame.rotation = facing(shape.normal);
        break;
    case TextureMapping::Cylindrical:
    case TextureMapping::Spherical:
        pattern.frame.rotation = facing(Vec3::UnitY());
        pattern.radius = kTextureRadius.clamped(
            meanDistance(soup, surface, pattern.frame, pattern.mapping == TextureMapping::Cylindrical));
        break;
    default:
        break;
    }
    return pattern;
}

} // namespace tactum
