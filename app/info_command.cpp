#include <algorithm>
#include <array>
#include <charconv>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/results.h"
#include "app/streams.h"
#include "core/base/numbers.h"
#include "core/files/source.h"
#include "core/scene/describe.h"

namespace tactum {

namespace {

using Json = nlohmann::ordered_json;

struct HealthField {
    const char* key;
    std::size_t MeshHealth::*count;
};

constexpr std::array<HealthField, 11> kHealthFields{{
    {"triangles", &MeshHealth::triangles},
    {"segments", &MeshHealth::segments},
    {"points", &MeshHealth::points},
    {"slivers", &MeshHealth::slivers},
    {"duplicate_faces", &MeshHealth::duplicateFaces},
    {"non_manifold_edges", &MeshHealth::nonManifoldEdges},
    {"boundary_edges", &MeshHealth::boundaryEdges},
    {"holes", &MeshHealth::holes},
    {"flipped_edges", &MeshHealth::flippedEdges},
    {"components", &MeshHealth::components},
    {"unreferenced_vertices", &MeshHealth::unreferencedVertices},
}};

Json vectorJson(const Vec3& v) {
    return Json::array({v.x(), v.y(), v.z()});
}

Json boundsJson(const Bounds& bounds) {
    if (bounds.empty()) return nullptr;
    return {
        {"low", vectorJson(bounds.low)}, {"high", vectorJson(bounds.high)}, {"diagonal", bounds.diagonal()}};
}

Json poseJson(const Pose& X_WB) {
    const Quat& q = X_WB.rotation;
    return {{"translation_m", vectorJson(X_WB.translation)},
            {"rotation", Json::array({q.x(), q.y(), q.z(), q.w()})}};
}

Json parametersJson(const std::vector<ParameterDescription>& parameters) {
    Json json = Json::object();
    for (const ParameterDescription& parameter : parameters)
        json[std::string(parameter.key)] = {{"value", parameter.value}, {"unit", parameter.unit}};
    return json;
}

Json healthJson(const MeshHealth& health) {
    Json json;
    for (const HealthField& field : kHealthFields)
        json[field.key] = health.*field.count;
    json["has_normals"] = health.hasNormals;
    json["has_uvs"] = health.hasUvs;
    json["closed"] = health.closed();
    return json;
}

Json motionJson(const std::optional<MotionDescription>& motion) {
    if (!motion) return nullptr;
    return {{"duration_s", motion->duration}, {"top_speed_m_s", motion->topSpeed}, {"jumps", motion->jumps}};
}

const char* choiceName(NormalSource normals) {
    return normals == NormalSource::File ? "file" : "computed";
}

Json shadingJson(const Shading& shading) {
    return {{"on", shading.on},
            {"normals", choiceName(shading.normals)},
            {std::string(kCreaseAngle.key), {{"value", shading.creaseAngle}, {"unit", kCreaseAngle.unit}}}};
}

Json layerJson(const LayerDescription& layer) {
    const auto number = [](const ParameterDescription& parameter) {
        return Json{{"value", parameter.value}, {"unit", parameter.unit}};
    };
    return {{"name", layer.name},
            {"enabled", layer.enabled},
            {"source", layer.source},
            {"image", layer.image},
            {"mapping", layer.mapping},
            {"target", layer.target},
            {"strength", number(layer.strength)},
            {"blend", layer.blend},
            {"mask", layer.mask},
            {"opacity", number(layer.opacity)}};
}

Json surfaceJson(const SurfaceDescription& surface) {
    Json json{{"name", surface.name},
              {"sides", nameOf(surface.sides)},
              {"visible", surface.visible},
              {"locked", surface.locked},
              {"triangles", surface.triangles},
              {"parameters", parametersJson(surface.parameters)},
              {"shading", shadingJson(surface.shading)},
              {"layers", Json::array()}};
    for (const LayerDescription& layer : surface.layers)
        json["layers"].push_back(layerJson(layer));
    return json;
}

Json objectJson(const ObjectDescription& object) {
    Json json{{"name", object.name},
              {"visible", object.visible},
              {"motion", motionJson(object.motion)},
              {"triangles", object.triangles},
              {"vertices", object.vertices},
              {"bounds_m", boundsJson(object.bounds_B)},
              {"pose", poseJson(object.pose)},
              {"health", healthJson(object.health)},
              {"surfaces", Json::array()},
              {"sets", Json::array()}};
    for (const SurfaceDescription& surface : object.surfaces)
        json["surfaces"].push_back(surfaceJson(surface));
    for (const SetDescription& set : object.sets)
        json["sets"].push_back({{"name", set.name}, {"triangles", set.triangles}});
    return json;
}

Json bodyJson(const BodyDescription& body) {
    return {{"name", body.name},
            {"mass_kg", body.mass},
            {"kinematic", body.kinematic},
            {"colliders", body.colliders}};
}

Json jointJson(const JointDescription& joint) {
    const auto nameOrNone = [](const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); };
    return {{"name", joint.name}, {"a", nameOrNone(joint.a)}, {"b", nameOrNone(joint.b)}};
}

Json loadedJson(const LoadedScene& loaded) {
    const SceneDescription scene = describe(loaded.scene);
    Json json{{"version", 1}, // of docs/schema
              {"triangles", scene.triangles},
              {"bounds_m", boundsJson(scene.bounds_W)},
              {"parameters", parametersJson(scene.parameters)},
              {"reach", scene.reach},
              {"objects", Json::array()},
              {"bodies", Json::array()},
              {"joints", Json::array()},
              {"cameras", Json::array()}};
    for (const ObjectDescription& object : scene.objects)
        json["objects"].push_back(objectJson(object));
    for (const BodyDescription& body : scene.bodies)
        json["bodies"].push_back(bodyJson(body));
    for (const JointDescription& joint : scene.joints)
        json["joints"].push_back(jointJson(joint));
    for (const SavedCamera& camera : loaded.scene.cameras)
        json["cameras"].push_back({{"name", camera.name}, {"parallel", camera.parallel}});
    json["findings"] = findingsJson(loaded.findings);
    return json;
}

// Six digits at most: more than a person reads, and what doubles make of decimal numbers stays out of sight.
void appendReadable(std::string& out, double value) {
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::scientific, 5).ptr;
    appendNumber(out, parseNumber(std::string_view(digits, std::size_t(end - digits))).value_or(value));
}

std::string textOf(std::string_view key, const ParameterDescription& parameter) {
    std::string text = std::string(key) + " ";
    appendReadable(text, parameter.value);
    if (!parameter.unit.empty()) text += " " + std::string(parameter.unit);
    return text + (parameter.allowed ? "" : "  (out of range)");
}

void printInfo(const std::vector<ParameterDescription>& parameters, const std::string& indent) {
    for (const ParameterDescription& parameter : parameters)
        std::cout << indent << textOf(parameter.key, parameter) << '\n';
}

void printInfo(const Shading& shading) {
    std::string line = "    shading ";
    line +=
        shading.on ? "on, normals " + std::string(choiceName(shading.normals)) + ", crease-angle " : "off";
    if (shading.on) appendReadable(line, shading.creaseAngle);
    std::cout << line << (shading.on ? " rad\n" : "\n");
}

void printInfo(const LayerDescription& layer) {
    std::cout << "    layer " << layer.name << (layer.enabled ? "" : " (off)") << ": " << layer.source
              << (layer.image.empty() ? "" : " ") << layer.image
              << (layer.mapping.empty() ? "" : ", mapping ") << layer.mapping
              << (layer.mask.empty() ? "" : ", mask ") << layer.mask << ", "
              << textOf(layer.target, layer.strength) << ", blend " << layer.blend << ", "
              << textOf(layer.opacity.key, layer.opacity) << '\n';
}

void printInfo(const MotionDescription& motion) {
    std::string line = "  moves for ";
    appendReadable(line, motion.duration);
    line += " s, at up to ";
    appendReadable(line, motion.topSpeed);
    std::cout << line << " m/s" << (motion.jumps ? ", and jumps" : "") << '\n';
}

void printInfo(const ObjectDescription& object) {
    std::cout << "object " << object.name << (object.visible ? "" : " (hidden)") << ": "
              << counted(object.triangles, "triangle") << ", " << object.vertices
              << (object.vertices == 1 ? " vertex, " : " vertices, ")
              << (object.health.closed() ? "closed" : "open") << '\n';
    if (object.motion) printInfo(*object.motion);
    for (const HealthField& field : kHealthFields)
        if (field.count != &MeshHealth::triangles && object.health.*field.count > 0)
            std::cout << "  " << field.key << ' ' << object.health.*field.count << '\n';
    for (const SurfaceDescription& surface : object.surfaces) {
        std::cout << "  surface " << surface.name << (surface.visible ? "" : " (hidden)")
                  << (surface.locked ? " (locked)" : "") << ": " << counted(surface.triangles, "triangle")
                  << '\n'
                  << "    sides " << nameOf(surface.sides) << '\n';
        printInfo(surface.parameters, "    ");
        printInfo(surface.shading);
        for (const LayerDescription& layer : surface.layers)
            printInfo(layer);
    }
    for (const SetDescription& set : object.sets)
        std::cout << "  set " << set.name << ": " << counted(set.triangles, "triangle") << '\n';
}

void printInfo(const BodyDescription& body) {
    std::string line = "body " + body.name + ": ";
    appendReadable(line, body.mass);
    std::cout << line << " kg, " << counted(body.colliders, "collider")
              << (body.kinematic ? ", moved by its keys\n" : "\n");
}

void printInfo(const JointDescription& joint) {
    const auto nameOf = [](const std::string& name) { return name.empty() ? "the world" : name; };
    std::cout << "joint " << joint.name << ": " << nameOf(joint.a) << " to " << nameOf(joint.b) << '\n';
}

void printInfo(const LoadedScene& loaded) {
    const SceneDescription scene = describe(loaded.scene);
    std::string diagonal;
    appendReadable(diagonal, scene.bounds_W.diagonal());
    std::cout << "scene: " << counted(scene.objects.size(), "object") << ", "
              << counted(scene.triangles, "triangle") << ", diagonal " << diagonal << " m\n";
    printInfo(scene.parameters, "  ");
    if (loaded.scene.reach != Reach{}) std::cout << "  reach: " << scene.reach << '\n';
    for (const ObjectDescription& object : scene.objects)
        printInfo(object);
    for (const BodyDescription& body : scene.bodies)
        printInfo(body);
    for (const JointDescription& joint : scene.joints)
        printInfo(joint);
    for (const SavedCamera& camera : loaded.scene.cameras)
        std::cout << "camera " << camera.name << (camera.parallel ? ": parallel\n" : ": perspective\n");
    for (const std::string& line : linesOf(loaded.findings))
        std::cout << line << '\n';
}

} // namespace

Result<int> runInfo(const InfoOptions& options) {
    Json all = Json::array();
    int worst = 0;
    for (const std::filesystem::path& scene : options.scenes) {
        const auto loaded = importGiven(scene, options.axes);
        if (!loaded) worst = std::max(worst, sayError(loaded.error())); // the others are told all the same
        if (options.json) {
            all.push_back(loaded ? loadedJson(*loaded)
                                 : Json{{"version", 1}, {"error", loaded.error().text}});
            if (options.scenes.size() > 1) all.back()["file"] = shownPath(scene);
        } else if (loaded) {
            if (options.scenes.size() > 1) std::cout << shownPath(scene) << ":\n";
            printInfo(*loaded);
        }
    }
    if (options.json)
        std::cout << (options.scenes.size() > 1 ? all : all.front())
                         .dump(2, ' ', false, Json::error_handler_t::replace)
                  << '\n';
    return worst;
}

} // namespace tactum
