#include "core/geometry/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactum {

namespace {

ClosestPoint onEdge(const Vec3& from, const Vec3& to, double s, int i, int j) noexcept {
    ClosestPoint result;
    result.point = from + s * (to - from);
    result.weights = Vec3::Zero();
    result.weights[i] += 1 - s;
    result.weights[j] += s;
    result.feature = Feature::Edge;
    return result;
}

ClosestPoint atVertex(const Vec3& v, int i) noexcept {
    ClosestPoint result;
    result.point = v;
    result.weights = Vec3::Unit(i);
    result.feature = Feature::Vertex;
    return result;
}

ClosestPoint nearestOfEdges(const Triangle& t, const Vec3& p) noexcept {
    const std::array<const Vec3*, 3> corner{&t.a, &t.b, &t.c};
    ClosestPoint best = atVertex(t.a, 0);
    double bestSquared = (p - t.a).squaredNorm();
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const Vec3 edge = *corner[j] - *corner[i];
        const double length2 = edge.squaredNorm();
        if (!(length2 > 0)) continue;
        const double s = std::clamp(edge.dot(p - *corner[i]) / length2, 0.0, 1.0);
        const ClosestPoint candidate = s <= 0   ? atVertex(*corner[i], i)
                                       : s >= 1 ? atVertex(*corner[j], j)
                                                : onEdge(*corner[i], *corner[j], s, i, j);
        const double squared = (p - candidate.point).squaredNorm();
        if (squared < bestSquared) best = candidate, bestSquared = squared;
    }
    return best;
}

// First t in [0, 1] at which |m + t d| = r on the way in; m is the start relative to the point.
double sweepPoint(const Vec3& m, const Vec3& d, double r) noexcept {
    const double c = m.squaredNorm() - r * r;
    const double b = m.dot(d);
    if (b >= 0) return kNoContact;
    if (c <= 0) return 0;
    const double discriminant = b * b - d.squaredNorm() * c;
    if (discriminant < 0) return kNoContact;
    // c / (-b + root) is the smaller root without the cancellation of (-b - root) / a.
    const double t = c / (-b + std::sqrt(discriminant));
    return t <= 1 ? t : kNoContact;
}

// The same for a segment: enter the infinite cylinder, then see whether that is beside the segment.
double sweepSegment(const Vec3& from, const Vec3& to, const Vec3& p, const Vec3& d, double r) noexcept {
    const Vec3 e = to - from;
    const Vec3 m = p - from;
    const double length2 = e.squaredNorm();
    if (!(length2 > 0)) return sweepPoint(m, d, r);
    const double mAlong = m.dot(e) / length2;
    const double dAlong = d.dot(e) / length2;
    const Vec3 mAcross = m - mAlong * e;
    const Vec3 dAcross = d - dAlong * e;
    const double a = dAcross.squaredNorm();
    const double b = mAcross.dot(dAcross);
    const double c = mAcross.squaredNorm() - r * r;
    double along = mAlong;
    if (c > 0) {
        const double discriminant = b * b - a * c;
        if (b >= 0 || discriminant < 0) return kNoContact;
        const double t = c / (-b + std::sqrt(discriminant));
        if (t > 1) return kNoContact;
        along = mAlong + t * dAlong;
        if (along >= 0 && along <= 1) return t;
    } else if (along >= 0 && along <= 1) {
        return b < 0 ? 0 : kNoContact;
    }
    return along < 0 ? sweepPoint(m, d, r) : sweepPoint(p - to, d, r);
}

// Below this ratio of height to length a flat triangle's normal is rounding noise, and its edges alone are
// nearer to the truth: at 1e-6 both are wrong by 1e-10 of the length for a sphere a thousand times smaller.
constexpr double kSliver = 1e-6;

// (b - a) x (c - a), from the two shorter sides, which lose least to rounding; zero for a sliver, a segment
// and a point.
Vec3 faceNormal(const Triangle& t) noexcept {
    const Vec3 ab = t.b - t.a, bc = t.c - t.b, ca = t.a - t.c;
    const double ab2 = ab.squaredNorm(), bc2 = bc.squaredNorm(), ca2 = ca.squaredNorm();
    const bool abLongest = ab2 >= bc2 && ab2 >= ca2, bcLongest = bc2 >= ca2;
    const Vec3 normal = abLongest ? bc.cross(ca) : bcLongest ? ca.cross(ab) : ab.cross(bc);
    const double shorter2 = abLongest ? bc2 * ca2 : bcLongest ? ca2 * ab2 : ab2 * bc2;
    if (!(normal.squaredNorm() > kSliver * kSliver * shorter2)) return Vec3::Zero();
    return normal;
}

bool insideFace(const Triangle& t, const Vec3& normal, const Vec3& q) noexcept {
    return normal.dot((t.b - t.a).cross(q - t.a)) >= 0 && normal.dot((t.c - t.b).cross(q - t.b)) >= 0 &&
           normal.dot((t.a - t.c).cross(q - t.c)) >= 0;
}

// closestPoint() with a normal that is found only when it is needed.
template <class FaceNormal>
ClosestPoint closestWith(const Triangle& t, const Vec3& p, FaceNormal&& normalOf) noexcept {
    const Vec3 ab = t.b - t.a, ac = t.c - t.a;
    const Vec3 ap = p - t.a, bp = p - t.b, cp = p - t.c;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return atVertex(t.a, 0);
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return atVertex(t.b, 1);
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return atVertex(t.c, 2);
    // The signed areas of the foot point, by the normal: d1 d4 - d3 d2 and its like say the same but lose
    // twice as many digits on a thin triangle.
    const Vec3 normal = normalOf();
    const double va = normal.dot(bp.cross(cp)), vb = normal.dot(cp.cross(ap)), vc = normal.dot(ap.cross(bp));
    const double sum = va + vb + vc;
    if (!(sum > 0)) return nearestOfEdges(t, p);
    if (va <= 0 || vb <= 0 || vc <= 0) return nearestOfEdges(t, p);
    ClosestPoint result;
    const double v = vb / sum, w = vc / sum;
    result.weights = {1 - v - w, v, w};
    result.point = t.a + v * ab + w * ac;
    result.feature = Feature::Face;
    return result;
}

// Everything but a face that is entered from above: edges and vertices, and a sphere that is there already.
double sweepBesideFace(const Triangle& t, const Vec3& normal, const Vec3& p, const Vec3& d, double r,
                       double until) noexcept {
    const ClosestPoint closest = closestWith(t, p, [&]() -> const Vec3& { return normal; });
    const Vec3 away = p - closest.point;
    const double distance2 = away.squaredNorm(), approach = -away.dot(d);
    // The distance is convex along the path and so stays above its tangent at the start.
    if (!(approach > 0)) return kNoContact;
    if (distance2 <= r * r) return 0;
    const double distance = std::sqrt(distance2);
    if ((distance - r) * distance > until * approach) return kNoContact;
    // Above the face the distance is the height: a sphere that rests on the face to the last bit must not
    // fall between the two answers, and through.
    if (closest.feature == Feature::Face && distance <= r * (1 + 1e-12)) return 0;
    return std::min(
        {sweepSegment(t.a, t.b, p, d, r), sweepSegment(t.b, t.c, p, d, r), sweepSegment(t.c, t.a, p, d, r)});
}

} // namespace

ClosestPoint closestPoint(const Triangle& t, const Vec3& p) noexcept {
    return closestWith(t, p, [&] { return faceNormal(t); });
}

ClosestPoint footOnPlane(const Triangle& triangle, const Vec3& p) noexcept {
    const Vec3 b = triangle.b - triangle.a, c = triangle.c - triangle.a, n = b.cross(c);
    const double area2 = n.squaredNorm();
    if (!(area2 > 1e-24 * b.squaredNorm() * c.squaredNorm())) return closestPoint(triangle, p);
    const Vec3 m = p - triangle.a;
    const double alongB = m.cross(c).dot(n) / area2, alongC = b.cross(m).dot(n) / area2;
    return {triangle.a + alongB * b + alongC * c, Vec3(1 - alongB - alongC, alongB, alongC), Feature::Face};
}

double sweepSphere(const Triangle& t, const Vec3& p, const Vec3& d, double r, double until) noexcept {
    const Vec3 normal = faceNormal(t);
    const double doubleArea = normal.norm();
    if (!(doubleArea > 0)) return sweepBesideFace(t, normal, p, d, r, until);
    const double height = normal.dot(p - t.a) / doubleArea;
    if (std::abs(height) <= r) {
        // closestPoint() may see the same height a rounding above r.
        return sweepBesideFace(t, normal, p, d, r, until);
    }
    // From outside the slab nothing is touched before the slab is entered.
    const double side = height < 0 ? -1 : 1;
    const double descent = -side * normal.dot(d);
    const double above = (side * height - r) * doubleArea;
    if (!(above <= until * descent)) return kNoContact;
    const double reach = above / descent;
    const Vec3 touched = p + reach * d - (side * r / doubleArea) * normal;
    if (insideFace(t, normal, touched)) return reach <= 1 ? reach : kNoContact;
    return sweepBesideFace(t, normal, p, d, r, until);
}

} // namespace tactum
