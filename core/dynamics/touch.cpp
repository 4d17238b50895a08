#include "core/dynamics/touch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "core/dynamics/round/pairs.h"
#include "core/dynamics/segments.h"

namespace tactum {

namespace {

/// A cylinder stands whose axis is nearer to the normal than this, rad: then no side of it is lower than
/// others.
constexpr double kUpright = 1e-3;
/// One that leans farther than this, rad, touches a plane with one place of each end at most.
constexpr double kOnItsSide = 0.2;
/// How much less than the radius the middle of a prism's side is from the axis: 1 - cos(pi / 48).
constexpr double kSagitta = 2.2e-3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Two edges have to be this much nearer than two faces to count: parallel ones are a matter of rounding.
constexpr double kEdgeGain = 1e-6;

/// A polytope where it is.
struct Placed {
    const Polytope& body;
    const Pose& pose;
    std::span<const Vec3> points, normals; ///< world frame

    Placed(const Polytope& polytope, const Pose& at, std::vector<Vec3>& room,
           std::vector<Vec3>& normalRoom) noexcept
        : body(polytope), pose(at), points(room.data(), polytope.points.size()),
          normals(normalRoom.data(), polytope.faces.size()) {
        const Mat3 turn = at.rotation.toRotationMatrix();
        for (std::size_t i = 0; i < polytope.points.size(); ++i)
            room[i] = turn * polytope.points[i] + at.translation;
        for (std::size_t i = 0; i < polytope.faces.size(); ++i)
            normalRoom[i] = turn * polytope.faces[i].normal;
    }
    const Vec3& normal(std::size_t face) const noexcept { return normals[face]; }
    double offset(std::size_t face) const noexcept {
        return body.faces[face].offset + normals[face].dot(pose.translation);
    }
    Vec3 centre() const noexcept { return pose.apply(body.centre); }
    double most(const Vec3& way) const noexcept {
        double best = -kInfinity;
        for (const Vec3& p : points)
            best = std::max(best, way.dot(p));
        return best;
    }
    const Vec3& from(const Polytope::Edge& edge) const noexcept { return points[std::size_t(edge.a)]; }
    const Vec3& to(const Polytope::Edge& edge) const noexcept { return points[std::size_t(edge.b)]; }
};

/// The face of b that lies farthest from all of a.
struct FaceGap {
    std::size_t face = 0;
    double gap = -kInfinity;
};
FaceGap widestFace(const Placed& faces, const Placed& other) noexcept {
    FaceGap best;
    for (std::size_t i = 0; i < faces.body.faces.size(); ++i) {
        const Vec3 n = faces.normal(i);
        const double gap = -other.most(-n) - faces.offset(i);
        if (gap > best.gap) best = {i, gap};
    }
    return best;
}

struct EdgeGap {
    Vec3 normal = Vec3::Zero(); ///< from a to b
    std::size_t a = 0, b = 0;   ///< edges
    double gap = -kInfinity;
};
/// Of the edges that make a face of the Minkowski difference: whose arcs on the sphere of normals cross.
/// Source: D. Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013.
EdgeGap widestEdges(const Placed& a, const Placed& b, double enough) noexcept {
    EdgeGap best;
    const Vec3 centre = a.centre();
    for (std::size_t i = 0; i < a.body.edges.size(); ++i) {
        const Polytope::Edge& ofA = a.body.edges[i];
        const Vec3 &p = a.from(ofA), u = a.to(ofA) - p;
        const Vec3 &n1 = a.normal(std::size_t(ofA.left)), &n2 = a.normal(std::size_t(ofA.right));
        for (std::size_t j = 0; j < b.body.edges.size(); ++j) {
            const Polytope::Edge& ofB = b.body.edges[j];
            // The arc of b from the other side.
            const double c = -u.dot(b.normal(std::size_t(ofB.left))),
                         d = -u.dot(b.normal(std::size_t(ofB.right)));
            if (c * d >= 0) continue;
            const Vec3 &q = b.from(ofB), v = b.to(ofB) - q;
            const double e = v.dot(n1), f = v.dot(n2);
            if (e * f >= 0 || c * f <= 0) continue;
            Vec3 n = u.cross(v);
            const double length = n.norm();
            if (length < 1e-4 * std::sqrt(u.squaredNorm() * v.squaredNorm())) continue; // parallel
            n /= n.dot(p - centre) < 0 ? -length : length;
            const double gap = n.dot(q - p);
            if (gap > best.gap) best = {n, i, j, gap};
            if (best.gap > enough) return best;
        }
    }
    return best;
}

/// Of many places those four that span the most: the lowest, and what is farthest from those chosen.
void keepSpanning(std::span<const TouchPoint> all, TouchPoints& points) noexcept {
    std::size_t first = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        if (all[i].gap < all[first].gap) first = i;
    points.push(all[first]);
    while (points.size() < std::min(kMaxTouchPoints, all.size())) {
        std::size_t best = 0;
        double most = -1;
        for (std::size_t i = 0; i < all.size(); ++i) {
            double least = kInfinity;
            for (const TouchPoint& chosen : points.all())
                least = std::min(least, (all[i].point - chosen.point).squaredNorm());
            if (least > most) {
                most = least;
                best = i;
            }
        }
        if (!(most > 0)) return;
        points.push(all[best]);
    }
}

/// The part of the facing face of `other` that lies over a face; `flip`: the face belongs to b.
void clipFaces(const Placed& faces, std::size_t face, const Placed& other, bool flip, double margin,
               TouchScratch& scratch, TouchPoints& points) noexcept {
    const Vec3 n = faces.normal(face);
    std::size_t facing = 0;
    double least = kInfinity;
    for (std::size_t i = 0; i < other.body.faces.size(); ++i)
        if (const double along = n.dot(other.normal(i)); along < least) {
            least = along;
            facing = i;
        }
    auto &polygon = scratch.polygon, &next = scratch.other;
    polygon.clear();
    for (const int corner : other.body.faces[facing].corners)
        polygon.push_back(other.points[std::size_t(corner)]);
    const std::vector<int>& rim = faces.body.faces[face].corners;
    for (std::size_t i = 0; i < rim.size() && !polygon.empty(); ++i) {
        const Vec3 &p = faces.points[std::size_t(rim[i])],
                   &q = faces.points[std::size_t(rim[(i + 1) % rim.size()])];
        const Vec3 out = (q - p).cross(n);
        next.clear();
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Vec3 &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
            const double before = out.dot(from - p), after = out.dot(to - p);
            if (before <= 0) next.push_back(from);
            if ((before < 0 && after > 0) || (before > 0 && after < 0))
                next.push_back(from + before / (before - after) * (to - from));
        }
        std::swap(polygon, next);
    }
    const double offset = faces.offset(face);
    InplaceVector<TouchPoint, 128> found;
    for (const Vec3& p : polygon) {
        const double gap = n.dot(p) - offset;
        if (gap <= margin && found.size() < found.room())
            found.push({p - 0.5 * gap * n, flip ? Vec3(-n) : n, gap});
    }
    if (found.size() > 0) keepSpanning(found.all(), points);
}

TouchPoints polytopes(const Polytope& first, const Pose& a_W, const Polytope& second, const Pose& b_W,
                      double margin, TouchScratch& scratch) noexcept {
    TouchPoints points;
    const Placed a(first, a_W, scratch.a, scratch.normalsA), b(second, b_W, scratch.b, scratch.normalsB);
    const FaceGap ofA = widestFace(a, b);
    if (ofA.gap > margin) return points;
    const FaceGap ofB = widestFace(b, a);
    if (ofB.gap > margin) return points;
    const EdgeGap edges = widestEdges(a, b, margin);
    if (edges.gap > margin) return points;
    const double faces = std::max(ofA.gap, ofB.gap);
    if (edges.gap > faces + kEdgeGain) {
        const Polytope::Edge &edgeA = first.edges[edges.a], &edgeB = second.edges[edges.b];
        const Vec3 on = nearestPoints(a.from(edgeA), a.to(edgeA), b.from(edgeB), b.to(edgeB)).a;
        keep(points, on, edges.normal, edges.gap, margin);
    } else if (ofA.gap >= ofB.gap - kEdgeGain) { // the same one of two equal ones
        clipFaces(a, ofA.face, b, false, margin, scratch, points);
    } else {
        clipFaces(b, ofB.face, a, true, margin, scratch, points);
    }
    return points;
}

/// The nearest point of a polytope's surface to a point, and the way out there.
struct Surface {
    Vec3 point, normal;
    double gap = 0; ///< below 0 inside
};
Surface nearestOn(const Placed& body, const Vec3& p) noexcept {
    std::size_t widest = 0;
    double most = -kInfinity;
    for (std::size_t i = 0; i < body.body.faces.size(); ++i)
        if (const double gap = body.normal(i).dot(p) - body.offset(i); gap > most) {
            most = gap;
            widest = i;
        }
    Surface best{p - most * body.normal(widest), body.normal(widest), most};
    if (most <= 0) return best;
    double least = kInfinity;
    for (std::size_t i = 0; i < body.body.faces.size(); ++i) {
        const Vec3 n = body.normal(i);
        const double gap = n.dot(p) - body.offset(i);
        if (gap <= 0) continue;
        // Over the face its plane is nearest, else its rim.
        const std::vector<int>& rim = body.body.faces[i].corners;
        bool over = true;
        Vec3 place = p - gap * n;
        double distance = kInfinity;
        for (std::size_t k = 0; k < rim.size(); ++k) {
            const Vec3 &u = body.points[std::size_t(rim[k])],
                       &v = body.points[std::size_t(rim[(k + 1) % rim.size()])];
            if ((v - u).cross(n).dot(p - u) <= 0) continue;
            over = false;
            const Vec3 on = u + std::clamp((p - u).dot(v - u) / (v - u).squaredNorm(), 0.0, 1.0) * (v - u);
            if ((p - on).norm() < distance) {
                distance = (p - on).norm();
                place = on;
            }
        }
        if (over) distance = gap;
        if (distance < least) {
            least = distance;
            best = {place, distance > 1e-12 ? Vec3((p - place) / distance) : n, distance};
        }
    }
    return best;
}

struct Segment {
    Vec3 p, q;
};
Segment segmentOf(const Convex& body, const Pose& pose) noexcept {
    const Vec3 up = pose.rotation * Vec3(0, body.half, 0);
    return {pose.translation - up, pose.translation + up};
}

/// A round body a and a flat one b; the normal from a to b.
TouchPoints roundAndFlat(const Convex& a, const Pose& a_W, const Polytope& body, const Pose& b_W,
                         double margin, TouchScratch& scratch) noexcept {
    TouchPoints points;
    const Placed b(body, b_W, scratch.b, scratch.normalsB);
    const Segment segment = segmentOf(a, a_W);
    const auto touch = [&](const Vec3& p) {
        const Surface at = nearestOn(b, p);
        keep(points, p - a.radius * at.normal, -at.normal, at.gap - a.radius, margin);
    };
    touch(segment.p);
    if (a.half == 0) return points;
    touch(segment.q);
    // Between its ends it may lie over an edge, nearer than both ends do.
    double least = kInfinity;
    Vec3 place = segment.p;
    for (const Polytope::Edge& edge : body.edges) {
        const PointPair pair =
            nearestPoints(segment.p, segment.q, b.points[std::size_t(edge.a)], b.points[std::size_t(edge.b)]);
        if (const double distance = (pair.a - pair.b).squaredNorm(); distance < least) {
            least = distance;
            place = pair.a;
        }
    }
    if ((place - segment.p).norm() > 0.01 * a.half && (place - segment.q).norm() > 0.01 * a.half)
        touch(place);
    return points;
}

/// All below y = 0 of frame a.
TouchPoints onHalfSpace(const Pose& a_W, const Convex& b, const Pose& b_W, double margin,
                        TouchScratch& scratch) noexcept {
    TouchPoints points;
    const Vec3 n = a_W.rotation * Vec3::UnitY();
    const double offset = n.dot(a_W.translation);
    const auto place = [&](const Vec3& p) {
        const double gap = n.dot(p) - b.radius - offset;
        return TouchPoint{p - (b.radius + 0.5 * gap) * n, n, gap};
    };
    if (b.core == Convex::Core::Polytope) {
        const Placed body(b.polytope, b_W, scratch.b, scratch.normalsB);
        InplaceVector<TouchPoint, 128> found;
        const bool isPrism = b.round > 0 && body.points.size() == 2 * kCylinderSides;
        if (isPrism && b_W.rotateInverse(n).cwiseProduct(Vec3(1, 0, 1)).norm() > kOnItsSide) {
            // Of each end only the corner that was turned down: those beside it are nearer than they would
            // be.
            const auto lowest =
                std::ranges::min_element(body.points, {}, [&](const Vec3& p) { return n.dot(p); });
            const std::size_t pair = std::size_t(lowest - body.points.begin()) / 2 * 2;
            for (const std::size_t i : {pair, pair + 1})
                if (const TouchPoint at = place(body.points[i]); at.gap <= margin) points.push(at);
            return points;
        }
        for (const Vec3& p : body.points)
            if (const TouchPoint at = place(p); at.gap <= margin && found.size() < found.room())
                found.push(at);
        if (found.size() > 0) keepSpanning(found.all(), points);
        return points;
    }
    const Segment segment = segmentOf(b, b_W);
    for (const Vec3& p : {segment.p, segment.q}) {
        const TouchPoint at = place(p);
        if (at.gap <= margin) points.push(at);
        if (b.half == 0) break;
    }
    return points;
}

/// Not two round ones: round/pairs.h has those.
TouchPoints touchAsTheyAre(const Convex& a, const Pose& a_W, const Convex& b, const Pose& b_W, double margin,
                           TouchScratch& scratch) noexcept {
    using Core = Convex::Core;
    if (a.core == Core::HalfSpace && b.core == Core::HalfSpace) return {};
    if (a.core == Core::HalfSpace) return onHalfSpace(a_W, b, b_W, margin, scratch);
    if (b.core == Core::HalfSpace) return reversed(onHalfSpace(b_W, a, a_W, margin, scratch));
    const bool flatA = a.core == Core::Polytope, flatB = b.core == Core::Polytope;
    if ((flatA && a.polytope.faces.empty()) || (flatB && b.polytope.faces.empty())) return {};
    if (flatA && flatB) return polytopes(a.polytope, a_W, b.polytope, b_W, margin, scratch);
    if (flatB) return roundAndFlat(a, a_W, b.polytope, b_W, margin, scratch);
    return reversed(roundAndFlat(b, b_W, a.polytope, a_W, margin, scratch));
}

/// A cylinder turned about its axis, which changes nothing, until an edge of its prism points along a way.
Pose edgeToward(const Convex& body, const Pose& pose, const Vec3& way_W) noexcept {
    if (body.round == 0) return pose;
    const Vec3 way = pose.rotateInverse(way_W);
    if (std::hypot(way.x(), way.z()) < kUpright) return pose;
    constexpr double kSide = 2 * std::numbers::pi / kCylinderSides;
    const double angle = std::atan2(-way.z(), way.x());
    const double turn = angle - std::round(angle / kSide) * kSide;
    return {pose.rotation * Quat(Eigen::AngleAxisd(turn, Vec3::UnitY())), pose.translation};
}

} // namespace

// What a prism has less than its cylinder, where it touches with a side, is as much nearer at first.
TouchPoints touchPoints(const Convex& a, const Pose& a_W, const Convex& b, const Pose& b_W, double margin,
                        TouchScratch& scratch) noexcept {
    if (const auto points = touchRound(a, a_W, b, b_W, margin)) return *points;
    const double round = a.round + b.round;
    const TouchPoints first = touchAsTheyAre(a, a_W, b, b_W, margin + kSagitta * round, scratch);
    if (round == 0 || first.size() == 0) return first;
    const Vec3 normal = first.all()[0].normal;
    return touchAsTheyAre(a, edgeToward(a, a_W, normal), b, edgeToward(b, b_W, -normal), margin, scratch);
}

} // namespace tactum
