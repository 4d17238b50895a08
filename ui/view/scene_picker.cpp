#include "ui/view/scene_picker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "core/scene/object_bounds.h"

namespace tactum {

namespace {

/// A ray is the sweep of a sphere this small, as a part of the scene's size.
constexpr double kRayThickness = 1e-6;

constexpr int kPieces = 96;
/// Of the scene's size: the ray is not cut finer for a body that is smaller.
constexpr double kSmallestBox = 1e-3;

/// Where a ray enters and leaves a slightly larger box; an empty span if it misses it.
std::pair<double, double> spanIn(const Bounds& box, const Ray& ray) {
    const Vec3 margin = Vec3::Constant(1e-3 * box.diagonal() + 1e-9);
    double enter = 0, leave = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double a = (box.low[i] - margin[i] - ray.origin[i]) / ray.direction[i];
        const double b = (box.high[i] + margin[i] - ray.origin[i]) / ray.direction[i];
        enter = std::fmax(enter, std::fmin(a, b)); // fmin and fmax pass over 0 / 0
        leave = std::fmin(leave, std::fmax(a, b));
    }
    return {enter, leave};
}

using Tree = std::shared_future<std::shared_ptr<const SphereTree>>;

/// Equal for soups of one shape.
std::size_t keyOf(const TriangleSoup& soup) {
    const std::hash<double> hash;
    std::size_t key = soup.triangles.size() * 31 + soup.positions.size();
    if (!soup.positions.empty())
        for (const Vec3& p : {soup.positions.front(), soup.positions.back()})
            key = key * 31 + hash(p.x()) + 7 * hash(p.y()) + 17 * hash(p.z());
    return key;
}

bool isReady(const auto& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// Body frame; of segments and points any.
Vec3 normalOf(const TriangleSoup& soup, Index triangle) {
    const auto& t = soup.triangles[triangle];
    const Vec3& a = soup.positions[t[0]];
    const Vec3 normal = (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a);
    return normal.squaredNorm() > 0 ? normal.stableNormalized() : Vec3(Vec3::UnitZ());
}

/// Of a box of the body frame, world frame.
Bounds boxAround(const Bounds& own, const Pose& pose) {
    Bounds box;
    if (own.empty()) return box;
    for (int corner = 0; corner < 8; ++corner)
        box.add(pose.apply({(corner & 1 ? own.high : own.low).x(), (corner & 2 ? own.high : own.low).y(),
                            (corner & 4 ? own.high : own.low).z()}));
    return box;
}

constexpr std::size_t kSpanningPoints = 20000;

} // namespace

std::vector<Vec3> spanningPoints(const Scene& scene) {
    std::vector<Vec3> points;
    const std::size_t stride = 1 + 3 * triangleCount(scene) / kSpanningPoints;
    for (const SceneObject& object : scene.objects) {
        const TriangleSoup& soup = *object.geometry;
        for (std::size_t i = 0; i < 3 * soup.triangles.size(); i += stride)
            points.push_back(object.pose.apply(soup.positions[soup.triangles[i / 3][i % 3]]));
    }
    return points;
}

void ScenePicker::setScene(const Scene& scene) {
    Known known;
    for (const Target& target : targets_)
        known.emplace(keyOf(*target.soup), &target);
    std::vector<Target> targets;
    bounds_ = Bounds();
    for (const SceneObject& object : scene.objects) {
        const Target& target = targets.emplace_back(targetOf(object, known));
        if (target.box.empty()) continue;
        bounds_.add(target.box.low);
        bounds_.add(target.box.high);
    }
    buildTrees(targets);
    targets_ = std::move(targets);
}

void ScenePicker::put(Target& target, const Pose& pose) {
    if (target.pose == pose) return;
    if (!target.own) {
        target.own.emplace();
        for (const Vec3& point : target.soup->positions)
            target.own->add(point);
    }
    target.pose = pose;
    target.box = boxAround(*target.own, pose);
}

void ScenePicker::put(std::span<const PlacedObject> places) {
    for (const PlacedObject& placed : places)
        for (Target& target : targets_)
            if (target.object == placed.object) put(target, placed.pose);
}

void ScenePicker::putNoOthers(std::span<const PlacedObject> places) {
    for (Target& target : targets_)
        if (std::ranges::find(places, target.object, &PlacedObject::object) == places.end())
            put(target, target.rest);
}

/// What is known of the same geometry, as far as it still holds.
ScenePicker::Target ScenePicker::targetOf(const SceneObject& object, const Known& known) const {
    const auto [first, last] = known.equal_range(keyOf(*object.geometry));
    const Target* same = nullptr;
    for (auto at = first; at != last && !same; ++at)
        if (haveSameShape(*at->second->soup, *object.geometry)) same = at->second;
    Target target{object.id,
                  object.pose,
                  object.geometry,
                  same ? same->tree : Tree(),
                  object.visible,
                  {},
                  same && same->pose == object.pose ? same->box : boundsOf(object)};
    target.rest = object.pose;
    for (const Surface& surface : object.surfaces)
        target.sides.push_back(surface.visible ? Sides::Both : Sides::None);
    return target;
}

// One thread for all of them: a scene may have thousands.
void ScenePicker::buildTrees(std::vector<Target>& targets) {
    std::erase_if(builders_, [](const auto& builder) { return isReady(builder); });
    using Built = std::shared_ptr<const SphereTree>;
    std::vector<std::pair<std::shared_ptr<const TriangleSoup>, std::promise<Built>>> work;
    for (Target& target : targets) {
        if (target.tree.valid()) continue;
        target.tree = work.emplace_back(target.soup, std::promise<Built>()).second.get_future().share();
    }
    if (work.empty()) return;
    builders_.push_back(std::async(std::launch::async, [work = std::move(work)]() mutable {
        for (auto& [soup, promise] : work)
            promise.set_value(std::make_shared<const SphereTree>(*soup));
    }));
}

// Nearest boxes first, so that those behind what is hit are not asked.
std::optional<PickHit> ScenePicker::cast(const Ray& ray, Patience patience, double farthest) const {
    std::vector<std::pair<double, const Target*>> met;
    for (const Target& target : targets_) {
        if (!target.visible || target.box.empty()) continue;
        if (const auto [enter, leave] = spanOf(target.box, ray); enter <= std::min(leave, farthest))
            met.emplace_back(enter, &target);
    }
    std::ranges::stable_sort(met, {}, &std::pair<double, const Target*>::first);
    std::optional<PickHit> nearest;
    for (const auto& [enter, target] : met) {
        const double reach = nearest ? nearest->distance : farthest;
        if (enter > reach) break;
        if (patience == Patience::Now && !isReady(target->tree)) continue;
        if (auto hit = castAt(*target, ray, reach)) nearest = hit;
    }
    return nearest;
}

std::pair<double, double> ScenePicker::spanOf(const Bounds& box, const Ray& ray) const {
    auto [enter, leave] = spanIn(box, ray);
    if (!section_) return {enter, leave};
    const double height = section_->height(ray.origin), rise = section_->normal().dot(ray.direction);
    if (rise > 0) leave = std::min(leave, -height / rise);
    if (rise < 0) enter = std::max(enter, -height / rise);
    if (rise == 0 && height > 0) leave = -1; // all along it
    return {enter, leave};
}

// The hierarchy is made for the short moves of a proxy: it looks at everything within a move's length. So the
// ray goes through the body's box in short pieces.
std::optional<PickHit> ScenePicker::castAt(const Target& target, const Ray& ray, double reach) const {
    if (!(bounds_.diagonal() > 0)) return std::nullopt;
    const auto [enter, leave] = spanOf(target.box, ray);
    const double piece = std::max(target.box.diagonal(), kSmallestBox * bounds_.diagonal()) / kPieces,
                 last = std::min(leave, reach);
    const Vec3 motion = piece * target.pose.rotateInverse(ray.direction);
    for (double d = enter; d < last; d += piece) {
        const SpherePath path{target.pose.applyInverse(ray.at(d)), motion, kRayThickness * bounds_.diagonal(),
                              target.sides};
        const SweepHit hit = target.tree.get()->sweep(*target.soup, path, {});
        const double distance = d + hit.t * piece;
        if (hit.t <= 1 && distance <= std::min(reach, leave))
            return PickHit{{target.object, target.soup->surfaceOf[hit.triangle]},
                           hit.triangle,
                           ray.at(distance),
                           target.pose.rotate(normalOf(*target.soup, hit.triangle)),
                           distance};
    }
    return std::nullopt;
}

std::shared_ptr<const TriangleSoup> ScenePicker::soupOf(ObjectId object) const {
    const auto target = std::ranges::find(targets_, object, &Target::object);
    return target == targets_.end() ? nullptr : target->soup;
}

bool ScenePicker::isFree(const Vec3& from, const Vec3& to) const {
    const double length = (to - from).norm();
    if (!(length > 0)) return true;
    const auto hit = cast({from, (to - from) / length}, Patience::Wait);
    return !hit || hit->distance > length;
}

bool ScenePicker::isClear(const Vec3& from, const Vec3& to) const {
    const double length = (to - from).norm();
    if (!(length > 0)) return true;
    const Ray ray{from, (to - from) / length};
    return std::ranges::none_of(targets_, [&](const Target& target) {
        if (!target.visible || target.box.empty()) return false;
        const auto [enter, leave] = spanIn(target.box, ray);
        return enter <= leave && enter <= length;
    });
}

} // namespace tactum
