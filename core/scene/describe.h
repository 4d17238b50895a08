// A scene in plain words and numbers: what `tactum info` prints.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/mesh_health.h"
#include "core/scene/scene.h"

namespace tactum {

struct ParameterDescription {
    std::string_view key;  ///< e.g. "static-friction"
    std::string_view unit; ///< empty for a ratio
    double value = 0;
    bool allowed = true; ///< inside the parameter's range
};

/// Of a layer of haptic texture, in the keys of texture_layer.h.
struct LayerDescription {
    std::string name;
    bool enabled = true;
    std::string_view source;
    std::string image;        ///< its name; empty for another source, or when it is missing
    std::string_view mapping; ///< empty for what is painted
    std::string_view target, blend;
    std::string_view mask;         ///< its source; empty for none
    ParameterDescription strength; ///< m for a height, else a ratio
    ParameterDescription opacity;
};

struct SurfaceDescription {
    std::string name;
    std::size_t triangles = 0;
    Eigen::Vector3f colour; ///< linear RGB
    Sides sides = Sides::Both;
    bool visible = true, locked = false;
    std::vector<ParameterDescription>
        parameters; ///< every number of the material, in the order of kMaterialFields
    Shading shading;
    std::vector<LayerDescription> layers; ///< lowest first
};

/// Of a body that moves by itself.
struct MotionDescription {
    double duration = 0; ///< s
    double topSpeed = 0; ///< m/s, of its fastest point
    bool jumps = false;  ///< somewhere, or from its end to its start
};

/// A selection set, as far as it is of one object.
struct SetDescription {
    std::string name;
    std::size_t triangles = 0;
};

struct ObjectDescription {
    ObjectId id = 0;
    std::string name;
    bool visible = true;
    std::size_t triangles = 0; ///< segments and points are in its health
    std::size_t vertices = 0;
    Bounds bounds_B; ///< m, body frame
    Pose pose;       ///< X_WB, at the time 0
    std::optional<MotionDescription> motion;
    MeshHealth health;
    std::vector<SurfaceDescription> surfaces;
    std::vector<SetDescription> sets; ///< rising by names
};

struct BodyDescription {
    std::string name;
    double mass = 0;        ///< kg
    bool kinematic = false; ///< its keys move it, and no force
    std::size_t colliders = 0;
};

struct JointDescription {
    std::string name;
    std::string a, b; ///< names of bodies; empty: the world
};

struct SceneDescription {
    std::size_t triangles = 0;
    Bounds bounds_W;                              ///< m, world frame
    std::vector<ParameterDescription> parameters; ///< of the scene itself: the proxy radius
    std::string_view reach;                       ///< of hands, a key of kReachChoices
    std::vector<ObjectDescription> objects;
    std::vector<BodyDescription> bodies;
    std::vector<JointDescription> joints;
};

/// Examines every mesh once, also where objects share one. Thread: any but real time.
SceneDescription describe(const Scene& scene);

/// Nothing for a body at rest. Thread: any but real time.
std::optional<MotionDescription> describeMotion(const SceneObject& object);

} // namespace tactum
