// Scenes of bodies that forces move: pieces, bodies made of them, joints between these.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "resources/make_samples/finger.h"
#include "resources/make_samples/mesh.h"

namespace tactum::samples {

/// A simple shape somewhere in a body: seen, felt, weighed, and what other bodies meet.
struct Piece {
    ColliderShape shape;
    Pose pose;
};
/// Round pieces stand along y, about the middle `at`.
Piece block(const Vec3& size, const Vec3& at = Vec3::Zero());
Piece rod(double radius, double height, const Vec3& at = Vec3::Zero());
Piece capsule(double radius, double height, const Vec3& at = Vec3::Zero());
Piece globe(double radius, const Vec3& at = Vec3::Zero());
Piece turned(Piece piece, double degrees, const Vec3& axis);

struct Look {
    Eigen::Vector3f colour;
    Material material{.stiffness = 800, .staticFriction = 0.4, .dynamicFriction = 0.3};
};

class Works {
public:
    /// A thing that stands still; its number for Joint::part.
    std::uint32_t still(const std::string& name, const Look& look, const std::vector<Piece>& pieces);
    /// One that moves, of even density in kg/m^3.
    BodyId body(const std::string& name, const Pose& at, double density, const Look& look,
                const std::vector<Piece>& pieces);
    /// Looks for the eye and the finger that no other body meets.
    void trim(BodyId body, const std::string& name, const Look& look, const std::vector<Piece>& pieces);
    /// A mesh that stands still, for the eye and the finger.
    void decor(const std::string& name, const Look& look, const Mesh& mesh);

    /// Joints at a place of the world; `part`: of the thing that it is fixed to, where `a` is the world.
    Joint& hinge(const std::string& name, BodyId a, BodyId b, const Vec3& at, const Vec3& axis,
                 std::uint32_t part = 0);
    Joint& slider(const std::string& name, BodyId a, BodyId b, const Vec3& at, const Vec3& axis,
                  std::uint32_t part = 0);
    Joint& ball(const std::string& name, BodyId a, BodyId b, const Vec3& at, std::uint32_t part = 0);

    /// A body on a curve of the world, where it is put at first.
    Joint& ride(const std::string& name, BodyId b, const JointPath& path);

    /// Drawn `size` times as large as it is, with a hand that feels its masses and times as HandScale says;
    /// the mass of each body is `mass` times what its drawn volume has. After all bodies.
    void scale(double size, double mass, double force, double time);

    /// The joint that was made last.
    Joint& last() { return scene_.mechanics.joints.back(); }

    Scene take(std::span<const FingerKey> keys);
    Scene take(double seconds, const std::function<Vec3(double t)>& finger);

private:
    Joint& joint(const std::string& name, BodyId a, BodyId b, const Pose& at, std::uint32_t part);
    Pose poseOf(BodyId body) const;
    void show(BodyId body, const std::string& name, const Look& look, const std::vector<Piece>& pieces);
    void collide(BodyId body, std::uint32_t part, const std::vector<Piece>& pieces);

    Scene scene_;
    std::uint32_t parts_ = 0;
};

/// Of the one free axis of a hinge or a slider.
JointLimit within(bool angular, double min, double max);
JointDrive spring(bool angular, double stiffness, double damping, double position = 0);
JointDrive motor(bool angular, double velocity, double damping, double most);
/// `force`: what leaves one.
JointDrive detents(bool angular, double spacing, double force);

} // namespace tactum::samples
