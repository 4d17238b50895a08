#include "core/proxy/surface_under.h"

namespace tactum {

namespace {

// Slopes below this are flat.
constexpr double kFlat = 1e-12;

} // namespace

// One that is flat holds nothing back, but beside a tilted one
// it would hold the finger on that one's slope.
int slopesOf(const TextureFeel& feel, FeltSlopes& slopes) noexcept {
    int count = 0;
    if (feel.slope.norm() > kFlat) slopes[std::size_t(count++)] = feel.slope;
    for (int i = 0; i < feel.ownPlanes; ++i)
        if (feel.ownSlopes[std::size_t(i)].norm() > kFlat)
            slopes[std::size_t(count++)] = feel.ownSlopes[std::size_t(i)];
    if (count == 0) slopes[std::size_t(count++)] = Vec3::Zero();
    return count;
}

} // namespace tactum
