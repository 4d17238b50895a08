// The format of a file without a name, by how it begins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace tactum {

/// As much of the beginning of a file as is looked at.
inline constexpr std::size_t kTellingHead = 4096;

/// The ending that a file of `size` bytes with this beginning would have; empty for what cannot be told.
/// Thread: any but real time.
std::string_view toldEnding(std::string_view head, std::uint64_t size);

/// How long a file with this beginning has to be where its format says so: glb, and binary STL, for which
/// everything is taken that no other format begins with. Nothing for what may have any length.
std::optional<std::uint64_t> announcedSize(std::string_view head);

} // namespace tactum
