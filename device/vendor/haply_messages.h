// What Haply's Inverse Service says and understands (docs.haply.co, version 3.5): JSON, metre, newton; one
// answer for every message. Never tried with the real one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/port/haptic_device.h"

namespace tactum::haply {

/// One Inverse3 as a message tells of it.
struct State {
    std::string id;
    DeviceSample sample;    ///< in D; valid when the message has a whole position
    bool calibrated = true; ///< where the message does not say so: as before, true at first
};

/// Every Inverse3 of a message; what cannot be read is left out. The buttons are those of the first grip.
std::vector<State> read(std::string_view message);

/// What an Inverse3 shall push with. `first`: with the greeting, which asks for a workspace about the origin.
std::string write(const std::string& id, const Vec3& force_D, bool first);

} // namespace tactum::haply
