// Bodies that are told where to go, with a proxy among them: for the tests of the carry stage.
#pragma once

#include "core/proxy/carry.h"
#include "tests/support/hand.h"
#include "tests/support/reference.h"

namespace tactum::test {

inline constexpr double kRadius = 1e-3;

/// Bodies that are told where to go, and a proxy among them.
class Stage {
public:
    explicit Stage(const Material& material = frictionless()) : materials_{material} {}
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    /// Before the first step.
    int addMover(Soup soup, const Pose& pose = {}) {
        add(std::move(soup), pose);
        movers_.push_back({pose, pose});
        obstacles_.back().mover = int(movers_.size()) - 1;
        return obstacles_.back().mover;
    }
    void addStatic(Soup soup, const Pose& pose = {}) { add(std::move(soup), pose); }

    /// From which side all of the body is felt, in the order in which bodies were added.
    void feelFrom(std::size_t body, Sides sides) {
        sides_.push_back(std::make_unique<const Sides>(sides));
        obstacles_[body].sides = {sides_.back().get(), 1};
    }

    void put(int mover, const Pose& pose, bool jumped = false) {
        movers_[std::size_t(mover)].now = pose;
        movers_[std::size_t(mover)].jumped = jumped;
    }
    void startAt(const Vec3& p) { restart(state, p); }
    ProxyReport step(const Vec3& finger) {
        const ProxyReport report = moveAndUpdate(state, obstacles_, kRadius, finger, kMillisecond, movers_);
        for (BodyMotion& body : movers_)
            body = {body.now, body.now};
        return report;
    }
    /// The first stage of a step alone.
    CarryReport carryAlone() {
        const CarryReport report = carry(state, obstacles_, movers_, kRadius);
        for (BodyMotion& body : movers_)
            body = {body.now, body.now};
        return report;
    }
    const Pose& pose(int mover) const { return movers_[std::size_t(mover)].now; }
    Vec3 inBody(int mover) const { return pose(mover).applyInverse(state.position); }
    /// From the proxy's centre to the nearest primitive of all.
    double clear() const {
        double least = 1e300;
        for (const Obstacle& obstacle : obstacles_) {
            const Pose& at = obstacle.mover < 0 ? obstacle.pose : pose(obstacle.mover);
            least = std::min(least, clearance(*obstacle.mesh->soup, at.applyInverse(state.position)));
        }
        return least;
    }

    ProxyState state;

private:
    void add(Soup soup, const Pose& pose) {
        meshes_.push_back(std::make_unique<CollisionMesh>(CollisionMesh{soup, SphereTree(*soup)}));
        obstacles_.push_back(Obstacle{meshes_.back().get(), pose, materials_});
    }

    std::vector<std::unique_ptr<CollisionMesh>> meshes_;
    std::vector<Material> materials_;
    std::vector<std::unique_ptr<const Sides>> sides_;
    std::vector<Obstacle> obstacles_;
    std::vector<BodyMotion> movers_;
};

inline Pose at(const Vec3& translation) {
    return {Quat::Identity(), translation};
}
inline Pose turned(double angle, const Vec3& axis, const Vec3& translation = Vec3::Zero()) {
    return {Quat(Eigen::AngleAxisd(angle, axis)), translation};
}

/// Six faces of two triangles.
inline Soup box(const Vec3& half) {
    SoupBuilder builder;
    for (int axis = 0; axis < 3; ++axis)
        for (double side : {-1.0, 1.0}) {
            Vec3 c = Vec3::Zero(), u = Vec3::Zero(), v = Vec3::Zero();
            c[axis] = side * half[axis];
            u[(axis + 1) % 3] = half[(axis + 1) % 3];
            v[(axis + 2) % 3] = half[(axis + 2) % 3];
            builder.quad(c - u - v, c + u - v, c + u + v, c - u + v);
        }
    return builder.build();
}

inline bool isInside(const Vec3& p, const Vec3& half) {
    return (p.cwiseAbs().array() < half.array()).all();
}

/// A body that wanders: by up to `slide` m and `turn` rad each step, about where it is, never far from home.
inline Pose wandered(const Pose& pose, Rng& rng, double slide, double turn, double home) {
    const Quat more(Eigen::AngleAxisd(uniform(rng, -turn, turn), direction(rng)));
    Vec3 to = pose.translation + slide * direction(rng) * uniform(rng, 0, 1);
    if (to.norm() > home) to *= home / to.norm();
    return {(more * pose.rotation).normalized(), to};
}

inline std::string inMicrons(double length) {
    return std::to_string(1e6 * length) + " um";
}

} // namespace tactum::test
