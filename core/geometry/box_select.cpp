#include "core/geometry/box_select.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tactum {
namespace {

using Vec4 = Eigen::Vector4d;
using BoxCorners = std::array<Index, 3>;

/// The five planes of the box's pyramid: a point of clip space is inside where none is negative.
class Pyramid {
public:
    static constexpr int kPlanes = 5;

    explicit Pyramid(const ScreenBox& box) {
        planes_.row(0) << 1, 0, 0, -box.left;
        planes_.row(1) << -1, 0, 0, box.right;
        planes_.row(2) << 0, 1, 0, -box.bottom;
        planes_.row(3) << 0, -1, 0, box.top;
        planes_.row(4) << 0, 0, 1, 1; // the near plane
    }

    /// A bit for each plane that the point is outside of.
    std::uint8_t outside(const Vec4& p) const {
        const Eigen::Matrix<double, kPlanes, 1> heights = planes_ * p;
        unsigned bits = 0;
        for (int i = 0; i < kPlanes; ++i)
            bits |= unsigned(heights[i] < 0) << i;
        return std::uint8_t(bits);
    }

    /// Whether some of a triangle is left when it is cut off at one plane after the other (I. E. Sutherland
    /// and G. W. Hodgman, "Reentrant Polygon Clipping", 1974).
    bool meets(const std::array<Vec4, 3>& triangle) const {
        std::array<Vec4, 3 + kPlanes> polygon, rest;
        std::size_t count = 3;
        std::copy(triangle.begin(), triangle.end(), polygon.begin());
        for (int i = 0; i < kPlanes && count > 0; ++i) {
            count = cut(polygon, count, i, rest);
            std::swap(polygon, rest);
        }
        return count > 0;
    }

private:
    template <class Polygon>
    std::size_t cut(const Polygon& from, std::size_t count, int plane, Polygon& to) const {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const Vec4 &a = from[i], &b = from[(i + 1) % count];
            const double heightA = planes_.row(plane).dot(a), heightB = planes_.row(plane).dot(b);
            if (heightA >= 0) to[kept++] = a;
            if ((heightA >= 0) != (heightB >= 0)) to[kept++] = a + heightA / (heightA - heightB) * (b - a);
        }
        return kept;
    }

    Eigen::Matrix<double, kPlanes, 4> planes_;
};

/// Twice the area on the screen, positive when the corners go round counter-clockwise, times the product of
/// the depths: also where a corner is behind the eye.
bool looksToTheEye(const Vec4& a, const Vec4& b, const Vec4& c) {
    const auto flat = [](const Vec4& p) { return Vec3(p.x(), p.y(), p.w()); };
    return flat(a).dot(flat(b).cross(flat(c))) > 0;
}

bool isTriangle(const BoxCorners& c) {
    return c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
}

} // namespace

TriangleSet trianglesInBox(const TriangleSoup& soup, const Eigen::Matrix4d& clipFromBody,
                           const ScreenBox& box, BoxRule rule) {
    const Pyramid pyramid(box);
    const auto inClip = [&](Index v) -> Vec4 { return clipFromBody * soup.positions[v].homogeneous(); };
    std::vector<std::uint8_t> outside(soup.positions.size());
    for (Index v = 0; v < outside.size(); ++v)
        outside[v] = pyramid.outside(inClip(v));

    const auto isTaken = [&](const BoxCorners& c) {
        const unsigned a = outside[c[0]], b = outside[c[1]], d = outside[c[2]];
        if (a & b & d) return false;
        if (rule.whole && (a | b | d)) return false;
        if (rule.frontOnly && isTriangle(c) && !looksToTheEye(inClip(c[0]), inClip(c[1]), inClip(c[2])))
            return false;
        return !(a && b && d) || pyramid.meets({inClip(c[0]), inClip(c[1]), inClip(c[2])});
    };
    TriangleSet result;
    for (Index t = 0; t < soup.triangles.size(); ++t)
        if (isTaken(soup.triangles[t])) result.push_back(t);
    return result;
}

} // namespace tactum
