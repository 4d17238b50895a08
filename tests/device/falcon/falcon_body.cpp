#include "tests/device/falcon/falcon_body.h"

#include <algorithm>
#include <cmath>

namespace tactum::test {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979323846;

/// The angle at which the knee is one shin's length from the grip's joint:
///   A cos t + B sin t = C,  by the tangent of half the angle.
double degreesOfLeg(const Vec3& p, double azimuthDegrees) {
    const double a = azimuthDegrees / kDegrees;
    const double joint = std::cos(a) * p.x() + std::sin(a) * p.y() - 0.0400 + 0.01443;
    const double aside = -std::sin(a) * p.x() + std::cos(a) * p.y() + 0.02309 - 0.025;
    const double shin = 0.0225 + std::sqrt(0.1025 * 0.1025 - aside * aside);
    const double A = 2 * 0.060 * joint, B = 2 * 0.060 * p.z();
    const double C = joint * joint + p.z() * p.z() + 0.060 * 0.060 - shin * shin;
    return 2 * std::atan((B - std::sqrt(A * A + B * B - C * C)) / (A + C)) * kDegrees;
}

} // namespace

Vec3 legDegrees(const Vec3& p) {
    return {degreesOfLeg(p, 105), degreesOfLeg(p, -15), degreesOfLeg(p, -135)};
}

Vec3 forceAtGrip(const Vec3& p, const Vec3& torques) {
    constexpr double h = 1e-6;
    Vec3 force;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = h * Vec3::Unit(axis);
        force[axis] = torques.dot(legDegrees(p + step) - legDegrees(p - step)) / kDegrees / (2 * h);
    }
    return force;
}

void FalconBody::put(const Vec3& p) {
    position_ = goal_ = led_ = p;
    velocity_ = Vec3::Zero();
    homing_ = 0;
}

void FalconBody::leadTo(const Vec3& p) {
    goal_ = p;
    homing_ = 0;
}

void FalconBody::lead(double dt) {
    const Vec3 stations[kStations] = {{0, 0, 0.125}, {0, 0, 0.08}, {0, 0, 0.17}};
    if (homing_ > 0) goal_ = stations[homing_ - 1];
    const Vec3 way = goal_ - led_;
    const double most = hand.speed * dt;
    led_ = way.norm() <= most ? goal_ : Vec3(led_ + most * way.normalized());
    if (homing_ > 0 && led_ == goal_) --homing_;
}

void FalconBody::step(double dt, const Vec3& torques) {
    lead(dt);
    const Vec3 pull = hand.stiffness * (led_ - position_) - hand.damping * velocity_;
    const Vec3 next =
        position_ + dt * (velocity_ + dt * (pull + forceAtGrip(position_, torques)) / hand.mass);
    const bool reaches = legDegrees(next).allFinite() && next.z() > 0.07 && next.z() < 0.18;
    velocity_ = reaches ? Vec3((next - position_) / dt) : Vec3(0, 0, 0);
    if (reaches) position_ = next;
}

} // namespace tactum::test
