#include "ui/engine/device_trial.h"

#include <algorithm>
#include <map>
#include <utility>

namespace tactum {

namespace {

// Parts of the workspace's radius.
constexpr double kProxy = 0.01, kBall = 0.03, kAway = 0.3, kHalfWidth = 0.6;
constexpr double kPullAtEdge = 0.4;              // of the device's force
constexpr double kStiffWall = 0.8, kPlate = 0.5; // of the ceiling
constexpr double kHolds = 0.7, kSlides = 0.5;    // friction of the plate
constexpr int kHalvings = 3;
constexpr ObjectId kNobodys = ~ObjectId(0); // of no object that a document has

TriangleSoup octahedron() {
    TriangleSoup soup;
    for (int axis = 0; axis < 3; ++axis)
        for (const double end : {1.0, -1.0})
            soup.positions.push_back(end * Vec3::Unit(axis));
    for (int i = 0; i < 8; ++i) {
        const Index x = i & 1, y = 2 + Index((i >> 1) & 1), z = 4 + Index((i >> 2) & 1);
        const bool mirrored = ((i & 1) + ((i >> 1) & 1) + ((i >> 2) & 1)) % 2 != 0;
        soup.triangles.push_back(mirrored ? std::array{x, z, y} : std::array{x, y, z});
    }
    return soup;
}

/// Each triangle into four, on the sphere of radius 1.
TriangleSoup halved(const TriangleSoup& coarse) {
    TriangleSoup fine;
    fine.positions = coarse.positions;
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
        const auto [at, fresh] = middles.try_emplace(std::minmax(a, b), Index(fine.positions.size()));
        if (fresh) fine.positions.push_back((fine.positions[a] + fine.positions[b]).normalized());
        return at->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const auto& part :
             {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
            fine.triangles.push_back(part);
    }
    return fine;
}

TriangleSoup ball(double radius) {
    TriangleSoup soup = octahedron();
    for (int i = 0; i < kHalvings; ++i)
        soup = halved(soup);
    for (Vec3& position : soup.positions)
        position *= radius;
    return soup;
}

/// Upright, its front to the left; or lying, its front up.
TriangleSoup square(double half, bool upright) {
    TriangleSoup soup;
    for (const auto& [a, b] : {std::pair{-half, -half}, {half, -half}, {half, half}, {-half, half}})
        soup.positions.push_back(upright ? Vec3(0, b, a) : Vec3(a, 0, -b));
    soup.triangles = {{0, 1, 2}, {0, 2, 3}};
    return soup;
}

struct Piece {
    const char* name;
    TriangleSoup soup;
    Vec3 away = Vec3::Zero(); ///< from the centre
    Material material;
    Sides sides = Sides::Both;
};

Piece pieceOf(Trial trial, const TrialFigures& figures) {
    const double stiff = std::max(kStiffness.minimum, figures.ceiling);
    const double width = kHalfWidth * figures.radius, away = kAway * figures.radius;
    switch (trial) {
    case Trial::Spring:
        return {.name = "Spring to the centre",
                .soup = ball(kBall * figures.radius),
                .material = {.stiffness = std::min(kPullAtEdge * figures.maxForce / figures.radius, stiff)},
                .sides = Sides::Back};
    case Trial::Wall:
        return {.name = "Wall",
                .soup = square(width, true),
                .away = {away, 0, 0},
                .material = {.stiffness = kStiffWall * stiff}};
    case Trial::Friction:
        break;
    }
    return {.name = "Plate",
            .soup = square(width, false),
            .away = {0, -away, 0},
            .material = {.stiffness = kPlate * stiff, .staticFriction = kHolds, .dynamicFriction = kSlides}};
}

} // namespace

Scene trialScene(Trial trial, const TrialFigures& figures) {
    Piece piece = pieceOf(trial, figures);
    piece.soup.surfaceOf.assign(piece.soup.triangles.size(), 0);
    SceneObject object;
    object.name = piece.name;
    object.pose.translation = figures.centre + piece.away;
    object.geometry = std::make_shared<const TriangleSoup>(std::move(piece.soup));
    object.surfaces.resize(1);
    object.surfaces[0].name = piece.name;
    object.surfaces[0].material = piece.material;
    object.surfaces[0].sides = piece.sides;
    Scene scene;
    scene.proxyRadius = kProxyRadius.clamped(kProxy * figures.radius);
    scene.add(std::move(object)).id = kNobodys;
    return scene;
}

} // namespace tactum
