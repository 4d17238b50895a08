#include "core/haptics/compile.h"

#include <algorithm>
#include <atomic>

#include "core/base/realtime.h"
#include "core/dynamics/body_motion.h"
#include "core/geometry/closed.h"
#include "core/surface/smooth_normals.h"
#include "core/surface/texture_stack.h"

namespace tactum {

namespace {

std::shared_ptr<const CollisionMesh> reuseOrBuild(const std::shared_ptr<const TriangleSoup>& soup,
                                                  const World& world, const World* previous) {
    const CollisionMesh* regrouped = nullptr; // its triangles were of other surfaces
    for (const World* known : {&world, previous}) {
        if (!known) continue;
        for (const WorldBody& body : known->bodies) {
            if (body.mesh->soup == soup) return body.mesh;
            if (!regrouped && haveSameShape(*body.mesh->soup, *soup)) regrouped = body.mesh.get();
        }
    }
    if (regrouped)
        return std::make_shared<const CollisionMesh>(CollisionMesh{soup, regrouped->tree, regrouped->closed});
    return std::make_shared<const CollisionMesh>(CollisionMesh{soup, SphereTree(*soup), isClosed(*soup)});
}

// All that worlds know already of one kind: to be found again.
template <class T>
std::vector<std::shared_ptr<const T>> known(std::vector<std::shared_ptr<const T>> WorldBody::*kind,
                                            const World& world, const World* previous) {
    std::vector<std::shared_ptr<const T>> result;
    for (const World* each : {&world, previous}) {
        if (!each) continue;
        for (const WorldBody& body : each->bodies)
            for (const auto& one : body.*kind)
                if (one) result.push_back(one);
    }
    return result;
}

// Shading and texture of every surface; nothing at all where none has any.
Result<void> addFeels(WorldBody& body, const SceneObject& object, const World& world, const World* previous,
                      const Progress& progress) {
    auto normals = known(&WorldBody::normals, world, previous);
    const auto textures = known(&WorldBody::textures, world, previous);
    for (std::size_t i = 0; i < object.surfaces.size(); ++i) {
        const Surface& surface = object.surfaces[i];
        const auto shaded = compileNormals(surface.shading, object.geometry, normals, progress);
        if (!shaded) return tl::unexpected(shaded.error());
        normals.push_back(*shaded);
        body.normals.push_back(*shaded);
        body.textures.push_back(compileTextures(surface.layers, object.geometry, Index(i), textures));
        body.feels.push_back({body.normals.back().get(), body.textures.back().get()});
    }
    const bool plain = std::ranges::none_of(
        body.feels, [](const SurfaceFeel& feel) { return feel.normals || feel.texture; });
    if (plain) body.feels.clear();
    for (const SurfaceFeel& feel : body.feels)
        body.feelsWithoutTexture.push_back({feel.normals, nullptr});
    if (std::ranges::none_of(body.feels, [](const SurfaceFeel& feel) { return feel.normals; }))
        body.feelsWithoutTexture.clear();
    return {};
}

// What the loops may rely on, whatever a file said.
Material madeSafe(Material material) {
    for (const MaterialField& field : kMaterialFields)
        material.*field.value = field.parameter->clamped(material.*field.value);
    material.dynamicFriction = std::min(material.dynamicFriction, material.staticFriction);
    return material;
}

void addSides(WorldBody& body, const SceneObject& object) {
    const auto felt = [](const Surface& surface) { return surface.visible ? surface.sides : Sides::None; };
    const auto isBoth = [&](const Surface& surface) { return felt(surface) == Sides::Both; };
    if (std::ranges::all_of(object.surfaces, isBoth)) return;
    std::ranges::transform(object.surfaces, std::back_inserter(body.sides), felt);
}

bool sameMotions(const World& a, const World& b) {
    return std::ranges::equal(a.movers, b.movers, [](const Mover& x, const Mover& y) {
        return x.body == y.body && x.rest == y.rest && (x.motion == y.motion || *x.motion == *y.motion);
    });
}

bool sameShape(const Obstacle& x, const Obstacle& y) {
    return x.mesh == y.mesh && x.pose == y.pose && std::ranges::equal(x.sides, y.sides);
}

bool sameShape(const World& a, const World& b) {
    return a.proxyRadius == b.proxyRadius && sameMotions(a, b) &&
           std::ranges::equal(a.obstacles, b.obstacles,
                              [](const Obstacle& x, const Obstacle& y) { return sameShape(x, y); });
}

// In which shape of the world each obstacle came to where it is.
void datePlaces(World& world, const World* previous) {
    for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
        Obstacle& obstacle = world.obstacles[i];
        obstacle.placedIn = world.shapeRevision;
        if (!previous) continue;
        if (i < previous->obstacles.size() && sameShape(obstacle, previous->obstacles[i])) {
            obstacle.placedIn = previous->obstacles[i].placedIn; // most edits leave all where they are
            continue;
        }
        const auto before = std::ranges::find_if(
            previous->obstacles, [&](const Obstacle& known) { return sameShape(obstacle, known); });
        if (before != previous->obstacles.end()) obstacle.placedIn = before->placedIn;
    }
}

// What the proxy meets when there is no time for textures, or for shading.
void addLesserObstacles(World& world) {
    world.untextured = world.plain = world.obstacles;
    for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
        world.untextured[i].feels = world.bodies[i].feelsWithoutTexture;
        world.plain[i].feels = {};
    }
}

void addMover(World& world, const SceneObject& object) {
    world.obstacles.back().mover = int(world.movers.size());
    world.movers.push_back({std::uint32_t(world.bodies.size() - 1), object.pose, object.motion});
}

tl::unexpected<Error> tooManyMovers(std::size_t count) {
    return inputError("the scene: " + std::to_string(count) +
                      " visible objects move by themselves, but at most " + std::to_string(kMaxMovers) +
                      " can; join those that move alike, or hide some");
}

/// Everything but its numbers.
Result<std::shared_ptr<World>> build(const Scene& scene, const World* previous, const Progress& progress) {
    assertNotRealtime();
    auto world = std::make_shared<World>();
    world->scene = std::make_shared<const Scene>(scene);
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
        if (const auto added = addFeels(body, object, *world, previous, progress); !added)
            return tl::unexpected(added.error());
        addSides(body, object);
        world->bodies.push_back(std::move(body));
        world->obstacles.push_back({.pose = object.pose});
        if (object.motion) addMover(*world, object);
    }
    if (world->movers.size() > kMaxMovers) return tooManyMovers(world->movers.size());
    for (std::size_t i = 0; i < world->bodies.size(); ++i) {
        world->obstacles[i].mesh = world->bodies[i].mesh.get();
        world->obstacles[i].materials = world->bodies[i].materials;
        world->obstacles[i].feels = world->bodies[i].feels;
        world->obstacles[i].sides = world->bodies[i].sides;
    }
    world->near = NearBodies(world->obstacles);
    return world;
}

} // namespace

Result<std::shared_ptr<const World>> compile(const Scene& scene, const World* previous,
                                             const Progress& progress) {
    auto built = build(scene, previous, progress);
    if (!built) return tl::unexpected(built.error());
    World* world = built->get();
    // Numbers of the whole program, so that the contacts of one shape are never taken for those of another.
    static std::atomic<std::uint64_t> revisions{0}, shapes{0};
    world->revision = ++revisions;
    world->shapeRevision = previous && sameShape(*world, *previous) ? previous->shapeRevision : ++shapes;
    datePlaces(*world, previous);
    addLesserObstacles(*world);
    return std::shared_ptr<const World>(std::move(*built));
}

WorldNumbers numbersOf(const World& world) {
    WorldNumbers numbers{world.revision, world.shapeRevision, {}};
    for (const Obstacle& obstacle : world.obstacles)
        numbers.placedIn.push_back(obstacle.placedIn);
    return numbers;
}

Result<std::shared_ptr<const World>> compileNumbered(const Scene& scene, const WorldNumbers& numbers,
                                                     const World* previous, const Progress& progress) {
    auto built = build(scene, previous, progress);
    if (!built) return tl::unexpected(built.error());
    World& world = **built;
    world.revision = numbers.revision;
    world.shapeRevision = numbers.shapeRevision;
    const std::size_t places = std::min(world.obstacles.size(), numbers.placedIn.size());
    for (std::size_t i = 0; i < places; ++i)
        world.obstacles[i].placedIn = numbers.placedIn[i];
    addLesserObstacles(world);
    return std::shared_ptr<const World>(std::move(*built));
}

} // namespace tactum
