// Bytes as text and back, for pictures inside JSON (RFC 4648, section 4).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tactum {

std::string base64Of(std::string_view bytes);
/// Nothing for a text that base64Of() does not write.
std::optional<std::string> fromBase64(std::string_view text);

} // namespace tactum
