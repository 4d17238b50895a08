// What is left of a number when it is kept as a float.
#pragma once

#include "core/base/vec.h"

namespace tactum {

/// The nearest float, as a double. Through memory that the compiler has to believe in: g++ 12.2 at -O2 makes
/// two of them side by side one vector, and takes that for nothing having been done, so that no digit was
/// lost.
inline double asSingle(double value) {
    const volatile float single = float(value);
    return single;
}
inline Vec3 asSingle(const Vec3& v) {
    return {asSingle(v.x()), asSingle(v.y()), asSingle(v.z())};
}

} // namespace tactum
