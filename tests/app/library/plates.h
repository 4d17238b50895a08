// What the tests of the library touch: a plate to press on, and what an error says.
#pragma once

#include <string>
#include <vector>

#include <tactum/tactum.h>

#include "core/base/vec.h"

namespace tactum::test {

namespace lib = tactum::library;

/// In the plane y = 0, 0.2 m wide, felt from above; the proxy's radius is 1 mm.
inline lib::Scene plate(double stiffness = 500) {
    const std::vector<lib::Vec3> corners{{-0.1, 0, -0.1}, {0.1, 0, -0.1}, {0.1, 0, 0.1}, {-0.1, 0, 0.1}};
    const std::vector<lib::Triangle> triangles{{0, 2, 1}, {0, 3, 2}};
    lib::Scene scene;
    scene.addMesh(corners, triangles, {}, "plate").set("stiffness", stiffness);
    return scene;
}

/// The finger goes down to `depth` (m) below the plate and aside there.
inline std::vector<lib::FingerPoint> press(double depth = 0.002, int rows = 200) {
    std::vector<lib::FingerPoint> path;
    for (int i = 0; i < rows; ++i) {
        const double part = double(i) / rows;
        path.push_back({1e-3 * i, {0.02 * part, 0.01 - (0.01 + depth) * std::min(1.0, 2 * part), 0}});
    }
    return path;
}

inline Vec3 eigen(const lib::Vec3& v) {
    return {v.x, v.y, v.z};
}

/// The sentence of the Error that this throws.
template <class Work> std::string sentenceOf(const Work& work) {
    try {
        work();
    } catch (const lib::Error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

} // namespace tactum::test
