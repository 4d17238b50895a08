#include "core/presets/base64.h"

#include <array>
#include <cstdint>

namespace tactum {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// 0 for what is no letter: fromBase64() sees that it does not come back.
constexpr std::array<std::uint8_t, 256> kNumbers = [] {
    std::array<std::uint8_t, 256> numbers{};
    for (std::size_t i = 0; i < kLetters.size(); ++i)
        numbers[std::size_t(std::uint8_t(kLetters[i]))] = std::uint8_t(i);
    return numbers;
}();

} // namespace

std::string base64Of(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t at = 0; at < bytes.size(); at += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 3; ++i)
            word = word << 8 | (i < count ? std::uint8_t(bytes[at + i]) : 0);
        for (std::size_t i = 0; i < 4; ++i)
            text += i <= count ? kLetters[word >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

std::optional<std::string> fromBase64(std::string_view text) {
    if (text.size() % 4 != 0) return std::nullopt;
    const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3);
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < text.size() - padding; ++i) {
        word = word << 6 | kNumbers[std::size_t(std::uint8_t(text[i]))];
        if (i % 4 != 3) continue;
        for (int shift = 16; shift >= 0; shift -= 8)
            bytes += char(word >> shift & 0xFF);
    }
    if (padding == 1) bytes += {char(word >> 10 & 0xFF), char(word >> 2 & 0xFF)};
    if (padding == 2) bytes += char(word >> 4 & 0xFF);
    return base64Of(bytes) == text ? std::optional(std::move(bytes)) : std::nullopt;
}

} // namespace tactum
