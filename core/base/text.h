// Reading text files: lines, fields, numbers in the C locale, and words that are safe to show.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tactum {

/// Text made safe to print: valid UTF-8 without control characters, at most `limit` bytes (3 or more).
std::string printable(std::string_view text, std::size_t limit = 60);
/// Of an object, a surface or a layer: bytes.
inline constexpr std::size_t kLongestName = 1000;
/// The same in quotes.
std::string inQuotes(std::string_view text);

/// A reference of a URI with its %20 and the like as the bytes that they stand for.
std::string withoutPercents(std::string_view uri);

bool isBlank(char c); ///< space, tab, carriage return, vertical tab, form feed
std::string_view trimmed(std::string_view text);
std::string lowerCase(std::string_view text); ///< of the letters a to z

/// The whole of `token` as a number, an optional + included. "nan" and "inf" count as numbers here.
bool parseNumber(std::string_view token, double& value);
bool parseNumber(std::string_view token, std::int64_t& value);

/// Takes the next field away from a text whose fields such characters separate; empty at its end.
std::string_view takeSeparated(std::string_view& rest, bool (*separates)(char));

/// The blank-separated fields of a line, one after the other.
class Fields {
public:
    explicit Fields(std::string_view line) : rest_(line) {}
    /// Empty at the end of the line.
    std::string_view next();
    /// What has not been taken yet, without blanks around it.
    std::string_view rest() const { return trimmed(rest_); }

private:
    std::string_view rest_;
};

/// The lines of a text, without their line ends (LF or CRLF).
class Lines {
public:
    /// `joinContinued`: a line that ends in a backslash goes on in the next one.
    explicit Lines(std::string_view text, bool joinContinued = false) : text_(text), join_(joinContinued) {}

    bool next(std::string_view& line);
    std::size_t number() const { return number_; } ///< of the last line, from 1; its first where joined
    std::size_t offset() const { return at_; }     ///< of the byte after it

private:
    std::string_view raw();

    std::string_view text_;
    bool join_;
    std::size_t at_ = 0, number_ = 0, skipped_ = 0;
    std::string joined_;
};

} // namespace tactum
