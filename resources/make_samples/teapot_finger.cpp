#include "resources/make_samples/teapot_finger.h"

#include <algorithm>
#include <cmath>

namespace tactum::samples {
namespace {

Vec3 fingerAt(const Part& part, double u, double v, double depth) {
    return part.point(u, v) - 1e-3 * depth * part.normal(u, v);
}

} // namespace

Vec3 teapotFinger(std::span<const TeapotKey> keys, double t) {
    const auto next =
        std::find_if(keys.begin() + 1, keys.end() - 1, [&](const TeapotKey& key) { return key.t >= t; });
    const TeapotKey &a = *(next - 1), &b = *next;
    const double x = std::clamp((t - a.t) / (b.t - a.t), 0.0, 1.0), s = x * x * (3 - 2 * x);
    if (a.part != b.part)
        return (1 - s) * fingerAt(*a.part, a.u, a.v, a.depth) + s * fingerAt(*b.part, b.u, b.v, b.depth);
    return fingerAt(*a.part, std::lerp(a.u, b.u, s), std::lerp(a.v, b.v, s), std::lerp(a.depth, b.depth, s));
}

} // namespace tactum::samples
