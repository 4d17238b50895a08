// A made-up program for the Falcon: the form of a real one, and none of its content.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace tactum::test {

/// A boot stream with blocks of so many words.
inline std::vector<std::uint8_t> makeBootStream(const std::vector<int>& blocks = {900, 3, 250}) {
    std::vector<std::uint8_t> bytes;
    const auto put = [&](unsigned word) {
        bytes.push_back(std::uint8_t(word & 255));
        bytes.push_back(std::uint8_t(word >> 8));
    };
    std::mt19937 random(7);
    put(0x08aa);
    for (int i = 0; i < 8; ++i)
        put(0);
    put(0x003f);
    put(0x8000);
    for (const int words : blocks) {
        put(unsigned(words));
        put(0x003f);
        put(random() & 0xffff);
        for (int i = 0; i < words; ++i)
            put(random() & 0xffff);
    }
    put(0);
    return bytes;
}

} // namespace tactum::test
