#include "tests/realtime/bumpy_scene.h"

#include <cmath>
#include <random>

#include "core/motion/motion_build.h"

namespace tactum {
namespace {

constexpr Index kCells = 80; ///< along each side

Index corner(Index column, Index row) {
    return row * (kCells + 1) + column;
}

/// The same plate upside down, not larger than a hand: it comes down on the finger, turns and jumps back.
SceneObject movingOver(SceneObject plate, int edit) {
    plate.pose.translation = {0.01, 0, 6e-3};
    const auto turn = [](double angle) {
        return Quat(Eigen::AngleAxisd(angle, Vec3(0.1, 0, 1).normalized())).coeffs();
    };
    plate.motion = std::make_shared<const Motion>(
        makeMotion({Interpolation::CubicSpline,
                    {0, 0.4, 1},
                    {Vec3::Zero(), {0, 0.01, -8e-3}, {0, 0, 1e-3}},
                    {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()},
                    {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}},
                   {Interpolation::Linear, {0, 1.0 + edit % 3}, {turn(0), turn(2)}, {}, {}}, 1.0 + edit % 3));
    return plate;
}

/// The same for all plates and edits.
std::shared_ptr<const PaintedValues> stripes() {
    static const auto painted = [] {
        std::vector<float> values;
        for (Index i = 0; i < (kCells + 1) * (kCells + 1); ++i)
            values.push_back(float(i % 7) / 6);
        return std::make_shared<const PaintedValues>(std::move(values));
    }();
    return painted;
}

std::vector<TextureLayer> someLayers() {
    std::vector<TextureLayer> layers(4);
    layers[0].pattern.size = 2e-3;
    layers[0].strength = 2e-4;
    layers[1].pattern.source = TextureSource::Grooves;
    layers[1].strength = 5e-4;
    layers[1].ownPlane = true;
    layers[2].target = TextureTarget::StaticFriction;
    layers[2].strength = 0.5;
    layers[3].pattern.source = TextureSource::Painted;
    layers[3].pattern.painted.values = stripes();
    layers[3].mask = layers[3].pattern;
    return layers;
}

} // namespace

std::shared_ptr<const TriangleSoup> bumpyPlate(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> height(-kBumpHeight, kBumpHeight);
    TriangleSoup soup;
    for (Index row = 0; row <= kCells; ++row)
        for (Index column = 0; column <= kCells; ++column)
            soup.positions.emplace_back(kBumpyHalfWidth * (2.0 * column / kCells - 1),
                                        kBumpyHalfWidth * (2.0 * row / kCells - 1), height(random));
    for (Index row = 0; row < kCells; ++row)
        for (Index column = 0; column < kCells; ++column) {
            const Index a = corner(column, row), b = corner(column + 1, row);
            const Index c = corner(column + 1, row + 1), d = corner(column, row + 1);
            soup.triangles.push_back({a, b, c});
            soup.triangles.push_back({a, c, d});
        }
    soup.surfaceOf.assign(soup.triangles.size(), 0);
    return std::make_shared<const TriangleSoup>(std::move(soup));
}

Scene bumpyScene(const std::shared_ptr<const TriangleSoup>& plate, int edit) {
    SceneObject object;
    object.geometry = plate;
    object.surfaces.resize(1);
    Material& material = object.surfaces[0].material;
    material.stiffness = 300 + 100 * (edit % 7);
    material.damping = edit % 3;
    material.staticFriction = 0.2 * (edit % 5);
    material.dynamicFriction = 0.6 * material.staticFriction;
    material.viscosity = edit % 4;
    // Five edits plain, five shaded, five with texture too.
    object.surfaces[0].shading.on = edit / 5 % 3 > 0;
    if (edit / 5 % 3 > 1) object.surfaces[0].layers = someLayers();
    Scene scene;
    scene.add(object);
    scene.add(movingOver(object, edit));
    return scene;
}

Vec3 wanderingFinger(double t) {
    return {0.04 * std::sin(2.1 * t), 0.04 * std::sin(3.1 * t + 1), 6e-3 * std::sin(1.3 * t) - 3e-3};
}

} // namespace tactum
