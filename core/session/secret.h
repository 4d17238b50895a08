// Secrets that programs show each other: made of the system's randomness, compared without telling how far
// they agree.
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace tactum {

/// 128 bits. Thread: any but real time.
Result<std::string> makeSecret();

/// As letters: two hexadecimal digits for each byte.
std::string hexOf(std::string_view bytes);

/// Takes as long for every text of the length of `secret`; false for an empty secret.
bool sameSecret(std::string_view secret, std::string_view given);

} // namespace tactum
