#include "core/scene/order.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include "core/scene/groups.h"
#include "core/scene/standing.h"

namespace tactum {

namespace {

auto isOneOf(std::span<const ObjectId> objects) {
    return [objects](const SceneObject& object) {
        return std::ranges::find(objects, object.id) != objects.end();
    };
}

double placeOf(const Bounds& box, int axis, BoxSide side) {
    return side == BoxSide::Low ? box.low[axis] : side == BoxSide::High ? box.high[axis] : box.centre()[axis];
}

/// Not by what rounding leaves of a way that was gone before.
void moveAlong(Scene& scene, const GoingAlong& part, const Bounds& box, int axis, double way) {
    if (std::abs(way) > 1e-12 * (box.diagonal() + std::abs(box.centre()[axis])))
        arrange(scene, part, {.move = way * Vec3::Unit(axis)});
}

} // namespace

void reorder(Scene& scene, std::span<const ObjectId> objects, ObjectId before) {
    const auto moves = isOneOf(objects);
    auto at = std::ranges::find(scene.objects, before, &SceneObject::id);
    at = std::find_if_not(at, scene.objects.end(), moves);
    const ObjectId behind = at == scene.objects.end() ? 0 : at->id;
    const auto moved = std::stable_partition(scene.objects.begin(), scene.objects.end(), std::not_fn(moves));
    std::vector<SceneObject> taken(std::make_move_iterator(moved),
                                   std::make_move_iterator(scene.objects.end()));
    scene.objects.erase(moved, scene.objects.end());
    const auto place = std::ranges::find(scene.objects, behind, &SceneObject::id);
    scene.objects.insert(place, std::make_move_iterator(taken.begin()), std::make_move_iterator(taken.end()));
}

namespace {

/// Whether `at`, the outermost of these, would have to leave its group for the place of `next`.
bool staysInGroup(const Scene& scene, std::span<const ObjectId> objects, const SceneObject& at,
                  const SceneObject& next) {
    return !at.group.empty() && at.group != next.group && !wholeGroups(scene, objects).contains(at.group);
}

} // namespace

void moveUp(Scene& scene, std::span<const ObjectId> objects) {
    const auto first = std::ranges::find_if(scene.objects, isOneOf(objects));
    if (first == scene.objects.end()) return;
    if (first == scene.objects.begin()) return reorder(scene, objects, first->id);
    const SceneObject& above = *std::prev(first);
    if (staysInGroup(scene, objects, *first, above)) return;
    const bool passes = !above.group.empty() && above.group != first->group;
    reorder(scene, objects, passes ? objectsOfGroup(scene, above.group).front() : above.id);
}

void moveDown(Scene& scene, std::span<const ObjectId> objects) {
    const auto end = std::find_if(scene.objects.rbegin(), scene.objects.rend(), isOneOf(objects)).base();
    if (end == scene.objects.begin()) return;
    if (end == scene.objects.end()) return reorder(scene, objects, 0);
    const SceneObject &last = *std::prev(end), &below = *end;
    if (staysInGroup(scene, objects, last, below)) return;
    const bool passes = !below.group.empty() && below.group != last.group;
    const ObjectId passed = passes ? objectsOfGroup(scene, below.group).back() : below.id;
    const auto behind = std::next(std::ranges::find(scene.objects, passed, &SceneObject::id));
    reorder(scene, objects, behind == scene.objects.end() ? 0 : behind->id);
}

void align(Scene& scene, std::span<const GoingAlong> parts, const Bounds& to, int axis, BoxSide side) {
    if (to.empty()) return;
    const double goal = placeOf(to, axis, side);
    for (const GoingAlong& part : parts)
        if (const Bounds box = boundsOf(scene, part.objects); !box.empty())
            moveAlong(scene, part, box, axis, goal - placeOf(box, axis, side));
}

void distribute(Scene& scene, std::span<const GoingAlong> parts, int axis) {
    std::vector<std::pair<double, const GoingAlong*>> row;
    for (const GoingAlong& part : parts)
        if (const Bounds box = boundsOf(scene, part.objects); !box.empty())
            row.emplace_back(box.centre()[axis], &part);
    if (row.size() < 3) return;
    std::ranges::stable_sort(row, {}, [](const auto& each) { return each.first; });
    const double first = row.front().first, step = (row.back().first - first) / double(row.size() - 1);
    for (std::size_t i = 1; i + 1 < row.size(); ++i)
        moveAlong(scene, *row[i].second, boundsOf(scene, row[i].second->objects), axis,
                  first + double(i) * step - row[i].first);
}

} // namespace tactum
