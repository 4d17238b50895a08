#include "core/proxy/contact.h"

#include <algorithm>
#include <array>

namespace tactum {

Triangle Obstacle::triangle(Index index) const {
    const TriangleSoup& soup = *mesh->soup;
    const auto& corner = soup.triangles[index];
    return {soup.positions[corner[0]], soup.positions[corner[1]], soup.positions[corner[2]]};
}

namespace {

// Along the edge that a closest point lies on, body frame.
Vec3 edgeAt(const Triangle& t, const ClosestPoint& closest) noexcept {
    const std::array<Vec3, 3> opposite{t.c - t.b, t.a - t.c, t.b - t.a};
    int off = 0;
    closest.weights.cwiseAbs().minCoeff(&off);
    return opposite[off].normalized();
}

} // namespace

void locate(Contact& contact, std::span<const Obstacle> obstacles, const StepMotions& movers, double radius,
            const Vec3& centre_W) noexcept {
    const Obstacle& obstacle = obstacles[contact.body];
    const Pose pose = poseNow(obstacle, movers);
    const Triangle triangle = obstacle.triangle(contact.triangle);
    const Vec3 centre = pose.applyInverse(centre_W);
    const ClosestPoint closest = closestPoint(triangle, centre);
    const Vec3 away = centre - closest.point;
    const double distance = away.norm();
    contact.point = pose.apply(closest.point);
    if (distance > 0) contact.normal = pose.rotate(away / distance);
    contact.gap = distance - radius;
    contact.bend = closest.feature == Feature::Face ? 0 : 1 / std::max(distance, 0.5 * radius);
    contact.edge = closest.feature == Feature::Edge ? pose.rotate(edgeAt(triangle, closest)) : Vec3::Zero();
}

} // namespace tactum
