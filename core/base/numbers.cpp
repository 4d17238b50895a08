#include "core/base/numbers.h"

#include <charconv>
#include <cmath>

namespace tactum {

std::optional<double> parseNumber(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

namespace {

template <class Number> void append(std::string& out, Number value) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    if (error == std::errc()) out.append(digits, end);
}

} // namespace

void appendNumber(std::string& out, double value) {
    append(out, value);
}

void appendNumber(std::string& out, float value) {
    append(out, value);
}

} // namespace tactum
