// Boxes as objects of a scene, and a door at its post.
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/scene/scene.h"

namespace tactum::test {

inline TriangleSoup box(const Vec3& size, const Vec3& at = Vec3::Zero()) {
    TriangleSoup soup;
    for (unsigned i = 0; i < 8; ++i)
        soup.positions.push_back(at +
                                 size.cwiseProduct(Vec3(i & 1, i >> 1 & 1, i >> 2) - Vec3::Constant(0.5)));
    for (const auto& side : {std::array<Index, 4>{0, 4, 6, 2},
                             {1, 3, 7, 5},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 2, 3, 1},
                             {4, 5, 7, 6}}) {
        soup.triangles.push_back({side[0], side[1], side[2]});
        soup.triangles.push_back({side[0], side[2], side[3]});
    }
    soup.surfaceOf.assign(12, 0);
    return soup;
}

inline TriangleSoup both(TriangleSoup a, const TriangleSoup& b) {
    const Index first = Index(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    a.surfaceOf.assign(a.triangles.size(), 0);
    return a;
}

inline ObjectId add(Scene& scene, const std::string& name, TriangleSoup soup, const Pose& pose = {}) {
    SceneObject object;
    object.name = name, object.pose = pose;
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    object.surfaces.resize(1);
    return scene.add(std::move(object)).id;
}

/// A post, and a door of 80 x 130 x 8 mm to its right.
struct Doorway {
    Scene scene;
    ObjectId post, door;
    Doorway() {
        post = add(scene, "post", box({0.01, 0.2, 0.02}), {Quat::Identity(), {-0.046, 0, 0}});
        door = add(scene, "door", box({0.08, 0.13, 0.008}));
    }
};

} // namespace tactum::test
