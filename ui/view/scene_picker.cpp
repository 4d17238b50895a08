#include "ui/view/scene_picker.h"

#include <algorithm>
#include <chrono>

namespace tactum {

namespace {

/// A ray is the sweep of a sphere this small, as a part of the scene's size.
constexpr double kRayThickness = 1e-6;

bool isReady(const auto& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace

void ScenePicker::setScene(const Scene& scene) {
    std::vector<Target> targets;
    for (const SceneObject& object : scene.objects)
        targets.push_back({object.id, object.pose, object.geometry, treeOf(object.geometry), object.visible});
    targets_ = std::move(targets);
    bounds_ = boundsOf(scene);
}

ScenePicker::Tree ScenePicker::treeOf(const std::shared_ptr<const TriangleSoup>& soup) const {
    const auto known =
        std::find_if(targets_.begin(), targets_.end(), [&](const auto& t) { return t.soup == soup; });
    if (known != targets_.end()) return known->tree;
    return std::async(
               std::launch::async,
               [soup] { return std::shared_ptr<const SphereTree>(std::make_shared<SphereTree>(*soup)); })
        .share();
}

std::optional<PickHit> ScenePicker::cast(const Ray& ray, Patience patience) const {
    std::optional<PickHit> nearest;
    for (const Target& target : targets_) {
        if (!target.visible || (patience == Patience::Now && !isReady(target.tree))) continue;
        const double reach = nearest ? nearest->distance : reachOf(ray);
        if (auto hit = castAt(target, ray, reach)) nearest = hit;
    }
    return nearest;
}

std::optional<PickHit> ScenePicker::castAt(const Target& target, const Ray& ray, double reach) const {
    const SpherePath path{target.pose.applyInverse(ray.origin),
                          reach * target.pose.rotateInverse(ray.direction),
                          kRayThickness * bounds_.diagonal()};
    const SweepHit hit = target.tree.get()->sweep(*target.soup, path, {});
    if (hit.t > 1) return std::nullopt;
    return PickHit{
        {target.object, target.soup->surfaceOf[hit.triangle]}, ray.at(hit.t * reach), hit.t * reach};
}

bool ScenePicker::isFree(const Vec3& from, const Vec3& to) const {
    const double length = (to - from).norm();
    if (!(length > 0)) return true;
    const auto hit = cast({from, (to - from) / length}, Patience::Wait);
    return !hit || hit->distance > length;
}

/// Far enough to leave the scene on its far side.
double ScenePicker::reachOf(const Ray& ray) const {
    return bounds_.empty() ? 0 : (bounds_.centre() - ray.origin).norm() + bounds_.diagonal();
}

} // namespace tactum
