#include "core/scene/describe.h"

#include <algorithm>
#include <map>

#include "core/geometry/filing.h"
#include "core/motion/motion_build.h"
#include "core/scene/world_fields.h"

namespace tactum {
namespace {

ParameterDescription described(const Parameter& parameter, double value) {
    return {parameter.key, parameter.unit, value, parameter.allows(value)};
}

LayerDescription described(const TextureLayer& layer) {
    const TexturePattern& pattern = layer.pattern;
    return {.name = layer.name,
            .enabled = layer.enabled,
            .source = kTextureSources[std::size_t(pattern.source)].key,
            .image = pattern.source == TextureSource::Image && pattern.image ? pattern.image->name()
                                                                             : std::string(),
            .mapping = pattern.source == TextureSource::Painted
                           ? std::string_view()
                           : kTextureMappings[std::size_t(pattern.mapping)].key,
            .target = kTextureTargets[std::size_t(layer.target)].key,
            .blend = kTextureBlends[std::size_t(layer.blend)].key,
            .mask = layer.mask ? kTextureSources[std::size_t(layer.mask->source)].key : std::string_view(),
            .strength = described(strengthParameter(layer.target), layer.strength),
            .opacity = described(kTextureOpacity, layer.opacity)};
}

SurfaceDescription described(const Surface& surface) {
    SurfaceDescription result;
    result.name = surface.name;
    result.colour = surface.colour;
    result.sides = surface.sides;
    result.visible = surface.visible;
    result.locked = surface.locked;
    result.shading = surface.shading;
    for (const TextureLayer& layer : surface.layers)
        result.layers.push_back(described(layer));
    for (const MaterialField& field : kMaterialFields)
        result.parameters.push_back(described(*field.parameter, surface.material.*field.value));
    return result;
}

ObjectDescription described(const SceneObject& object) {
    const TriangleSoup& soup = *object.geometry;
    ObjectDescription result;
    result.id = object.id;
    result.name = object.name;
    result.visible = object.visible;
    result.vertices = soup.positions.size();
    result.bounds_B = boundsOf(soup);
    result.pose = object.pose;
    result.motion = describeMotion(object);
    for (const Surface& surface : object.surfaces)
        result.surfaces.push_back(described(surface));
    for (const NamedTriangles& set : object.sets)
        result.sets.push_back({set.name, countOf(set.triangles)});
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) { // a soup has segments and points too
        if (kindOf(soup.triangles[i]) != Kind::Triangle) continue;
        ++result.triangles;
        ++result.surfaces[soup.surfaceOf[i]].triangles;
    }
    return result;
}

} // namespace

std::optional<MotionDescription> describeMotion(const SceneObject& object) {
    if (!object.motion) return std::nullopt;
    double reach = 0;
    for (const Vec3& p : object.geometry->positions)
        reach = std::max(reach, p.norm());
    const Motion& motion = *object.motion;
    return MotionDescription{motion.duration, topSpeed(motion, reach),
                             motion.jumpsAtEnd || !motion.jumps.empty()};
}

namespace {

void describeMechanics(const Mechanics& mechanics, SceneDescription& result) {
    std::map<BodyId, std::string> names;
    for (const RigidBody& body : mechanics.bodies) {
        names[body.id] = body.name;
        const auto colliders = std::ranges::count(mechanics.colliders, body.id, &Collider::body);
        result.bodies.push_back({body.name, body.mass, body.kinematic, std::size_t(colliders)});
    }
    for (const Joint& joint : mechanics.joints)
        result.joints.push_back({joint.name, names[joint.a], names[joint.b]});
}

} // namespace

SceneDescription describe(const Scene& scene) {
    SceneDescription result;
    result.bounds_W = boundsOf(scene);
    result.parameters.push_back(described(kProxyRadius, scene.proxyRadius));
    result.reach = kReachChoices[std::size_t(scene.reach.mode)].key;
    if (scene.reach.mode == ReachMode::Rate)
        result.parameters.push_back(described(kShellRadius, scene.reach.shell));
    if (!scene.mechanics.bodies.empty())
        for (const WorldField& field : kWorldFields)
            result.parameters.push_back(described(*field.parameter, scene.mechanics.*field.value));
    std::map<const TriangleSoup*, MeshHealth> healths;
    for (const SceneObject& object : scene.objects) {
        auto [health, isNew] = healths.try_emplace(object.geometry.get());
        if (isNew) health->second = healthOf(*object.geometry).value();
        result.objects.push_back(described(object));
        result.objects.back().health = health->second;
        result.triangles += result.objects.back().triangles;
    }
    describeMechanics(scene.mechanics, result);
    return result;
}

} // namespace tactum
