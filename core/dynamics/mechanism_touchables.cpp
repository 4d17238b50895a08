#include "core/dynamics/mechanism_touchables.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tactum {

namespace {

/// Each two of them have a bit.
constexpr std::size_t kMostTouchables = 8192;

bool hasAny(const std::vector<std::string>& names, const std::vector<std::string>& among) {
    return std::ranges::any_of(
        names, [&](const std::string& name) { return std::ranges::find(among, name) != among.end(); });
}

/// Whether one filter lets the other's systems come (KHR_physics_rigid_bodies, Collision Filtering).
bool lets(const CollisionFilter& own, const CollisionFilter& other) {
    if (!own.with.empty() && !hasAny(other.systems, own.with)) return false;
    return !hasAny(other.systems, own.notWith);
}

} // namespace

Result<void> addTouchables(Mechanism& made, std::span<const Joint> joints,
                           std::span<const Collider> colliders) {
    if (colliders.size() > kMostTouchables)
        return inputError("the scene has " + std::to_string(colliders.size()) + " colliders, and at most " +
                          std::to_string(kMostTouchables) + " can touch each other; join some of them");
    using Thing = std::pair<BodyId, std::uint32_t>; // a body, or a part of the world
    const auto thingOf = [](BodyId body, std::uint32_t part) {
        return Thing{body, body == kWorldBody ? part : 0};
    };
    std::set<std::pair<Thing, Thing>> joined;
    for (const Joint& joint : joints) {
        const Thing a = thingOf(joint.a, joint.part), b = thingOf(joint.b, joint.part);
        const bool isPlain = a == Thing{} || b == Thing{}; // the world, but no thing in particular
        if (!joint.collide && !isPlain) joined.insert({std::min(a, b), std::max(a, b)});
    }
    std::map<BodyId, const Place*> placeOf;
    for (std::size_t i = 0; i < made.bodies.size(); ++i)
        placeOf[made.bodies[i].id] = &made.places[i];
    std::vector<const Collider*> from;
    for (const Collider& collider : colliders) {
        const auto found = placeOf.find(collider.body);
        const Place* body = found == placeOf.end() ? nullptr : found->second;
        Touchable touchable;
        touchable.place = body ? Place{body->link, body->pose * collider.pose} : Place{-1, collider.pose};
        touchable.convex = convexOf(collider.shape);
        touchable.material = collider.material;
        from.push_back(&collider);
        made.touchables.push_back(std::move(touchable));
    }
    const auto isFixedIn = [&](const Touchable& one) {
        if (one.place.link < 0) return true;
        const Link& link = made.links[std::size_t(one.place.link)];
        return link.driven == kAllAxes && link.kind == LinkKind::Ball && link.parent >= 0 &&
               made.links[std::size_t(link.parent)].driven != 0;
    };
    const std::size_t count = from.size();
    made.meets.assign(count * count, false);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const Touchable &a = made.touchables[i], &b = made.touchables[j];
            const bool apart = from[i]->body != from[j]->body && a.place.link != b.place.link &&
                               !(isFixedIn(a) && isFixedIn(b));
            made.meets[i * count + j] =
                apart &&
                !joined.contains(std::minmax(thingOf(from[i]->body, from[i]->part),
                                             thingOf(from[j]->body, from[j]->part))) &&
                lets(from[i]->filter, from[j]->filter) && lets(from[j]->filter, from[i]->filter);
        }
    return {};
}

} // namespace tactum
