// Bodies, joints and colliders at random that use every value an author can set. They need not be able to
// move.
#pragma once

#include <random>

#include "core/scene/scene.h"

namespace tactum::test {

/// As a file gives them back: bodies are numbered from 1, colliders of the world by what they stand still
/// with.
class MechanicsDice {
public:
    explicit MechanicsDice(std::mt19937& random) : random_(random) {}

    /// Some of the scene's objects move with bodies, those of one body in a row.
    void addTo(Scene& scene) {
        Mechanics& to = scene.mechanics;
        const int bodies = count(1, 4);
        for (int i = 1; i <= bodies; ++i)
            to.bodies.push_back(body(BodyId(i)));
        BodyId next = 1;
        for (SceneObject& object : scene.objects) {
            const bool moves = next <= BodyId(bodies) && chance(2);
            if (moves) object.body = next;
            if (!moves || chance(2)) ++next;
        }
        for (int i = count(0, 5); i > 0; --i)
            to.colliders.push_back(collider(bodies));
        for (int i = count(0, 4); i > 0; --i)
            to.joints.push_back(joint(bodies));
        to.gravity = vector(10);
        if (chance(2)) to.airDensity = 1000 * unit();
        if (chance(2)) to.forceScale = 10 * length(), to.timeScale = length();
    }

private:
    int count(int low, int high) { return low + int(random_() % unsigned(high - low + 1)); }
    bool chance(unsigned oneIn) { return random_() % oneIn == 0; }
    double unit() { return double(random_()) / double(std::mt19937::max()); }
    double length() { return 0.01 + unit(); }
    double bound() { return chance(2) ? kUnbounded : length(); }
    Vec3 vector(double size) {
        const double x = unit(), y = unit(), z = unit();
        return size * (Vec3(2 * x, 2 * y, 2 * z) - Vec3::Ones());
    }
    Pose pose() {
        const Vec3 v = vector(1), at = vector(0.5);
        return {chance(4) ? Quat::Identity() : Quat(0.1 + unit(), v.x(), v.y(), v.z()).normalized(), at};
    }

    RigidBody body(BodyId id) {
        RigidBody body;
        body.id = id;
        body.name = "body " + std::to_string(id);
        body.pose = pose();
        body.mass = chance(5) ? 0 : length();
        body.centre = vector(0.1);
        body.inertia = vector(0.01).cwiseAbs();
        body.inertiaFrame = pose().rotation;
        if (chance(2)) body.velocity = vector(1);
        if (chance(2)) body.angularVelocity = vector(20);
        body.gravityFactor = 2 * unit() - 0.5;
        body.kinematic = chance(4);
        return body;
    }

    ColliderShape shape() {
        ColliderShape shape;
        shape.kind = ShapeKind(count(0, 6));
        switch (shape.kind) {
        case ShapeKind::Box:
            shape.size = {length(), length(), length()};
            break;
        case ShapeKind::Sphere:
            shape.radius = shape.radiusBottom = length();
            break;
        case ShapeKind::Plane:
            shape.size = {bound(), 0, bound()};
            break;
        case ShapeKind::Hull:
        case ShapeKind::Mesh:
            shape.mesh = mesh(shape.kind == ShapeKind::Mesh || chance(2));
            break;
        default:
            shape.radius = length(), shape.radiusBottom = length(), shape.height = length();
        }
        return shape;
    }
    std::shared_ptr<const ShapeMesh> mesh(bool faces) {
        ShapeMesh mesh;
        for (int i = count(4, 12); i > 0; --i)
            mesh.points.push_back(vector(0.1));
        if (faces)
            for (std::uint32_t i = 0; i + 2 < mesh.points.size(); ++i)
                mesh.faces.push_back({i, i + 1, i + 2});
        return std::make_shared<const ShapeMesh>(std::move(mesh));
    }

    Collider collider(int bodies) {
        Collider collider;
        collider.body = BodyId(count(0, bodies));
        collider.pose = pose();
        collider.shape = shape();
        TouchMaterial& material = collider.material;
        material = {unit(), unit(), unit(), Combine(count(0, 3)), Combine(count(0, 3))};
        if (chance(3)) collider.filter = {{"a", "b"}, {"c"}, {}};
        if (chance(5)) collider.filter.with = {"a"};
        if (collider.body == kWorldBody) {
            const bool known = parts_ > 0 && chance(3);
            collider.part = known ? std::uint32_t(count(1, int(parts_))) : ++parts_;
        }
        return collider;
    }

    JointLimit limit() {
        JointLimit limit;
        limit.angular = chance(2);
        limit.axes = AxisSet(count(1, 7));
        limit.min = -bound(), limit.max = bound();
        if (chance(3)) limit.min = limit.max = 0;
        limit.stiffness = bound();
        limit.damping = chance(2) ? 0 : unit();
        return limit;
    }
    /// On a wavy ring, so that it is one that can be ridden on.
    JointPath path() {
        JointPath path;
        const int points = count(5, 20);
        const bool hasUps = chance(2);
        path.closed = chance(2);
        for (int i = 0; i < points; ++i) {
            const double a = 6 * double(i) / points;
            path.points.push_back(Vec3(std::cos(a), 0.1 * unit(), std::sin(a)));
            if (hasUps) path.ups.push_back(Vec3(0.1 * unit(), 1, 0.1 * unit()));
        }
        return path;
    }
    Joint joint(int bodies) {
        Joint joint;
        joint.name = "joint " + std::to_string(count(0, 99));
        joint.a = BodyId(count(0, bodies));
        do
            joint.b = BodyId(count(0, bodies));
        while (joint.b == joint.a);
        joint.frameA = pose(), joint.frameB = pose();
        for (int i = count(0, 3); i > 0; --i)
            joint.limits.push_back(limit());
        for (int i = count(0, 2); i > 0; --i)
            joint.drives.push_back(
                {chance(2), count(0, 2), unit(), unit(), unit() - 0.5, unit() - 0.5, bound(), chance(2)});
        for (int i = count(0, 2); i > 0; --i) // in the file behind the others
            joint.drives.push_back(
                {chance(2), count(0, 2), unit(), unit(), unit(), 0, bound(), false, length()});
        for (int i = count(0, 2); i > 0; --i)
            joint.frictions.push_back({chance(2), count(0, 2), unit()});
        if (chance(3)) joint.path = path();
        joint.collide = chance(2);
        if (joint.a == kWorldBody || joint.b == kWorldBody) joint.part = std::uint32_t(count(0, int(parts_)));
        return joint;
    }

    std::mt19937& random_;
    std::uint32_t parts_ = 0;
};

} // namespace tactum::test
