// Where a proxy touches, or would touch, a surface that feels otherwise than its facets.
#pragma once

#include "core/proxy/contact.h"

namespace tactum {

/// Where a place is looked at. At those that the proxy may go to a face that it touches counts as going on
/// beyond its edges: what comes there is not known, and seldom an end. What rubs does not come back from
/// where it went too far, and is asked what it would touch there.
enum class Look : std::uint8_t { Here, AheadInPlane, AheadOverEdges };

/// The closest point, and the triangle that it is on. Body frame.
struct Foot {
    ClosestPoint point;
    Index triangle = 0;
};

/// Of a proxy at `centre` (body frame), which touches the contact's triangle now. Over edges it looks at
/// shaded surfaces alone, whose compiling knows the neighbours. Thread: real time; at most six triangles.
Foot footAt(const Contact& contact, const Obstacle& obstacle, const Vec3& centre, Look where) noexcept;

} // namespace tactum
