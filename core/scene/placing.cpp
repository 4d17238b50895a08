#include "core/scene/placing.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/motion/motion_build.h"

namespace tactum {
namespace {

/// The finger with every point where `place` puts it.
template <class Place> void moveFinger(Scene& scene, Place place) {
    if (!scene.finger) return;
    auto finger = std::make_shared<std::vector<FingerPoint>>(*scene.finger);
    for (FingerPoint& point : *finger)
        point.position = place(point.position);
    scene.finger = std::move(finger);
}

} // namespace

std::optional<double> metresOf(std::string_view unit) {
    const auto found = std::ranges::find(kLengthUnits, unit, &LengthUnit::name);
    return found == std::end(kLengthUnits) ? std::nullopt : std::optional(found->metres);
}

bool fitsHand(double across) {
    constexpr double kSmallest = 0.02, kLargest = 0.5; // m
    return across >= kSmallest && across <= kLargest;
}

FileAxes guessAxes(const Scene& asMetres) {
    constexpr double kMillimetre = 1e-3;
    return {fitsHand(kMillimetre * boundsOf(asMetres).diagonal()) ? kMillimetre : 1, false};
}

FileAxes axesLike(const Scene& asMetres, const Scene& like, std::optional<double> unit,
                  std::optional<bool> zUp) {
    const auto sidesOf = [](const Scene& scene) {
        const Bounds box = boundsOf(scene);
        return box.empty() ? Vec3(Vec3::Zero()) : Vec3(box.high - box.low);
    };
    const Vec3 sides = sidesOf(asMetres), wanted = sidesOf(like);
    const double thin = 1e-3 * wanted.maxCoeff(); // of no weight: a sheet may be a little thicker
    FileAxes best{unit.value_or(1), zUp.value_or(false)};
    double least = std::numeric_limits<double>::infinity();
    for (const bool turned : {false, true})
        for (const LengthUnit& of : kLengthUnits) {
            if (turned != zUp.value_or(turned) || of.metres != unit.value_or(of.metres)) continue;
            const Vec3 turnedSides = turned ? Vec3(sides.x(), sides.z(), sides.y()) : sides;
            double far = 0;
            for (int axis = 0; axis < 3; ++axis)
                far += std::pow(std::log((of.metres * turnedSides[axis] + thin) / (wanted[axis] + thin)), 2);
            if (far < least - 1e-9) least = far, best = {of.metres, turned};
        }
    return best;
}

void placeAs(Scene& asMetres, const FileAxes& axes) {
    if (axes.unit != 1) scaleScene(asMetres, axes.unit, Vec3::Zero());
    if (axes.zUp) turnUpright(asMetres);
}

void scaleScene(Scene& scene, double factor, const Vec3& about) {
    scene.mechanics = scaled(std::move(scene.mechanics), factor, about);
    for (SceneObject& object : scene.objects) {
        object.pose.translation = factor * (object.pose.translation - about);
        if (factor == 1) continue; // geometry and keys stay shared
        auto larger = std::make_shared<TriangleSoup>(*object.geometry);
        for (Vec3& p : larger->positions)
            p *= factor;
        object.geometry = std::move(larger);
        if (object.motion) object.motion = std::make_shared<const Motion>(scaled(*object.motion, factor));
    }
    for (SavedCamera& camera : scene.cameras) {
        camera.pose.translation = factor * (camera.pose.translation - about);
        for (double SavedCamera::*length : {&SavedCamera::ahead, &SavedCamera::near, &SavedCamera::far})
            camera.*length *= factor;
        if (camera.parallel) camera.height *= factor;
    }
    std::erase_if(scene.cameras, std::not_fn(isCamera)); // that is too far away now
    moveFinger(scene, [&](const Vec3& p) { return Vec3(factor * (p - about)); });
}

void moveScene(Scene& scene, const Vec3& way) {
    scaleScene(scene, 1, -way);
}

bool turnUpright(Scene& scene) {
    if (!scene.mechanics.bodies.empty()) return false;
    const Quat turn(std::sqrt(0.5), -std::sqrt(0.5), 0, 0); // a quarter around x
    const auto turned = [](const Vec3& p) { return Vec3(p.x(), p.z(), -p.y()); };
    for (SceneObject& object : scene.objects) {
        object.pose.rotation = (turn * object.pose.rotation).normalized();
        object.pose.translation = turned(object.pose.translation);
    }
    for (SavedCamera& camera : scene.cameras)
        camera.pose = Pose{turn, Vec3::Zero()} * camera.pose;
    moveFinger(scene, turned);
    return true;
}

} // namespace tactum
