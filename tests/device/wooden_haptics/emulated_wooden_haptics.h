// A WoodenHaptics on the emulated bus: its board, its motors and the arm itself.
//
// The arm is worked out from rotations and differences, not by the formulas of the driver that it tests.
#pragma once

#include <atomic>
#include <deque>

#include "device/wooden_haptics/arm.h"
#include "tests/device/usb/emulated_usb.h"
#include "tests/device/usb/shared_value.h"

namespace tactum::test {

/// Where the finger is, in frame D, by turning one body after the other.
Vec3 fingerByRotations(const WoodenArm& arm, const Vec3& joints);
/// By differences of that, m/rad.
Mat3 jacobianByDifferences(const WoodenArm& arm, const Vec3& joints);

/// Thread: that of the bus; a test that calls its members is that thread too.
class EmulatedWoodenHaptics final : public EmulatedUsbDevice {
public:
    UsbDescription describe() const override;
    std::optional<Bytes> control(const UsbSetup&, std::span<const std::uint8_t>, std::int64_t) override;
    void out(std::span<const std::uint8_t> bytes, std::int64_t now) override;
    std::optional<Bytes> in(std::int64_t now) override;
    std::int64_t nextIn(std::int64_t now) const override;

    /// A millisecond of the board: the arm moves, and a report is ready. Not needed when `paced`.
    void tick();
    /// The arm is put here, and held until let go.
    void hold(const Vec3& joints);
    void letGo() { held_ = false; }
    /// As after a cut of the power: counts and counter begin at 0 where the arm is.
    void restart();

    Vec3 finger() const { return fingerByRotations(arm, joints_); }
    Vec3 joints() const { return joints_; }
    /// N, what the motors do to the finger.
    Vec3 motorForce() const;
    int milliamperes(std::size_t motor) const { return (*currents_)[motor]; }
    int commands() const { return commands_; }

    WoodenArm arm;
    bool paced = false;             ///< reports go by the clock, one a millisecond
    Vec3 handForce = Vec3::Zero();  ///< N, on the finger
    double mass = 0.2, damping = 8; ///< kg, N s/m, of arm and hand at the finger
    bool frozen = false;            ///< the board hangs and says the same again and again
    std::size_t reportSize = 8;

private:
    Counts counts() const;
    void move(double dt);

    Vec3 joints_ = Vec3::Zero(), velocity_ = Vec3::Zero();
    Vec3 powerOn_ = Vec3::Zero(); ///< the joints where the counts are 0
    bool held_ = true;
    std::uint16_t counter_ = 0;
    int sinceCommand_ = 0; ///< ms
    int commands_ = 0;
    std::int64_t due_ = 0;
    std::deque<Bytes> reports_;
    SharedValue<std::array<std::atomic<int>, 3>> currents_; ///< mA; a forked child may stop them
};

} // namespace tactum::test
