#include "core/scene/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>

namespace tactum {
namespace {

/// Parts by joining corners; those at one place are one, whatever their normals.
class Parts {
public:
    explicit Parts(const TriangleSoup& soup) : parent_(soup.positions.size()) {
        std::iota(parent_.begin(), parent_.end(), Index(0));
        std::vector<Index> byPlace = parent_;
        const auto place = [&](Index i) {
            const Vec3& p = soup.positions[i];
            return std::tuple(p.x(), p.y(), p.z(), i);
        };
        std::ranges::sort(byPlace, {}, place);
        for (std::size_t i = 1; i < byPlace.size(); ++i)
            if (soup.positions[byPlace[i]] == soup.positions[byPlace[i - 1]])
                join(byPlace[i], byPlace[i - 1]);
        for (const auto& corners : soup.triangles)
            join(corners[0], corners[1]), join(corners[0], corners[2]);
    }
    /// The lowest of its corners.
    Index of(Index i) {
        while (parent_[i] != i)
            i = parent_[i] = parent_[parent_[i]];
        return i;
    }

private:
    void join(Index a, Index b) {
        a = of(a), b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
    }
    std::vector<Index> parent_;
};

/// Positions that a triangle uses, each once.
std::vector<Index> usedIn(const TriangleSoup& soup) {
    std::vector<char> used(soup.positions.size(), 0);
    for (const auto& corners : soup.triangles)
        for (const Index corner : corners)
            used[corner] = 1;
    std::vector<Index> all;
    for (Index i = 0; i < used.size(); ++i)
        if (used[i]) all.push_back(i);
    return all;
}

/// Along directions that are spread evenly over the sphere by the golden angle.
std::vector<Vec3> farthest(const std::vector<Vec3>& points) {
    std::vector<std::size_t> chosen;
    const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
    for (std::size_t i = 0; i < kMostHullPoints; ++i) {
        const double y = 1 - 2 * (double(i) + 0.5) / double(kMostHullPoints), r = std::sqrt(1 - y * y);
        const Vec3 way(r * std::cos(golden * double(i)), y, r * std::sin(golden * double(i)));
        const auto most = std::ranges::max_element(points, {}, [&](const Vec3& p) { return p.dot(way); });
        chosen.push_back(std::size_t(most - points.begin()));
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    std::vector<Vec3> left;
    for (const std::size_t i : chosen)
        left.push_back(points[i]);
    return left;
}

ColliderShape hullShape(std::vector<Vec3> points) {
    const auto before = [](const Vec3& a, const Vec3& b) {
        return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
    };
    std::ranges::sort(points, before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    ColliderShape shape;
    shape.kind = ShapeKind::Hull;
    ShapeMesh mesh;
    mesh.points = points.size() > kMostHullPoints ? farthest(points) : std::move(points);
    shape.mesh = std::make_shared<const ShapeMesh>(std::move(mesh));
    return shape;
}

} // namespace

std::vector<ColliderShape> convexParts(const TriangleSoup& soup) {
    Parts parts(soup);
    const std::vector<Index> used = usedIn(soup);
    std::map<Index, std::vector<Vec3>> points; // by the lowest corner of their part
    std::vector<Vec3> all;
    for (const Index i : used) {
        all.push_back(soup.positions[i]);
        if (const Index part = parts.of(i); points.size() <= kMostParts || points.contains(part))
            points[part].push_back(soup.positions[i]);
    }
    std::vector<ColliderShape> shapes;
    if (points.size() <= kMostParts)
        for (auto& [part, of] : points)
            if (ColliderShape shape = hullShape(std::move(of)); massOf(shape).volume > 0)
                shapes.push_back(std::move(shape));
    if (shapes.empty()) shapes = {hullShape(std::move(all))};
    return shapes;
}

} // namespace tactum
