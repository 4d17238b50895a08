// The articulated-body algorithm: accelerations of all links from all forces, in time linear in their number.
// Source: R. Featherstone, Rigid Body Dynamics Algorithms, Springer 2008, section 7.3; of the paper (22), all
// terms.
#pragma once

#include <vector>

#include "core/dynamics/measure.h"
#include "core/dynamics/mechanism.h"
#include "core/dynamics/spatial.h"

namespace tactum {

using Coordinates = Eigen::VectorXd; ///< of a fixed length: no operation here allocates

/// What is known of a link at one moment; spatial vectors as in spatial.h, about the origin of its island.
struct LinkNow {
    Pose pose;                             ///< X_WL
    Eigen::Matrix<double, 6, 3> way, push; ///< what its freedoms move (S), and the momentum that takes (U)
    Mat3 yield = Mat3::Zero();             ///< the inverse of S^T U
    Vec6 velocity = Vec6::Zero(), drift = Vec6::Zero(), acceleration = Vec6::Zero();
    Vec6 pathDrift = Vec6::Zero(); ///< of Path: the part of `drift` that the curve makes, S' s'^2
    Vec6 force = Vec6::Zero();     ///< from outside, gravity too
    Vec6 bias = Vec6::Zero();
    Vec3 rest = Vec3::Zero();
    Mat6 inertia; ///< of the link alone, then of all that hangs on it
};

/// About the origin of an island, along the axes of the world.
struct IslandWrench {
    Vec3 torque = Vec3::Zero(), force = Vec3::Zero(); ///< N m, N
};

/// Thread: one at a time; all but the constructor real time.
class Articulation {
public:
    explicit Articulation(const Mechanism& mechanism);

    /// Where every link is and how it moves. Forces begin at none.
    void place(const Coordinates& q, const Coordinates& v) noexcept;
    void addGravity(const Vec3& gravity) noexcept;
    /// On b, the opposite on a, `size` times.
    void addForce(const Place& a, const Place& b, const Wrench& wrench, double size) noexcept;
    void addForce(int link, const Vec3& force_W, const Vec3& point_W) noexcept;

    /// Of the places alone: what respond() stands on.
    void factor() noexcept;
    /// The same, and q'' for the forces and the forces along the coordinates.
    void accelerate(const Coordinates& along, Coordinates& acceleration) noexcept;
    /// How the velocities of an island change by an impulse along its coordinates: M^-1 J^T. Both have as
    /// many numbers as the island has velocities.
    void respond(const Island& island, const double* impulse, double* change) noexcept;
    /// The same impulse, given as a wrench on a link: adds J^T, of the link's island.
    void addJacobian(int link, const Wrench& wrench, double size, double* along) const noexcept;

    Pose poseOf(const Place& frame) const noexcept;
    FrameVelocity velocityOf(const Place& frame) const noexcept;
    /// The power of a wrench on b and its opposite on a: W for each unit of the wrench.
    double powerOf(const Place& a, const Place& b, const Wrench& wrench) const noexcept;
    /// d/dt of powerOf() as the accelerations of the last accelerate() have it, the change of the wrench
    /// itself left out.
    double accelerationAlong(const Place& a, const Place& b, const Wrench& wrench) const noexcept;
    /// The part of accelerationAlong() that is there without any acceleration of the coordinates.
    double driftAlong(const Place& a, const Place& b, const Wrench& wrench) const noexcept;
    const LinkNow& link(int index) const noexcept { return now_[std::size_t(index)]; }
    const Vec3& originOf(int link) const noexcept {
        return origins_[std::size_t(mechanism_.links[std::size_t(link)].island)];
    }

private:
    /// `size` times a wrench about the origin of a link's island.
    IslandWrench atOrigin(int link, const Wrench& wrench, double size = 1) const noexcept;
    void placeLink(std::size_t i, const Coordinates& q) noexcept;
    FrameVelocity moveFreedoms(std::size_t i, const Vec3& at, const Mat3& axes,
                               const Coordinates& v) noexcept;
    void moveLink(std::size_t i, const Coordinates& v) noexcept;
    void factorLink(std::size_t i) noexcept;
    void passForce(std::size_t i, const Coordinates& along) noexcept;
    Pose alongPath(const Link& link, double way) noexcept;
    void moveAlongPath(std::size_t i, double rate) noexcept;

    const Mechanism& mechanism_;
    std::vector<LinkNow> now_;
    std::vector<Vec3> origins_;   ///< of each island
    std::vector<PathSpot> spots_; ///< of each path, where its link is
    std::vector<Vec6> impulses_;  ///< of respond()
    std::vector<Vec3> rests_;
};

/// Velocities at the time 0 as near to those of the bodies as the joints let them be: what their momenta
/// would bring about as one blow. Thread: any but real time.
void startVelocities(Mechanism& mechanism);

} // namespace tactum
