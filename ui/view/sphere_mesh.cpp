#include "ui/view/sphere_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace tactum {

namespace {

/// What a graphics card draws at once, and the processor still.
constexpr std::size_t kMaxSphereTriangles = 260'000;

/// A sphere of radius 1 from triangles of about one size.
struct UnitSphere {
    std::vector<Eigen::Vector3f> places;
    std::vector<std::array<int, 3>> triangles;
};

UnitSphere icosahedron() {
    const float g = 0.5f * (1 + std::sqrt(5.0f));
    UnitSphere s;
    for (int axis = 0; axis < 3; ++axis)
        for (float a : {-1.0f, 1.0f})
            for (float b : {-g, g}) {
                Eigen::Vector3f p = Eigen::Vector3f::Zero();
                p[(axis + 1) % 3] = a;
                p[(axis + 2) % 3] = b;
                s.places.push_back(p.normalized());
            }
    const auto near = [&](int i, int j) {
        return (s.places[std::size_t(i)] - s.places[std::size_t(j)]).norm() < 1.1f;
    };
    for (int i = 0; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j)
            for (int k = j + 1; k < 12; ++k) {
                if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
                const auto &a = s.places[std::size_t(i)], &b = s.places[std::size_t(j)],
                           &c = s.places[std::size_t(k)];
                const bool outward = (b - a).cross(c - a).dot(a) > 0;
                s.triangles.push_back(outward ? std::array{i, j, k} : std::array{i, k, j});
            }
    return s;
}

/// Each triangle in four. Vertices are shared along no edge: there are few of them.
UnitSphere finer(const UnitSphere& coarse) {
    UnitSphere s;
    for (const auto& t : coarse.triangles) {
        const Eigen::Vector3f a = coarse.places[std::size_t(t[0])], b = coarse.places[std::size_t(t[1])],
                              c = coarse.places[std::size_t(t[2])];
        const int first = int(s.places.size());
        for (const Eigen::Vector3f& p :
             {a, b, c, Eigen::Vector3f(a + b), Eigen::Vector3f(b + c), Eigen::Vector3f(c + a)})
            s.places.push_back(p.normalized());
        for (const auto& part : {std::array{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
            s.triangles.push_back({first + part[0], first + part[1], first + part[2]});
    }
    return s;
}

/// As round as there is room for so many.
UnitSphere sphereFor(std::size_t count) {
    UnitSphere s = icosahedron();
    for (int i = 0; i < 3 && 4 * s.triangles.size() * count <= kMaxSphereTriangles; ++i)
        s = finer(s);
    return s;
}

void appendSphere(SphereMesh& mesh, const UnitSphere& shape, const BoundingSphere& sphere) {
    const int first = int(mesh.positions.size() / 3);
    for (const Eigen::Vector3f& p : shape.places) {
        const Eigen::Vector3f at = sphere.centre + sphere.radius * p;
        mesh.positions.insert(mesh.positions.end(), at.data(), at.data() + 3);
        mesh.normals.insert(mesh.normals.end(), p.data(), p.data() + 3);
    }
    for (const auto& t : shape.triangles)
        for (int corner : t)
            mesh.triangles.push_back(first + corner);
}

int depthOf(const SphereTree& tree) {
    int deepest = 0;
    std::vector<std::pair<std::int32_t, int>> open;
    if (!tree.nodes().empty()) open.emplace_back(0, 0);
    while (!open.empty()) {
        const auto [index, level] = open.back();
        open.pop_back();
        deepest = std::max(deepest, level);
        const SphereTree::Node& node = tree.nodes()[std::size_t(index)];
        for (int i = 0; i < SphereTree::kWidth; ++i)
            if (node.radius[i] >= 0 && node.child[i] >= 0) open.emplace_back(node.child[i], level + 1);
    }
    return deepest;
}

struct Found {
    std::size_t body;
    BoundingSphere sphere;
    float distance; ///< to the place that counts, squared
};

} // namespace

SphereLevel sphereLevel(const World& world, int level, const Vec3& near_W, const Progress& progress) {
    SphereLevel result;
    std::vector<Found> found;
    for (std::size_t b = 0; b < world.bodies.size() && !progress.isCancelled(); ++b) {
        const SphereTree& tree = world.bodies[b].mesh->tree;
        result.deepest = std::max(result.deepest, depthOf(tree));
        const Eigen::Vector3f near = world.obstacles[b].pose.applyInverse(near_W).cast<float>();
        for (const BoundingSphere& sphere : tree.spheresAt(level))
            found.push_back({b, sphere, (sphere.centre - near).squaredNorm()});
        result.meshes.push_back({world.bodies[b].object, {}, {}, {}});
    }
    result.all = found.size();
    result.drawn = std::min(found.size(), kMaxSpheres);
    const auto nearer = [](const Found& a, const Found& b) { return a.distance < b.distance; };
    if (found.size() > kMaxSpheres) {
        std::ranges::nth_element(found, found.begin() + std::ptrdiff_t(kMaxSpheres), nearer);
        found.resize(kMaxSpheres);
    }
    const UnitSphere shape = sphereFor(result.drawn);
    for (const Found& f : found)
        appendSphere(result.meshes[f.body], shape, f.sphere);
    return result;
}

} // namespace tactum
