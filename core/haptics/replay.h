// A recorded finger through hapticStep, single-threaded and deterministic: the replay behind `tactum touch`.
#pragma once

#include <cstdint>
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
    std::int64_t updateNs = 0; ///< how long the step took
    double tangential = 0;     ///< N of the force along the surfaces that push
};
using TouchTrace = std::vector<TouchRow>;

/// One haptic step for each point of the path; its time step is the time since the point before. Bodies that
/// move by themselves are at each point where the path's time puts them.
TouchTrace replay(const World& world, const std::vector<FingerPoint>& path);
/// The same; fails when it is cancelled.
Result<TouchTrace> replay(const World& world, const std::vector<FingerPoint>& path, const Progress& progress);

struct UpdateTimes {
    double mean = 0;
    std::int64_t median = 0, p99 = 0, p999 = 0, max = 0; ///< ns
};
UpdateTimes updateTimes(const TouchTrace& rows);

} // namespace tactum
