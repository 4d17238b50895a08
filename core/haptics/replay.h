// A recorded finger through hapticStep, single-threaded and deterministic: the replay behind `tactum touch`.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/haptics/world.h"
#include "core/scene/finger_path.h"

namespace tactum {

/// One haptic step of a replay. World frame, SI.
struct TouchRow {
    double t = 0;
    Vec3 finger = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    Vec3 force = Vec3::Zero();
    int contacts = 0;
    int rounds = 0;            ///< of move and update
    std::int64_t updateNs = 0; ///< how long the step took, that of all hands
    double tangential = 0;     ///< N of the force along the surfaces that push
};
using TouchTrace = std::vector<TouchRow>;
using FingerPath = std::vector<FingerPoint>;

/// One haptic step for each point of the path; its time step is the time since the point before. Bodies that
/// move by themselves are at each point where the path's time puts them.
TouchTrace replay(const World& world, const FingerPath& path);
/// The same; fails when it is cancelled.
Result<TouchTrace> replay(const World& world, const FingerPath& path, const Progress& progress);
/// The same for one to kMaxHands hands in one World: a trace for each path, in their order. The first path
/// has the times of the steps. At each the other fingers are where their paths have them, straight between
/// two points; they rest before the first and after the last. An empty path leaves all traces empty.
Result<std::vector<TouchTrace>> replay(const World& world, std::span<const FingerPath> paths,
                                       const Progress& progress);

struct UpdateTimes {
    double mean = 0;
    std::int64_t median = 0, p99 = 0, p999 = 0, max = 0; ///< ns
};
UpdateTimes updateTimes(const TouchTrace& rows);

} // namespace tactum
