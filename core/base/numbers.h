// Numbers as text: always the C locale, whatever the user's is; written so that reading gives the same bits.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tactum {

/// The whole text as one finite number.
std::optional<double> parseNumber(std::string_view text);

/// The shortest text that reads back as the same double.
void appendNumber(std::string& out, double value);
/// The shortest text that reads back as the same float; seven digits where a double needs seventeen.
void appendNumber(std::string& out, float value);

} // namespace tactum
