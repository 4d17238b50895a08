// The fingerprint that tells that a file, or an entry of a bundle, is what it was.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tactum {

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits. Thread: any but real time.
std::string sha256(std::string_view bytes);
/// Of what a file holds, as `sha256sum` says it; empty where it cannot be read. Thread: any but real time.
std::string fingerprintOf(const std::filesystem::path& file);

} // namespace tactum
