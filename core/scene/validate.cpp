// What `tactum check` says of a scene: values, sizes, meshes.
#include <charconv>
#include <map>

#include "core/geometry/mesh_health.h"
#include "core/scene/load_scene.h"
#include "core/scene/readers.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

std::string text(double value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6).ptr};
}

std::string withUnit(double value, std::string_view unit) {
    return text(value) + (unit.empty() ? "" : " ") + std::string(unit);
}

class Validation {
public:
    explicit Validation(const Scene& scene) : scene_(scene) {}

    std::vector<Finding> run() {
        checkParameter("", "", kProxyRadius, scene_.proxyRadius);
        if (scene_.objects.empty()) say(Severity::Warning, "", "the scene is empty", "open a model");
        for (const SceneObject& object : scene_.objects)
            check(object);
        checkSize();
        return std::move(findings_);
    }

private:
    void say(Severity severity, const std::string& object, std::string sentence, std::string remedy) {
        findings_.push_back({severity, object, std::move(sentence), std::move(remedy)});
    }

    void check(const SceneObject& object) {
        for (const Surface& surface : object.surfaces)
            checkMaterial(object.name, surface);
        if (!object.geometry || object.geometry->triangles.empty())
            return say(Severity::Warning, object.name, "has no triangles", "delete it or give it a mesh");
        const double diagonal = boundsOf(*object.geometry).diagonal();
        if (diagonal < 2 * scene_.proxyRadius)
            say(Severity::Warning, object.name,
                "is smaller (" + withUnit(diagonal, "m") + ") than the proxy (radius " +
                    withUnit(scene_.proxyRadius, "m") + ")",
                "scale the object up or make the proxy smaller");
        const auto [health, isNew] = healths_.try_emplace(object.geometry.get());
        if (isNew) health->second = healthOf(*object.geometry).value();
        appendHealth(findings_, object.name, health->second);
    }

    void checkMaterial(const std::string& object, const Surface& surface) {
        const std::string of = " of surface \"" + surface.name + "\"";
        for (const MaterialField& field : kMaterialFields)
            checkParameter(object, of, *field.parameter, surface.material.*field.value);
        const Material& m = surface.material;
        if (m.dynamicFriction > m.staticFriction)
            say(Severity::Warning, object,
                "dynamic friction" + of + " (" + text(m.dynamicFriction) + ") is above static friction (" +
                    text(m.staticFriction) + ")",
                "clamped to it when touched; raise static or lower dynamic friction");
    }

    /// A number that means nothing is an error; one beyond the range is clamped when touched.
    void checkParameter(const std::string& object, const std::string& of, const Parameter& parameter,
                        double value) {
        if (parameter.allows(value)) return;
        const std::string what = std::string(parameter.label) + of + " is ";
        if (!std::isfinite(value))
            return say(Severity::Error, object, what + "not a number",
                       "set it, for example to " + withUnit(parameter.initial, parameter.unit));
        const std::string range =
            text(parameter.minimum) + " to " + withUnit(parameter.maximum, parameter.unit);
        const Severity severity = value < parameter.minimum ? Severity::Error : Severity::Warning;
        say(severity, object, what + withUnit(value, parameter.unit) + ", outside " + range,
            "set it inside that range; " + withUnit(parameter.clamped(value), parameter.unit) +
                " is used when touched");
    }

    /// Against the reach of desktop devices: about 0.1 to 0.4 m.
    void checkSize() {
        constexpr double kLargest = 2, kSmallest = 0.005; // m
        const double diagonal = boundsOf(scene_).diagonal();
        if (triangleCount(scene_) == 0 || (diagonal <= kLargest && diagonal >= kSmallest)) return;
        const bool large = diagonal > kLargest;
        say(Severity::Warning, "",
            "the scene is " + withUnit(diagonal, "m") + " across, which looks like another unit",
            large ? "scale it down, for example by 0.001 if it is in millimetres"
                  : "scale it up to fit a hand's reach");
    }

    const Scene& scene_;
    std::vector<Finding> findings_;
    std::map<const TriangleSoup*, MeshHealth> healths_;
};

} // namespace

std::vector<Finding> validate(const Scene& scene) {
    return Validation(scene).run();
}

} // namespace tactum
