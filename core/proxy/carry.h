// The first stage of the update: bodies have moved, and take the proxy along or push it before them.
#pragma once

#include <span>

#include "core/motion/movers.h"
#include "core/proxy/proxy.h"

namespace tactum {

/// A moving body's way in one step is cut into at most so many pieces, each straight enough for its sweep.
inline constexpr int kMaxPieces = 64;
/// Times that the proxy is kept out of something in one piece; each takes a sweep, and one more shows that
/// the place is free. What is not settled by then passes over the proxy.
inline constexpr int kMaxCarryRounds = 16;
/// What the bodies' own motion did.
struct CarryReport {
    /// Where the proxy would be had nothing pushed it: where it was, or where the body took it that holds it
    /// by friction. World frame. The state's finger of the last step went with that body too, so that what is
    /// compared with them is seen from the body.
    Vec3 start = Vec3::Zero();
    bool squeezed = false; ///< between surfaces with less room than the proxy needs
    bool passed = false;   ///< there was none: a body passed over the proxy
    int sweeps = 0;        ///< of a body, in the piece that took most: at most kMaxCarryRounds + 1
};

/// Takes the proxy from where the bodies were to where they are, sweeping its motion relative to each body in
/// that body's own frame: from before^-1 x old proxy to now^-1 x new proxy. The proxy rides with the body
/// that holds it by friction, any other pushes it out of its way and no farther. It is swept against all
/// bodies, moving or not. What pushed it is among the contacts afterwards, to be located anew.
///
/// With less room than it needs it gives way evenly to all sides, so that its centre stays between them.
/// Without any room a moving body passes over it and is not felt until there is a free way back to the side
/// on which the proxy was. A body that jumps farther than the proxy is wide lets it go and touches nothing on
/// its way.
///
/// Thread: real time; at most kMaxPieces x (kMaxCarryRounds + 1) sweeps of each body, and again for every
/// body that passes over or lets the proxy go; one sweep of the bodies in reach is usual.
CarryReport carry(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers,
                  double radius, const NearBodies* near = nullptr) noexcept;

} // namespace tactum
