#include "device/falcon/falcon_readings.h"

#include <algorithm>

namespace tactum {

/// Whether the grip can have gone there since the last report.
bool FalconReadings::follow(const FalconLegs& counts) noexcept {
    constexpr double kShortest = 1e-3; // s: reports come in pairs
    const std::optional<Vec3> place = falconPosition(falconAngles(counts), position_);
    const std::optional<FalconArm> arm = place ? falconArmAt(*place) : std::nullopt;
    if (!arm) {
        why_ = FalconTrouble::Impossible;
        known_ = false;
        return false;
    }
    const double longest = std::max(*std::max_element(spans_.begin(), spans_.end()), kShortest);
    const bool jumped = known_ && (*place - position_).norm() > kFastest * std::max(silence_, longest);
    if (jumped) why_ = FalconTrouble::Jumped;
    position_ = *place;
    arm_ = *arm;
    known_ = true;
    return !jumped;
}

DeviceSample FalconReadings::operator()(const std::optional<FalconReport>& report, double dt) noexcept {
    spans_ = {dt, spans_[0], spans_[1]};
    silence_ += std::max(0.0, dt);
    distrust_ = std::max(0, distrust_ - 1);
    mention_ = std::max(0.0, mention_ - dt);
    bool believed = false;
    if (report) {
        buttons_ = report->buttons;
        homed_ = report->homed == FalconReport::kAllHomed;
        if (!homed_) {
            known_ = false;
        } else if (follow(report->counts)) {
            believed = distrust_ == 0;
        } else {
            distrust_ = kDistrust;
            mention_ = kMention;
        }
        silence_ = 0;
    }
    return {.position = position_, .buttons = buttons_, .valid = believed};
}

FalconTrouble FalconReadings::trouble() const noexcept {
    if (silence_ > kSilent) return FalconTrouble::Silent;
    if (!homed_) return FalconTrouble::NotHomed;
    return mention_ > 0 ? why_ : FalconTrouble::None;
}

} // namespace tactum
