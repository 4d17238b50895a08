#include "tests/realtime/bumpy_scene.h"

#include <cmath>
#include <random>

namespace tactum {
namespace {

constexpr Index kCells = 80; ///< along each side

Index corner(Index column, Index row) {
    return row * (kCells + 1) + column;
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
    Scene scene;
    scene.add(object);
    return scene;
}

Vec3 wanderingFinger(double t) {
    return {0.04 * std::sin(2.1 * t), 0.04 * std::sin(3.1 * t + 1), 6e-3 * std::sin(1.3 * t) - 3e-3};
}

} // namespace tactum
