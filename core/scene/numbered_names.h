// Names that are given out once each: "cup", "cup 2", "cup 3".
#pragma once

#include <map>
#include <set>
#include <string>

#include "core/base/text.h"

namespace tactum {

/// Case alone is no difference. Thread: any but real time.
class NumberedNames {
public:
    void reserve(const std::string& name) { taken_.insert(lowerCase(name)); }
    /// `wanted`, or with the next number behind it that is free.
    std::string take(const std::string& wanted) {
        if (taken_.insert(lowerCase(wanted)).second) return wanted;
        const std::string stem = stemOf(wanted);
        int& number = numbers_.try_emplace(lowerCase(stem), 1).first->second;
        for (;;)
            if (const std::string name = stem + ' ' + std::to_string(++number);
                taken_.insert(lowerCase(name)).second)
                return name;
    }

private:
    /// One more of "cup 2" is "cup 3".
    static std::string stemOf(const std::string& name) {
        const auto last = name.find_last_not_of("0123456789");
        const bool numbered =
            last != std::string::npos && last > 0 && last + 1 < name.size() && name[last] == ' ';
        return numbered ? name.substr(0, last) : name;
    }

    std::set<std::string> taken_;
    std::map<std::string, int> numbers_; ///< of each stem, the last that was given out
};

} // namespace tactum
