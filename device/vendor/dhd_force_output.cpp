#include "device/vendor/dhd_force_output.h"

#include <array>

namespace tactum::dhd {
namespace {

constexpr int kEvery = 20;       ///< exchanges, for a look is a transfer of its own
constexpr int kLooksOfRest = 25; ///< half a second

/// What a button or a switch did is a person's word.
bool mayComeBack(int cause) noexcept {
    return cause == kOffVelocity || cause == kOffWatchdog || cause == kOffSoftware;
}

} // namespace

void ForceOutput::begin() noexcept {
    off_ = kOn;
    exchanges_ = looks_ = 0;
    error_ = kNoError;
}

bool ForceOutput::look(const Api& api, char id) noexcept {
    if (++exchanges_ >= kEvery) {
        exchanges_ = 0;
        std::array<int, kRoomForStatus> status{};
        status[kStatusForceOffCause] = kOffUnknown;
        error_ = api.getStatus(status.data(), id) < kNoError ? api.errorGetLast() : int(kNoError);
        if (error_ == kNoError) takeIn(api, id, status.data());
    }
    return off_ == kOn && error_ == kNoError;
}

void ForceOutput::takeIn(const Api& api, char id, const int* status) noexcept {
    if (status[kStatusForce] != 0) {
        off_ = kOn;
        looks_ = 0;
        return;
    }
    off_ = status[kStatusForceOffCause];
    if (++looks_ % kLooksOfRest == 0 && mayComeBack(off_)) api.enableForce(dhd::kOn, id);
}

std::string ForceOutput::trouble() const {
    const int cause = off_;
    return cause == kOn ? std::string() : sentenceOf(ForceOff(cause));
}

} // namespace tactum::dhd
