// The update stage on surfaces that feel otherwise than their facets: shaded or textured (sections 3, 4.3).
#pragma once

#include <span>

#include "core/proxy/proxy.h"

namespace tactum {

/// Features of a texture that pass by in less than so many steps are filtered: at a servo rate f and a slide
/// of v, what is shorter than v / (f / 10).
inline constexpr double kStepsToAFeature = 10;

/// What the update stage works on. World frame, SI.
struct FeltContacts {
    std::span<const Obstacle> obstacles;
    std::span<const BodyMotion> movers;
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

/// How much of `slide` leads on, after `drop`, of what updateFelt wished: the felt normal changes on the way,
/// and beyond the place where the wish turns back the proxy would swing to and fro. At most 1, or 2 with
/// `mayExtend`, where the wish is seen to reach farther. Thread: real time; at most nine updates.
double feltReach(const ProxyState& state, const FeltContacts& on, const Vec3& drop, const Vec3& slide,
                 bool mayExtend) noexcept;

} // namespace tactum
