#include <fcntl.h>
#include <iostream>
#include <unistd.h>

#include "app/commands.h"
#include "device/listings_text.h"
#include "device/registry.h"
#include "device/remote/serve_device.h"

namespace tactum {
namespace {

/// Makers' libraries write what they like to the standard output: nobody hears it for so long.
class Muted {
public:
    Muted() : kept_(dup(STDOUT_FILENO)) {
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        dup2(nowhere, STDOUT_FILENO);
        close(nowhere);
    }
    ~Muted() {
        dup2(kept_, STDOUT_FILENO);
        close(kept_);
    }
    Muted(const Muted&) = delete;
    Muted& operator=(const Muted&) = delete;

private:
    int kept_;
};

std::vector<DeviceListing> listOf(const std::string& maker) {
    const Muted muted;
    return DeviceRegistry::listMakers(maker);
}

DeviceRegistry registry(const std::filesystem::path& program) {
    return DeviceRegistry({.hand = {}, .profiles = personsProfiles(), .program = program});
}

} // namespace

Result<int> runDevices(const std::optional<std::string>& makers, bool json) {
    std::error_code unknown; // then the libraries are asked here
    const auto listings =
        makers ? listOf(*makers) : registry(std::filesystem::read_symlink("/proc/self/exe", unknown)).list();
    if (json) {
        std::cout << toJson(listings) << '\n';
        return 0;
    }
    for (const DeviceListing& listing : listings)
        std::cout << listing.name << (listing.id.empty() ? "" : " (" + listing.id + ")") << ": "
                  << (listing.usable ? "ready" : "not usable") << ": " << listing.sentence << '\n';
    return 0;
}

// The driver runs here: this process does nothing else.
Result<int> runDeviceServer(const std::string& id) {
    const auto device = registry({}).make(id);
    if (device) return serveDevice(**device, kServeDescriptor);
    refuseToServe(device.error(), kServeDescriptor);
    return tl::unexpected(device.error());
}

} // namespace tactum
