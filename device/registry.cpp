#include "device/registry.h"

#include <algorithm>
#include <array>
#include <fstream>

namespace tactum {

namespace {

struct KnownUsbDevice {
    std::string_view vendor, product; ///< as the kernel writes them, product empty for any
    std::string_view name;
};

constexpr std::array<KnownUsbDevice, 2> kKnown{{
    {"0403", "cb48", "Novint Falcon"},
    {"1234", "0006", "WoodenHaptics"},
}};

std::string firstWord(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string word;
    in >> word;
    return word;
}

} // namespace

std::vector<DeviceListing> listDevices(const std::filesystem::path& usbDevices) {
    std::vector<DeviceListing> listings{
        {"simulated", "Simulated hand", true,
         "the mouse moves it in the window; 3 degrees of freedom, 1 kHz"},
        {"", "Recorded hand", true, "plays a finger path: tactum touch SCENE --path FINGER.csv"}};
    std::error_code error;
    std::vector<DeviceListing> found;
    for (const auto& entry : std::filesystem::directory_iterator(usbDevices, error)) {
        const std::string vendor = firstWord(entry.path() / "idVendor");
        const std::string product = firstWord(entry.path() / "idProduct");
        for (const KnownUsbDevice& known : kKnown)
            if (vendor == known.vendor && product == known.product)
                found.push_back({"", std::string(known.name), false,
                                 "connected at USB " + entry.path().filename().string() +
                                     "; this version has no driver for it, use the simulated hand"});
    }
    std::ranges::sort(found, {}, &DeviceListing::sentence);
    listings.insert(listings.end(), found.begin(), found.end());
    if (found.empty())
        listings.push_back(
            {"", "USB", false, "no known haptic device (Novint Falcon, WoodenHaptics) is connected"});
    return listings;
}

} // namespace tactum
