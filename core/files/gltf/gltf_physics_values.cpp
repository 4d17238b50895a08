#include "core/files/gltf/gltf_physics_values.h"

#include <algorithm>
#include <array>

#include "core/dynamics/path_curve.h"
#include "core/geometry/soup_builder.h"

namespace tactum {

namespace {

void leaveOut(std::vector<Finding>& findings, const Joint& joint, const std::string& sentence,
              const std::string& remedy) {
    findings.push_back({Finding::Severity::Warning, joint.name, sentence, remedy});
}

Combine combineIn(const Values& material, const char* key) {
    constexpr std::array kModes{Combine::Average, Combine::Minimum, Combine::Maximum, Combine::Multiply};
    return kModes[material.oneOf(key, {"average", "minimum", "maximum", "multiply"})];
}

bool hasAny(const Json& limit, const char* key) {
    const Json* list = member(limit, key);
    return list && !(list->is_array() && list->empty());
}

/// Nothing where there are none, or what is no axis.
AxisSet axesIn(const Json& limit, const char* key) {
    AxisSet axes = 0;
    const Json* list = member(limit, key);
    if (!list || !list->is_array()) return 0;
    for (const Json& axis : *list) {
        const auto number = axis.is_number_integer() ? axis.get<std::int64_t>() : -1;
        if (number < 0 || number > 2) return 0;
        axes = AxisSet(axes | 1 << number);
    }
    return axes;
}

} // namespace

double Values::inRange(const char* key, double otherwise, double least, double most,
                       const char* words) const {
    if (!member(json_, key)) return otherwise;
    const auto value = numberIn(json_, key);
    if (value && *value >= least && *value <= most) return *value;
    warn(std::string("whose ") + key + " is not " + words, "it is as if it were not there; correct it");
    return otherwise;
}

std::size_t Values::oneOf(const char* key, std::initializer_list<const char*> words) const {
    if (!member(json_, key)) return 0;
    const auto found = std::ranges::find(words, textIn(json_, key));
    if (found != words.end()) return std::size_t(found - words.begin());
    std::string all;
    for (const char* word : words)
        all += (all.empty() ? "" : word == *(words.end() - 1) ? " or " : ", ") + std::string(word);
    warn(std::string("whose ") + key + " is not " + all,
         std::string(*words.begin()) + " is used; correct it");
    return 0;
}

const Json* Values::ofKind(const char* key, bool (Json::*is)() const noexcept, const char* words) const {
    const Json* found = member(json_, key);
    if (!found || (found->*is)()) return found;
    warn(std::string("whose ") + key + " is not " + words, "it is as if it were not there; correct it");
    return nullptr;
}

bool Values::flag(const char* key) const {
    const Json* found = ofKind(key, &Json::is_boolean, "true or false");
    return found && found->get<bool>();
}

const Json* Values::list(const char* key) const {
    return ofKind(key, &Json::is_array, "a list");
}

const Json* Values::object(const char* key) const {
    return ofKind(key, &Json::is_object, "an object");
}

const Json* Values::listOfObjects(const char* key) const {
    const Json* all = list(key);
    if (!all) return nullptr;
    if (!std::ranges::all_of(*all, [](const Json& one) { return one.is_object(); }))
        warn(std::string("whose ") + key + " are not all objects",
             "the others are as if they were not there; correct them");
    return all;
}

void Values::warn(const std::string& sentence, const std::string& remedy) const {
    findings_.push_back({Finding::Severity::Warning, of_, "has a " + what_ + " " + sentence, remedy});
}

std::optional<ColliderShape> implicitShapeOf(const Json& json, const Mat3& stretch, const std::string& owner,
                                             std::vector<Finding>& findings) {
    const Vec3 scale = stretch.diagonal().cwiseAbs();
    if (scale.isZero(0)) return std::nullopt; // disabled
    const std::string type = textIn(json, "type");
    static const Json kNothing = Json::object();
    const Json* given = type.empty() ? nullptr : Values(json, owner, "shape", findings).object(type.c_str());
    const Json& of = given ? *given : kNothing;
    const Values values(of, owner, type, findings);
    const double across = 0.5 * (scale.x() + scale.z());
    ColliderShape shape;
    if (type == "box") {
        shape.kind = ShapeKind::Box;
        const auto size = vectorIn<3>(of, "size");
        if (!size && member(of, "size"))
            values.warn("whose size is not three numbers", "1 m each is used; correct it");
        shape.size = size.value_or(Vec3::Ones()).cwiseProduct(scale);
    } else if (type == "sphere") {
        shape.kind = ShapeKind::Sphere;
        shape.radius = shape.radiusBottom = values.number("radius", 0.5) * scale.mean();
    } else if (type == "capsule" || type == "cylinder") {
        shape.kind = type == "capsule" ? ShapeKind::Capsule : ShapeKind::Cylinder;
        const double radius = values.number("radius", 0.25); // of an older draft
        shape.radius = values.number("radiusTop", radius) * across;
        shape.radiusBottom = values.number("radiusBottom", radius) * across;
        shape.height = values.number("height", 0.5) * scale.y();
        if (type == "capsule" && shape.radius != shape.radiusBottom)
            values.warn("of two radii", "it touches as one of their mean; make it of two shapes");
    } else if (type == "plane") {
        shape.kind = ShapeKind::Plane;
        const auto extent = [&](const char* key, double by) { return values.number(key, kUnbounded) * by; };
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

TouchMaterial touchMaterialOf(const Json& json, const std::string& of, std::vector<Finding>& findings) {
    const Values values(json, of, "material", findings);
    TouchMaterial material;
    material.staticFriction = values.positive("staticFriction", material.staticFriction);
    material.dynamicFriction = values.positive("dynamicFriction", material.dynamicFriction);
    material.restitution = values.ratio("restitution", 0);
    material.frictionCombine = combineIn(values, "frictionCombine");
    material.restitutionCombine = combineIn(values, "restitutionCombine");
    return material;
}

CollisionFilter collisionFilterOf(const Json& json, const std::string& of, std::vector<Finding>& findings) {
    const Values values(json, of, "collision filter", findings);
    CollisionFilter filter;
    const auto names = [&](const char* key) {
        std::vector<std::string> all;
        const Json* list = values.list(key);
        if (!list) return all;
        for (const Json& name : *list)
            if (name.is_string()) all.push_back(name.get<std::string>());
        if (all.size() != list->size())
            values.warn(std::string("whose ") + key + " are not all names", "the others are left out");
        return all;
    };
    filter.systems = names("collisionSystems");
    filter.notWith = names("notCollideWithSystems");
    filter.with = names("collideWithSystems");
    return filter;
}

void addLimits(const Json& description, Joint& joint, std::vector<Finding>& findings) {
    const Json* all = Values(description, joint.name, "joint", findings).list("limits");
    if (!all) return;
    for (const Json& json : *all) {
        const Values values(json, joint.name, "limit", findings);
        JointLimit limit;
        limit.angular = !hasAny(json, "linearAxes");
        limit.axes = axesIn(json, limit.angular ? "angularAxes" : "linearAxes");
        if (!limit.angular && hasAny(json, "angularAxes"))
            values.warn("of linear and of angular axes", "the linear ones count; make it two limits");
        limit.min = values.number("min", -kUnbounded);
        limit.max = values.number("max", kUnbounded);
        limit.stiffness = values.positive("stiffness", kUnbounded);
        limit.damping = values.positive("damping", 0);
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
    const Json* all = Values(from, joint.name, "joint", findings).list(array);
    if (!all) return;
    for (const Json& json : *all) {
        const Values values(json, joint.name, "drive", findings);
        JointDrive drive;
        drive.angular = values.oneOf("type", {"linear", "angular"}) == 1;
        drive.axis = indexIn(json, "axis", 3);
        drive.stiffness = values.positive("stiffness", 0);
        drive.damping = values.positive("damping", 0);
        drive.position = values.number("positionTarget", 0);
        drive.velocity = values.number("velocityTarget", 0);
        drive.maxForce = values.positive("maxForce", kUnbounded);
        drive.acceleration = values.oneOf("mode", {"force", "acceleration"}) == 1;
        drive.spacing = values.positive("spacing", 0);
        if (drive.axis < 0)
            leaveOut(findings, joint, "has a drive without an axis from 0 to 2", "left out; correct it");
        else
            joint.drives.push_back(drive);
    }
}

void addFrictions(const Json& ours, Joint& joint, std::vector<Finding>& findings) {
    const Json* all = Values(ours, joint.name, "joint", findings).list("frictions");
    if (!all) return;
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
    const Values values(path, joint.name, "path", findings);
    const auto vectors = [](const Json* list) {
        std::vector<Vec3> all;
        if (list)
            for (std::size_t i = 0; i < std::min(list->size(), kMostPathPoints + 1); ++i)
                all.push_back(vectorOf<3>((*list)[i]).value_or(Vec3::Constant(kUnbounded)));
        return all;
    };
    joint.path.points = vectors(values.list("points"));
    joint.path.ups = vectors(values.list("ups"));
    joint.path.closed = values.flag("closed");
    const auto curve = PathCurve::through(joint.path);
    if (!curve)
        leaveOut(findings, joint, "has a path that is none: " + curve.error().text, "the joint is left out");
    return curve.has_value();
}

} // namespace tactum
