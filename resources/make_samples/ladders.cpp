// One number of the material, from plate to plate: friction, viscosity, stiffness.
#include <array>

#include "resources/make_samples/finger.h"
#include "resources/make_samples/mesh.h"
#include "resources/make_samples/samples.h"

namespace tactum::samples {
namespace {

constexpr std::size_t kPlates = 6;
constexpr double kWidth = 0.028, kDepth = 0.07, kHeight = 0.006; // m, of a plate
constexpr double kGap = 0.0004;                                  // m: the proxy does not fall in
constexpr double kStep = kWidth + kGap;

struct Plate {
    std::string name;
    Material material;
};

double leftOf(std::size_t plate) {
    return double(plate) * kStep - (double(kPlates) * kStep - kGap) / 2;
}

/// With as many studs before each plate as its number, for eye and finger.
SceneObject board() {
    Mesh mesh;
    const double side = -leftOf(0) + 0.006, back = kDepth / 2 + 0.006, front = kDepth / 2 + 0.014;
    mesh.box({-side, -0.006, -back}, {side, 0, front});
    constexpr double kStud = 0.0024, kApart = 0.004;
    for (std::size_t plate = 0; plate < kPlates; ++plate)
        for (std::size_t i = 0; i <= plate; ++i) {
            const double x = leftOf(plate) + kWidth / 2 + (double(i) - double(plate) / 2) * kApart;
            const double z = kDepth / 2 + 0.007;
            mesh.box({x - kStud / 2, 0, z - kStud / 2}, {x + kStud / 2, 0.0015, z + kStud / 2}, 1);
        }
    return object("board", mesh,
                  {surface("board", {0.16f, 0.12f, 0.09f}), surface("studs", {0.80f, 0.76f, 0.66f})});
}

/// Along the ladder, 2 mm into the plates: what is felt changes from step to step.
std::shared_ptr<const std::vector<FingerPoint>> alongThePlates() {
    const double in = 0.006, high = kHeight + kFingerRadius, end = -leftOf(0) - in;
    const std::vector<FingerKey> keys{{0.0, {-end, high + 0.008, 0}},
                                      {0.25, {-end, high - 0.002, 0}},
                                      {1.75, {end, high - 0.002, 0}},
                                      {2.0, {end, high + 0.008, 0}}};
    return fingerPath(keys, [](const Vec3& p) { return p; });
}

/// The plates' colours go from one to the other.
Scene ladder(const std::array<Plate, kPlates>& plates, const Eigen::Vector3f& from,
             const Eigen::Vector3f& to) {
    Scene scene;
    for (std::size_t i = 0; i < kPlates; ++i) {
        Mesh mesh;
        mesh.box({leftOf(i), 0, -kDepth / 2}, {leftOf(i) + kWidth, kHeight, kDepth / 2});
        const float part = float(i) / float(kPlates - 1);
        scene.add(object("plate " + std::to_string(i + 1), mesh,
                         {surface(plates[i].name, (1 - part) * from + part * to, plates[i].material)}));
    }
    scene.add(board());
    scene.finger = alongThePlates();
    return scene;
}

Material rough(double staticFriction) {
    return {.staticFriction = staticFriction, .dynamicFriction = 0.7 * staticFriction};
}

Material springy(double stiffness) {
    return {.stiffness = stiffness};
}

Material viscous(double viscosity) {
    return {.viscosity = viscosity};
}

} // namespace

Scene frictionLadder() {
    return ladder({{{"mu 0", rough(0)},
                    {"mu 0.2", rough(0.2)},
                    {"mu 0.4", rough(0.4)},
                    {"mu 0.6", rough(0.6)},
                    {"mu 0.8", rough(0.8)},
                    {"mu 1", rough(1)}}},
                  {0.50f, 0.70f, 0.80f}, {0.55f, 0.12f, 0.06f});
}

Scene viscosityLadder() {
    return ladder({{{"b 0 N s/m", viscous(0)},
                    {"b 4 N s/m", viscous(4)},
                    {"b 8 N s/m", viscous(8)},
                    {"b 12 N s/m", viscous(12)},
                    {"b 16 N s/m", viscous(16)},
                    {"b 20 N s/m", viscous(20)}}},
                  {0.90f, 0.75f, 0.30f}, {0.30f, 0.10f, 0.02f});
}

Scene stiffnessLadder() {
    return ladder({{{"k 50 N/m", springy(50)},
                    {"k 100 N/m", springy(100)},
                    {"k 200 N/m", springy(200)},
                    {"k 400 N/m", springy(400)},
                    {"k 800 N/m", springy(800)},
                    {"k 1600 N/m", springy(1600)}}},
                  {0.75f, 0.55f, 0.60f}, {0.08f, 0.12f, 0.16f});
}

} // namespace tactum::samples
