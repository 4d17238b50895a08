// What may be believed of the Falcon's reports, and whether it may be pushed. Thread: real time.
#pragma once

#include <array>
#include <limits>
#include <optional>

#include "core/port/haptic_device.h"
#include "device/falcon/falcon_kinematics.h"

namespace tactum {

enum class FalconTrouble : unsigned char {
    None,
    Silent,     ///< no reports
    NotHomed,   ///< counts without meaning
    Jumped,     ///< counts that no hand makes
    Impossible, ///< counts of no place
    Broken,     ///< transfers fail
    Gone,       ///< unplugged
};

class FalconReadings {
public:
    /// One exchange: the newest report if one came, `dt` s after the last. A reading that cannot be true is
    /// not valid, nor are those of the next kDistrust exchanges.
    DeviceSample operator()(const std::optional<FalconReport>& report, double dt) noexcept;
    void restart() noexcept { *this = {}; }
    /// Nobody knows how long it is until the next exchange: the hand may be anywhere by then.
    void pause() noexcept { spans_.fill(std::numeric_limits<double>::infinity()); }

    /// d angles / d position where the grip is, for a force; nullptr: none, because nobody knows where it is.
    const Mat3* whereToPush() const noexcept { return mayPush() ? &arm_.jacobian : nullptr; }
    FalconTrouble trouble() const noexcept;
    bool homed() const noexcept { return homed_; }
    /// Whether a reading that cannot be true came in the last kDistrust exchanges.
    bool distrusted() const noexcept { return distrust_ > 0; }
    /// s since the last report.
    double silence() const noexcept { return silence_; }

    static constexpr double kFastest = 3;   ///< m/s
    static constexpr double kStale = 0.005; ///< s: a report that is older moves no motor
    static constexpr double kSilent = 0.1;  ///< s, until the person is told
    static constexpr int kDistrust = 20;    ///< exchanges: long enough to count as lost
    static constexpr double kMention = 2;   ///< s, that a jump is told of

private:
    bool mayPush() const noexcept { return homed_ && known_ && distrust_ == 0 && silence_ <= kStale; }
    bool follow(const FalconLegs& counts) noexcept;

    FalconArm arm_;
    Vec3 position_ = Vec3::Zero(); ///< where it was last, believed or not
    bool known_ = false;           ///< whether it was anywhere
    bool homed_ = false;
    std::uint32_t buttons_ = 0;
    double silence_ = 0; ///< s
    /// s, of the last exchanges: a report answers one of the commands before, so that after a stall the
    /// reports are as far apart as the exchanges were.
    std::array<double, 3> spans_{};
    int distrust_ = 0;   ///< exchanges that are still not believed
    double mention_ = 0; ///< s
    FalconTrouble why_ = FalconTrouble::None;
};

} // namespace tactum
