#include "core/runtime/compile.h"

#include <algorithm>
#include <atomic>

#include "core/base/realtime.h"

namespace tactum {

namespace {

std::shared_ptr<const CollisionMesh> reuseOrBuild(const std::shared_ptr<const TriangleSoup>& soup,
                                                  const World& world, const World* previous) {
    for (const World* known : {&world, previous}) {
        if (!known) continue;
        for (const WorldBody& body : known->bodies)
            if (body.mesh->soup == soup) return body.mesh;
    }
    return std::make_shared<const CollisionMesh>(CollisionMesh{soup, SphereTree(*soup)});
}

// What the loops may rely on, whatever a file said.
Material madeSafe(Material material) {
    for (const MaterialField& field : kMaterialFields)
        material.*field.value = field.parameter->clamped(material.*field.value);
    material.dynamicFriction = std::min(material.dynamicFriction, material.staticFriction);
    return material;
}

bool sameShape(const World& a, const World& b) {
    return a.proxyRadius == b.proxyRadius &&
           std::ranges::equal(a.obstacles, b.obstacles, [](const Obstacle& x, const Obstacle& y) {
               return x.mesh == y.mesh && x.pose == y.pose;
           });
}

} // namespace

Result<std::shared_ptr<const World>> compile(const Scene& scene, const World* previous,
                                             const Progress& progress) {
    assertNotRealtime();
    auto world = std::make_shared<World>();
    world->proxyRadius = kProxyRadius.clamped(scene.proxyRadius);
    world->bodies.reserve(scene.objects.size());
    for (const SceneObject& object : scene.objects) {
        if (progress.isCancelled())
            return inputError("cancelled: the scene was not compiled; nothing was changed");
        if (progress.report) progress.report(double(world->bodies.size()) / double(scene.objects.size()));
        if (!object.visible || !object.geometry || object.geometry->triangles.empty()) continue;
        WorldBody body;
        body.object = object.id;
        body.mesh = reuseOrBuild(object.geometry, *world, previous);
        for (const Surface& surface : object.surfaces)
            body.materials.push_back(madeSafe(surface.material));
        world->bodies.push_back(std::move(body));
        world->obstacles.push_back({nullptr, object.pose, {}});
    }
    for (std::size_t i = 0; i < world->bodies.size(); ++i) {
        world->obstacles[i].mesh = world->bodies[i].mesh.get();
        world->obstacles[i].materials = world->bodies[i].materials;
    }
    // Numbers of the whole program, so that the contacts of one shape are never taken for those of another.
    static std::atomic<std::uint64_t> revisions{0}, shapes{0};
    world->revision = ++revisions;
    world->shapeRevision = previous && sameShape(*world, *previous) ? previous->shapeRevision : ++shapes;
    return std::shared_ptr<const World>(std::move(world));
}

} // namespace tactum
