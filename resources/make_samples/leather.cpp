// A cushion of leather out of layers: grain, a worn place that is smoother and slides better, a seam.
#include <cmath>

#include "resources/make_samples/finger.h"
#include "resources/make_samples/height_image.h"
#include "resources/make_samples/mesh.h"
#include "resources/make_samples/samples.h"

namespace tactum::samples {
namespace {

// m. The stitches lie on a grid of 2.5 mm, as the cells of the mesh do: two cells of thread, two without.
constexpr double kWidth = 0.14, kDepth = 0.1, kBulge = 0.012, kCell = 0.0025;
constexpr double kInset = 5.5 * kCell; ///< of the seam's middle from the edge

// Stitches are as round as they are wide: they curve by 0.24 a millimetre, and a finger 2 mm deep can follow.
// One with a steep flank on the slope of the cushion holds with this friction whatever pushes along the
// table.
constexpr double kRounded = 0.5 * kCell; // m

/// How much of a stitch's height is here; x and z from the corner of the cushion.
double stitch(double x, double z, double softness) {
    const double acrossX = std::min(x, kWidth - x) - kInset, acrossZ = std::min(z, kDepth - z) - kInset;
    const auto thread = [&](double across, double along) {
        const double phase = along - 4 * kCell * std::floor(along / (4 * kCell)) - kCell;
        return (1 - smoothStep(0.5 * kCell - softness, 0.5 * kCell + softness, std::abs(across))) *
               (1 - smoothStep(kCell - softness, kCell + softness, std::abs(phase)));
    };
    // A seam ends at the other one.
    const double alongX = acrossZ > -kCell ? thread(acrossX, z) : 0;
    const double alongZ = acrossX > -kCell ? thread(acrossZ, x) : 0;
    return std::max(alongX, alongZ);
}

/// From 1 in the middle, where hands have been, to 0.
double worn(double u, double v) {
    return 1 - smoothStep(0.10, 0.30, std::hypot(u - 0.5, (v - 0.5) * kDepth / kWidth));
}

TexturePattern picture(std::string name, int width, int height, double (*value)(double u, double v)) {
    TexturePattern made;
    made.source = TextureSource::Image;
    made.mapping = TextureMapping::UvUnit;
    made.image = heightImage(std::move(name), width, height, value);
    return made;
}

TexturePattern grain(double size, double octaves) {
    TexturePattern made;
    made.mapping = TextureMapping::Uv;
    made.size = size;
    made.octaves = octaves;
    return made;
}

TextureLayer layer(std::string name, TexturePattern pattern, TextureTarget target, double strength,
                   TextureBlend blend) {
    TextureLayer made;
    made.name = std::move(name);
    made.pattern = std::move(pattern);
    made.target = target;
    made.strength = strength;
    made.blend = blend;
    return made;
}

std::vector<TextureLayer> layers() {
    const TexturePattern wear = picture("wear", 42, 30, worn);
    const TexturePattern seam = picture(
        "stitches", 280, 200, [](double u, double v) { return stitch(u * kWidth, v * kDepth, kRounded); });
    TextureLayer smooth =
        layer("worn smooth", grain(0.006, 1), TextureTarget::Height, 0.1e-3, TextureBlend::Replace);
    smooth.mask = wear;
    return {layer("grain", grain(0.0025, 3), TextureTarget::Height, 0.3e-3, TextureBlend::Add), smooth,
            layer("stitches", seam, TextureTarget::Height, 0.25e-3, TextureBlend::Maximum),
            layer("polish, at rest", wear, TextureTarget::StaticFriction, -0.5, TextureBlend::Add),
            layer("polish, sliding", wear, TextureTarget::DynamicFriction, -0.5, TextureBlend::Add)};
}

Vec3 onCushion(double x, double z) {
    const double a = 2 * x / kWidth - 1, b = 2 * z / kDepth - 1;
    return {x - kWidth / 2, kBulge * (1 - std::pow(a, 6)) * (1 - std::pow(b, 6)), kDepth / 2 - z};
}

/// Where it lies on the board, counter-clockwise seen from below.
std::vector<Vec3> outline() {
    const int wide = int(std::lround(kWidth / kCell)), deep = int(std::lround(kDepth / kCell));
    std::vector<Vec3> rim;
    for (int i = 0; i < deep; ++i)
        rim.push_back(onCushion(0, kDepth * i / deep));
    for (int i = 0; i < wide; ++i)
        rim.push_back(onCushion(kWidth * i / wide, kDepth));
    for (int i = deep; i > 0; --i)
        rim.push_back(onCushion(kWidth, kDepth * i / deep));
    for (int i = wide; i > 0; --i)
        rim.push_back(onCushion(kWidth * i / wide, 0));
    return rim;
}

SceneObject cushion() {
    Mesh mesh;
    mesh.grid(
        evenly(0, kWidth, int(std::lround(kWidth / kCell))),
        evenly(0, kDepth, int(std::lround(kDepth / kCell))), onCushion,
        [](double x, double z) { return Index(stitch(x, z, 1e-6) > 0.5); },
        [](double x, double z) { return Uv(float(x / kWidth), float(z / kDepth)); });
    mesh.fan(Vec3::Zero(), outline(), 2); // on the board: nobody feels it
    const Material material{.stiffness = 400, .damping = 1, .staticFriction = 0.6, .dynamicFriction = 0.5};
    SceneObject made = object("cushion", mesh,
                              {surface("leather", {0.23f, 0.09f, 0.04f}, material),
                               surface("thread", {0.70f, 0.55f, 0.32f}, material),
                               surface("lining", {0.16f, 0.12f, 0.10f}, material)});
    const std::vector<TextureLayer> all = layers();
    for (std::size_t i = 0; i < 2; ++i) {
        made.surfaces[i].layers = all;
        made.surfaces[i].shading = {.on = true, .normals = NormalSource::Computed};
    }
    return made;
}

/// Over one seam, the grain, the worn place, the grain and the other seam; 2 mm deep, on a line of stitches.
std::shared_ptr<const std::vector<FingerPoint>> acrossTheCushion() {
    const double end = 0.004, z = 21 * kCell, in = 2e-3;
    const std::vector<FingerKey> keys{{0.0, {end, z, -8e-3}},
                                      {0.25, {end, z, in}},
                                      {1.75, {kWidth - end, z, in}},
                                      {2.0, {kWidth - end, z, -8e-3}}};
    return fingerPath(keys, [](const Vec3& p) { // z: how deep
        return Vec3(onCushion(p.x(), p.y()) + Vec3(0, kFingerRadius - p.z(), 0));
    });
}

} // namespace

Scene layeredLeather() {
    Mesh mesh;
    constexpr double kRim = 0.008;
    mesh.box({-kWidth / 2 - kRim, -0.008, -kDepth / 2 - kRim}, {kWidth / 2 + kRim, 0.001, kDepth / 2 + kRim});
    Scene scene;
    scene.finger = acrossTheCushion();
    scene.add(cushion());
    scene.add(
        object("board", mesh,
               {surface("wood", {0.38f, 0.27f, 0.17f}, {.staticFriction = 0.5, .dynamicFriction = 0.3})}));
    return scene;
}

} // namespace tactum::samples
