// The figures of a device as a text file that a person can edit: resources/devices/*.json are built in.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/port/haptic_device.h"

namespace tactum {

struct DeviceProfile {
    std::string key;            ///< name of its file without the ending: "falcon"
    DeviceInfo info;            ///< a real device
    double countsPerTorque = 0; ///< motor command for 1 N m, where the driver asks for it; else 0
    // Of the Falcon's driver, what no device could be asked yet (docs/falcon.md); the defaults are the
    // careful ones.
    double commandsOnWay = 1;     ///< before their reports have come
    double resetPause = 0.01;     ///< s, between the edges that reset its processor
    double longestUnheard = 0.03; ///< s without a command handed over, and the line counts as broken
};

/// What the text says over what is in `profile`; a figure that it does not name stays. `file` is for
/// messages. Refuses unknown figures and those that no device has (checkDevice()). Thread: any but real time.
Result<DeviceProfile> readProfile(std::string_view text, const std::filesystem::path& file,
                                  DeviceProfile profile);

/// Those that are built in, by key. Thread: any but real time.
const std::vector<DeviceProfile>& builtInProfiles();

/// The built-in one, with what KEY.json in the person's folder says over it; a folder that is not there says
/// nothing. Errors: no such key, a file that cannot be read. Thread: any but real time.
Result<DeviceProfile> profileOf(std::string_view key, const std::filesystem::path& folder);

/// Lays the figures of a profile's text over KEY.json in the person's folder: what it does not name stays, a
/// limit that the person set for instance. The file that was there is copied beside it first; the answer is
/// that copy, or empty. Errors: a text or a file that is wrong, a folder that cannot be written.
/// Thread: any but real time.
Result<std::filesystem::path> keepProfile(std::string_view key, std::string_view text,
                                          const std::filesystem::path& folder);

/// The built-in profile for what a device calls itself: the one most of whose words begin words of the name,
/// and all of them; empty when there is none. "omega.3" is an omega. Thread: any but real time.
std::string profileFor(std::string_view model);

} // namespace tactum
