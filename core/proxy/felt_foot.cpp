#include "core/proxy/felt_foot.h"

#include "core/proxy/surface_under.h"

namespace tactum {

namespace {

// Beyond an edge it is hollow where the way to the next face is shorter by this part of it, squared.
constexpr double kHollow = 1e-9;
// A slide is followed over so many edges.
constexpr int kMostEdges = 6;

// Onto which triangle of its surface a felt one goes on over the edge that a foot is on.
Index goesOnOver(const Obstacle& obstacle, const SmoothNormals& normals, const Foot& foot) noexcept {
    if (foot.point.feature != Feature::Edge) return SmoothNormals::kNothing;
    int opposite = 0;
    foot.point.weights.cwiseAbs().minCoeff(&opposite);
    const Index next = normals.across[foot.triangle][std::size_t(opposite)];
    if (next == SmoothNormals::kNothing) return next;
    return obstacle.surfaceOf(next) == obstacle.surfaceOf(foot.triangle) ? next : SmoothNormals::kNothing;
}

// On a shaded surface, over edges around which a large proxy rolls, and down onto what comes next. In a
// hollow and where the surface ends it goes on in its plane.
Foot footOverEdges(const Contact& contact, const Obstacle& obstacle, const SmoothNormals& normals,
                   const Vec3& centre) noexcept {
    const Triangle triangle = obstacle.triangle(contact.triangle);
    const Foot inPlane{footOnPlane(triangle, centre), contact.triangle};
    if (inPlane.point.weights.minCoeff() >= 0) return inPlane;
    const auto distance2 = [&](const Foot& foot) { return (centre - foot.point.point).squaredNorm(); };
    Foot foot{closestPoint(triangle, centre), contact.triangle};
    for (int edges = 0; edges < kMostEdges && foot.point.feature != Feature::Face; ++edges) {
        const Index next = goesOnOver(obstacle, normals, foot);
        if (next == SmoothNormals::kNothing)
            return contact.bend == 0 && foot.triangle == contact.triangle ? inPlane : foot;
        const Foot there{closestPoint(obstacle.triangle(next), centre), next};
        if (distance2(there) < (1 - kHollow) * distance2(inPlane)) return inPlane;
        if (!(distance2(there) < distance2(foot))) break; // it rolls around the edge
        foot = there;
    }
    return foot;
}

} // namespace

Foot footAt(const Contact& contact, const Obstacle& obstacle, const Vec3& centre, Look where) noexcept {
    const Triangle triangle = obstacle.triangle(contact.triangle);
    const SurfaceFeel* feel = feelOf(obstacle, contact.triangle);
    if (where == Look::AheadOverEdges && feel && feel->normals)
        return footOverEdges(contact, obstacle, *feel->normals, centre);
    const bool goesOn = where != Look::Here && contact.bend == 0;
    return {goesOn ? footOnPlane(triangle, centre) : closestPoint(triangle, centre), contact.triangle};
}

} // namespace tactum
