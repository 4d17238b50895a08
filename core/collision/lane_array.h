// Eight floats in memory, as one instruction takes them.
#pragma once

namespace tactum {

inline constexpr int kLanes = 8;

struct alignas(32) LaneArray {
    float v[kLanes] = {};
    float& operator[](int i) { return v[i]; }
    float operator[](int i) const { return v[i]; }
};

} // namespace tactum
