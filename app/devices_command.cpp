#include <iostream>

#include "app/commands.h"
#include "device/listings_text.h"
#include "device/registry.h"
#include "device/remote/serve_device.h"

namespace tactum {
namespace {

/// No driver runs in a process of its own: this one does nothing else.
DeviceRegistry ownRegistry() {
    return DeviceRegistry({.hand = {}, .profiles = personsProfiles(), .program = {}});
}

} // namespace

Result<int> runDevices(bool makers, bool json) {
    const auto listings = makers ? DeviceRegistry::listMakers() : ownRegistry().list();
    if (json) {
        std::cout << toJson(listings) << '\n';
        return 0;
    }
    for (const DeviceListing& listing : listings)
        std::cout << listing.name << (listing.id.empty() ? "" : " (" + listing.id + ")") << ": "
                  << (listing.usable ? "ready" : "not usable") << ": " << listing.sentence << '\n';
    return 0;
}

Result<int> runDeviceServer(const std::string& id) {
    const auto device = ownRegistry().make(id);
    return device ? serveDevice(**device, kServeDescriptor) : refuseToServe(device.error(), kServeDescriptor);
}

} // namespace tactum
