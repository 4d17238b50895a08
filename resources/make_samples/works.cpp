#include "resources/make_samples/works.h"

#include <numbers>

#include "core/dynamics/weigh.h"
#include "resources/make_samples/finger.h"

namespace tactum::samples {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kSides = 24; // of what is round

/// Rings around y from (radius, height) to (radius, height); their first and last have radius 0.
void lathe(Mesh& mesh, const Pose& pose, const std::vector<std::array<double, 2>>& profile) {
    std::vector<std::vector<Index>> rings;
    for (const auto& [radius, height] : profile) {
        std::vector<Index>& ring = rings.emplace_back();
        for (int i = 0; i < (radius > 0 ? kSides : 1); ++i) {
            const double a = kTurn * i / kSides;
            ring.push_back(mesh.point(pose.apply({radius * std::cos(a), height, -radius * std::sin(a)})));
        }
    }
    const auto at = [](const std::vector<Index>& ring, int i) { return ring[std::size_t(i) % ring.size()]; };
    for (std::size_t r = 0; r + 1 < rings.size(); ++r)
        for (int i = 0; i < kSides; ++i) {
            const std::vector<Index>&low = rings[r], &high = rings[r + 1];
            if (low.size() > 1) mesh.triangle(at(low, i), at(low, i + 1), at(high, i));
            if (high.size() > 1) mesh.triangle(at(low, i + 1), at(high, i + 1), at(high, i));
        }
}

/// Half circles from the bottom to the top; between them it is straight.
std::vector<std::array<double, 2>> roundEnds(double radius, double height) {
    constexpr int kRings = 12;
    std::vector<std::array<double, 2>> profile;
    for (int i = 0; i <= kRings; ++i) {
        const double a = std::numbers::pi * (double(i) / kRings - 0.5);
        const bool end = i == 0 || i == kRings;
        const double middle = i == kRings / 2 ? 0 : (i < kRings / 2 ? -height : height) / 2;
        if (i == kRings / 2 && height > 0) {
            profile.push_back({radius, -height / 2}), profile.push_back({radius, height / 2});
            continue;
        }
        profile.push_back({end ? 0 : radius * std::cos(a), middle + radius * std::sin(a)});
    }
    return profile;
}

void draw(Mesh& mesh, const Piece& piece) {
    const ColliderShape& shape = piece.shape;
    const double r = shape.radius, h = shape.height / 2;
    if (shape.kind == ShapeKind::Sphere) return lathe(mesh, piece.pose, roundEnds(r, 0));
    if (shape.kind == ShapeKind::Capsule) return lathe(mesh, piece.pose, roundEnds(r, 2 * h));
    if (shape.kind == ShapeKind::Cylinder) return lathe(mesh, piece.pose, {{0, -h}, {r, -h}, {r, h}, {0, h}});
    mesh.box(-shape.size / 2, shape.size / 2, piece.pose);
}

} // namespace

Piece block(const Vec3& size, const Vec3& at) {
    Piece piece;
    piece.shape.kind = ShapeKind::Box, piece.shape.size = size;
    piece.pose.translation = at;
    return piece;
}

Piece rod(double radius, double height, const Vec3& at) {
    Piece piece;
    piece.shape.kind = ShapeKind::Cylinder, piece.shape.height = height;
    piece.shape.radius = piece.shape.radiusBottom = radius;
    piece.pose.translation = at;
    return piece;
}

Piece capsule(double radius, double height, const Vec3& at) {
    Piece piece = rod(radius, height, at);
    piece.shape.kind = ShapeKind::Capsule;
    return piece;
}

Piece globe(double radius, const Vec3& at) {
    Piece piece = rod(radius, 0.5, at);
    piece.shape.kind = ShapeKind::Sphere;
    return piece;
}

Piece turned(Piece piece, double degrees, const Vec3& axis) {
    piece.pose.rotation = Quat(Eigen::AngleAxisd(degrees * kTurn / 360, axis.normalized()));
    return piece;
}

Pose Works::poseOf(BodyId body) const {
    return body == kWorldBody ? Pose{} : scene_.mechanics.bodies[body - 1].pose;
}

void Works::show(BodyId body, const std::string& name, const Look& look, const std::vector<Piece>& pieces) {
    Mesh mesh;
    for (const Piece& piece : pieces)
        draw(mesh, piece);
    SceneObject& made = scene_.add(object(name, mesh, {surface(name, look.colour, look.material)}));
    made.body = body;
    made.pose = poseOf(body);
}

void Works::collide(BodyId body, std::uint32_t part, const std::vector<Piece>& pieces) {
    for (const Piece& piece : pieces) {
        Collider collider;
        collider.body = body, collider.part = part;
        collider.pose = piece.pose, collider.shape = piece.shape;
        collider.material = {0.4, 0.3, 0.2};
        scene_.mechanics.colliders.push_back(std::move(collider));
    }
}

std::uint32_t Works::still(const std::string& name, const Look& look, const std::vector<Piece>& pieces) {
    show(kWorldBody, name, look, pieces);
    collide(kWorldBody, ++parts_, pieces);
    return parts_;
}

BodyId Works::body(const std::string& name, const Pose& at, double density, const Look& look,
                   const std::vector<Piece>& pieces) {
    RigidBody body;
    body.id = BodyId(scene_.mechanics.bodies.size() + 1);
    body.name = name, body.pose = at;
    ShapeMass mass;
    for (const Piece& piece : pieces)
        mass = together(mass, placed(massOf(piece.shape), piece.pose));
    weigh(body, mass, density * mass.volume);
    scene_.mechanics.bodies.push_back(body);
    show(body.id, name, look, pieces);
    collide(body.id, 0, pieces);
    return body.id;
}

void Works::scale(double size, double mass, double force, double time) {
    Mechanics& mechanics = scene_.mechanics;
    mechanics.gravity *= size;
    mechanics.forceScale = force, mechanics.timeScale = time;
    for (RigidBody& body : mechanics.bodies)
        body.mass *= mass, body.inertia *= mass;
}

void Works::trim(BodyId body, const std::string& name, const Look& look, const std::vector<Piece>& pieces) {
    show(body, name, look, pieces);
}

void Works::decor(const std::string& name, const Look& look, const Mesh& mesh) {
    scene_.add(object(name, mesh, {surface(name, look.colour, look.material)}));
}

Joint& Works::ride(const std::string& name, BodyId b, const JointPath& path) {
    Joint joint;
    joint.name = name, joint.b = b, joint.path = path;
    return scene_.mechanics.joints.emplace_back(std::move(joint));
}

Joint& Works::joint(const std::string& name, BodyId a, BodyId b, const Pose& at, std::uint32_t part) {
    Joint joint;
    joint.name = name, joint.a = a, joint.b = b, joint.part = part;
    joint.frameA = poseOf(a).inverse() * at;
    joint.frameB = poseOf(b).inverse() * at;
    JointLimit held;
    held.min = held.max = 0;
    joint.limits.push_back(held);
    return scene_.mechanics.joints.emplace_back(std::move(joint));
}

Joint& Works::hinge(const std::string& name, BodyId a, BodyId b, const Vec3& at, const Vec3& axis,
                    std::uint32_t part) {
    Joint& made = joint(name, a, b, {Quat::FromTwoVectors(Vec3::UnitX(), axis), at}, part);
    JointLimit held;
    held.angular = true, held.axes = 6, held.min = held.max = 0;
    made.limits.push_back(held);
    return made;
}

Joint& Works::slider(const std::string& name, BodyId a, BodyId b, const Vec3& at, const Vec3& axis,
                     std::uint32_t part) {
    Joint& made = joint(name, a, b, {Quat::FromTwoVectors(Vec3::UnitX(), axis), at}, part);
    made.limits[0].axes = 6;
    JointLimit held = made.limits[0];
    held.angular = true, held.axes = kAllAxes;
    made.limits.push_back(held);
    return made;
}

Joint& Works::ball(const std::string& name, BodyId a, BodyId b, const Vec3& at, std::uint32_t part) {
    return joint(name, a, b, {Quat::Identity(), at}, part);
}

Scene Works::take(std::span<const FingerKey> keys) {
    scene_.finger = fingerPath(keys, [](const Vec3& p) { return p; });
    return std::move(scene_);
}

Scene Works::take(double seconds, const std::function<Vec3(double t)>& finger) {
    scene_.finger = fingerPath(seconds, finger);
    return std::move(scene_);
}

JointLimit within(bool angular, double min, double max) {
    JointLimit limit;
    limit.angular = angular, limit.axes = 1;
    limit.min = min, limit.max = max;
    return limit;
}

JointDrive spring(bool angular, double stiffness, double damping, double position) {
    JointDrive drive;
    drive.angular = angular;
    drive.stiffness = stiffness, drive.damping = damping, drive.position = position;
    return drive;
}

JointDrive motor(bool angular, double velocity, double damping, double most) {
    JointDrive drive;
    drive.angular = angular;
    drive.velocity = velocity, drive.damping = damping, drive.maxForce = most;
    return drive;
}

JointDrive detents(bool angular, double spacing, double force) {
    JointDrive drive = spring(angular, force * kTurn / spacing, 0);
    drive.spacing = spacing;
    return drive;
}

} // namespace tactum::samples
