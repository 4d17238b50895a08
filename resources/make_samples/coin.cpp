// A coin whose flat face feels like a relief: one picture of 16 bits over the unit square.
#include <cmath>
#include <numbers>

#include "resources/make_samples/finger.h"
#include "resources/make_samples/height_image.h"
#include "resources/make_samples/mesh.h"
#include "resources/make_samples/reliefs.h"
#include "resources/make_samples/samples.h"

namespace tactum::samples {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kField = 0.044, kEdge = 0.05; // m: radii of the face and of the whole coin
constexpr double kFace = 0.007, kRim = 0.0085; // m: heights above the table
constexpr double kRelief = 1e-3;               // m
constexpr double kBead = 0.94;                 // of the field's radius: where the ring of beads is

/// A dome amid six petals, with a ring of 24 beads around; x and y from -1 to 1. Everything is round where it
/// ends, for a finger 1.5 mm deep falls over what curves by more than 0.67 a millimetre; the beads do by 0.5.
double relief(double x, double y) {
    const double r = std::hypot(x, y), angle = std::atan2(y, x);
    const double petal = 0.54 + 0.14 * std::cos(6 * angle);
    const double flower = 0.8 * smoothStep(0, 0.16, petal - r) * smoothStep(0.24, 0.34, r);
    const double dome = 1 - smoothStep(0, 0.24, r);
    const double along = kTurn / 24 * std::round(angle / (kTurn / 24));
    const double bead = std::hypot(x - kBead * 0.9 * std::cos(along), y - kBead * 0.9 * std::sin(along));
    return std::max({flower, dome, 0.5 * (1 - smoothStep(0, 0.055, bead))});
}

/// The face in rings around its middle.
SceneObject coin() {
    Mesh mesh;
    constexpr int kAround = 96, kRings = 25;
    const auto onFace = [](double r, double turn) {
        return Vec3(kField * r * std::cos(turn), kFace, -kField * r * std::sin(turn));
    };
    const auto uvAt = [](double r, double turn) {
        return Uv(float(0.5 + 0.5 * r * std::cos(turn)), float(0.5 + 0.5 * r * std::sin(turn)));
    };
    const auto raised = [](double r, double turn) {
        return Index(relief(r * std::cos(turn), r * std::sin(turn)) > 0.15);
    };
    constexpr double kMiddle = 1e-3;
    mesh.grid(evenly(kMiddle, 1, kRings), evenly(0, kTurn, kAround), onFace, raised, uvAt);
    // From the face over the rim to the table; the lines are sharp.
    const std::array<Eigen::Vector2d, 5> profile{
        {{kField, kFace}, {kField + 0.001, kRim}, {kEdge - 0.001, kRim}, {kEdge, kRim - 0.001}, {kEdge, 0}}};
    mesh.grid(
        evenly(0, 4, 4), evenly(0, kTurn, kAround),
        [&](double i, double turn) {
            const Eigen::Vector2d& p = profile[std::size_t(i)];
            return Vec3(p.x() * std::cos(turn), p.y(), -p.x() * std::sin(turn));
        },
        [](double, double) { return Index(2); });
    // The middle of the face, and what lies on the table.
    const auto around = [&](double r, double y, int way) {
        std::vector<Vec3> ring;
        for (int i = 0; i < kAround; ++i) {
            const double turn = way * kTurn * i / kAround;
            ring.emplace_back(r * std::cos(turn), y, -r * std::sin(turn));
        }
        return ring;
    };
    mesh.fan({0, kFace, 0}, around(kField * kMiddle, kFace, 1), 1, [](const Vec3& p) {
        return Uv(float(0.5 + 0.5 * p.x() / kField), float(0.5 - 0.5 * p.z() / kField));
    });
    mesh.fan(Vec3::Zero(), around(kEdge, 0, -1), 2);
    const Material metal{.stiffness = 1000, .damping = 0.5, .staticFriction = 0.25, .dynamicFriction = 0.2};
    return object("coin", mesh,
                  {surface("field", {0.32f, 0.19f, 0.05f}, metal),
                   surface("relief", {0.78f, 0.55f, 0.18f}, metal),
                   surface("rim", {0.62f, 0.42f, 0.13f}, metal)});
}

/// Over two petals and the dome, then along half the ring of beads; 1.5 mm deep.
std::shared_ptr<const std::vector<FingerPoint>> overTheRelief() {
    const double ring = 0.9 * kBead, in = 1.5e-3, half = kTurn / 2;
    const std::vector<FingerKey> keys{{0.0, {-ring, 0, -8e-3}},
                                      {0.25, {-ring, 0, in}},
                                      {1.25, {ring, 0, in}},
                                      {2.25, {ring, half, in}},
                                      {2.5, {ring, half, -8e-3}}};
    return fingerPath(keys, [](const Vec3& p) { // radius in parts of the field, angle, depth
        return Vec3(kField * p.x() * std::cos(p.y()), kFace + kFingerRadius - p.z(),
                    -kField * p.x() * std::sin(p.y()));
    });
}

} // namespace

double coinHeight(double x, double y) {
    return kRelief * relief(x / kField, y / kField);
}

Scene reliefCoin() {
    TextureLayer layer;
    layer.name = "relief";
    layer.pattern.source = TextureSource::Image;
    layer.pattern.mapping = TextureMapping::UvUnit;
    layer.pattern.image =
        heightImage("relief", 192, 192, [](double u, double v) { return relief(2 * u - 1, 2 * v - 1); });
    layer.strength = kRelief;
    SceneObject made = coin();
    for (std::size_t i = 0; i < 2; ++i)
        made.surfaces[i].layers = {layer};
    Mesh tray;
    tray.box({-0.065, -0.006, -0.065}, {0.065, 0, 0.065});
    Scene scene;
    scene.finger = overTheRelief();
    scene.add(made);
    scene.add(object("tray", tray,
                     {surface("felt", {0.05f, 0.14f, 0.09f},
                              {.stiffness = 300, .staticFriction = 0.6, .dynamicFriction = 0.5})}));
    return scene;
}

} // namespace tactum::samples
