#include "core/base/text.h"

#include <charconv>
#include <cstring>
#include <utility>

namespace tactum {
namespace {

/// How many bytes the UTF-8 character at the start of `text` has; 0 when it is not one.
std::size_t utf8Length(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? std::uint8_t(text[i]) : std::uint8_t(0);
    };
    const auto follows = [&](std::size_t i) { return (byte(i) & 0xC0) == 0x80; };
    const std::uint8_t first = byte(0), second = byte(1);
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
    if (first >= 0xE0 && first <= 0xEF) {
        const bool overlong = first == 0xE0 && second < 0xA0, surrogate = first == 0xED && second > 0x9F;
        return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
    }
    if (first >= 0xF0 && first <= 0xF4) {
        const bool overlong = first == 0xF0 && second < 0x90, beyond = first == 0xF4 && second > 0x8F;
        return follows(1) && follows(2) && follows(3) && !overlong && !beyond ? 4 : 0;
    }
    return 0;
}

bool isControl(std::string_view character) {
    const auto first = std::uint8_t(character[0]);
    return first < 0x20 || first == 0x7F || (first == 0xC2 && std::uint8_t(character[1]) < 0xA0);
}

/// Characters that turn the direction of the text around them: "cod\u202Egpj.exe" looks like another name.
bool turnsDirection(std::string_view character) {
    if (character.size() == 2) return character == "\u061C";
    if (character.size() != 3 || character[0] != '\xE2') return false;
    const auto last = std::uint8_t(character[2]);
    return (character[1] == '\x80' && ((last >= 0xAA && last <= 0xAE) || last == 0x8E || last == 0x8F)) ||
           (character[1] == '\x81' && last >= 0xA6 && last <= 0xA9);
}

template <class T> bool parseWhole(std::string_view token, T& value) {
    if (token.size() > 1 && token[0] == '+' && token[1] != '-') token.remove_prefix(1);
    const char* end = token.data() + token.size();
    const auto [last, fault] = std::from_chars(token.data(), end, value);
    return fault == std::errc() && last == end;
}

} // namespace

std::string printable(std::string_view text, std::size_t limit) {
    constexpr std::string_view kDots = "...";
    const std::size_t room = limit - std::min(limit, kDots.size());
    std::string result;
    std::size_t cut = 0; ///< where dots still have room behind it
    while (!text.empty()) {
        const std::size_t length = utf8Length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        const bool hidden = length == 0 || isControl(character) || turnsDirection(character);
        result += hidden ? "?" : character;
        if (result.size() > limit) return result.substr(0, cut).append(kDots);
        if (result.size() <= room) cut = result.size();
        text.remove_prefix(character.size());
    }
    return result;
}

std::string inQuotes(std::string_view text) {
    return "\"" + printable(text) + "\"";
}

std::string withoutPercents(std::string_view uri) {
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        int value = 0;
        const bool coded =
            uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(uri.data() + i + 1, uri.data() + i + 3, value, 16).ptr == uri.data() + i + 3;
        text += coded ? char(value) : uri[i];
        if (coded) i += 2;
    }
    return text;
}

bool isBlank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r' && c != '\n');
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

std::string lowerCase(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return result;
}

bool parseNumber(std::string_view token, double& value) {
    return parseWhole(token, value);
}
bool parseNumber(std::string_view token, std::int64_t& value) {
    return parseWhole(token, value);
}

std::string_view takeSeparated(std::string_view& rest, bool (*separates)(char)) {
    std::size_t start = 0;
    while (start < rest.size() && separates(rest[start]))
        ++start;
    std::size_t end = start;
    while (end < rest.size() && !separates(rest[end]))
        ++end;
    const std::string_view field = rest.substr(start, end - start);
    rest.remove_prefix(end);
    return field;
}

std::string_view Fields::next() {
    return takeSeparated(rest_, isBlank);
}

std::string_view Lines::raw() {
    const char* start = text_.data() + at_;
    const std::size_t left = text_.size() - at_;
    const void* found = std::memchr(start, '\n', left);
    const std::size_t length = found ? std::size_t(static_cast<const char*>(found) - start) : left;
    at_ += found ? length + 1 : length;
    std::string_view line(start, length);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    return line;
}

bool Lines::next(std::string_view& line) {
    if (at_ >= text_.size()) return false;
    number_ += 1 + std::exchange(skipped_, 0);
    line = raw();
    if (!join_ || line.empty() || line.back() != '\\') return true;
    joined_.clear();
    for (;; ++skipped_) {
        const bool goesOn = !line.empty() && line.back() == '\\';
        joined_ += goesOn ? line.substr(0, line.size() - 1) : line;
        joined_ += ' ';
        if (!goesOn || at_ >= text_.size()) break;
        line = raw();
    }
    line = joined_;
    return true;
}

} // namespace tactum
