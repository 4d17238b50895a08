// Judges how a proxy slides from the triangles alone: formulas of its own, nothing of the program's.
#pragma once

#include <limits>

#include "tests/support/exactness.h"

namespace tactum::bench {

/// The place of a mesh that is nearest to a point.
struct NearestPlace {
    Vec3 point = Vec3::Zero();
    double distance = std::numeric_limits<double>::infinity(); ///< m
    std::size_t triangle = 0;
    const char* on = "nothing"; ///< "face", "edge" or "corner" of it
};

/// Looks at every triangle within `reach` of p, which grows until there is one.
NearestPlace nearestPlace(const test::TriangleGrid& grid, const Vec3& p, double reach);

/// What a step says of itself.
struct SlideStep {
    Vec3 finger = Vec3::Zero(), proxy = Vec3::Zero(); ///< m
    int planes = 0;                                   ///< that push
    bool slips = false;                               ///< all of them
};

/// What there is to say of a step.
struct JudgedStep {
    NearestPlace touched;
    double gap = 0;   ///< from the proxy's surface to what is nearest, m
    double ratio = 0; ///< of the tangential to the normal part of the way from the finger to the proxy
    double pace = 0;  ///< of the proxy to the finger in this step
    /// The ratio shall be mu: in four steps, of which this is the last, everything slips on one plane, and
    /// the proxy goes by 0.7 to 1.3 of the finger's way. A step that ends on a surface which leans more
    /// against the way than where the step began is none: it leads into a fold, and there the proxy arrives
    /// within the cone of the next facet, and waits.
    bool isSteady = false;
};

/// Of one proxy, from step to step.
class FrictionJudge {
public:
    /// `radius` of the proxy, m. Keeps a reference to the grid.
    FrictionJudge(const test::TriangleGrid& grid, double radius) : grid_(grid), radius_(radius) {}

    JudgedStep judge(const SlideStep& step);

private:
    const test::TriangleGrid& grid_;
    double radius_;
    SlideStep before_;
    Vec3 normalBefore_ = Vec3::Zero();
    int steady_ = 0; ///< steps in a row
};

} // namespace tactum::bench
