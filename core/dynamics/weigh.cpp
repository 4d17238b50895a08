#include "core/dynamics/weigh.h"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace tactum {

void weigh(RigidBody& body, const ShapeMass& shapes, double mass) {
    body.mass = mass;
    body.centre = shapes.centre;
    body.inertiaFrame = Quat::Identity();
    const double counts = mass > 0 ? mass : 1;
    if (!(shapes.volume > 0)) {
        const double r = std::cbrt(3 * counts / (4 * std::numbers::pi * kDensity));
        body.inertia = Vec3::Constant(0.4 * counts * r * r);
        return;
    }
    const Mat3 moments = shapes.moments * (counts / shapes.volume);
    const Mat3 off = moments - Mat3(moments.diagonal().asDiagonal());
    if (off.norm() <= 1e-12 * moments.norm()) { // the axes that it has: no turn by rounding
        body.inertia = moments.diagonal();
        return;
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> axes(moments);
    Mat3 turn = axes.eigenvectors();
    if (turn.determinant() < 0) turn.col(0) = -turn.col(0);
    body.inertia = axes.eigenvalues();
    body.inertiaFrame = Quat(turn).normalized();
}

} // namespace tactum
