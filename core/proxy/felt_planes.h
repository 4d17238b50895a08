// The update stage on surfaces that feel otherwise than their facets: shaded or textured (sections 3, 4.3).
#pragma once

#include <span>

#include "core/proxy/proxy.h"

namespace tactum {

/// The smallest feature of a texture passes by in so many steps. Of waves as short nothing is left, for the
/// steps would show them as others; from eight times of it on all is. At a rate f frequencies up to f / 20
/// are whole, half is left of f / 7, and none of f / 2.5.
inline constexpr double kStepsToAFeature = 2.5;
/// Features of a texture below this part of the proxy's radius are not felt at any speed.
inline constexpr double kFinestFeature = 0.05;

/// What the update stage works on. World frame, SI.
struct FeltContacts {
    std::span<const Obstacle> obstacles;
    const StepMotions& movers;
    std::span<Contact> contacts;
    double radius = 0;
    Vec3 finger = Vec3::Zero();
    double smallestFeature = 0; ///< of the texture, m
};

/// Whether any of the contacts is on a surface with shading or texture. Thread: real time.
bool isFelt(std::span<const Obstacle> obstacles, std::span<const Contact> contacts) noexcept;

/// Both passes of section 3. Returns where the proxy would go without friction, relative to where it is: zero
/// exactly where the finger is held by a force along the felt normals. The multipliers are those of the
/// contacts' true planes, in their order. Writes them into the contacts, with the materials that are felt,
/// and lists the felt planes that push. Thread: real time; two minimisations and one sample of the texture
/// for each contact.
NearestPoint updateFelt(ProxyState& state, const FeltContacts& on) noexcept;

/// How much of `slide` leads on, after `drop`, of what updateFelt wished: the felt normal, the depth and the
/// friction change on the way, and beyond the place where the wish turns back, or where friction holds what
/// is left of it, the proxy would swing to and fro. `hold`: what friction holds back of the wish at the
/// beginning, m. At most 1, or 2 with `mayExtend`, where the wish is seen to reach farther. Thread: real
/// time; at most eleven updates.
double feltReach(const ProxyState& state, const FeltContacts& on, const Vec3& drop, const Vec3& slide,
                 double hold, bool mayExtend) noexcept;

} // namespace tactum
