// The stiffness ceiling as a person can read it: what the machine's jitter does to it settles first.
#pragma once

#include "ui/engine/health_words.h"

namespace tactum {

/// The servo's ceiling follows every late tick and comes back over seconds. Shown is a value that it stays
/// within 5 % of; another one once it has stayed beyond that, on one side: lower for a second, higher for
/// three. What has another cause than a late servo (the device, the grip, the surface, an oscillation) is
/// shown at once. Thread: ui.
class SteadyCeiling {
public:
    static constexpr double kUnseen = 0.05;
    static constexpr double kFalls = 1, kRises = 3; ///< s

    /// `time`: s, of a steady clock. Whether the value that is shown is another one for a late servo, or one
    /// that is in time again.
    bool follow(const CeilingNow& now, double time);
    const CeilingNow& shown() const { return shown_; }
    /// Another device: what comes next is shown at once.
    void forget() { *this = {}; }

private:
    CeilingNow shown_, next_; ///< next: the nearest to what is shown since it began to stay beyond
    double since_ = -1;       ///< s; < 0: nothing is about to change
};

} // namespace tactum
