#include "core/haptics/compile.h"

#include <algorithm>
#include <atomic>
#include <span>
#include <unordered_map>
#include <unordered_set>

#include "core/base/realtime.h"
#include "core/dynamics/mechanism_build.h"
#include "core/geometry/closed.h"
#include "core/motion/movers.h"
#include "core/surface/smooth_normals.h"
#include "core/surface/texture_stack.h"

namespace tactum {

namespace {

// All that can be used again: of the world before, and of this one as far as it is made.
class Known {
public:
    explicit Known(const World* previous) {
        if (!previous) return;
        for (const WorldBody& body : previous->bodies)
            remember(body);
    }

    void remember(const WorldBody& body) {
        if (meshes_.try_emplace(body.mesh->soup.get(), body.mesh).second)
            shapes_.emplace(shapeKey(*body.mesh->soup), body.mesh);
        for (const auto& one : body.normals)
            remember(normals, one);
        for (const auto& one : body.textures)
            remember(textures, one);
    }
    template <class T>
    void remember(std::vector<std::shared_ptr<const T>>& all, const std::shared_ptr<const T>& one) {
        if (one && seen_.insert(one.get()).second) all.push_back(one);
    }

    std::shared_ptr<const CollisionMesh> meshOf(const std::shared_ptr<const TriangleSoup>& soup) const {
        if (const auto found = meshes_.find(soup.get()); found != meshes_.end()) return found->second;
        // The same triangles, of other surfaces or read twice.
        const auto [first, last] = shapes_.equal_range(shapeKey(*soup));
        for (auto like = first; like != last; ++like)
            if (const CollisionMesh& mesh = *like->second; haveSameShape(*mesh.soup, *soup))
                return std::make_shared<const CollisionMesh>(CollisionMesh{soup, mesh.tree, mesh.closed});
        return std::make_shared<const CollisionMesh>(CollisionMesh{soup, SphereTree(*soup), isClosed(*soup)});
    }

    std::vector<std::shared_ptr<const SmoothNormals>> normals;
    std::vector<std::shared_ptr<const TextureStack>> textures;

private:
    // Equal for equal shapes, and for few others.
    static std::size_t shapeKey(const TriangleSoup& soup) {
        std::size_t key = soup.triangles.size();
        for (const std::size_t i : {std::size_t(0), soup.positions.size() / 2, soup.positions.size() - 1})
            for (const double c : soup.positions[i])
                key = 31 * key + std::hash<double>{}(c);
        return key;
    }

    std::unordered_map<const TriangleSoup*, std::shared_ptr<const CollisionMesh>> meshes_;
    std::unordered_multimap<std::size_t, std::shared_ptr<const CollisionMesh>> shapes_;
    std::unordered_set<const void*> seen_;
};

// Shading and texture of every surface; nothing at all where none has any.
Result<void> addFeels(WorldBody& body, const SceneObject& object, Known& known, const Progress& progress) {
    for (std::size_t i = 0; i < object.surfaces.size(); ++i) {
        const Surface& surface = object.surfaces[i];
        const auto shaded = compileNormals(surface.shading, object.geometry, known.normals, progress);
        if (!shaded) return tl::unexpected(shaded.error());
        known.remember(known.normals, *shaded); // the next surface may have the same
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
        const bool alike = x.motion == y.motion || (x.motion && y.motion && *x.motion == *y.motion);
        return x.body == y.body && x.rest == y.rest && x.driven == y.driven && alike;
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
    const std::span<const Obstacle> known = previous ? previous->obstacles : std::span<const Obstacle>{};
    auto expected = known.begin(); // most edits leave all others in their order
    for (Obstacle& obstacle : world.obstacles) {
        obstacle.placedIn = world.shapeRevision;
        const auto isIt = [&](const Obstacle& one) { return sameShape(obstacle, one); };
        const auto before =
            expected != known.end() && isIt(*expected) ? expected : std::ranges::find_if(known, isIt);
        if (before == known.end()) continue;
        obstacle.placedIn = before->placedIn;
        expected = before + 1;
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

// What is edited in the hand is mostly something else: then the mechanism is the same one.
Result<void> addMechanics(World& world, const World* previous) {
    const Mechanics& mechanics = world.scene->mechanics;
    if (mechanics.bodies.empty()) return {};
    std::shared_ptr<const Mechanism> mechanism;
    if (previous && previous->moving && previous->scene->mechanics == mechanics)
        mechanism = previous->moving->mechanism();
    if (!mechanism) {
        auto made =
            compileMechanism(mechanics.bodies, mechanics.joints, mechanics.colliders, mechanics.airDensity);
        if (!made) return tl::unexpected(made.error());
        mechanism = std::make_shared<const Mechanism>(std::move(*made));
    }
    if (mechanism->vs == 0) return {};
    if (mechanism->qs > kMaxCoordinates)
        return inputError("the bodies that forces move: joints and loose bodies have " +
                          std::to_string(mechanism->qs) + " coordinates together, and " +
                          std::to_string(kMaxCoordinates) +
                          " are the most; make some of them still, a loose body has seven");
    world.moving = std::make_unique<MovingBodies>(std::move(mechanism), mechanics.gravity,
                                                  HandScale{mechanics.forceScale, mechanics.timeScale});
    return {};
}

// An object of a body that forces move keeps its place on it.
void addDriven(World& world, const SceneObject& object) {
    const Mechanism& mechanism = *world.moving->mechanism();
    const auto body = std::ranges::find(mechanism.bodies, object.body, &RigidBody::id);
    if (body == mechanism.bodies.end()) return;
    const std::size_t index = std::size_t(body - mechanism.bodies.begin());
    if (mechanism.places[index].link < 0) return; // nothing moves it
    const int driven = world.moving->add({index, body->pose.inverse() * object.pose});
    world.obstacles.back().mover = int(world.movers.size());
    world.movers.push_back({std::uint32_t(world.bodies.size() - 1), object.pose, nullptr, driven});
}

/// Everything but its numbers.
Result<std::shared_ptr<World>> build(const Scene& scene, const World* previous, const Progress& progress) {
    assertNotRealtime();
    auto world = std::make_shared<World>();
    world->scene = std::make_shared<const Scene>(scene);
    world->proxyRadius = kProxyRadius.clamped(scene.proxyRadius);
    world->bodies.reserve(scene.objects.size());
    if (const auto added = addMechanics(*world, previous); !added) return tl::unexpected(added.error());
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
        if (object.motion)
            addMover(*world, object);
        else if (world->moving)
            addDriven(*world, object);
    }
    for (std::size_t i = 0; i < world->bodies.size(); ++i) {
        world->obstacles[i].mesh = world->bodies[i].mesh.get();
        world->obstacles[i].materials = world->bodies[i].materials;
        world->obstacles[i].feels = world->bodies[i].feels;
        world->obstacles[i].sides = world->bodies[i].sides;
    }
    world->near = NearBodies(world->obstacles, world->movers);
    return world;
}

// Below this many triangles what is painted all over is made smooth within a part of a frame: 5 ms.
constexpr std::size_t kPaintedAtOnce = 2'000;

bool paintTakesTime(const SceneObject& object, const World& previous) {
    if (!object.visible || !object.geometry || object.geometry->triangles.size() < kPaintedAtOnce)
        return false;
    const auto body = std::ranges::find(previous.bodies, object.id, &WorldBody::object);
    const auto known = body == previous.bodies.end() ? decltype(body->textures){} : body->textures;
    for (std::size_t i = 0; i < object.surfaces.size(); ++i)
        if (arePaintedAnew(object.surfaces[i].layers, *object.geometry, Index(i), known)) return true;
    return false;
}

} // namespace

bool paintTakesTime(const Scene& scene, const World& previous) {
    return std::ranges::any_of(scene.objects,
                               [&](const SceneObject& object) { return paintTakesTime(object, previous); });
}

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
