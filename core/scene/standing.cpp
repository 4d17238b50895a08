#include "core/scene/standing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "core/scene/object_bounds.h"

namespace tactum {
namespace {

constexpr double kGap = 0.1;              // between things, of the longer side of what comes
constexpr double kTouching = 1e-6;        // of its size: what only touches is not inside
constexpr double kFlat = 0.2;             // of the shorter side: a floor is no higher
constexpr std::size_t kMostBoxes = 1'000; // beside more of them, only beside all

struct Surroundings {
    std::vector<Bounds> boxes;   ///< without the floor
    std::optional<Bounds> floor; ///< what lies beneath all others, if it is flat

    std::optional<double> lowest() const {
        if (floor) return floor->low.y();
        if (boxes.empty()) return std::nullopt;
        return std::ranges::min(boxes, {}, [](const Bounds& box) { return box.low.y(); }).low.y();
    }
};

void join(Bounds& box, const Bounds& other) {
    if (other.empty()) return;
    box.add(other.low);
    box.add(other.high);
}

bool isFlat(const Bounds& box) {
    const Vec3 size = box.high - box.low;
    return size.y() <= kFlat * std::min(size.x(), size.z());
}

Surroundings surroundingsOf(const Scene& scene, const std::vector<ObjectId>& without) {
    Surroundings around;
    for (const SceneObject& object : scene.objects) {
        if (!object.visible || std::ranges::find(without, object.id) != without.end()) continue;
        if (const Bounds box = boundsOf(object); !box.empty()) around.boxes.push_back(box);
    }
    auto& boxes = around.boxes;
    const auto lowest = std::ranges::min_element(boxes, {}, [](const Bounds& box) { return box.low.y(); });
    const auto isAbove = [&](const Bounds& box) {
        return &box == &*lowest || box.low.y() >= lowest->centre().y();
    };
    if (lowest != boxes.end() && isFlat(*lowest) && std::ranges::all_of(boxes, isAbove)) {
        around.floor = *lowest;
        boxes.erase(lowest);
    }
    if (boxes.size() > kMostBoxes) {
        Bounds all;
        for (const Bounds& box : boxes)
            join(all, box);
        boxes = {all};
    }
    return around;
}

bool meet(const Bounds& a, const Bounds& b, double tolerance) {
    return ((a.low.array() + tolerance < b.high.array()) && (b.low.array() + tolerance < a.high.array()))
        .all();
}

/// Seen from above.
bool liesOver(const Bounds& box, const Bounds& floor) {
    return box.low.x() >= floor.low.x() && box.high.x() <= floor.high.x() && box.low.z() >= floor.low.z() &&
           box.high.z() <= floor.high.z();
}

Bounds moved(Bounds box, const Vec3& way) {
    box.low += way, box.high += way;
    return box;
}

/// To the four sides of another box, in the order of preference; y stays.
std::array<Vec3, 4> waysBeside(const Bounds& box, const Bounds& other) {
    const Vec3 size = box.high - box.low, half = 0.5 * (size + other.high - other.low);
    const double gap = kGap * std::max(size.x(), size.z());
    const Vec3 x = (half.x() + gap) * Vec3::UnitX(), z = (half.z() + gap) * Vec3::UnitZ();
    Vec3 middle = other.centre() - box.centre();
    middle.y() = 0;
    return {middle + x, middle + z, middle - x, middle - z};
}

/// As far along x and z, by turns as waysBeside() has them, but not into line with the other box.
std::array<Vec3, 4> straightWaysBeside(const Bounds& box, const Bounds& other) {
    std::array<Vec3, 4> ways = waysBeside(box, other);
    for (std::size_t i = 0; i < ways.size(); ++i)
        ways[i][i % 2 == 0 ? 2 : 0] = 0;
    return ways;
}

using Ways = std::array<Vec3, 4>(const Bounds& box, const Bounds& other);

/// The shortest way to where the box meets nothing, beside one of the things or where it is; along y none.
std::optional<Vec3> wayBesideAny(const Bounds& box, const std::vector<Bounds>& things,
                                 const std::optional<Bounds>& within = {}, Ways& ways = waysBeside) {
    const double rounding = kTouching * box.diagonal();
    double shortest = std::numeric_limits<double>::infinity();
    std::optional<Vec3> best;
    const auto offer = [&](const Vec3& way) {
        const Bounds there = moved(box, way);
        if (way.norm() + rounding >= shortest || (within && !liesOver(there, *within))) return;
        if (std::ranges::any_of(things, [&](const Bounds& thing) { return meet(there, thing, rounding); }))
            return;
        shortest = way.norm();
        best = way;
    };
    offer(Vec3::Zero());
    for (const Bounds& thing : things)
        for (const Vec3& way : ways(box, thing))
            offer(way);
    return best;
}

/// To stand on a height, over the middle of something.
Vec3 wayOver(const Bounds& box, const Bounds& thing, double height) {
    const Vec3 from = box.centre(), to = thing.centre();
    return {to.x() - from.x(), height - box.low.y(), to.z() - from.z()};
}

} // namespace

Bounds boundsOf(const Scene& scene, std::span<const ObjectId> objects) {
    Bounds box;
    for (const ObjectId id : objects)
        if (const SceneObject* object = scene.find(id)) join(box, boundsOf(*object));
    return box;
}

Vec3 wayToRoom(const Scene& scene, const Bounds& box) {
    if (box.empty()) return Vec3::Zero();
    Surroundings around = surroundingsOf(scene, {});
    const auto lowest = around.lowest();
    if (!lowest) return -Vec3(box.centre().x(), box.low.y(), box.centre().z());
    if (around.floor) {
        const Vec3 onto = wayOver(box, *around.floor, around.floor->high.y());
        if (const auto way = wayBesideAny(moved(box, onto), around.boxes, around.floor)) return onto + *way;
        around.boxes.push_back(*around.floor);
    }
    Bounds all;
    for (const Bounds& each : around.boxes)
        join(all, each);
    const Vec3 onto = wayOver(box, all, *lowest);
    const Bounds there = moved(box, onto);
    for (Bounds& each : around.boxes) // neither over nor under anything
        each.low.y() = all.low.y(), each.high.y() = std::max(all.high.y(), there.high.y());
    return onto + wayBesideAny(there, around.boxes).value_or(Vec3::Zero());
}

Vec3 wayBeside(const Scene& scene, const Bounds& box) {
    if (box.empty()) return Vec3::Zero();
    Surroundings around = surroundingsOf(scene, {});
    if (around.floor) around.boxes.push_back(*around.floor);
    // Beyond the outermost there is always one.
    return wayBesideAny(box, around.boxes, {}, straightWaysBeside).value_or(Vec3::Zero());
}

double wayToGround(const Scene& scene, const GoingAlong& along) {
    const Bounds box = boundsOf(scene, along.objects);
    if (box.empty()) return 0;
    const Surroundings around = surroundingsOf(scene, along.objects);
    const double rounding = kTouching * box.diagonal();
    const auto isUnder = [&](const Bounds& other) {
        Bounds column = box;
        column.low.y() = other.low.y() - 1, column.high.y() = other.high.y() + 1;
        return meet(column, other, rounding);
    };
    double level = around.lowest().value_or(0);
    if (around.floor && isUnder(*around.floor)) level = around.floor->high.y();
    for (const Bounds& other : around.boxes)
        if (other.high.y() <= box.low.y() + rounding && isUnder(other))
            level = std::max(level, other.high.y());
    const double way = level - box.low.y();
    return std::abs(way) > rounding ? way : 0;
}

} // namespace tactum
