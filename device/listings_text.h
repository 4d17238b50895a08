// Listings of devices as text, for a process that asks another one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/port/device_catalogue.h"

namespace tactum {

/// A JSON array of objects with id, name, usable, sentence, forbidden and lacks. Thread: any but real time.
std::string toJson(const std::vector<DeviceListing>& listings);
/// Nothing where the text is no such array. Thread: any but real time.
std::vector<DeviceListing> listingsOf(std::string_view json);

} // namespace tactum
