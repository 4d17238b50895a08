#include "core/dynamics/convex.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace tactum {

namespace {

/// Edges from the corners of faces, each once.
void addEdges(Polytope& body) {
    std::map<std::pair<int, int>, int> faceOf; // of an edge in its sense
    for (std::size_t i = 0; i < body.faces.size(); ++i) {
        const std::vector<int>& rim = body.faces[i].corners;
        for (std::size_t k = 0; k < rim.size(); ++k)
            faceOf[{rim[k], rim[(k + 1) % rim.size()]}] = int(i);
    }
    for (const auto& [edge, face] : faceOf) {
        const auto other = faceOf.find({edge.second, edge.first});
        if (other != faceOf.end() && edge.first < edge.second)
            body.edges.push_back({edge.first, edge.second, face, other->second});
    }
}

void finish(Polytope& body) {
    body.centre = Vec3::Zero();
    for (const Vec3& p : body.points)
        body.centre += p / double(body.points.size());
    for (Polytope::Face& face : body.faces) {
        // Newell's normal of all corners: of the best plane through them.
        Vec3 normal = Vec3::Zero(), middle = Vec3::Zero();
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const Vec3& a = body.points[std::size_t(face.corners[i])];
            const Vec3& b = body.points[std::size_t(face.corners[(i + 1) % face.corners.size()])];
            normal += (a - body.centre).cross(b - body.centre);
            middle += a / double(face.corners.size());
        }
        face.normal = normal.normalized();
        face.offset = face.normal.dot(middle);
    }
    addEdges(body);
}

Polytope prismOf(double bottom, double top, double height) {
    Polytope body;
    const double up = 0.5 * height;
    for (int i = 0; i < kCylinderSides; ++i) {
        const double angle = 2 * std::numbers::pi * i / kCylinderSides;
        body.points.emplace_back(bottom * std::cos(angle), -up, -bottom * std::sin(angle));
        body.points.emplace_back(top * std::cos(angle), up, -top * std::sin(angle));
    }
    if (!(bottom > 0) || !(top > 0)) return hullOf(body.points); // a cone
    Polytope::Face lower, upper;
    for (int i = 0; i < kCylinderSides; ++i) {
        const int j = (i + 1) % kCylinderSides;
        body.faces.push_back({Vec3::UnitZ(), 0, {2 * i, 2 * j, 2 * j + 1, 2 * i + 1}});
        upper.corners.push_back(2 * i + 1);
        lower.corners.push_back(2 * (kCylinderSides - 1 - i));
    }
    body.faces.push_back(lower);
    body.faces.push_back(upper);
    finish(body);
    return body;
}

/// The hull of points in space by adding the farthest one again and again: triangles that see it give way.
class HullBuilder {
public:
    explicit HullBuilder(const std::vector<Vec3>& points) : points_(points) {}

    std::vector<std::array<int, 3>> run() {
        if (!begin()) return {};
        for (int count = 4; count < kMostCorners; ++count) {
            const int next = farthestOutside();
            if (next < 0) break;
            add(next);
        }
        std::vector<std::array<int, 3>> faces;
        for (const Face& face : faces_)
            faces.push_back(face.corners);
        return faces;
    }

private:
    struct Face {
        std::array<int, 3> corners;
        Vec3 normal;
        double offset;
    };

    const Vec3& at(int i) const { return points_[std::size_t(i)]; }
    void addFace(int a, int b, int c) {
        const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
        faces_.push_back({{a, b, c}, normal, normal.dot(at(a))});
    }

    /// The point that lies farthest beyond any face; -1 when none does.
    int farthestOutside() const {
        int farthest = -1;
        double most = near_;
        for (int i = 0; i < int(points_.size()); ++i)
            for (const Face& face : faces_)
                if (const double beyond = face.normal.dot(at(i)) - face.offset; beyond > most) {
                    most = beyond;
                    farthest = i;
                }
        return farthest;
    }

    /// A tetrahedron of points far from each other.
    bool begin() {
        if (points_.size() < 4) return false;
        const auto farthest = [&](auto&& measure) {
            int best = 0;
            for (int i = 1; i < int(points_.size()); ++i)
                if (measure(at(i)) > measure(at(best))) best = i;
            return best;
        };
        const int a = farthest([](const Vec3& p) { return -p.x(); });
        const int b = farthest([&](const Vec3& p) { return (p - at(a)).squaredNorm(); });
        const double size = (at(b) - at(a)).norm();
        if (!(size > 0)) return false;
        const Vec3 along = (at(b) - at(a)) / size;
        const int c = farthest([&](const Vec3& p) { return (p - at(a)).cross(along).squaredNorm(); });
        const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
        if (!(normal.norm() > 1e-9 * size * size)) return false;
        const Vec3 n = normal.normalized();
        const int d = farthest([&](const Vec3& p) { return std::abs(n.dot(p - at(a))); });
        const double height = n.dot(at(d) - at(a));
        near_ = 1e-9 * size;
        if (std::abs(height) <= near_) return false;
        const auto [p, q] = height > 0 ? std::pair{c, b} : std::pair{b, c};
        addFace(a, p, q), addFace(a, q, d), addFace(q, p, d), addFace(p, a, d);
        return true;
    }

    void add(int i) {
        std::map<std::pair<int, int>, bool> rim; // edges of what sees the point, in their sense
        const auto sees = [&](const Face& face) { return face.normal.dot(at(i)) - face.offset > near_; };
        if (std::ranges::none_of(faces_, sees)) return;
        for (const Face& face : faces_)
            if (sees(face))
                for (std::size_t k = 0; k < 3; ++k)
                    rim[{face.corners[k], face.corners[(k + 1) % 3]}] = true;
        std::erase_if(faces_, sees);
        for (const auto& [edge, there] : rim)
            if (!rim.contains({edge.second, edge.first})) addFace(edge.first, edge.second, i);
    }

    const std::vector<Vec3>& points_;
    std::vector<Face> faces_;
    double near_ = 0;
};

/// Triangles of one plane as one face: the rim of them, in order.
void mergeFaces(const std::vector<std::array<int, 3>>& triangles, Polytope& body) {
    std::vector<Vec3> normals;
    for (const auto& t : triangles) {
        const Vec3& a = body.points[std::size_t(t[0])];
        normals.push_back(
            (body.points[std::size_t(t[1])] - a).cross(body.points[std::size_t(t[2])] - a).normalized());
    }
    std::vector<bool> used(triangles.size(), false);
    for (std::size_t first = 0; first < triangles.size(); ++first) {
        if (used[first]) continue;
        std::map<int, int> next;
        std::map<std::pair<int, int>, bool> sides;
        for (std::size_t i = first; i < triangles.size(); ++i)
            if (!used[i] && (normals[i] - normals[first]).squaredNorm() < 1e-12) {
                used[i] = true;
                for (std::size_t k = 0; k < 3; ++k)
                    sides[{triangles[i][k], triangles[i][(k + 1) % 3]}] = true;
            }
        for (const auto& [side, there] : sides)
            if (!sides.contains({side.second, side.first})) next[side.first] = side.second;
        if (next.empty()) continue;
        Polytope::Face face;
        int at = next.begin()->first;
        for (std::size_t k = 0; k < next.size() && next.contains(at); ++k) {
            face.corners.push_back(at);
            at = next[at];
        }
        body.faces.push_back(std::move(face));
    }
}

double reachOf(const Polytope& body) {
    double reach = 0;
    for (const Vec3& p : body.points)
        reach = std::max(reach, p.norm());
    return reach;
}

} // namespace

Polytope boxOf(const Vec3& size) {
    Polytope body;
    const Vec3 h = 0.5 * size;
    for (int i = 0; i < 8; ++i)
        body.points.emplace_back(i & 1 ? h.x() : -h.x(), i & 2 ? h.y() : -h.y(), i & 4 ? h.z() : -h.z());
    for (const auto& corners :
         {std::vector{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}})
        body.faces.push_back({Vec3::UnitZ(), 0, corners});
    finish(body);
    return body;
}

Polytope hullOf(const std::vector<Vec3>& points) {
    Polytope body;
    const auto triangles = HullBuilder(points).run();
    std::map<int, int> numbers;
    std::vector<std::array<int, 3>> renumbered;
    for (const auto& triangle : triangles) {
        std::array<int, 3> own{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [found, isNew] = numbers.emplace(triangle[k], int(body.points.size()));
            if (isNew) body.points.push_back(points[std::size_t(triangle[k])]);
            own[k] = found->second;
        }
        renumbered.push_back(own);
    }
    mergeFaces(renumbered, body);
    if (!body.faces.empty()) finish(body);
    return body;
}

/// m: what is endless along one side alone goes as far as places of a scene do.
static constexpr double kEndless = 2e6;

/// Below y = 0, for a plane has one side.
static Polytope slabOf(double x, double z) {
    const double thickness = 0.1 * std::min(x, z);
    Polytope slab = boxOf({x, thickness, z});
    for (Vec3& p : slab.points)
        p.y() -= 0.5 * thickness;
    for (Polytope::Face& face : slab.faces)
        face.offset = face.normal.dot(slab.points[std::size_t(face.corners[0])]);
    slab.centre.y() -= 0.5 * thickness;
    return slab;
}

Convex convexOf(const ColliderShape& shape) {
    Convex convex;
    switch (shape.kind) {
    case ShapeKind::Sphere:
        convex.form = Convex::Form::Ball;
        convex.radius = shape.radius;
        break;
    case ShapeKind::Capsule:
        convex.core = Convex::Core::Segment;
        convex.form = Convex::Form::Capsule;
        convex.half = 0.5 * shape.height;
        convex.radius = 0.5 * (shape.radius + shape.radiusBottom);
        break;
    case ShapeKind::Box:
        convex.core = Convex::Core::Polytope;
        convex.polytope = boxOf(shape.size);
        break;
    case ShapeKind::Cylinder:
        convex.core = Convex::Core::Polytope;
        convex.polytope = prismOf(shape.radiusBottom, shape.radius, shape.height);
        convex.round = std::max(shape.radiusBottom, shape.radius);
        convex.half = 0.5 * shape.height;
        if (shape.radiusBottom == shape.radius) convex.form = Convex::Form::Cylinder;
        break;
    case ShapeKind::Plane:
        if (std::isinf(shape.size.x()) && std::isinf(shape.size.z())) {
            convex.core = Convex::Core::HalfSpace;
            convex.reach = std::numeric_limits<double>::infinity();
            return convex;
        }
        convex.core = Convex::Core::Polytope;
        convex.polytope = slabOf(std::min(shape.size.x(), kEndless), std::min(shape.size.z(), kEndless));
        break;
    case ShapeKind::Hull:
    case ShapeKind::Mesh:
        convex.core = Convex::Core::Polytope;
        if (shape.mesh) convex.polytope = hullOf(shape.mesh->points);
        break;
    }
    convex.reach = std::max(reachOf(convex.polytope), convex.half + convex.radius);
    if (convex.polytope.points.empty()) return convex;
    convex.low = convex.high = convex.polytope.points.front();
    for (const Vec3& p : convex.polytope.points) {
        convex.low = convex.low.cwiseMin(p);
        convex.high = convex.high.cwiseMax(p);
    }
    if (convex.round > 0) { // however it is turned about its axis
        convex.low.x() = convex.low.z() = -convex.round;
        convex.high.x() = convex.high.z() = convex.round;
    }
    return convex;
}

} // namespace tactum
