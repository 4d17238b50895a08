// Eight floats in memory, as one instruction takes them.
#pragma once

#include <cstddef>

namespace tactum {

inline constexpr int kLanes = 8;

/// What is read as a whole begins where a line of the cache does.
inline constexpr std::size_t kCacheLine = 64;

struct alignas(32) LaneArray {
    float v[kLanes] = {};
    float& operator[](int i) { return v[i]; }
    float operator[](int i) const { return v[i]; }
};

} // namespace tactum
