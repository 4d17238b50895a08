// Bodies and joints as X3D's component RigidBodyPhysics (ISO/IEC 19775-1, 37). For write_x3d.cpp only.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/files/loss_report.h"
#include "core/files/unique_names.h"
#include "core/files/x3d/xml_writer.h"
#include "core/scene/scene.h"

namespace tactum {

/// A body has its centre of mass for the origin and the axes of the world at first, since the engines behind
/// X3D want their centres there. What hangs on a joint that X3D lacks stands still. Thread: any but real
/// time.
class X3dBodies {
public:
    X3dBodies(const Scene& scene, UniqueNames& names, std::vector<Loss>& losses);

    /// Where the origin of a body is that moves; nothing for one that stands still.
    std::optional<Vec3> originOf(BodyId body) const;
    /// The Transform of this DEF follows the body.
    void lead(BodyId body, const std::string& transform) { led_.emplace_back(body, transform); }
    /// After everything that they lead.
    void write(XmlElement& scene);

private:
    struct Shape;

    void writeBody(XmlElement& collection, const RigidBody& body);
    void writeCollider(XmlElement& parent, const char* field, const Collider& collider, const Pose& place);
    void writeCollidable(XmlElement& parent, const char* field, const Shape& shape, const Pose& place);
    void writeShape(XmlElement& collidable, const Shape& shape) const;
    void writeColliders(XmlElement& collection);
    void writeJoint(XmlElement& collection, const Joint& joint) const;
    const RigidBody* find(BodyId id) const;
    Pose poseOf(BodyId id) const;
    void lose(const std::string& of, const char* what, LossKind kind, const char* sentence);

    const Scene& scene_;
    UniqueNames& names_;
    std::vector<Loss>& losses_;
    std::set<BodyId> still_;
    std::map<BodyId, std::string> defs_;
    std::vector<std::string> collidables_;
    std::vector<std::pair<BodyId, std::string>> led_;
};

} // namespace tactum
