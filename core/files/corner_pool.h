// Values that many corners share, each kept once: for file formats that index them.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/geometry/triangle_soup.h"

namespace tactum {

/// Numbers the different keys in the order in which they first come. A key is a row of 32 bits.
template <std::size_t N> class CornerPool {
public:
    using Key = std::array<std::uint32_t, N>;

    Index numberOf(const Key& key) {
        const auto [found, isNew] = numbers_.try_emplace(key, Index(keys_.size()));
        if (isNew) keys_.push_back(key);
        return found->second;
    }
    const std::vector<Key>& keys() const { return keys_; }

private:
    struct Hash {
        std::size_t operator()(const Key& key) const {
            std::uint64_t hash = 0;
            for (const std::uint32_t part : key)
                hash = (hash ^ part) * 0x9E3779B97F4A7C15u, hash ^= hash >> 29;
            return std::size_t(hash);
        }
    };

    std::unordered_map<Key, Index, Hash> numbers_;
    std::vector<Key> keys_;
};

inline std::uint32_t bitsOf(float value) {
    return std::bit_cast<std::uint32_t>(value);
}
inline float floatOf(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}

/// How many different corners a triangle of a soup has: 3, 2 of a segment, 1 of a point.
inline int cornersOf(const std::array<Index, 3>& triangle) {
    if (triangle[1] != triangle[2]) return 3;
    return triangle[0] == triangle[1] ? 1 : 2;
}

} // namespace tactum
