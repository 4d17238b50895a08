#include "core/surface/painted_slopes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/parallel.h"
#include "core/base/realtime.h"
#include "core/surface/painted_fit.h"

namespace tactum {

namespace {

// The slope across a side is quadratic along it where what is painted is cubic: its middle differs from the
// mean of the ends by an eighth of what the bend does.
std::array<float, 3> bulgeOf(const TriangleSoup& soup, const PaintedGround& ground,
                             const std::vector<Mat3>& bend, Index triangle) {
    const auto& corner = soup.triangles[triangle];
    if (std::ranges::all_of(corner, [&](Index i) { return bend[ground.place[i]].isZero(0); })) return {};
    const Triangle t = cornersOf(soup, triangle);
    const std::array<Vec3, 3> at{t.a, t.b, t.c};
    const Vec3 across = acrossOf(t).normalized(), middle = (t.a + t.b + t.c) / 3;
    std::array<float, 3> bulge{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const Vec3 edge = at[j] - at[i], up = middle - at[i];
        const Vec3 inward = up - up.dot(edge) / edge.squaredNorm() * edge;
        const auto bendAt = [&](std::size_t k) {
            const Index place = ground.place[corner[k]];
            const Vec3 normal = ground.normal[place].cast<double>();
            if (!shareAPlane(across, normal)) return 0.0;
            return turned(edge, across, normal).dot(bend[place] * turned(inward, across, normal));
        };
        const double higher = (bendAt(i) - bendAt(j)) / 12;
        bulge[i] = std::isfinite(higher) ? float(higher) : 0.0F;
    }
    return bulge;
}

} // namespace

Vec3 linearSlope(const Triangle& t, const Vec3& values) noexcept {
    const Vec3 across = acrossOf(t), toB = (values[1] - values[0]) * (t.c - t.a),
               toC = (values[2] - values[0]) * (t.b - t.a);
    const Vec3 slope = (toB - toC).cross(across) / across.squaredNorm();
    return slope.allFinite() ? slope : Vec3::Zero();
}

PaintedSlopes::PaintedSlopes(const TriangleSoup& soup, std::shared_ptr<const PaintedGround> ground,
                             const PaintedValues& values)
    : ground_(std::move(ground)), rise_(soup.positions.size(), Eigen::Vector3f::Zero()),
      bulge_(soup.triangles.size()) {
    assertNotRealtime();
    std::vector<Mat3> bend(rise_.size(), Mat3::Zero());
    parallelFor(rise_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        PaintedFitter fitter(soup, *ground_, values);
        for (std::size_t i = begin; i < end; ++i) {
            if (ground_->around(Index(i)).empty()) continue;
            const PaintedFit fit = fitter.at(Index(i));
            rise_[i] = fit.rise.cast<float>();
            bend[i] = fit.bend;
        }
    });
    parallelFor(bulge_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            bulge_[i] = bulgeOf(soup, *ground_, bend, Index(i));
    });
}

Vec3 PaintedSlopes::at(Index position, const Vec3& normal, const Vec3& otherwise) const noexcept {
    const Index place = ground_->place[position];
    const Vec3 there = ground_->normal[place].cast<double>();
    return shareAPlane(normal, there) ? turned(rise_[place].cast<double>(), there, normal) : otherwise;
}

} // namespace tactum
