// The bodies, joints and colliders of a scene as nodes of a glTF file: KHR_physics_rigid_bodies with
// KHR_implicit_shapes, and our extension for what these lack. What gltf_physics.h reads.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/dynamics/mechanics.h"
#include "core/files/gltf/gltf_data.h"

namespace tactum {

/// The mesh of the file that holds these corners and triangles.
using AddShapeMesh = std::function<int(const std::shared_ptr<const ShapeMesh>& mesh)>;

/// Of a scene without bodies it writes nothing. Thread: any but real time.
class PhysicsWriter {
public:
    /// All of it outlives this.
    PhysicsWriter(Json& root, GltfData& data, const Mechanics& mechanics, const AddShapeMesh& meshOf);

    /// Colliders and the frames of joints. Call it before the bodies, whose children they are: a reader takes
    /// them in the order of their nodes.
    void addParts();
    /// A body; `objects`: the nodes that move with it, in its frame.
    int addBody(const RigidBody& body, const std::vector<int>& objects);
    /// Nodes that stand still, for the scene; there after addParts().
    const std::vector<int>& still() const { return still_; }

private:
    struct Thing {
        int node = -1;
        Pose pose;
    };

    const Thing* thingOf(BodyId body, std::uint32_t part) const;
    void addCollider(const Collider& collider);
    void addJoint(const Joint& joint);
    void hang(int node, BodyId body, std::uint32_t part);
    Json partNode(const char* role, const std::string& name, const Pose& pose, BodyId body,
                  std::uint32_t part) const;
    void use(const char* extension);
    Json geometryOf(const ColliderShape& shape);
    int element(const char* extension, const char* array, Json value);

    Json& root_;
    GltfData& data_;
    const Mechanics& mechanics_;
    const AddShapeMesh& meshOf_;
    std::map<BodyId, std::vector<int>> below_;
    std::map<std::string, int> known_;      ///< elements by their array and what they say
    std::map<std::uint32_t, Thing> things_; ///< the first collider of each Collider::part
    std::vector<int> still_;
};

/// Takes all that becomes bodies, joints and colliders out of a root, with its nodes, or out of one node.
void eraseMechanics(Json& element);

} // namespace tactum
