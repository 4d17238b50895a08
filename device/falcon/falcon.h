// The Novint Falcon. What is known of it, and what was never tried on one: docs/falcon.md.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>

#include "core/port/haptic_device.h"
#include "device/falcon/falcon_readings.h"
#include "device/usb/usb_link.h"

namespace tactum {

struct FalconSettings {
    std::filesystem::path firmware; ///< the person's copy; empty: looked for (falcon_firmware.h)
    double countsPerTorque = 10000; ///< motor command for 1 N m at a leg, to be calibrated
    /// Commands whose reports have not come. A report waits in the chip for up to a millisecond: with two the
    /// device hears one in each, if its firmware bears that. More would only wait in line and come late.
    int commandsOnWay = 1;
    double resetPause = 0.01;     ///< s, between the edges of DTR that reset the processor
    double longestUnheard = 0.03; ///< s without a command handed over: the line counts as broken
};

/// Frame D: falcon_kinematics.h. Its motors keep their last torque until told otherwise, as far as is known:
/// zero goes out first when it is opened, last when it is closed, and with every reading that cannot be used.
class Falcon final : public HapticDevice {
public:
    /// `place`: where it was last; another socket is fine when there is only one. Of the profile everything
    /// is taken but the number of buttons.
    Falcon(UsbPlace place, DeviceInfo profile, FalconSettings settings = {});
    ~Falcon() override;

    DeviceInfo info() const override;
    std::vector<std::string> steps() const override;
    Result<void> prepare(Opening& watcher) override;
    Result<void> open() override;
    void close() override;
    std::string trouble() const override;
    /// Allocates and locks inside libusb, never waits.
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override;
    void emergencyStop() noexcept override;

private:
    void connect(std::unique_ptr<UsbLink> link) noexcept;
    bool startsToReport();
    std::optional<FalconReport> newestReport() noexcept;
    void command(const Vec3& force, double dt) noexcept;
    bool send(const FalconLegs& motors) noexcept;
    void sendLastZero();
    FalconTrouble troubleNow() const noexcept;

    UsbPlace place_;
    DeviceInfo profile_;
    FalconSettings settings_;
    FalconPacket zero_; ///< ready for an emergency

    std::unique_ptr<UsbLink> link_;
    std::atomic<UsbLink*> emergencyLink_{nullptr};
    std::atomic<FalconTrouble> trouble_{FalconTrouble::None};

    // Of the stream.
    bool streaming_ = false;
    FalconStream stream_;
    std::uint64_t dropped_ = 0; ///< bytes that the stream had dropped before
    FalconReadings readings_;
    int unanswered_ = 0;   ///< commands whose reports have not come
    double unheard_ = 0;   ///< s since a command was handed over
    bool pushing_ = false; ///< the last command that was handed over had a torque
};

} // namespace tactum
