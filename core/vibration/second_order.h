// A filter of second order for forces as they come, tick by tick.
#pragma once

#include <array>

#include "core/base/vec.h"

namespace tactum {

/// Butterworth's, by the bilinear transform, of three axes at once. What lies at the corner keeps half of its
/// power, and the powers that a low and a high pass of one corner leave add up to all of it. Thread: any,
/// one.
class SecondOrder {
public:
    /// corner and rate in Hz, the corner below half of the rate.
    static SecondOrder highPass(double corner, double rate);
    static SecondOrder lowPass(double corner, double rate);

    Vec3 operator()(const Vec3& in);
    /// From now on as if `in` had always been there and `out` had come of it.
    void settle(const Vec3& in, const Vec3& out);

private:
    std::array<double, 3> b_{}, a_{}; ///< newest first
    std::array<Vec3, 2> in_{Vec3::Zero(), Vec3::Zero()}, out_{Vec3::Zero(), Vec3::Zero()};
};

} // namespace tactum
