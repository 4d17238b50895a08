#include "core/motion/movers.h"

#include <algorithm>

namespace tactum {

BodyMotion StepMotions::of(int mover) const noexcept {
    if (movers_.empty()) return given_[std::size_t(mover)];
    if (const int driven = movers_[std::size_t(mover)].driven; driven >= 0)
        return given_[std::size_t(driven)];
    for (const Found& found : found_.all())
        if (found.mover == mover) return found.motion;
    const Mover& body = movers_[std::size_t(mover)];
    if (found_.size() == found_.room()) found_.clear();
    found_.push({mover, {body.poseAt(before_), body.poseAt(now_), body.motion->jumpsBetween(before_, now_)}});
    return found_[found_.size() - 1].motion;
}

} // namespace tactum
