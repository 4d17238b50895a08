// Keeps a measurement on one core.
#pragma once

#include <sched.h>

namespace tactum::bench {

// While it lives this thread stays on the last core, so that a replay is not moved about; building and
// loading have all of them.
class OneCore {
public:
    OneCore() {
        if (sched_getaffinity(0, sizeof before_, &before_) != 0) return;
        int last = CPU_SETSIZE - 1;
        while (last > 0 && !CPU_ISSET(last, &before_))
            --last;
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(last, &one);
        changed_ = sched_setaffinity(0, sizeof one, &one) == 0;
    }
    ~OneCore() {
        if (changed_) sched_setaffinity(0, sizeof before_, &before_);
    }
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

private:
    cpu_set_t before_;
    bool changed_ = false;
};

} // namespace tactum::bench
