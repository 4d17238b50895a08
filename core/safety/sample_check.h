// Whether a reading of the device can be true.
#pragma once

#include "core/port/haptic_device.h"
#include "core/safety/velocity_estimate.h"

namespace tactum {

/// So many readings in a row that cannot be true, and the device counts as lost.
inline constexpr int kBadSamplesToLoss = 3;

/// Judges every reading by the one before. A reading that cannot be true is not used: for one or two of them
/// the finger stays where it was, then the device is lost, until as many good ones have come in a row. Where
/// nothing was read at all the finger stays where it was. Frame D, SI. Thread: real time.
class SampleCheck {
public:
    /// A finger that seems to go at more than twice the device's tripSpeed was misread.
    explicit SampleCheck(const DeviceInfo& device) noexcept
        : fastest_(2 * device.tripSpeed), measuresVelocity_(device.measuresVelocity),
          estimate_(device.positionResolution) {}

    /// `apart`: s from the valid reading before to this one; 0: it is that one once more, which says nothing
    /// new (ReadingClock). Returns whether the reading was believed.
    bool operator()(const DeviceSample& sample, double apart) noexcept;

    /// Whether it would be. Thread: real time.
    bool believes(const DeviceSample& sample, double apart) const noexcept {
        return canBeTrue(sample, since_ + apart);
    }

    bool lost() const noexcept { return lost_; }
    /// The newest that was believed, with its velocity; not valid before the first, nor while the device is
    /// lost. The first after a loss says that it jumped.
    const DeviceSample& believed() const noexcept { return believed_; }
    std::uint64_t refused() const noexcept { return refused_; }

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.fastest_, self.measuresVelocity_, self.estimate_, self.since_, self.good_, self.bad_,
              self.lost_, self.refused_, self.believed_);
    }

private:
    bool canBeTrue(const DeviceSample& sample, double since) const noexcept;

    double fastest_; ///< m/s
    bool measuresVelocity_;
    VelocityEstimate estimate_;
    double since_ = 0; ///< s from the newest that was believed to the newest valid one
    int good_ = 0, bad_ = 0;
    bool lost_ = false;
    std::uint64_t refused_ = 0;
    DeviceSample believed_;
};

} // namespace tactum
