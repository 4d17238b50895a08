// Names made fit for a format, and each given out once.
#pragma once

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

} // namespace tactum
