// The rules of what each format keeps, said once. For loss_report.cpp only.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

#include "core/files/corner_pool.h"
#include "core/files/loss_report.h"

namespace tactum {

/// What other programs put beside the scene.
struct ForeignParts {
    bool cameras = false, lights = false, pictures = false, others = false;
};

/// What a rule is asked about. `object` is null for a thing of the scene, `surface` for one of an object.
struct LossSubject {
    const Scene& scene;
    ForeignParts foreign;
    const SceneObject* object = nullptr;
    const Surface* surface = nullptr;
};

struct LossRule {
    LossKind kind;
    std::string_view sentence;
};

/// One line of the table: a thing that scenes may have, and what becomes of it in the order of ExportTarget.
struct LossRow {
    std::string_view what;
    bool (*has)(const LossSubject&);
    std::array<LossRule, kExportTargets.size()> rules;
};

namespace loss_table {

constexpr LossRule kept(std::string_view sentence = {}) {
    return {LossKind::Kept, sentence};
}
constexpr LossRule degraded(std::string_view sentence) {
    return {LossKind::Degraded, sentence};
}
constexpr LossRule lost(std::string_view sentence) {
    return {LossKind::Lost, sentence};
}

/// A format of bare meshes knows nothing of feel.
inline constexpr LossRule kNoFeel = lost("the format knows shapes, not how they feel");
inline constexpr LossRule kNoPhysics = lost("the extension has no place for it");
inline constexpr LossRule kNoSets = lost("only the glTF of the scene has a place for them");
inline constexpr LossRule kAtRest = lost("written where it is at the time 0");
inline constexpr LossRule kNotTouched = lost("the program keeps it for .glb, and does not know it itself");
inline constexpr LossRule kWorld = degraded("the vertices are written in the world frame");

inline bool anyLayer(const LossSubject& s, bool (*is)(const TextureLayer&)) {
    for (const TextureLayer& layer : s.surface->layers)
        if (layer.enabled && is(layer)) return true;
    return false;
}
inline bool always(const LossSubject&) {
    return true;
}
inline bool isPainted(const TextureLayer& layer) {
    return layer.pattern.source == TextureSource::Painted ||
           (layer.mask && layer.mask->source == TextureSource::Painted);
}
inline bool isHeight(const TextureLayer& layer) {
    return layer.target == TextureTarget::Height;
}
template <int kCorners> bool hasFacesOf(const LossSubject& s) {
    for (const auto& t : s.object->geometry->triangles)
        if (cornersOf(t) == kCorners) return true;
    return false;
}

/// What the glTF of the scene gives back, and nothing else can.
constexpr LossRow foreignRow(std::string_view what, bool (*has)(const LossSubject&)) {
    return {
        what, has, {kept(), kNotTouched, kept(), kept(), kNotTouched, kNotTouched, kNotTouched, kNotTouched}};
}

inline const std::array kSceneRows{
    LossRow{"finger path",
            [](const LossSubject& s) { return bool(s.scene.finger); },
            {kept(), lost("the format has no place for it"), kNoPhysics, kNoPhysics, kNoFeel, kNoFeel,
             kNoFeel, kNoFeel}},
    LossRow{"bodies and joints",
            [](const LossSubject& s) { return !s.scene.mechanics.bodies.empty(); },
            {kept(), degraded("as RigidBodyPhysics; the finger does not push them"), kNoPhysics,
             kept("its colliders touch each other; what the finger feels is left out"), kAtRest, kAtRest,
             kAtRest, kAtRest}},
    LossRow{"springs, motors and damping of joints",
            [](const LossSubject& s) {
                return std::ranges::any_of(s.scene.mechanics.joints,
                                           [](const Joint& joint) { return !joint.drives.empty(); });
            },
            {kept(), lost("X3D has none that is the same"), kNoPhysics, kept(), kAtRest, kAtRest, kAtRest,
             kAtRest}},
    LossRow{
        "paths, dry friction and detents of joints",
        [](const LossSubject& s) {
            return std::ranges::any_of(s.scene.mechanics.joints, [](const Joint& joint) {
                const auto isDetent = [](const JointDrive& drive) { return drive.spacing > 0; };
                return joint.path.isThere() || !joint.frictions.empty() ||
                       std::ranges::any_of(joint.drives, isDetent);
            });
        },
        {kept(), lost("X3D's joints have none"), kNoPhysics, kNoPhysics, kAtRest, kAtRest, kAtRest, kAtRest}},
    LossRow{"air that slows bodies",
            [](const LossSubject& s) {
                return !s.scene.mechanics.bodies.empty() && s.scene.mechanics.airDensity > 0;
            },
            {kept(), lost("X3D has none"), kNoPhysics, kNoPhysics, kAtRest, kAtRest, kAtRest, kAtRest}},
    LossRow{"how the hand is scaled to the bodies",
            [](const LossSubject& s) {
                const Mechanics& of = s.scene.mechanics;
                return !of.bodies.empty() && (of.forceScale != 1 || of.timeScale != 1);
            },
            {kept(), kNoPhysics, kNoPhysics, kNoPhysics, kAtRest, kAtRest, kAtRest, kAtRest}},
    LossRow{"how hands reach beyond their device's workspace",
            [](const LossSubject& s) { return s.scene.reach != Reach{}; },
            {kept(), lost("the format has no place for it"), kNoPhysics, kNoPhysics, kNoFeel, kNoFeel,
             kNoFeel, kNoFeel}},
    LossRow{"proxy radius",
            always,
            {kept(), kept("in the file of the device"), kNoPhysics, kNoPhysics, kNoFeel, kNoFeel, kNoFeel,
             kNoFeel}},
    LossRow{"cameras",
            [](const LossSubject& s) { return s.foreign.cameras || !s.scene.cameras.empty(); },
            {kept(), kNoSets, kept(), kept(), kNoSets, kNoSets, kNoSets, kNoSets}},
    foreignRow("lights", [](const LossSubject& s) { return s.foreign.lights; }),
    foreignRow("pictures for the eye", [](const LossSubject& s) { return s.foreign.pictures; }),
    foreignRow("other parts of other programs", [](const LossSubject& s) { return s.foreign.others; }),
};

inline const std::array kObjectRows{
    LossRow{"shape",
            hasFacesOf<3>,
            {kept(), kept("H3D reads it in single precision"), kept("in single precision"),
             kept("in single precision"), kept(), kept(), degraded("in single precision"), kept()}},
    LossRow{"lines",
            hasFacesOf<2>,
            {kept(), kept("as IndexedLineSet"), kept(), lost("colliders are made of triangles"), kept("as l"),
             kept("as edges"), lost("the format has triangles alone"), kept("as faces of two corners")}},
    LossRow{"points",
            hasFacesOf<1>,
            {kept(), kept("as PointSet"), kept(), lost("colliders are made of triangles"), kept("as p"),
             degraded("as vertices; felt again where the file has no faces and no lines"),
             lost("the format has triangles alone"), kept("as faces of one corner")}},
    LossRow{"normals",
            [](const LossSubject& s) { return !s.object->geometry->cornerNormals.empty(); },
            {kept(), degraded("for the eye; H3D feels facets"), kept(), kept(), kept(), kept(),
             lost("each triangle has its own"), lost("each triangle has its own")}},
    LossRow{"texture coordinates",
            [](const LossSubject& s) { return !s.object->geometry->cornerUvs.empty(); },
            {kept(), kept(), kept(), kept(), kept(), kept(), lost("the format has none"),
             lost("the format has none")}},
    LossRow{"pose",
            [](const LossSubject& s) { return !(s.object->pose == Pose{}); },
            {kept(), kept("as Transform"), kept(), kept(), kWorld, kWorld, kWorld, kWorld}},
    LossRow{"motion",
            [](const LossSubject& s) { return bool(s.object->motion); },
            {kept(), degraded("as TimeSensor and interpolators, which begin at any place of the loop"),
             degraded("as a glTF animation, for the eye"), degraded("as a glTF animation, for the eye"),
             kAtRest, kAtRest, kAtRest, kAtRest}},
    LossRow{"hidden",
            [](const LossSubject& s) { return !s.object->visible; },
            {kept(), kept("as Switch"), lost("is shown"), lost("is shown and felt"), lost("is shown"),
             lost("is shown"), lost("is shown"), lost("is shown")}},
    LossRow{"name",
            always,
            {kept(), kept("in the metadata; DEF has its plain letters"), kept(), kept(), kept(),
             lost("all objects are one mesh"), lost("all objects are one mesh"),
             lost("all objects are one mesh")}},
    LossRow{"group",
            [](const LossSubject& s) { return !s.object->group.empty(); },
            {kept("as a node above it"), kNoSets, kNoSets, kNoSets, kNoSets, kNoSets, kNoSets, kNoSets}},
    LossRow{"selection sets",
            [](const LossSubject& s) { return !s.object->sets.empty(); },
            {kept(), kNoSets, kNoSets, kNoSets, kNoSets, kNoSets, kNoSets, kNoSets}},
    LossRow{"surfaces",
            [](const LossSubject& s) { return s.object->surfaces.size() > 1; },
            {kept(), kept("a Shape each"),
             degraded("one material for the object: that of its largest surface"),
             degraded("one material for the object: that of its largest surface"), kept("a material each"),
             lost("all are one"), lost("all are one"), lost("all are one")}},
};

inline const std::array kSurfaceRows{
    LossRow{"colour",
            always,
            {kept(), kept(), kept(), kept(), kept("as Kd"), lost("the file has none"),
             lost("the file has none"), lost("the file has none")}},
    LossRow{"stiffness",
            always,
            {kept(), kept(), degraded("as a texture; the standard says no unit, ours beside it does"),
             kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"damping",
            [](const LossSubject& s) { return s.surface->material.damping != 0; },
            {kept(), kept(), kNoPhysics, kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"static friction",
            [](const LossSubject& s) { return s.surface->material.staticFriction != 0; },
            {kept(), kept(), lost("the standard has one coefficient"), kept(), kNoFeel, kNoFeel, kNoFeel,
             kNoFeel}},
    LossRow{"dynamic friction",
            [](const LossSubject& s) { return s.surface->material.dynamicFriction != 0; },
            {kept(), kept(), kept("as a texture"), kept(), kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"viscosity",
            [](const LossSubject& s) { return s.surface->material.viscosity != 0; },
            {kept(), lost("H3D has none; it stands in the metadata"), kNoPhysics, kNoPhysics, kNoFeel,
             kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"force shading",
            [](const LossSubject& s) { return s.surface->shading.on; },
            {kept(), lost("H3D feels facets: divide the mesh before; it stands in the metadata"), kNoPhysics,
             kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"felt side",
            [](const LossSubject& s) { return s.surface->sides != Sides::Both; },
            {kept(), kept("as touchableFace"), kNoPhysics, kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"hidden surface",
            [](const LossSubject& s) { return !s.surface->visible; },
            {kept(), kept("as Switch"), lost("is shown"), lost("is shown and felt"), lost("is shown"),
             lost("is shown"), lost("is shown"), lost("is shown")}},
    LossRow{"layers of height",
            [](const LossSubject& s) { return anyLayer(s, isHeight); },
            {kept(), degraded("flattened to one picture of 8 bits"),
             degraded("flattened to one picture of 16 bits and at most 192 texels a side; without texture "
                      "coordinates it is not there"),
             kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"layers of friction or stiffness",
            [](const LossSubject& s) {
                return anyLayer(s, [](auto& layer) {
                    return !isHeight(layer) && layer.target != TextureTarget::Viscosity;
                });
            },
            {kept(),
             degraded("flattened to pictures of 8 bits; their mean alone where there is height as well"),
             degraded("dynamic friction and stiffness as pictures of 16 bits and at most 192 texels a side; "
                      "the standard has one coefficient of friction"),
             kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{"painted values",
            [](const LossSubject& s) { return anyLayer(s, isPainted); },
            {kept("as an attribute of the vertices"),
             degraded("in the pictures of their layers; without texture coordinates they are not there"),
             degraded("in the pictures of their layers; without texture coordinates they are not there"),
             kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
    LossRow{
        "layers of viscosity",
        [](const LossSubject& s) {
            return anyLayer(s, [](auto& layer) { return layer.target == TextureTarget::Viscosity; });
        },
        {kept(), lost("H3D has no viscosity"), kNoPhysics, kNoPhysics, kNoFeel, kNoFeel, kNoFeel, kNoFeel}},
};

} // namespace loss_table
} // namespace tactum
