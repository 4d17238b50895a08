// Queries of the hierarchy. Their kernel is compiled for plain processors and for those with AVX2; the one
// that runs is chosen when the program starts. Both give the same bits.
// Thread: real time.

#include <algorithm>
#include <bit>
#include <cmath>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#include "core/collision/leaf_planes.h"
#include "core/collision/sphere_tree.h"

namespace tactum {

namespace {

#if defined(__AVX__)
#define TACTUM_AVX
#endif
namespace plain {
#include "core/collision/kernel/kernel.inc"
} // namespace plain

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__AVX2__)

#pragma GCC push_options
#pragma GCC target("avx2")
#define TACTUM_AVX
namespace avx2 {
#include "core/collision/kernel/kernel.inc"
} // namespace avx2
#pragma GCC pop_options

bool hasAvx2() {
    __builtin_cpu_init();
    return __builtin_cpu_supports("avx2");
}

const bool kAvx2 = hasAvx2();
const auto sweepTree = kAvx2 ? avx2::sweepTree : plain::sweepTree;
const auto gatherNear = kAvx2 ? avx2::gatherNear : plain::gatherNear;

#else

using plain::gatherNear;
using plain::sweepTree;

#endif

} // namespace

SweepHit SphereTree::sweep(const TriangleSoup& soup, const SpherePath& path, std::span<const Index> excluded,
                           Index hint, const Neighbourhood* near, LeafPlanes* planes) const noexcept {
    if (nodes_.empty()) return {};
    return sweepTree(*this, soup, path, excluded, hint, near, planes);
}

bool SphereTree::isBeyond(const Vec3& p, double reach) const noexcept {
    if (nodes_.empty()) return true;
    const Node& root = nodes_.front();
    for (int i = 0; i < kWidth; ++i) {
        const double room = reach + double(root.radius[i]);
        if (room > 0 && (p - origin_ - Vec3(root.x[i], root.y[i], root.z[i])).squaredNorm() <= room * room)
            return false;
    }
    return true;
}

void SphereTree::gather(const Vec3& centre, double radius, Neighbourhood& near) const noexcept {
    near.centre = centre;
    near.radius = radius;
    near.blocks = 0;
    near.crowded = false;
    if (!nodes_.empty()) gatherNear(*this, centre - origin_, radius, near);
}

} // namespace tactum
