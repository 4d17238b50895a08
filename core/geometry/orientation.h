// Which triangles to turn over so that a mesh has one front. For this folder only.
#pragma once

#include "core/geometry/face_graph.h"

namespace tactum {

/// What to turn over. Patches are what hangs together over edges of two triangles.
///
/// In a patch whose triangles disagree the smaller area is turned. A closed patch that no other one encloses
/// then has its front outside; in one that is enclosed either may be meant (a hollow, or a body in a body),
/// so that only disagreement is repaired there. What cannot have one front (a Moebius strip) stays as it is.
struct Orientation {
    TriangleSet turned;    ///< all that are to be turned over
    TriangleSet insideOut; ///< of these, whole closed patches that agreed within themselves
    std::size_t insideOutPatches = 0;
};

/// Linear but for closed patches that look inside out: each is compared with those whose box holds it, up to
/// 200 million triangles; what comes later stays as it is. Fails only when cancelled.
Result<Orientation> orientationOf(const FaceGraph& graph, const Progress& progress);

} // namespace tactum
