#include "device/plugin/plugin_library.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <dlfcn.h>

#include "core/base/text.h"
#include "core/port/device_check.h"

namespace tactum {
namespace {

constexpr std::int32_t kMostDevices = 16; ///< of one driver

Error broken(const std::filesystem::path& file, const std::string& fault) {
    return {Error::Kind::Machine, "The driver " + inQuotes(file.string()) + " " + fault};
}

/// Of a text that a driver wrote, whether it ended it or not.
std::string textOf(const char (&text)[TACTUM_TEXT]) {
    return printable(std::string(text, strnlen(text, TACTUM_TEXT)), kLongestDriverText);
}

DeviceInfo infoOf(const TactumFound& found) {
    const TactumFigures& said = found.figures;
    return {.name = textOf(found.name),
            .maxForce = said.max_force,
            .continuousForce = said.continuous_force,
            .maxStiffness = said.max_stiffness,
            .workspaceRadius = said.workspace_radius,
            .positionResolution = said.position_resolution,
            .rate = said.rate,
            .damping = said.damping,
            .dryFriction = said.dry_friction,
            .amplifierLag = said.amplifier_lag,
            .delay = said.delay,
            .buttons = said.buttons,
            .real = true,
            .measuresVelocity = said.measures_velocity != 0};
}

PluginFound checked(const TactumFound& found) {
    PluginFound device{textOf(found.port), textOf(found.name), textOf(found.trouble), infoOf(found)};
    if (device.trouble.empty())
        if (const std::string fault = impossibleFigure(device.info); !fault.empty())
            device.trouble = "its driver is wrong about it: " + fault;
    return device;
}

} // namespace

Result<PluginLibrary> PluginLibrary::open(const std::filesystem::path& file) {
    // Unloading a library whose threads still run would crash the program: it stays.
    void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (!handle) {
        const char* const reason = dlerror();
        return tl::unexpected(broken(file, "cannot be loaded (" +
                                               printable(reason ? reason : "", kLongestDriverText) +
                                               "): build it again for this machine, or remove it."));
    }
    const auto entry = reinterpret_cast<decltype(&tactum_driver)>(dlsym(handle, "tactum_driver"));
    const TactumDriver* const said = entry ? entry(TACTUM_DRIVER_ABI) : nullptr;
    if (!entry)
        return tl::unexpected(
            broken(file, "has no function tactum_driver(): see docs/drivers.md, or remove it."));
    if (!said || said->size < offsetof(TactumDriver, trouble))
        return tl::unexpected(broken(
            file, "is of another version than this program: build it again with its tactum_driver.h."));
    TactumDriver driver{};
    std::memcpy(&driver, said, std::min<std::size_t>(said->size, sizeof driver));
    if (!driver.find || !driver.open || !driver.exchange || !driver.close)
        return tl::unexpected(broken(file, "lacks find, open, exchange or close: see docs/drivers.md."));
    return PluginLibrary(driver);
}

std::vector<PluginFound> PluginLibrary::find() const {
    std::vector<TactumFound> found(kMostDevices);
    const std::int32_t count = std::clamp(driver_.find(found.data(), kMostDevices), 0, kMostDevices);
    std::vector<PluginFound> devices;
    std::transform(found.begin(), found.begin() + count, std::back_inserter(devices), checked);
    return devices;
}

} // namespace tactum
