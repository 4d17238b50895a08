// One driver of other people's, loaded, asked and checked.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/port/haptic_device.h"
#include "device/plugin/tactum_driver.h"

namespace tactum {

/// Of a text that a driver wrote, as it is shown: bytes.
inline constexpr std::size_t kLongestDriverText = 200;

/// One device that it has found.
struct PluginFound {
    std::string port, name;
    std::string trouble; ///< why it cannot be used; empty: it can
    DeviceInfo info;     ///< of a device that can be used: possible figures
};

/// Thread of every member: any but real time, one at a time.
class PluginLibrary {
public:
    /// Stays in memory once it was loaded. Errors: cannot be loaded, is no driver, is of another version.
    static Result<PluginLibrary> open(const std::filesystem::path& file);

    std::vector<PluginFound> find() const;
    const TactumDriver& driver() const { return driver_; }

private:
    explicit PluginLibrary(const TactumDriver& driver) : driver_(driver) {}

    TactumDriver driver_;
};

} // namespace tactum
