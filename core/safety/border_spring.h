// The border of rate control, felt as an elastic wall that never gives more than it took.
#pragma once

#include <array>

#include "core/port/haptic_device.h"

namespace tactum {

/// Of the border. Soft beside what surfaces have, so that a contact beyond the border is felt as such. Unit:
/// N/m.
inline constexpr double kBorderStiffness = 200;
/// It is never more than this part of the device's limit, so that a contact has room.
inline constexpr double kBorderMost = 0.4;
/// The work that its account may be wrong by. Unit: J.
inline constexpr double kBorderCredit = 1e-6;

/// A spring toward the device's centre beyond a ball about it. An account has the work that it took, as it
/// was felt: what answers a reading comes late, and a sampled spring would give back more than it took. A
/// hand that goes back gets no more force than the account bears until the next commands arrive. One that
/// goes out feels the spring itself and so pays what the account owes, and for one that rests the account is
/// what such a spring holds: else a handle that was let go, and came to rest beyond the border on the other
/// side with some microjoules owed, would lie there without force. Frame D, SI. Thread: real time.
class BorderSpring {
public:
    explicit BorderSpring(const DeviceInfo& device) noexcept;

    /// N, on the finger. `border`: m about the centre, 0: none; `limit`: N, of the device.
    Vec3 operator()(const Vec3& position, double border, double limit, double dt) noexcept;
    /// What of it the device is sent.
    void commanded(const Vec3& force) noexcept;
    double stored() const noexcept { return stored_; } ///< J, taken and not yet given back

    /// All that it remembers, for the recorder (core/base/byte_archive.h).
    static void fields(auto& visit, auto& self) {
        visit(self.resolution_, self.held_, self.known_, self.commanded_, self.stored_, self.step_,
              self.back_, self.rested_);
        visit.index(self.delay_, kLongestDelay + 1);
    }

private:
    static constexpr int kLongestDelay = 7; ///< ticks

    void account(const Vec3& position, double dt) noexcept;
    double onTheWay() const noexcept;

    double resolution_;
    int delay_;                ///< ticks
    Vec3 held_ = Vec3::Zero(); ///< what the finger has not left by more than a count
    bool known_ = false;
    std::array<Vec3, kLongestDelay + 1> commanded_; ///< newest first
    double stored_ = 0;
    double step_ = 0;   ///< m toward the centre in a tick, the longest of lately
    double back_ = 0;   ///< m toward the centre, of the last way
    double rested_ = 0; ///< s since then
};

} // namespace tactum
