// The author's scene: plain values with ==, edited on the ui thread, compiled into a World for the loops.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/reach.h"
#include "core/base/vec.h"
#include "core/dynamics/mechanics.h"
#include "core/geometry/sides.h"
#include "core/geometry/triangle_ranges.h"
#include "core/geometry/triangle_soup.h"
#include "core/motion/motion.h"
#include "core/scene/finger_path.h"
#include "core/scene/kept.h"
#include "core/scene/saved_cameras.h"
#include "core/surface/material.h"
#include "core/surface/shading.h"
#include "core/surface/texture_layer.h"

namespace tactum {

inline constexpr Parameter kProxyRadius{"proxy-radius",
                                        "Proxy radius",
                                        "m",
                                        1e-5,
                                        0.1,
                                        1e-4,
                                        1e-3,
                                        5,
                                        "Radius of the sphere that stands for the finger; larger than any "
                                        "gap it must not fall into (section 2)."};

/// In the order of ReachMode.
inline constexpr std::array<NamedChoice, kReachModes> kReachChoices{
    {{"position", "Position"}, {"rate", "Rate control beyond the shell"}, {"drift", "Drift"}}};

inline constexpr Parameter kShellRadius{
    "shell-radius",
    "Shell",
    "m",
    kMinShell,
    kMaxShell,
    1e-3,
    kUsualShell,
    4,
    "Radius about the device's centre within which the finger follows the hand. Beyond it a spring pulls the "
    "hand back, and the workspace goes where the hand pulls, the faster the farther."};

/// A part of an object with one feel: a group or material of the file.
struct Surface {
    std::string name;
    Material material;
    Shading shading;
    std::vector<TextureLayer> layers;               ///< of haptic texture, lowest first
    Eigen::Vector3f colour = {0.72f, 0.72f, 0.74f}; ///< linear RGB, 0 to 1; only for the eye
    Sides sides = Sides::Both;                      ///< from which it is felt
    bool visible = true;                            ///< else neither seen nor felt
    bool locked = false;                            ///< the window changes neither its feel nor its triangles
    Kept kept;                                      ///< of its glTF material

    bool operator==(const Surface&) const = default;
};

/// Names an object for its whole life, across undo and reordering. 0 is nobody.
using ObjectId = std::uint32_t;

/// What a selection set has of one object: see core/scene/selection_sets.h.
struct NamedTriangles {
    std::string name;
    TriangleRanges triangles; ///< of the object's geometry

    bool operator==(const NamedTriangles&) const = default;
};

struct SceneObject {
    ObjectId id = 0;
    std::string name;
    Pose pose;                                    ///< X_WB; of a body that moves, at the time 0
    std::shared_ptr<const Motion> motion;         ///< relative to `pose`, immutable; null: at rest
    std::shared_ptr<const TriangleSoup> geometry; ///< body frame, shared and immutable
    std::vector<Surface> surfaces;                ///< geometry->surfaceOf indexes it
    BodyId body = kWorldBody;                     ///< that it moves with; its pose is then that at the time 0
    bool visible = true;
    std::string group;                ///< that it is in, by its name; empty: none. See core/scene/groups.h
    std::vector<NamedTriangles> sets; ///< rising by names, each once, none without triangles
    Kept kept;                        ///< of its glTF node
    Kept keptMesh;                    ///< of its glTF mesh

    bool operator==(const SceneObject&) const = default;
};

struct Scene {
    std::vector<SceneObject> objects;
    Mechanics mechanics;                       ///< what moves by forces
    double proxyRadius = kProxyRadius.initial; ///< m
    Reach reach;                               ///< of hands beyond their device's workspace
    /// A stroke that shows what there is to feel; null: none was given. Shared and immutable.
    std::shared_ptr<const std::vector<FingerPoint>> finger;
    std::vector<SavedCamera> cameras; ///< to look from, in the author's order, each name once; never felt
    KeptFile kept;                    ///< of the glTF file

    bool operator==(const Scene&) const = default;

    SceneObject* find(ObjectId id);
    const SceneObject* find(ObjectId id) const;
    /// Appends under an id that no object of this scene has.
    SceneObject& add(SceneObject object);
};

/// The box of all objects in the world frame, at the time 0.
Bounds boundsOf(const Scene& scene);
std::size_t triangleCount(const Scene& scene);

/// What a mesh that does not fit a hand is scaled to when it is opened. Unit: m.
inline constexpr double kHandDiagonal = 0.2;

/// Scales every object about the centre of the scene's box so that its diagonal is `diagonal` metres, and
/// moves that centre to the world origin. Leaves a scene without extent as it is.
void fitDiagonal(Scene& scene, double diagonal);

} // namespace tactum
