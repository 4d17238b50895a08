// Shaded shapes from formulas, and fingers that go around them.
#pragma once

#include "tests/support/hand.h"

namespace tactum::test {

/// The soup with normal(position) at each corner, as a file would bring it.
template <class Normal> Soup withNormals(const Soup& soup, Normal&& normal) {
    auto result = std::make_shared<TriangleSoup>(*soup);
    for (const auto& triangle : result->triangles)
        for (Index corner : triangle)
            result->cornerNormals.push_back(Vec3(normal(result->positions[corner])).cast<float>());
    return result;
}

/// A tube's corners with the normals of the cylinder around y through them.
inline Soup roundPipe(double radius, double halfLength, int sides) {
    return withNormals(pipe(radius, halfLength, sides),
                       [](const Vec3& p) { return Vec3(p.x(), 0, p.z()).normalized(); });
}

inline Soup roundBall(double radius, int divisions) {
    return withNormals(ball(radius, divisions), [](const Vec3& p) { return p.normalized(); });
}

/// Two soups as one; both with normals, or both without.
inline Soup together(const TriangleSoup& a, const TriangleSoup& b) {
    auto result = std::make_shared<TriangleSoup>(a);
    const Index first = Index(a.positions.size());
    result->positions.insert(result->positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& t : b.triangles)
        result->triangles.push_back({first + t[0], first + t[1], first + t[2]});
    result->surfaceOf.resize(result->triangles.size(), 0);
    result->cornerNormals.insert(result->cornerNormals.end(), b.cornerNormals.begin(), b.cornerNormals.end());
    return result;
}

inline std::shared_ptr<const World> shadedWorld(Soup soup, const Material& material, double radius,
                                                bool shaded = true) {
    Scene scene = sceneOf(std::move(soup), material, radius);
    scene.objects[0].surfaces[0].shading.on = shaded;
    return compile(scene).value();
}

inline double degreesBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// What a finger feels on a closed path through a surface.
struct Round {
    double worstDirection = 0; ///< degrees between the force and the wanted direction
    double largestJump = 0;    ///< degrees between the forces of two steps
    double energy = 0;         ///< J that the loop gave to the hand
    double most = 0;           ///< N, largest force
    int rounds = 0;            ///< most of one step, the way in included
};

/// From `outside` into the path at its beginning, once around to settle, and once around to measure.
/// place(s), wanted(s): finger and direction of force for s from 0 to 1.
template <class Place, class Wanted>
Round goAround(Hand& hand, const Vec3& outside, int steps, Place&& place, Wanted&& wanted) {
    hand.to(outside);
    Round round;
    hand.go(place(0.0), 0.05,
            [&](const Hand& h) { round.rounds = std::max(round.rounds, h.output().report.rounds); });
    Vec3 force = Vec3::Zero(), finger = Vec3::Zero();
    for (int i = -steps; i <= steps; ++i) {
        const double s = double((i + steps) % steps) / steps;
        const HapticOutput& output = hand.to(place(s));
        if (i >= 0) {
            round.worstDirection = std::max(round.worstDirection, degreesBetween(output.force, wanted(s)));
            round.rounds = std::max(round.rounds, output.report.rounds);
            round.most = std::max(round.most, output.force.norm());
        }
        if (i > 0) {
            round.largestJump = std::max(round.largestJump, degreesBetween(force, output.force));
            round.energy += 0.5 * (force + output.force).dot(hand.finger() - finger);
        }
        force = output.force;
        finger = hand.finger();
    }
    return round;
}

} // namespace tactum::test
