// A Falcon on the emulated bus: its USB chip, the boot program of its processor, the firmware, its arm in a
// hand.
//
// To the byte what is known of a real one (docs/falcon.md). Its firmware is any boot stream.
#pragma once

#include <atomic>
#include <memory>
#include <random>

#include "device/falcon/falcon_packet.h"
#include "tests/device/falcon/emulated_ft232.h"
#include "tests/device/falcon/falcon_body.h"
#include "tests/device/usb/emulated_usb.h"
#include "tests/device/usb/shared_value.h"

namespace tactum::test {

/// What goes wrong in the device itself, until changed again; the bus has faults of its own (UsbFaults).
struct FalconFaults {
    // Of the boot program.
    int deafTries = 0;      ///< calls that are not answered
    bool zeroFirst = false; ///< a 0 before the answer
    int junkFirst = 0;      ///< bytes of junk before the answer
    int corruptEchoes = 0;  ///< so many bytes of the firmware come back wrong, the 500th of an attempt
    int lostEchoes = 0;     ///< so many do not come back
    bool startsNoFirmware = false;

    // Of the firmware.
    bool silent = false;  ///< hears and obeys, and says nothing
    int lostReports = 0;  ///< so many are not sent
    int shortReports = 0; ///< so many lack a byte
    int wrongEnds = 0;    ///< so many do not end as they should
    int junk = 0;         ///< bytes of junk before each report
    bool split = false;   ///< reports come in pieces
    bool babble = false;  ///< a packet that is longer than any may be
    int repeats = 0;      ///< each report is said so often again, unasked
    bool frozenEncoders = false;
    FalconLegs encoderJump{}; ///< counts added once
    bool forgetsHome = false; ///< once
};

class EmulatedFalcon final : public EmulatedUsbDevice {
public:
    static constexpr double kCountsPerTorque = 10000;

    enum class State { Off, Boot, Loading, Running };

    /// `hurry`: how many times faster than a real one its chip is; the arm keeps its own time.
    explicit EmulatedFalcon(double hurry = 1);

    // For the test. Thread: any; nothing here may be called while the bus is locked.

    void setFaults(const FalconFaults& faults);
    /// Its own power supply; firmware and home are lost without it. The chip lives off USB and goes on.
    void setPower(bool on);
    /// Into a socket: the chip begins anew, the processor goes on with what it did.
    static void plug(int socket, const std::shared_ptr<EmulatedFalcon>& device);
    /// As if the firmware had been loaded, and perhaps the arm homed, by somebody before.
    void startFirmware(bool homed);
    void setButtons(std::uint8_t buttons);

    void setHand(const FalconBody::Hand& hand);
    void homeByHand();
    void putGrip(const Vec3& p_D);
    void leadGrip(const Vec3& p_D);
    bool gripArrived() const;

    State state() const;
    bool homed() const;
    Vec3 grip() const;  ///< frame D of the driver, m
    Vec3 force() const; ///< of the motors, at the grip, N
    FalconLegs motors() const;
    FalconLight light() const;
    int latency() const;        ///< ms
    int uploads() const;        ///< firmware started by loading
    int commands() const;       ///< whole ones that the firmware obeyed
    int malformed() const;      ///< bytes that belonged to none
    int torqueCommands() const; ///< those of them with a torque
    /// Whether any command ever asked for more than a motor bears.
    bool overdriven() const;
    /// Whether the first command since the firmware was last started or the device plugged in had a torque.
    bool firstHadTorque() const;
    /// Of each obeyed command: ns of CLOCK_MONOTONIC. The newest 60 thousand or so.
    std::vector<std::int64_t> commandTimes() const;

    // For the bus.

    UsbDescription describe() const override;
    std::optional<Bytes> control(const UsbSetup& setup, std::span<const std::uint8_t> data,
                                 std::int64_t now) override;
    void out(std::span<const std::uint8_t> bytes, std::int64_t now) override;
    std::optional<Bytes> in(std::int64_t now) override;
    std::int64_t nextIn(std::int64_t now) const override;

private:
    void advance(std::int64_t now);
    void moveTo(std::int64_t now);
    void watchIndexMarks(const Vec3& before);
    void hear(const EmulatedFt232::LineByte& byte);
    void hearBoot(const EmulatedFt232::LineByte& byte);
    void hearFirmwareByte(const EmulatedFt232::LineByte& byte);
    void hearCommandByte(const EmulatedFt232::LineByte& byte);
    void obey();
    void report(std::int64_t at);
    void say(const Bytes& bytes, double baud, std::int64_t at);
    void reset();
    void start();
    FalconLegs counts() const;
    Vec3 torques() const;

    double hurry_;
    EmulatedFt232 chip_;
    FalconBody body_;
    FalconFaults faults_;
    std::mt19937 random_{1};

    State state_ = State::Boot;
    bool called_ = false;       ///< the boot program has answered
    Bytes heard_;               ///< of the stage that it is in
    std::size_t blockLeft_ = 0; ///< bytes of the block that is being loaded
    int uploads_ = 0;

    std::int64_t time_ = 0;
    std::uint8_t homed_ = 0, buttons_ = 0;
    bool homing_ = false;
    FalconLight light_ = FalconLight::Off;
    Vec3 zero_{20, 31, 27}; ///< degrees, at which the encoders of a leg that is not homed say 0
    FalconLegs jump_{}, frozen_{};
    bool isFrozen_ = false;
    SharedValue<std::atomic<std::uint64_t>> motors_; ///< a forked child may stop them
    int commands_ = 0, malformed_ = 0, torqueCommands_ = 0;
    bool overdriven_ = false, first_ = true, firstHadTorque_ = false;
    std::vector<std::int64_t> times_;
};

} // namespace tactum::test
