#include "core/dynamics/segments.h"

#include <algorithm>

namespace tactum {

/// Ericson, Real-Time Collision Detection, 5.1.9.
PointPair nearestPoints(const Vec3& p1, const Vec3& q1, const Vec3& p2, const Vec3& q2) noexcept {
    const Vec3 d1 = q1 - p1, d2 = q2 - p2, r = p1 - p2;
    const double a = d1.squaredNorm(), e = d2.squaredNorm(), f = d2.dot(r);
    double s = 0, t = 0;
    if (a <= 1e-30) {
        t = e > 1e-30 ? std::clamp(f / e, 0.0, 1.0) : 0;
    } else {
        const double c = d1.dot(r);
        if (e <= 1e-30) {
            s = std::clamp(-c / a, 0.0, 1.0);
        } else {
            const double b = d1.dot(d2), under = a * e - b * b;
            if (under > 1e-14 * a * e) s = std::clamp((b * f - c * e) / under, 0.0, 1.0);
            t = (b * s + f) / e;
            if (t < 0) {
                t = 0;
                s = std::clamp(-c / a, 0.0, 1.0);
            } else if (t > 1) {
                t = 1;
                s = std::clamp((b - c) / a, 0.0, 1.0);
            }
        }
    }
    return {p1 + s * d1, p2 + t * d2};
}

} // namespace tactum
