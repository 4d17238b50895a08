// The teapot as a scene: four surfaces that feel different, round although their mesh has facets.
#include "resources/make_samples/finger.h"
#include "resources/make_samples/mesh.h"
#include "resources/make_samples/samples.h"
#include "resources/make_samples/teapot_finger.h"

#include "core/base/single_precision.h"
namespace tactum::samples {
namespace {

/// Glazed: it slides well. Only the handle is dull.
Material glazed() {
    return {.stiffness = 800, .damping = 0.5, .staticFriction = 0.2, .dynamicFriction = 0.15};
}

Material cork() {
    return {.stiffness = 500, .damping = 0.5, .staticFriction = 0.6, .dynamicFriction = 0.5};
}

SceneObject objectOf(std::string name, const std::vector<std::pair<Part, Material>>& parts) {
    TriangleSoup soup;
    SceneObject made;
    made.name = std::move(name);
    for (const auto& [part, material] : parts) {
        const auto first = Index(soup.positions.size());
        std::vector<Eigen::Vector3f> normals;
        for (std::size_t i = 0; i <= part.rings; ++i)
            for (std::size_t k = 0; k < part.pointsOf(i); ++k) {
                soup.positions.push_back(asSingle(yUp(part.pointAt(i, k))));
                normals.push_back(yUp(part.normalAt(i, k)).cast<float>().normalized());
            }
        for (const auto& corners : part.triangles()) {
            soup.triangles.push_back(
                {first + Index(corners[0]), first + Index(corners[1]), first + Index(corners[2])});
            soup.surfaceOf.push_back(Index(made.surfaces.size()));
            for (const std::size_t corner : corners)
                soup.cornerNormals.push_back(normals[corner]);
        }
        made.surfaces.push_back(surface(part.name, part.colour, material));
        made.surfaces.back().shading.on = true;
    }
    made.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    return made;
}

/// Into the belly, twice as deep as it gives way, and around it, up to where the lid begins.
std::shared_ptr<const std::vector<FingerPoint>> finger() {
    const Part pot = teapotBody();
    const std::vector<TeapotKey> keys{{0.0, &pot, 0.48, 0.72, -30}, {0.5, &pot, 0.48, 0.72, -1},
                                      {0.8, &pot, 0.48, 0.72, 4},   {1.0, &pot, 0.48, 0.72, 1},
                                      {1.5, &pot, 0.44, 0.82, 2.5}, {2.2, &pot, 0.60, 0.90, 2},
                                      {2.5, &pot, 0.60, 0.90, -15}};
    return fingerPath(2.5, [&](double t) { return yUp(teapotFinger(keys, t)); });
}

} // namespace

Scene teapot() {
    Scene scene;
    scene.add(objectOf("teapot", {{teapotBody(), glazed()},
                                  {teapotLid(), glazed()},
                                  {teapotSpout(), glazed()},
                                  {teapotHandle(), cork()}}));
    scene.add(objectOf(
        "table", {{teapotTable(), {.stiffness = 1000, .staticFriction = 0.4, .dynamicFriction = 0.3}}}));
    scene.finger = finger();
    return scene;
}

} // namespace tactum::samples
