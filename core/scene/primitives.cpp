#include "core/scene/primitives.h"

#include <cmath>
#include <numbers>

namespace tactum {
namespace {

constexpr int kAround = 96; // facets of what is round: 0.02 mm beside the circle of a hand's size

/// Of one side after the other, a grid of corners that others may share.
class Sides {
public:
    Index vertex(const Vec3& p) {
        soup_.positions.push_back(p);
        return Index(soup_.positions.size() - 1);
    }
    struct Corner {
        Index vertex;
        Vec3 normal;
        Eigen::Vector2f uv;
    };
    void add(const Corner& a, const Corner& b, const Corner& c) {
        soup_.triangles.push_back({a.vertex, b.vertex, c.vertex});
        soup_.surfaceOf.push_back(0);
        for (const Corner* each : {&a, &b, &c}) {
            soup_.cornerNormals.push_back(each->normal.cast<float>());
            soup_.cornerUvs.push_back(each->uv);
        }
    }
    void add(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
        add(a, b, c);
        add(a, c, d);
    }
    TriangleSoup take() { return std::move(soup_); }

private:
    TriangleSoup soup_;
};

TriangleSoup boxSoup(const Vec3& size) {
    Sides sides;
    for (unsigned i = 0; i < 8; ++i)
        sides.vertex(0.5 * size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    struct Side {
        std::array<Index, 4> corners; ///< from outside, from its lower left on, counter-clockwise
        Vec3 normal;
    };
    const std::array<Side, 6> all{{{{5, 1, 3, 7}, Vec3::UnitX()},
                                   {{0, 4, 6, 2}, -Vec3::UnitX()},
                                   {{6, 7, 3, 2}, Vec3::UnitY()},
                                   {{0, 1, 5, 4}, -Vec3::UnitY()},
                                   {{4, 5, 7, 6}, Vec3::UnitZ()},
                                   {{1, 0, 2, 3}, -Vec3::UnitZ()}}};
    for (const auto& [corners, normal] : all)
        sides.add({corners[0], normal, {0, 0}}, {corners[1], normal, {1, 0}}, {corners[2], normal, {1, 1}},
                  {corners[3], normal, {0, 1}});
    return sides.take();
}

/// Toward a place around y, from z over x as a map is seen from outside.
Vec3 around(int i) {
    const double angle = 2 * std::numbers::pi * (i % kAround) / kAround;
    return {std::sin(angle), 0, std::cos(angle)};
}

TriangleSoup sphereSoup(double radius) {
    constexpr int kRings = kAround / 2; // from pole to pole
    Sides sides;
    const auto normalAt = [](int ring, int i) {
        const double up = std::numbers::pi * (double(ring) / kRings - 0.5);
        return Vec3(std::cos(up) * around(i) + std::sin(up) * Vec3::UnitY());
    };
    const Index south = sides.vertex(-radius * Vec3::UnitY()), north = sides.vertex(radius * Vec3::UnitY());
    for (int ring = 1; ring < kRings; ++ring)
        for (int i = 0; i < kAround; ++i)
            sides.vertex(radius * normalAt(ring, i));
    const auto corner = [&](int ring, int i) {
        const Index vertex = north + 1 + Index((ring - 1) * kAround + i % kAround);
        return Sides::Corner{vertex, normalAt(ring, i), {float(i) / kAround, float(ring) / kRings}};
    };
    for (int i = 0; i < kAround; ++i) {
        const float middle = (float(i) + 0.5f) / kAround;
        sides.add({south, -Vec3::UnitY(), {middle, 0}}, corner(1, i + 1), corner(1, i));
        for (int ring = 1; ring + 1 < kRings; ++ring)
            sides.add(corner(ring, i), corner(ring, i + 1), corner(ring + 1, i + 1), corner(ring + 1, i));
        sides.add(corner(kRings - 1, i), corner(kRings - 1, i + 1), {north, Vec3::UnitY(), {middle, 1}});
    }
    return sides.take();
}

TriangleSoup cylinderSoup(double radius, double height) {
    Sides sides;
    const Vec3 up = 0.5 * height * Vec3::UnitY();
    const Index below = sides.vertex(-up), above = sides.vertex(up);
    for (const double side : {-1.0, 1.0})
        for (int i = 0; i < kAround; ++i)
            sides.vertex(radius * around(i) + side * up);
    const auto vertex = [&](int ring, int i) { return above + 1 + Index(ring * kAround + i % kAround); };
    const auto wall = [&](int ring, int i) {
        return Sides::Corner{vertex(ring, i), around(i), {float(i) / kAround, float(ring)}};
    };
    const auto lid = [&](int ring, int i) {
        const Vec3 to = around(i);
        const double side = ring == 0 ? -1 : 1;
        return Sides::Corner{vertex(ring, i),
                             side * Vec3::UnitY(),
                             {float(0.5 + 0.5 * to.x()), float(0.5 - 0.5 * side * to.z())}};
    };
    for (int i = 0; i < kAround; ++i) {
        sides.add(wall(0, i), wall(0, i + 1), wall(1, i + 1), wall(1, i));
        sides.add({below, -Vec3::UnitY(), {0.5f, 0.5f}}, lid(0, i + 1), lid(0, i));
        sides.add({above, Vec3::UnitY(), {0.5f, 0.5f}}, lid(1, i), lid(1, i + 1));
    }
    return sides.take();
}

struct Form {
    const char* name;
    TriangleSoup soup;
    bool round;
};

Form formOf(Primitive primitive) {
    switch (primitive) {
    case Primitive::Sphere:
        return {"Sphere", sphereSoup(0.03), true};
    case Primitive::Cylinder:
        return {"Cylinder", cylinderSoup(0.03, 0.08), true};
    case Primitive::Plate:
        return {"Plate", boxSoup({0.12, 0.008, 0.12}), false};
    case Primitive::Ground:
        return {"Ground", boxSoup({0.32, 0.01, 0.32}), false};
    case Primitive::Box:
        break;
    }
    return {"Box", boxSoup({0.06, 0.06, 0.06}), false};
}

} // namespace

Scene sceneOf(Primitive primitive) {
    Form form = formOf(primitive);
    SceneObject object;
    object.name = form.name;
    object.geometry = std::make_shared<const TriangleSoup>(std::move(form.soup));
    Surface surface;
    surface.name = form.name;
    surface.shading.on = form.round;
    object.surfaces.push_back(std::move(surface));
    if (primitive == Primitive::Ground) object.pose.translation.y() = -0.005; // things stand on y = 0
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

} // namespace tactum
