// Polhem, the haptic arm of Haptikfabriken (Forsslund Systems): a Teensy board on a serial port, asked line
// by line. Written after what its maker has published; never tried with a real one.
//
// Its encoders count from wherever the arm was when the board got power: it has to be in its rest position
// then.
#pragma once

#include <atomic>
#include <memory>

#include "core/port/device_catalogue.h"
#include "core/port/force_limiter.h"
#include "core/port/haptic_device.h"
#include "device/polhem/polhem_arm.h"
#include "device/polhem/polhem_lines.h"
#include "device/polhem/serial_port.h"

namespace tactum {

/// Boards that may be one, by the name that the system gives their ports: it is that of every Teensy. Opens
/// nothing. TACTUM_POLHEM names another file, or a pattern. Thread: any but real time.
std::vector<DeviceListing> listPolhem();
/// Errors: not connected.
Result<std::unique_ptr<HapticDevice>> makePolhem(const std::string& id, const DeviceInfo& profile);

class Polhem final : public HapticDevice {
public:
    Polhem(std::filesystem::path file, DeviceInfo profile);
    ~Polhem() override;

    DeviceInfo info() const override { return profile_; }
    Result<void> open() override;
    void close() override;
    std::string trouble() const override;
    std::string caution() const override;
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override;
    HandleReading handle() noexcept override { return handle_; }
    void emergencyStop() noexcept override;

private:
    enum class Trouble { None, Gone, Silent, Lost };

    Result<void> meet();
    Result<void> firstPlace();
    bool read() noexcept;
    bool understand(std::string_view line) noexcept;
    void turn(double column, double forearm, const Vec3& wrist) noexcept;
    void judge(bool fresh) noexcept;
    void command(const Vec3& force) noexcept;
    void ask() noexcept;
    std::string_view noForce() const noexcept;

    std::filesystem::path file_;
    DeviceInfo profile_;
    PolhemArm arm_;
    ForceLimiter limit_;
    std::unique_ptr<SerialPort> port_;
    std::atomic<PolhemSpeech> speech_{PolhemSpeech::Forces};

    // Of the servo, from open() to close().
    PolhemReader reader_;
    PolhemCounts counts_; ///< the newest
    Vec3 position_ = Vec3::Zero();
    HandleReading handle_;
    int staleTicks_ = 0, silentTicks_ = 0; ///< since the last place, and the last line

    std::atomic<Trouble> trouble_{Trouble::None};
    std::atomic<int> boardsError_{0};
    std::atomic<SerialPort*> way_{nullptr}; ///< while it is open
};

} // namespace tactum
