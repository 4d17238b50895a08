// Every sweep of a replay, as the proxy asked for it.
#pragma once

#include <vector>

#include "core/collision/sphere_tree.h"

namespace tactum::bench {

struct RecordedSweep {
    SpherePath path;
    std::vector<Index> excluded;
};

/// While it is not null every sweep of the proxy is appended there. Not for several threads.
extern std::vector<RecordedSweep>* sweepRecord;

} // namespace tactum::bench
