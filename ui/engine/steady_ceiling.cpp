#include "ui/engine/steady_ceiling.h"

#include <algorithm>
#include <cmath>

namespace tactum {

bool SteadyCeiling::follow(const CeilingNow& now, double time) {
    if (shown_.value <= 0 || !(now.late || shown_.late)) {
        shown_ = now;
        since_ = -1;
        return false;
    }
    const bool near = std::abs(now.value - shown_.value) <= kUnseen * shown_.value;
    if (near && now.reason == shown_.reason) {
        since_ = -1;
        return false;
    }
    const bool lower = now.value < shown_.value;
    if (since_ < 0 || lower != (next_.value < shown_.value)) {
        since_ = time;
        next_ = now;
    }
    if (lower ? now.value >= next_.value : now.value <= next_.value) next_ = now;
    if (time - since_ < (lower ? kFalls : kRises)) return false;
    const bool moved = std::abs(next_.value - shown_.value) > kUnseen * shown_.value;
    shown_ = next_;
    since_ = -1;
    return moved;
}

} // namespace tactum
