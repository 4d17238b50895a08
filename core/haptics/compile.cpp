#include "core/haptics/compile.h"

#include <algorithm>
#include <atomic>
#include <unordered_map>

#include "core/base/realtime.h"
#include "core/dynamics/body_motion.h"
#include "core/geometry/closed.h"
#include "core/surface/smooth_normals.h"
#include "core/surface/texture_stack.h"

namespace tactum {

namespace {

// All that can be used again: of the world before, and of this one as far as it is made.
class Known {
public:
    explicit Known(const World* previous) : previous_(previous) {
        if (!previous) return;
        for (const WorldBody& body : previous->bodies)
            remember(body);
    }

    void remember(const WorldBody& body) {
        meshes_.try_emplace(body.mesh->soup.get(), body.mesh);
        for (const auto& one : body.normals)
            if (one) normals.push_back(one);
        for (const auto& one : body.textures)
            if (one) textures.push_back(one);
    }

    std::shared_ptr<const CollisionMesh> meshOf(const std::shared_ptr<const TriangleSoup>& soup) const {
        if (const auto found = meshes_.find(soup.get()); found != meshes_.end()) return found->second;
        if (const CollisionMesh* regrouped = regroupedFrom(*soup))
            return std::make_shared<const CollisionMesh>(
                CollisionMesh{soup, regrouped->tree, regrouped->closed});
        return std::make_shared<const CollisionMesh>(CollisionMesh{soup, SphereTree(*soup), isClosed(*soup)});
    }

    std::vector<std::shared_ptr<const SmoothNormals>> normals;
    std::vector<std::shared_ptr<const TextureStack>> textures;

private:
    // Whose triangles are the same, of other surfaces.
    const CollisionMesh* regroupedFrom(const TriangleSoup& soup) const {
        if (!previous_) return nullptr;
        const auto found = std::ranges::find_if(
            previous_->bodies, [&](const WorldBody& body) { return haveSameShape(*body.mesh->soup, soup); });
        return found == previous_->bodies.end() ? nullptr : found->mesh.get();
    }

    const World* previous_;
    std::unordered_map<const TriangleSoup*, std::shared_ptr<const CollisionMesh>> meshes_;
};

// Shading and texture of every surface; nothing at all where none has any.
Result<void> addFeels(WorldBody& body, const SceneObject& object, Known& known, const Progress& progress) {
    for (std::size_t i = 0; i < object.surfaces.size(); ++i) {
        const Surface& surface = object.surfaces[i];
        const auto shaded = compileNormals(surface.shading, object.geometry, known.normals, progress);
        if (!shaded) return tl::unexpected(shaded.error());
        if (*shaded) known.normals.push_back(*shaded); // the next surface may have the same
        body.normals.push_back(*shaded);
        body.textures.push_back(compileTextures(surface.layers, object.geometry, Index(i), known.textures));
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
    Known known(previous);
    for (const SceneObject& object : scene.objects) {
        if (progress.isCancelled())
            return inputError("cancelled: the scene was not compiled; nothing was changed");
        if (progress.report) progress.report(double(world->bodies.size()) / double(scene.objects.size()));
        if (!object.visible || !object.geometry || object.geometry->triangles.empty()) continue;
        WorldBody body;
        body.object = object.id;
        body.mesh = known.meshOf(object.geometry);
        for (const Surface& surface : object.surfaces)
            body.materials.push_back(madeSafe(surface.material));
        if (const auto added = addFeels(body, object, known, progress); !added)
            return tl::unexpected(added.error());
        addSides(body, object);
        known.remember(body);
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
