// WoodenHaptics, the haptic arm to build oneself: a USB HID device, 1234:0006.
//
// It reports by itself, a thousand times a second, and switches its motors off after half a second without a
// command. Its encoders count from wherever the arm was when it got power, so somebody has to put it into its
// rest position once.
#pragma once

#include <atomic>
#include <memory>

#include "core/port/haptic_device.h"
#include "device/usb/usb_link.h"
#include "device/wooden_haptics/arm.h"
#include "device/wooden_haptics/report.h"

namespace tactum {

inline constexpr UsbId kWoodenHapticsId{0x1234, 0x0006};

class WoodenHaptics final : public HapticDevice {
public:
    WoodenHaptics(const UsbPlace& place, DeviceInfo profile);
    ~WoodenHaptics() override;

    DeviceInfo info() const override { return profile_; }
    std::vector<std::string> steps() const override;
    Result<void> prepare(Opening& opening) override;
    Result<void> open() override;
    void close() override;
    std::string trouble() const override;
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override;
    void emergencyStop() noexcept override;

private:
    enum class Trouble { None, Gone, Silent, Frozen, Restarted, Deaf };

    Result<void> connect(Opening& opening);
    Result<void> findRest(Opening& opening);
    Result<WoodenReport> waitForReport(Opening& opening);
    bool readReports() noexcept;
    bool accept(const WoodenReport& report) noexcept;
    void judge(bool fresh) noexcept;
    void command(const Vec3& currents) noexcept;

    UsbPlace place_;
    DeviceInfo profile_;
    WoodenArm arm_;
    std::unique_ptr<UsbLink> link_;
    bool prepared_ = false; ///< `rest_` is known, and the device has not been away since
    Counts rest_{};

    // Of the servo, from open() to close().
    WoodenReport newest_;
    bool heard_ = false; ///< newest_ is one
    int staleTicks_ = 0; ///< since the last one that was new
    int sameCounter_ = 0;
    std::uint16_t sent_ = 0;

    std::atomic<Trouble> trouble_{Trouble::None};
    std::atomic<UsbLink*> stopWay_{nullptr}; ///< for emergencyStop()
};

} // namespace tactum
