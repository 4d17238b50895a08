// A box with a hole for the hand. What stands in it is too low to be seen from the usual views: touch alone
// tells what it is. For trials with people who look at the box from outside.
#include <cmath>
#include <numbers>

#include "resources/make_samples/finger.h"
#include "resources/make_samples/mesh.h"
#include "resources/make_samples/samples.h"

namespace tactum::samples {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kHalf = 0.06, kWall = 0.004, kTop = 0.1; // m
constexpr double kHole = 0.04;                            // m, radius
constexpr double kPi4 = std::numbers::pi / 4;

/// On the edge of the square, in the direction `turn`.
Vec3 onSquare(double turn, double y) {
    const double longest = std::max(std::abs(std::cos(turn)), std::abs(std::sin(turn)));
    return {kHalf * std::cos(turn) / longest, y, -kHalf * std::sin(turn) / longest};
}

Vec3 onHole(double turn, double y) {
    return {kHole * std::cos(turn), y, -kHole * std::sin(turn)};
}

/// Around the hole and the square: inner wall, top, outer edge, underside.
void addLid(Mesh& mesh, Index surface) {
    constexpr double kLow = kTop - kWall;
    const auto place = [&](double i, double turn) {
        switch (int(i)) {
        case 1:
            return onHole(turn, kTop);
        case 2:
            return onSquare(turn, kTop);
        case 3:
            return onSquare(turn, kLow);
        default:
            return onHole(turn, kLow);
        }
    };
    mesh.grid(evenly(0, 4, 4), evenly(-kPi4, kTurn - kPi4, 64), place,
              [&](double, double) { return surface; });
}

SceneObject box() {
    Mesh mesh;
    constexpr double kInside = kHalf - kWall, kUnder = kTop - kWall;
    mesh.box({-kHalf, 0, -kHalf}, {kHalf, kWall, kHalf});
    mesh.box({-kHalf, kWall, -kHalf}, {-kInside, kUnder, kHalf});
    mesh.box({kInside, kWall, -kHalf}, {kHalf, kUnder, kHalf});
    mesh.box({-kInside, kWall, -kHalf}, {kInside, kUnder, -kInside});
    mesh.box({-kInside, kWall, kInside}, {kInside, kUnder, kHalf});
    addLid(mesh, 1);
    return object("box", mesh,
                  {surface("walls", {0.16f, 0.17f, 0.24f}, {.staticFriction = 0.3, .dynamicFriction = 0.25}),
                   surface("lid", {0.75f, 0.50f, 0.14f}, {.staticFriction = 0.3, .dynamicFriction = 0.25})});
}

/// A star with five soft points, sunk a little into the floor of the box.
Vec3 onHidden(double rise, double turn) {
    const double out = 0.03 * (1 + 0.22 * std::cos(5 * turn)) * std::sin(rise);
    return {out * std::cos(turn), kWall - 0.002 + 0.036 * std::cos(rise), -out * std::sin(turn)};
}

SceneObject hidden() {
    Mesh mesh;
    constexpr int kAround = 100;
    const auto around = [](double rise, int way) {
        std::vector<Vec3> ring;
        for (int i = 0; i < kAround; ++i)
            ring.push_back(onHidden(rise, way * kTurn * i / kAround));
        return ring;
    };
    constexpr double kTip = 1e-3, kFoot = std::numbers::pi / 2;
    mesh.grid(evenly(kTip, kFoot, 24), evenly(0, kTurn, kAround), onHidden);
    mesh.fan(onHidden(0, 0), around(kTip, 1));
    mesh.fan({0, onHidden(kFoot, 0).y(), 0}, around(kFoot, -1));
    Surface made = surface("shape", {0.60f, 0.16f, 0.20f},
                           {.stiffness = 700, .staticFriction = 0.3, .dynamicFriction = 0.2});
    made.shading.on = true;
    return object("hidden shape", mesh, {made});
}

/// Through the hole onto the top of the shape, down its side and once around; 2 mm deep.
std::shared_ptr<const std::vector<FingerPoint>> intoTheBox() {
    const double high = 0.3, low = 1.2, in = 2e-3;
    const std::vector<FingerKey> keys{
        {0.0, {high, 0, -0.075}}, {0.6, {high, 0, -1e-3}},    {0.7, {high, 0, in}},       {1.0, {low, 0, in}},
        {2.6, {low, kTurn, in}},  {2.7, {low, kTurn, -1e-3}}, {3.0, {high, kTurn, -0.02}}};
    return fingerPath(keys, [](const Vec3& p) { // rise, turn, depth
        const Vec3 on = onHidden(p.x(), p.y()), foot(0, kWall - 0.002, 0);
        return Vec3(on + (kFingerRadius - p.z()) * (on - foot).normalized());
    });
}

} // namespace

Scene blindBox() {
    Scene scene;
    scene.add(box()); // first: what is selected at the beginning is outlined through everything
    scene.add(hidden());
    scene.finger = intoTheBox();
    return scene;
}

} // namespace tactum::samples
