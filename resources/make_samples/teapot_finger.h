// A finger on the parts of the teapot.
#pragma once

#include <span>

#include "resources/make_samples/teapot_shape.h"

namespace tactum::samples {

/// Where the finger is at a time: on a part, at a depth under its surface (negative: above it).
struct TeapotKey {
    double t; ///< s
    const Part* part;
    double u, v;
    double depth; ///< mm
};

/// Along the surface between keys of one part, straight through the air between keys of two. z is up.
Vec3 teapotFinger(std::span<const TeapotKey> keys, double t);

} // namespace tactum::samples
