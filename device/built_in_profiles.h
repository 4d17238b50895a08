// The text of every file in resources/devices, by its name without the ending; made by the build.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace tactum {

extern const std::span<const std::pair<std::string_view, std::string_view>> kBuiltInProfiles;

} // namespace tactum
