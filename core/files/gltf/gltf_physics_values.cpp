#include "core/files/gltf/gltf_physics_values.h"

#include <algorithm>

#include "core/dynamics/path_curve.h"
#include "core/geometry/soup_builder.h"

namespace tactum {

namespace {

void leaveOut(std::vector<Finding>& findings, const Joint& joint, const std::string& sentence,
              const std::string& remedy) {
    findings.push_back({Finding::Severity::Warning, joint.name, sentence, remedy});
}

Combine combineIn(const Json& holder, const char* key) {
    const std::string mode = textIn(holder, key);
    if (mode == "minimum") return Combine::Minimum;
    if (mode == "maximum") return Combine::Maximum;
    if (mode == "multiply") return Combine::Multiply;
    return Combine::Average;
}

AxisSet axesIn(const Json& limit, const char* key) {
    AxisSet axes = 0;
    const Json* list = member(limit, key);
    if (!list || !list->is_array()) return 0;
    for (const Json& axis : *list)
        if (axis.is_number_integer() && axis.get<int>() >= 0 && axis.get<int>() < 3)
            axes = AxisSet(axes | 1 << axis.get<int>());
    return axes;
}

} // namespace

std::optional<ColliderShape> implicitShapeOf(const Json& json, const Mat3& stretch) {
    const Vec3 scale = stretch.diagonal().cwiseAbs();
    if (scale.isZero(0)) return std::nullopt; // disabled
    const std::string type = textIn(json, "type");
    static const Json kNothing = Json::object();
    const Json* given = type.empty() ? nullptr : member(json, type.c_str());
    const Json& of = given ? *given : kNothing;
    const double across = 0.5 * (scale.x() + scale.z());
    ColliderShape shape;
    if (type == "box") {
        shape.kind = ShapeKind::Box;
        shape.size = vectorIn<3>(of, "size").value_or(Vec3::Ones()).cwiseProduct(scale);
    } else if (type == "sphere") {
        shape.kind = ShapeKind::Sphere;
        shape.radius = shape.radiusBottom = numberIn(of, "radius").value_or(0.5) * scale.mean();
    } else if (type == "capsule" || type == "cylinder") {
        shape.kind = type == "capsule" ? ShapeKind::Capsule : ShapeKind::Cylinder;
        const double radius = numberIn(of, "radius").value_or(0.25); // of an older draft
        shape.radius = numberIn(of, "radiusTop").value_or(radius) * across;
        shape.radiusBottom = numberIn(of, "radiusBottom").value_or(radius) * across;
        shape.height = numberIn(of, "height").value_or(0.5) * scale.y();
    } else if (type == "plane") {
        shape.kind = ShapeKind::Plane;
        const auto extent = [&](const char* key, double by) {
            const auto size = numberIn(of, key);
            return size ? *size * by : kUnbounded;
        };
        shape.size = {extent("sizeX", scale.x()), 0, extent("sizeZ", scale.z())};
    } else {
        return std::nullopt;
    }
    const bool round = shape.kind != ShapeKind::Box && shape.kind != ShapeKind::Plane;
    const bool usable = round ? shape.radius >= 0 && shape.radiusBottom >= 0 &&
                                    shape.radius + shape.radiusBottom > 0 && shape.height > 0
                              : shape.kind == ShapeKind::Plane || shape.size.minCoeff() > 0;
    const bool bounded = isCoordinate(shape.radius) && isCoordinate(shape.radiusBottom) &&
                         isCoordinate(shape.height) &&
                         (shape.kind == ShapeKind::Plane || isCoordinate(shape.size.maxCoeff()));
    return usable && bounded ? std::optional(shape) : std::nullopt;
}

TouchMaterial touchMaterialOf(const Json& json) {
    TouchMaterial material;
    const auto positive = [&](const char* key, double otherwise) {
        return std::max(0.0, numberIn(json, key).value_or(otherwise));
    };
    material.staticFriction = positive("staticFriction", material.staticFriction);
    material.dynamicFriction = positive("dynamicFriction", material.dynamicFriction);
    material.restitution = std::min(1.0, positive("restitution", 0));
    material.frictionCombine = combineIn(json, "frictionCombine");
    material.restitutionCombine = combineIn(json, "restitutionCombine");
    return material;
}

CollisionFilter collisionFilterOf(const Json& json) {
    CollisionFilter filter;
    const auto names = [&](const char* key) {
        std::vector<std::string> all;
        if (const Json* list = member(json, key); list && list->is_array())
            for (const Json& name : *list)
                if (name.is_string()) all.push_back(name.get<std::string>());
        return all;
    };
    filter.systems = names("collisionSystems");
    filter.notWith = names("notCollideWithSystems");
    filter.with = names("collideWithSystems");
    return filter;
}

void addLimits(const Json& description, Joint& joint, std::vector<Finding>& findings) {
    const Json* all = member(description, "limits");
    if (!all || !all->is_array()) return;
    for (const Json& json : *all) {
        JointLimit limit;
        limit.axes = axesIn(json, "linearAxes");
        limit.angular = limit.axes == 0;
        if (limit.angular) limit.axes = axesIn(json, "angularAxes");
        limit.min = numberIn(json, "min").value_or(-kUnbounded);
        limit.max = numberIn(json, "max").value_or(kUnbounded);
        limit.stiffness = std::max(0.0, numberIn(json, "stiffness").value_or(kUnbounded));
        limit.damping = std::max(0.0, numberIn(json, "damping").value_or(0));
        const bool isDistance = (limit.axes & (limit.axes - 1)) != 0; // or an angle from none to pi
        if (limit.axes == 0 || limit.min > limit.max || (isDistance && limit.max < 0))
            leaveOut(
                findings, joint,
                "has a limit without axes, or whose minimum is above its maximum, or its distance below 0",
                "left out; correct it");
        else
            joint.limits.push_back(limit);
    }
}

void addDrives(const Json& from, const char* array, Joint& joint, std::vector<Finding>& findings) {
    const Json* all = member(from, array);
    if (!all || !all->is_array()) return;
    for (const Json& json : *all) {
        JointDrive drive;
        drive.angular = textIn(json, "type") == "angular";
        drive.axis = indexIn(json, "axis", 3);
        drive.stiffness = std::max(0.0, numberIn(json, "stiffness").value_or(0));
        drive.damping = std::max(0.0, numberIn(json, "damping").value_or(0));
        drive.position = numberIn(json, "positionTarget").value_or(0);
        drive.velocity = numberIn(json, "velocityTarget").value_or(0);
        drive.maxForce = std::max(0.0, numberIn(json, "maxForce").value_or(kUnbounded));
        drive.acceleration = textIn(json, "mode") == "acceleration";
        drive.spacing = std::max(0.0, numberIn(json, "spacing").value_or(0));
        if (drive.axis < 0)
            leaveOut(findings, joint, "has a drive without an axis from 0 to 2", "left out; correct it");
        else
            joint.drives.push_back(drive);
    }
}

void addFrictions(const Json& ours, Joint& joint, std::vector<Finding>& findings) {
    const Json* all = member(ours, "frictions");
    if (!all || !all->is_array()) return;
    for (const Json& json : *all) {
        const JointFriction friction{textIn(json, "type") == "angular", indexIn(json, "axis", 3),
                                     numberIn(json, "force").value_or(-1)};
        if (friction.axis < 0 || friction.force < 0)
            leaveOut(findings, joint, "has a friction without an axis from 0 to 2 or a force",
                     "left out; correct it");
        else
            joint.frictions.push_back(friction);
    }
}

bool addPath(const Json& path, Joint& joint, std::vector<Finding>& findings) {
    const auto vectors = [](const Json* list) {
        std::vector<Vec3> all;
        if (list && list->is_array())
            for (std::size_t i = 0; i < std::min(list->size(), kMostPathPoints + 1); ++i)
                all.push_back(vectorOf<3>((*list)[i]).value_or(Vec3::Constant(kUnbounded)));
        return all;
    };
    joint.path.points = vectors(member(path, "points"));
    joint.path.ups = vectors(member(path, "ups"));
    joint.path.closed = path.is_object() && flagIn(path, "closed");
    const auto curve = PathCurve::through(joint.path);
    if (!curve)
        leaveOut(findings, joint, "has a path that is none: " + curve.error().text, "the joint is left out");
    return curve.has_value();
}

} // namespace tactum
