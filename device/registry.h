// Every device that this program can drive: found, explained, made.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string_view>

#include "core/port/device_catalogue.h"
#include "core/port/hand_target.h"
#include "device/simulated_hand.h"

namespace tactum {

struct RegistrySettings {
    std::shared_ptr<HandTarget> hand; ///< who leads the simulated hand; empty: it rests
    std::filesystem::path profiles;   ///< folder of the person's own (device/profile.h)
    /// That knows the verb device-server: drivers with a maker's library run in it and not here, where their
    /// crash would be ours. Empty: all run here.
    std::filesystem::path program;
    bool allApart = false; ///< our own drivers too
};

/// ids: "simulated", "falcon:PORT", "wooden-haptics:PORT", "polhem:PORT", those of the makers'
/// drivers, and "driver:LIBRARY:PORT".
class DeviceRegistry final : public DeviceCatalogue {
public:
    explicit DeviceRegistry(RegistrySettings settings) : settings_(std::move(settings)) {}

    /// What can be used comes first.
    std::vector<DeviceListing> list() override;
    /// Errors: no such device, or not there any more; a profile that is wrong.
    Result<std::unique_ptr<HapticDevice>> make(const std::string& id) override;
    Result<std::string> supply(const std::string& id, const std::filesystem::path& file) override;
    Result<std::string> keepFigures(const std::string& name, const std::string& profile) override;

    /// Those of one maker's library, "openhaptics" for instance, asked in this process; all of them without a
    /// name. Thread: as list().
    static std::vector<DeviceListing> listMakers(std::string_view family = {});

private:
    std::vector<DeviceListing> listMakersApart();
    bool runsApart(const std::string& id) const;

    RegistrySettings settings_;
    std::vector<DeviceListing> makers_; ///< as they were last asked for
    std::optional<std::chrono::steady_clock::time_point> asked_;
};

/// What everybody has, whatever is plugged in. A window says its words in its own language.
struct BuiltIn {
    std::string_view id; ///< empty: only a remark
    std::string_view name, sentence;
};
inline constexpr BuiltIn kBuiltIn[] = {
    {"simulated", kSimulatedHandName, "the mouse moves it in the window; 3 degrees of freedom, 1 kHz"},
    {"", "Recorded hand", "plays a finger path: tactum touch SCENE --path FINGER.csv"},
};

/// Where a person's own profiles are: ~/.config/Tactum/devices, or below XDG_CONFIG_HOME.
std::filesystem::path personsProfiles();

} // namespace tactum
