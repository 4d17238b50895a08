#include "ui/view/scene_picker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/scene/object_bounds.h"

namespace tactum {

namespace {

/// A ray is the sweep of a sphere this small, as a part of the scene's size.
constexpr double kRayThickness = 1e-6;

constexpr int kPieces = 96;

/// Where a ray enters and leaves a slightly larger box; an empty span if it misses it.
std::pair<double, double> spanIn(const Bounds& box, const Ray& ray) {
    const Vec3 margin = Vec3::Constant(1e-3 * box.diagonal());
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

Tree buildTree(const std::shared_ptr<const TriangleSoup>& soup) {
    return std::async(
               std::launch::async,
               [soup] { return std::shared_ptr<const SphereTree>(std::make_shared<SphereTree>(*soup)); })
        .share();
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
    std::vector<Target> targets;
    bounds_ = Bounds();
    for (const SceneObject& object : scene.objects) {
        const Target& target = targets.emplace_back(targetOf(object));
        if (target.box.empty()) continue;
        bounds_.add(target.box.low);
        bounds_.add(target.box.high);
    }
    targets_ = std::move(targets);
}

/// What is known of the same geometry, as far as it still holds.
ScenePicker::Target ScenePicker::targetOf(const SceneObject& object) const {
    const auto known = std::find_if(targets_.begin(), targets_.end(),
                                    [&](const auto& t) { return haveSameShape(*t.soup, *object.geometry); });
    const bool same = known != targets_.end();
    Target target{object.id,
                  object.pose,
                  object.geometry,
                  same ? known->tree : buildTree(object.geometry),
                  object.visible,
                  {},
                  same && known->pose == object.pose ? known->box : boundsOf(object)};
    for (const Surface& surface : object.surfaces)
        target.sides.push_back(surface.visible ? Sides::Both : Sides::None);
    return target;
}

std::optional<PickHit> ScenePicker::cast(const Ray& ray, Patience patience) const {
    std::optional<PickHit> nearest;
    for (const Target& target : targets_) {
        if (!target.visible || (patience == Patience::Now && !isReady(target.tree))) continue;
        const double reach = nearest ? nearest->distance : std::numeric_limits<double>::infinity();
        if (auto hit = castAt(target, ray, reach)) nearest = hit;
    }
    return nearest;
}

// The hierarchy is made for the short moves of a proxy: it looks at everything within a move's length. So the
// ray goes through the scene's box in short pieces.
std::optional<PickHit> ScenePicker::castAt(const Target& target, const Ray& ray, double reach) const {
    if (!(bounds_.diagonal() > 0)) return std::nullopt;
    const auto [enter, leave] = spanIn(bounds_, ray);
    const double piece = bounds_.diagonal() / kPieces, last = std::min(leave, reach);
    const Vec3 motion = piece * target.pose.rotateInverse(ray.direction);
    for (double d = enter; d < last; d += piece) {
        const SpherePath path{target.pose.applyInverse(ray.at(d)), motion, kRayThickness * bounds_.diagonal(),
                              target.sides};
        const SweepHit hit = target.tree.get()->sweep(*target.soup, path, {});
        const double distance = d + hit.t * piece;
        if (hit.t <= 1 && distance <= reach)
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

} // namespace tactum
