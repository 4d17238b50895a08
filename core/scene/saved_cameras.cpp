#include "core/scene/saved_cameras.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include "core/scene/scene.h"

namespace tactum {
namespace {

constexpr double kLeastCamera = 1e-9, kMostCamera = 1e6; // m
constexpr double kUnitLength = 1e-6;

bool isWithin(double value, double least, double most) {
    return value >= least && value <= most; // NaN is not
}

} // namespace

bool isCamera(const SavedCamera& camera) {
    const auto& [rotation, translation] = camera.pose;
    const bool placed = translation.allFinite() && translation.cwiseAbs().maxCoeff() <= kMostCamera &&
                        std::abs(rotation.norm() - 1) <= kUnitLength;
    return !camera.name.empty() && placed && camera.angle > 0 && camera.angle < std::numbers::pi &&
           isWithin(camera.height, kLeastCamera, kMostCamera) &&
           isWithin(camera.ahead, kLeastCamera, kMostCamera) && camera.near >= 0 && camera.far >= 0 &&
           std::isfinite(camera.near) && std::isfinite(camera.far);
}

bool areCameras(const std::vector<SavedCamera>& cameras) {
    std::set<std::string> names;
    const auto isNew = [&](const SavedCamera& camera) { return names.insert(camera.name).second; };
    return cameras.size() <= kMaxCameras && std::ranges::all_of(cameras, isCamera) &&
           std::ranges::all_of(cameras, isNew);
}

const SavedCamera* findCamera(const Scene& scene, const std::string& name) {
    const auto found = std::ranges::find(scene.cameras, name, &SavedCamera::name);
    return found == scene.cameras.end() ? nullptr : &*found;
}

void putCamera(Scene& scene, SavedCamera camera) {
    const auto found = std::ranges::find(scene.cameras, camera.name, &SavedCamera::name);
    if (found == scene.cameras.end()) {
        if (scene.cameras.size() < kMaxCameras) scene.cameras.push_back(std::move(camera));
        return;
    }
    camera.kept = found->kept, camera.keptCamera = found->keptCamera;
    *found = std::move(camera);
}

void renameCamera(Scene& scene, const std::string& from, const std::string& to) {
    const auto found = std::ranges::find(scene.cameras, from, &SavedCamera::name);
    if (found != scene.cameras.end() && !findCamera(scene, to)) found->name = to;
}

void removeCamera(Scene& scene, const std::string& name) {
    std::erase_if(scene.cameras, [&](const SavedCamera& camera) { return camera.name == name; });
}

} // namespace tactum
