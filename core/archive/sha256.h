// The fingerprint by which a bundle's manifest tells that an entry is what it was.
#pragma once

#include <string>
#include <string_view>

namespace tactum {

/// SHA-256 (FIPS 180-4) as 64 lower-case hexadecimal digits. Thread: any but real time.
std::string sha256(std::string_view bytes);

} // namespace tactum
