// The virtual proxy: the massless sphere that stays outside while the finger goes in (section 2).
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "core/proxy/contact.h"
#include "core/proxy/nearest_point.h"

namespace tactum {

/// Rounds of move and update in one step. A corner needs one for each of its planes and one to settle; falls
/// of centimetres over scanned meshes need the most, a few for each facet on the way: of six million steps
/// over the meshes of docs/physics/friction.md twelve needed more than 48, two more than 64, and those ended
/// within 4 um. Over random ground with friction 7 of 10,000 need more, and fall on in the next step.
inline constexpr int kMaxRounds = 64;
/// Where there is no time for all: enough for a corner, and the proxy comes after in the next steps.
inline constexpr int kFewRounds = 6;
/// The sweep's sphere is smaller than the proxy by this part of the radius, while constraint planes hold the
/// proxy at its full radius: a slide along a flat neighbour is then never mistaken for a collision. The
/// clearance is therefore at least r (1 - kSkin): one nanometre short for a proxy of one millimetre.
inline constexpr double kSkin = 1e-6;

/// A plane that the finger is felt to be held by, of one of the contacts.
struct FeltPlane {
    Vec3 normal = Vec3::UnitZ(); ///< world frame
    std::uint32_t body = 0;
    Index triangle = 0;
};

/// A body that passed over the proxy where there was no room left: it is not felt until the proxy is found
/// outside it again, on the side from which it came.
struct PassedBody {
    std::uint32_t body = 0;   ///< index of the obstacle
    Vec3 at_B = Vec3::Zero(); ///< where the proxy would be had it stayed outside, body frame
};

/// Of the bodies with surfaces that are felt from one side alone the proxy can be half through so many at
/// once; of what is beyond, the side is that of its centre.
inline constexpr int kMaxStraddled = 8;

/// A body with such surfaces that the proxy overlaps: it goes on passing through what it came to from the
/// wrong side, however far its centre is, until it was clear of the body once. The side of every surface is
/// that of one place: who goes half through a wall far around a bend is held by what he comes to from the
/// other side of its plane.
struct StraddledBody {
    std::uint32_t body = 0;     ///< index of the obstacle
    Vec3 from_B = Vec3::Zero(); ///< where the proxy last was clear of it, body frame
};

inline constexpr std::uint32_t kNoBody = ~std::uint32_t(0);
/// Equal to no place.
inline const Vec3 kNowhere = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());

/// At most so many bodies pass over the proxy at once; one more stays in its way.
inline constexpr int kMaxPassed = 64;

struct ProxyState {
    Vec3 position = Vec3::Zero(); ///< world frame
    Vec3 finger = Vec3::Zero();   ///< of the last step, world frame
    std::array<Contact, kMaxPlanes> contacts{};
    int contactCount = 0;
    /// Of shaded and textured surfaces: where forces go along other normals than the contacts'. Empty when
    /// no contact is of that kind.
    std::array<FeltPlane, 3> felt{};
    int feltCount = 0;
    double speed = 0; ///< of the proxy in the last step, m/s
    /// How far it may go at once on a felt surface, m: less whenever it turned back, so that it comes to rest
    /// between two facets that push it toward each other.
    double stride = std::numeric_limits<double>::infinity();
    /// Steps since the finger moved.
    int stillFor = 0;
    /// The body that the proxy last slid on: a contact that it meets next slips.
    std::uint32_t slidingOn = kNoBody;
    /// Where the contacts' planes were last seen from, world frame: from there they are what they are.
    /// Nowhere where that is not known, which costs a look and changes nothing.
    Vec3 seenFrom = kNowhere;
    /// Of the obstacles, each at its number modulo the size.
    std::array<SweepMemory, 4> memories{};
    std::array<PassedBody, kMaxPassed> passed{};
    int passedCount = 0;
    std::array<StraddledBody, kMaxStraddled> straddled{};
    int straddledCount = 0;
};

class NearBodies;

struct ProxyReport {
    int rounds = 0;
    bool boundHit = false; ///< the rounds ended the step; the state is valid and the next step goes on
    bool squeezed = false; ///< between surfaces that leave less room than the proxy needs
    bool passed = false;   ///< without any room left: a moving body passed over the proxy
};

/// Puts the proxy onto the finger, touching nothing. Thread: real time.
void restart(ProxyState& state, const Vec3& finger_W) noexcept;

/// Moves and updates the proxy toward the finger for one step of dt seconds, r = `radius` in metres.
/// After it the clearance is at least r (1 - kSkin) to everything that the proxy was clear of before and that
/// is felt from where it came. The distance to the finger has grown only where a moving body pushed or
/// carried the proxy, where it came out of a squeeze, and on shaded or textured surfaces. `contacts` holds
/// what is touched. `movers`: what the obstacles' `mover` names, how each of them moved in this step.
/// `mostRounds` end the step, at most kMaxRounds: the next one goes on from there. `near`: of these
/// obstacles, where they are many; without it each is looked at. Obstacles at rest and the radius are as in
/// the step before, or the proxy was restarted. Thread: real time; at most as many sweeps of each obstacle,
/// one more where a felt step ends by its bound, and before them, where `movers` move, those of carry(). With
/// every move one nearestOn() of each body in reach that is felt from one side alone.
ProxyReport moveAndUpdate(ProxyState& state, std::span<const Obstacle> obstacles, double radius,
                          const Vec3& finger_W, double dt, const StepMotions& movers = {},
                          int mostRounds = kMaxRounds, const NearBodies* near = nullptr) noexcept;

} // namespace tactum
