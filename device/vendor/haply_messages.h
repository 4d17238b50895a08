// What Haply's Inverse Service says and understands: JSON, metre, newton; one answer for every message.
// Written from docs.haply.co, version 3.5 (pages WebSocket protocol, Control commands, Device configuration,
// HTTP), and for the words of 3.1 from programs that speak them. Never tried with the real one.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/port/haptic_device.h"

namespace tactum::haply {

/// Which words the service understands: those of 3.1 are a force's "values" and a preset's bare name.
struct Version {
    int major = 3, minor = 5;

    auto operator<=>(const Version&) const = default;
};
inline constexpr Version kNewWords{3, 5};

/// What GET /version says; the newest that is known where that cannot be read.
Version versionOf(std::string_view answer);

/// The workspace that is asked for: about the origin.
inline constexpr const char* kPreset = "arm_front_centered";

/// One Inverse3 as a message tells of it.
struct State {
    std::string id;
    DeviceSample sample;       ///< in D; valid when the message has a whole position
    bool calibrated = true;    ///< where the message does not say so: as before, true at first
    std::optional<Vec3> force; ///< in D, N: what the service has it push with, where it says so
    std::string preset;        ///< that holds; empty in messages without the configuration
};

/// Every Inverse3 of a message; what cannot be read is left out. The buttons are those of the first grip.
std::vector<State> read(std::string_view message);

/// What else a message asks for, besides a force.
enum class Asking { Nothing, Configuration, Workspace };

/// What an Inverse3 shall push with. `asking`: to tell its configuration, and before that to take the
/// workspace.
std::string write(const std::string& id, const Vec3& force_D, Asking asking, Version version);

} // namespace tactum::haply
