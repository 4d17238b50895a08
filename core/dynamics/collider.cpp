#include "core/dynamics/collider.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/dynamics/convex.h"

namespace tactum {

namespace {

constexpr double pi = std::numbers::pi;

/// The part of a sphere above y = 0, its flat side at the origin.
ShapeMass halfBall(double r) {
    ShapeMass half;
    half.volume = 2.0 / 3 * pi * r * r * r;
    half.centre.y() = 3.0 / 8 * r;
    const double across = half.volume * r * r * 83 / 320;
    half.moments = Vec3(across, half.volume * r * r * 2 / 5, across).asDiagonal();
    return half;
}

/// Of slices from y = -h/2 to h/2 whose radius goes evenly from `bottom` to `top`.
ShapeMass frustum(double bottom, double top, double h) {
    // Moments of r(y)^2 = (m + s y)^2 over the height: polynomials, exact.
    const double m = 0.5 * (bottom + top), s = (top - bottom) / h;
    const double h3 = h * h * h / 12, h5 = std::pow(h, 5) / 80;
    const double square = m * m * h + s * s * h3;                                            // of r^2
    const double first = 2 * m * s * h3;                                                     // of r^2 y
    const double second = m * m * h3 + s * s * h5;                                           // of r^2 y^2
    const double fourth = std::pow(m, 4) * h + 6 * m * m * s * s * h3 + std::pow(s, 4) * h5; // of r^4
    ShapeMass mass;
    mass.volume = pi * square;
    mass.centre.y() = first / square;
    const double about = pi / 2 * fourth;
    const double across = pi / 4 * fourth + pi * second - mass.volume * mass.centre.y() * mass.centre.y();
    mass.moments = Vec3(across, about, across).asDiagonal();
    return mass;
}

/// The sum of the tetrahedra from the origin to each triangle; of a hull without faces its box.
ShapeMass enclosed(const ShapeMesh& mesh) {
    ShapeMass mass;
    Mat3 second = Mat3::Zero(); // the integral of x x^T
    Vec3 first = Vec3::Zero();
    for (const auto& face : mesh.faces) {
        Mat3 corners;
        for (int k = 0; k < 3; ++k)
            corners.col(k) = mesh.points[face[std::size_t(k)]];
        const double six = corners.determinant();
        mass.volume += six / 6;
        const Vec3 sum = corners.rowwise().sum();
        first += six / 24 * sum;
        second += six / 120 * (corners * corners.transpose() + sum * sum.transpose());
    }
    if (!(mass.volume > 0)) return {};
    mass.centre = first / mass.volume;
    second -= mass.volume * mass.centre * mass.centre.transpose();
    mass.moments = second.trace() * Mat3::Identity() - second;
    return mass;
}

} // namespace

double distanceTo(const ColliderShape& shape, const Vec3& point) {
    const auto beyond = [](const Vec3& p, const Vec3& low, const Vec3& high) {
        return (p - p.cwiseMax(low).cwiseMin(high)).norm();
    };
    const Vec3 half = 0.5 * shape.size;
    switch (shape.kind) {
    case ShapeKind::Box:
        return beyond(point, -half, half);
    case ShapeKind::Sphere:
        return std::max(0.0, point.norm() - shape.radius);
    case ShapeKind::Capsule:
    case ShapeKind::Cylinder: {
        const double up = 0.5 * shape.height, along = std::clamp(point.y(), -up, up);
        const double radius =
            shape.radiusBottom + (along / shape.height + 0.5) * (shape.radius - shape.radiusBottom);
        const double across = Vec3(point.x(), 0, point.z()).norm();
        if (shape.kind == ShapeKind::Capsule)
            return std::max(0.0, std::hypot(across, point.y() - along) - radius);
        return std::hypot(std::max(0.0, across - radius), point.y() - along);
    }
    case ShapeKind::Plane:
        return std::max(0.0, point.y());
    case ShapeKind::Hull:
    case ShapeKind::Mesh: {
        Vec3 low = Vec3::Constant(1e300), high = -low;
        for (const Vec3& corner : shape.mesh->points) {
            low = low.cwiseMin(corner);
            high = high.cwiseMax(corner);
        }
        return beyond(point, low, high);
    }
    }
    return 0;
}

ShapeMass placed(const ShapeMass& mass, const Pose& pose) {
    const Mat3 turn = pose.rotation.toRotationMatrix();
    return {mass.volume, pose.apply(mass.centre), turn * mass.moments * turn.transpose()};
}

ShapeMass together(const ShapeMass& a, const ShapeMass& b) {
    ShapeMass sum;
    sum.volume = a.volume + b.volume;
    if (!(sum.volume > 0)) return sum;
    sum.centre = (a.volume * a.centre + b.volume * b.centre) / sum.volume;
    for (const ShapeMass* one : {&a, &b}) {
        const Vec3 arm = one->centre - sum.centre;
        sum.moments +=
            one->moments + one->volume * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
    }
    return sum;
}

/// What contact sees of a hull is what it weighs.
static ShapeMesh meshOf(const Polytope& hull) {
    ShapeMesh mesh{hull.points, {}};
    for (const Polytope::Face& face : hull.faces)
        for (std::size_t i = 1; i + 1 < face.corners.size(); ++i)
            mesh.faces.push_back({std::uint32_t(face.corners[0]), std::uint32_t(face.corners[i]),
                                  std::uint32_t(face.corners[i + 1])});
    return mesh;
}

ShapeMass massOf(const ColliderShape& shape) {
    ShapeMass mass;
    switch (shape.kind) {
    case ShapeKind::Box: {
        mass.volume = shape.size.prod();
        const Vec3 squares = shape.size.cwiseProduct(shape.size);
        mass.moments = (mass.volume / 12 * (Vec3::Constant(squares.sum()) - squares)).asDiagonal();
        return mass;
    }
    case ShapeKind::Sphere:
        mass.volume = 4.0 / 3 * pi * std::pow(shape.radius, 3);
        mass.moments = 0.4 * mass.volume * shape.radius * shape.radius * Mat3::Identity();
        return mass;
    case ShapeKind::Cylinder:
        return frustum(shape.radiusBottom, shape.radius, shape.height);
    case ShapeKind::Capsule: {
        const Vec3 up(0, shape.height / 2, 0);
        const Quat over(0, 1, 0, 0); // half a turn about x
        return together(frustum(shape.radiusBottom, shape.radius, shape.height),
                        together(placed(halfBall(shape.radius), {Quat::Identity(), up}),
                                 placed(halfBall(shape.radiusBottom), {over, -up})));
    }
    case ShapeKind::Plane:
        return mass;
    case ShapeKind::Hull:
        return shape.mesh ? enclosed(meshOf(hullOf(shape.mesh->points))) : mass;
    case ShapeKind::Mesh:
        return shape.mesh ? enclosed(*shape.mesh) : mass;
    }
    return mass;
}

} // namespace tactum
