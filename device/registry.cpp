#include "device/registry.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include "core/base/text.h"
#include "device/falcon/falcon.h"
#include "device/falcon/falcon_firmware.h"
#include "device/falcon/falcon_line.h"
#include "device/listings_text.h"
#include "device/plugin/plugin.h"
#include "device/polhem/polhem.h"
#include "device/profile.h"
#include "device/remote/output_of.h"
#include "device/remote/remote_device.h"
#include "device/simulated_hand.h"
#include "device/usb/usb_link.h"
#include "device/vendor/force_dimension.h"
#include "device/vendor/haply_inverse3.h"
#include "device/vendor/open_haptics.h"
#include "device/wooden_haptics/wooden_haptics.h"

namespace tactum {
namespace {

using Made = Result<std::unique_ptr<HapticDevice>>;

constexpr const char* kSimulated = "simulated";
constexpr std::string_view kPolhem = "polhem"; ///< driven by ourselves as well, over a serial port
constexpr int kMakersPatience = 5000;          ///< ms, to say what is connected
constexpr std::chrono::seconds kMakersEvery{10};

/// A device that we drive ourselves over USB.
struct UsbFamily {
    std::string_view prefix; ///< of its ids, and the key of its profile
    UsbId id;
    std::string_view name;
    std::unique_ptr<HapticDevice> (*make)(const UsbPlace& place, const DeviceProfile& profile);
    /// Of a file that the person has to have: which, while there is none; and keeping theirs.
    std::string (*lacks)() = [] { return std::string(); };
    Result<std::string> (*supply)(const std::filesystem::path& file) = nullptr;
};

std::string lackOfFalcon() {
    return findFalconFirmware({}) ? std::string() : std::string("firmware (*.bin)");
}

Result<std::string> supplyFalcon(const std::filesystem::path& file) {
    const auto kept = keepFalconFirmware(file);
    if (!kept) return tl::unexpected<Error>(kept.error());
    return "The Falcon's firmware (" + (kept->name.empty() ? std::string("not a known one") : kept->name) +
           ") was copied to " + inQuotes(kept->file.string()) + ".";
}

constexpr std::array<UsbFamily, 2> kUsbFamilies{{
    {"falcon", kFalconUsb, "Novint Falcon",
     [](const UsbPlace& place, const DeviceProfile& profile) -> std::unique_ptr<HapticDevice> {
         return std::make_unique<Falcon>(place, profile.info,
                                         FalconSettings{.firmware = {},
                                                        .countsPerTorque = profile.countsPerTorque,
                                                        .commandsOnWay = int(profile.commandsOnWay),
                                                        .resetPause = profile.resetPause,
                                                        .longestUnheard = profile.longestUnheard});
     },
     lackOfFalcon, supplyFalcon},
    {"wooden-haptics", kWoodenHapticsId, "WoodenHaptics",
     [](const UsbPlace& place, const DeviceProfile& profile) -> std::unique_ptr<HapticDevice> {
         return std::make_unique<WoodenHaptics>(place, profile.info);
     }},
}};

/// Devices that a maker's library drives, where the person has it.
struct MakersFamily {
    std::string_view prefix, profile, name;
    std::vector<DeviceListing> (*list)();
    Made (*make)(const std::string& id, FiguresOf figures);
};

Made makeOnlyHaply(const std::string& id, FiguresOf figures) {
    const Result<DeviceInfo> known = figures("");
    if (!known) return tl::unexpected<Error>(known.error());
    return makeHaply(id, *known);
}

std::vector<DeviceListing> listDrivers() {
    std::vector<DeviceListing> listings = listPlugins();
    if (!listings.empty()) return listings;
    const auto folders = driverFolders();
    return {{"", "Drivers of your own", false,
             folders.empty() ? "there is no folder for them: set TACTUM_DRIVERS"
                             : "none in " + inQuotes(folders.front().string()) +
                                   "; docs/drivers.md says how one is made"}};
}

constexpr std::array<MakersFamily, 4> kMakersFamilies{{
    {"openhaptics", "phantom", "OpenHaptics", listOpenHaptics, makeOpenHaptics},
    {"forcedimension", "omega", "Force Dimension", listForceDimension, makeForceDimension},
    {"haply", "inverse3", "Haply", listHaply, makeOnlyHaply},
    {"driver", "", "Drivers of your own", listDrivers,
     [](const std::string& id, FiguresOf) { return makePlugin(id); }},
}};

std::string prefixOf(const std::string& id) {
    return id.substr(0, id.find(':'));
}

template <class Families> const auto* familyOf(const Families& families, const std::string& id) {
    const auto found = std::ranges::find(families, prefixOf(id), &Families::value_type::prefix);
    return found == families.end() ? nullptr : &*found;
}

/// Of the model, where there is a profile for it; else those of its family, under the model's own name.
Result<DeviceInfo> figuresOf(std::string_view model, std::string_view family,
                             const std::filesystem::path& folder) {
    const std::string key = profileFor(model);
    Result<DeviceProfile> profile = profileOf(key.empty() ? family : key, folder);
    if (!profile) return tl::unexpected<Error>(profile.error());
    if (key.empty() && !model.empty()) profile->info.name = model;
    return profile->info;
}

std::vector<UsbId> wantedIds() {
    std::vector<UsbId> ids;
    for (const UsbFamily& family : kUsbFamilies)
        ids.push_back(family.id);
    return ids;
}

/// Whether this person may write to the device's file. One that nobody can see is left to the link's own
/// words.
bool mayOpen(const UsbPlace& place) {
    std::array<char, 64> file{};
    std::snprintf(file.data(), file.size(), "/dev/bus/usb/%03d/%03d", place.bus, place.address);
    return access(file.data(), W_OK) == 0 || errno != EACCES;
}

DeviceListing listingOf(const UsbFamily& family, const UsbPlace& place) {
    DeviceListing listing{std::string(family.prefix) + ':' + place.port, std::string(family.name), true,
                          "connected at USB " + place.port};
    listing.lacks = family.lacks();
    if (mayOpen(place)) return listing;
    listing.usable = false;
    listing.forbidden = true;
    listing.sentence += ", but you have no permission to use it: install the rule "
                        "resources/udev/70-tactum.rules in /etc/udev/rules.d and plug it in again";
    return listing;
}

std::vector<DeviceListing> listOwn() {
    const Result<std::vector<UsbPlace>> places = listUsb(wantedIds());
    std::vector<DeviceListing> listings = listPolhem();
    if (!places) listings.push_back({"", "USB", false, places.error().text});
    for (const UsbPlace& place : places.value_or(std::vector<UsbPlace>()))
        for (const UsbFamily& family : kUsbFamilies)
            if (family.id == place.id) listings.push_back(listingOf(family, place));
    std::ranges::sort(listings, {}, &DeviceListing::id);
    if (listings.empty())
        listings.push_back(
            {"", "USB", false, "no Novint Falcon, WoodenHaptics or Polhem is connected; plug one in"});
    return listings;
}

Made makeOwn(const UsbFamily& family, const std::string& id, const DeviceProfile& profile) {
    const Result<std::vector<UsbPlace>> places = listUsb(wantedIds());
    if (!places) return tl::unexpected<Error>(places.error());
    const auto place = std::ranges::find_if(*places, [&](const UsbPlace& found) {
        return found.id == family.id && id == std::string(family.prefix) + ':' + found.port;
    });
    if (place == places->end())
        return machineError("The " + std::string(family.name) + " of \"" + id +
                            "\" is not connected: plug it in, or choose another device.");
    return family.make(*place, profile);
}

} // namespace

std::vector<DeviceListing> DeviceRegistry::listMakers(std::string_view name) {
    std::vector<DeviceListing> listings;
    for (const MakersFamily& family : kMakersFamilies)
        if (name.empty() || name == family.prefix)
            std::ranges::move(family.list(), std::back_inserter(listings));
    return listings;
}

/// A maker's library may take long to look, so it is not asked each time, and not at all while one of them
/// drives a device of ours: it would be disturbed, or be called missing. Each is asked in a process of its
/// own, which a broken one takes with it.
std::vector<DeviceListing> DeviceRegistry::listMakersApart() {
    const auto now = std::chrono::steady_clock::now();
    if (asked_ && (countRemoteDevices() > 0 || now - *asked_ < kMakersEvery)) return makers_;
    asked_ = now;
    makers_.clear();
    for (const MakersFamily& family : kMakersFamilies) {
        auto found = listingsOf(outputOf(settings_.program,
                                         {"devices", "--json", "--makers", std::string(family.prefix)},
                                         kMakersPatience));
        if (found.empty())
            found.push_back({"", std::string(family.name), false,
                             "its library crashed or did not answer when it was asked what is connected; "
                             "install it anew, or ask its maker"});
        std::ranges::move(found, std::back_inserter(makers_));
    }
    return makers_;
}

std::vector<DeviceListing> DeviceRegistry::list() {
    std::vector<DeviceListing> listings;
    for (const BuiltIn& each : kBuiltIn)
        listings.push_back({std::string(each.id), std::string(each.name), true, std::string(each.sentence)});
    std::ranges::move(listOwn(), std::back_inserter(listings));
    std::ranges::move(settings_.program.empty() ? listMakers() : listMakersApart(),
                      std::back_inserter(listings));
    std::ranges::stable_partition(
        listings, [](const DeviceListing& listing) { return listing.usable && !listing.id.empty(); });
    return listings;
}

bool DeviceRegistry::runsApart(const std::string& id) const {
    return !settings_.program.empty() && (settings_.allApart || familyOf(kMakersFamilies, id));
}

Made DeviceRegistry::make(const std::string& id) {
    if (id == kSimulated)
        return std::make_unique<SimulatedHand>(settings_.hand ? settings_.hand
                                                              : std::make_shared<HandTarget>());
    const UsbFamily* const own = familyOf(kUsbFamilies, id);
    const MakersFamily* const makers = familyOf(kMakersFamilies, id);
    const bool polhem = prefixOf(id) == kPolhem;
    if (!own && !makers && !polhem)
        return inputError("There is no device " + inQuotes(id) +
                          ": tactum devices lists those that there are.");
    if (runsApart(id)) return makeRemoteDevice(settings_.program, {"device-server", id});
    if (makers)
        return makers->make(id, [family = makers->profile, folder = settings_.profiles](
                                    std::string_view model) { return figuresOf(model, family, folder); });
    const auto profile = profileOf(own ? own->prefix : kPolhem, settings_.profiles);
    if (!profile) return tl::unexpected<Error>(profile.error());
    return own ? makeOwn(*own, id, *profile) : makePolhem(id, profile->info);
}

Result<std::string> DeviceRegistry::supply(const std::string& id, const std::filesystem::path& file) {
    const UsbFamily* const own = familyOf(kUsbFamilies, id);
    if (!own || !own->supply) return inputError("The device \"" + id + "\" lacks no file.");
    return own->supply(file);
}

Result<std::string> DeviceRegistry::keepFigures(const std::string& name, const std::string& profile) {
    const std::string key = profileFor(name);
    if (key.empty())
        return inputError("There is no profile for " + inQuotes(name) + ": save the self-test instead.");
    if (settings_.profiles.empty()) return machineError("There is no folder for profiles: set HOME.");
    const auto kept = keepProfile(key, profile, settings_.profiles);
    if (!kept) return tl::unexpected<Error>(kept.error());
    const std::string where = inQuotes((settings_.profiles / (key + ".json")).string());
    return "The measured figures are in " + where +
           (kept->empty() ? "." : "; what was there before is in " + inQuotes(kept->string()) + ".");
}

std::filesystem::path personsProfiles() {
    const char* const settings = std::getenv("XDG_CONFIG_HOME");
    const char* const home = std::getenv("HOME");
    if (settings && *settings) return std::filesystem::path(settings) / "Tactum/devices";
    return home ? std::filesystem::path(home) / ".config/Tactum/devices" : std::filesystem::path();
}

} // namespace tactum
