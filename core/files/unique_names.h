// Names made fit for a format, and each given out once.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

#include "core/base/text.h"

namespace tactum {

/// Gives each name out once; the second time with a number. Names that differ in case alone count as the
/// same, since some file systems see no difference.
class UniqueNames {
public:
    std::string take(const std::string& wanted) {
        std::string name = wanted;
        for (int i = 2; !taken_.insert(lowerCase(name)).second; ++i)
            name = wanted + "_" + std::to_string(i);
        return name;
    }

private:
    std::set<std::string> taken_;
};

/// Letters a to z, digits and _ alone, beginning with a letter, at most 40: an XML name and a file name
/// anywhere.
inline std::string plainName(std::string_view name) {
    std::string plain;
    for (const char c : name.substr(0, 40)) {
        const bool isLetter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'),
                   isDigit = c >= '0' && c <= '9';
        if (plain.empty() && !isLetter) plain += 'n';
        plain += isLetter || isDigit ? c : '_';
    }
    return plain.empty() ? "n" : plain;
}

/// How the names of files begin that belong to the one of this stem and are named inside it. Letters, digits,
/// _ - and . stay, other characters that can be read as well; blanks, signs and broken bytes become ~ and
/// their two hexadecimal digits, which neither a URL nor a line of words takes for anything else. Two stems
/// never become the same.
inline std::string sideFileStem(std::string_view stem) {
    const bool readable = printable(stem, stem.size()) == stem;
    std::string name;
    for (const char c : stem) {
        const auto byte = std::uint8_t(c);
        const bool stays = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '_' || c == '-' || c == '.' || (byte >= 0x80 && readable);
        if (stays)
            name += c;
        else
            name += {'~', "0123456789ABCDEF"[byte >> 4], "0123456789ABCDEF"[byte & 15]};
    }
    return name;
}

} // namespace tactum
