#include "device/plugin/plugin.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdlib>

#include <unistd.h>

#include "core/base/text.h"
#include "core/port/force_limiter.h"
#include "device/plugin/plugin_library.h"

namespace tactum {
namespace {

constexpr std::string_view kPrefix = "driver:";

/// A device by the functions of its driver. Thread of exchange(): servo, real time.
class PluginDevice final : public HapticDevice {
public:
    PluginDevice(PluginLibrary library, PluginFound found)
        : driver_(library.driver()), found_(std::move(found)), limit_{.maxForce = found_.info.maxForce} {}
    ~PluginDevice() override { close(); }

    DeviceInfo info() const override { return found_.info; }

    Result<void> open() override {
        if (device_) return {};
        std::array<char, TACTUM_TEXT> trouble{};
        void* const opened = driver_.open(found_.port.c_str(), trouble.data());
        trouble.back() = 0;
        if (!opened)
            return machineError("The " + found_.name + " cannot be opened: " +
                                (trouble[0] ? printable(trouble.data(), kLongestDriverText)
                                            : "its driver does not say why; plug it in again."));
        gone_ = false;
        device_ = opened;
        return {};
    }

    void close() override {
        void* const opened = device_.exchange(nullptr);
        while (asking_ != 0) // whoever asks for trouble asks a device that is there
            usleep(100);
        if (opened) driver_.close(opened);
    }

    std::string trouble() const override {
        ++asking_;
        std::string text = troubleNow();
        --asking_;
        return text;
    }

    std::string caution() const override {
        return driver_.stop
                   ? std::string()
                   : "Its driver has no way to stop it at once: if this program crashes, the device does "
                     "what it does without commands.";
    }

    DeviceSample exchange(const DeviceCommand& command, double) noexcept override {
        void* const opened = device_.load(std::memory_order_relaxed);
        if (!opened) return {};
        const Vec3 force = limit_(command.force);
        TactumReading reading{};
        const std::int32_t fresh = driver_.exchange(opened, force.data(), &reading);
        if (fresh < 0) gone_.store(true, std::memory_order_relaxed);
        if (fresh > 0) gone_.store(false, std::memory_order_relaxed);
        return {.position = Vec3(reading.position),
                .velocity = Vec3(reading.velocity),
                .buttons = reading.buttons,
                .valid = fresh > 0,
                .at = reading.measured_at};
    }

    void emergencyStop() noexcept override {
        if (void* const opened = device_.load(std::memory_order_relaxed); opened && driver_.stop)
            driver_.stop(opened);
    }

private:
    std::string troubleNow() const {
        void* const opened = device_;
        if (!opened) return {};
        const char* const said = driver_.trouble ? driver_.trouble(opened) : nullptr;
        if (said && *said) return printable(said, kLongestDriverText);
        return gone_ ? "The " + found_.name + " does not answer any more: plug it in and open it again."
                     : std::string();
    }

    TactumDriver driver_;
    PluginFound found_;
    ForceLimiter limit_;
    std::atomic<void*> device_{nullptr}; ///< the driver's own, from open() to close()
    std::atomic<bool> gone_{false};
    mutable std::atomic<int> asking_{0}; ///< for its trouble, at this moment
};

std::vector<std::filesystem::path> librariesIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().extension() == ".so") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::vector<std::filesystem::path> libraries() {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path& folder : driverFolders())
        std::ranges::move(librariesIn(folder), std::back_inserter(files));
    return files;
}

std::string idOf(const std::filesystem::path& file, const PluginFound& found) {
    return std::string(kPrefix) + file.stem().string() + ':' + found.port;
}

DeviceListing listingOf(const std::filesystem::path& file, const PluginFound& found) {
    const bool usable = found.trouble.empty();
    return {usable ? idOf(file, found) : std::string(), found.name, usable,
            usable ? "connected at " + found.port + ", by the driver " + inQuotes(file.filename().string())
                   : found.trouble};
}

} // namespace

std::vector<std::filesystem::path> driverFolders() {
    std::vector<std::filesystem::path> folders;
    if (const char* const named = std::getenv("TACTUM_DRIVERS"); named && *named) {
        for (std::string_view rest = named; !rest.empty();) {
            const std::size_t end = std::min(rest.find(':'), rest.size());
            if (end > 0) folders.emplace_back(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
        return folders;
    }
    const char* const data = std::getenv("XDG_DATA_HOME");
    const char* const home = std::getenv("HOME");
    if (data && *data)
        folders.push_back(std::filesystem::path(data) / "Tactum/drivers");
    else if (home && *home)
        folders.push_back(std::filesystem::path(home) / ".local/share/Tactum/drivers");
    return folders;
}

std::vector<DeviceListing> listPlugins() {
    std::vector<DeviceListing> listings;
    for (const std::filesystem::path& file : libraries()) {
        const auto library = PluginLibrary::open(file);
        if (!library) {
            listings.push_back({"", file.filename().string(), false, library.error().text});
            continue;
        }
        for (const PluginFound& found : library->find())
            listings.push_back(listingOf(file, found));
    }
    return listings;
}

Result<std::unique_ptr<HapticDevice>> makePlugin(const std::string& id) {
    for (const std::filesystem::path& file : libraries()) {
        if (!id.starts_with(std::string(kPrefix) + file.stem().string() + ':')) continue;
        auto library = PluginLibrary::open(file);
        if (!library) return tl::unexpected(library.error());
        for (PluginFound& found : library->find())
            if (found.trouble.empty() && idOf(file, found) == id)
                return std::make_unique<PluginDevice>(std::move(*library), std::move(found));
    }
    return machineError(
        "The device " + inQuotes(id) +
        " is not connected, or its driver is not there any more: plug it in, or choose another device.");
}

} // namespace tactum
