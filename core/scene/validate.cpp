// What `tactum check` says of a scene: values, sizes, meshes.
#include <map>

#include "core/geometry/mesh_health.h"
#include "core/motion/movers.h"
#include "core/scene/describe.h"
#include "core/scene/findings.h"
#include "core/scene/light_bodies.h"
#include "core/scene/value_checks.h"
#include "core/scene/world_fields.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

class Validation {
public:
    explicit Validation(const Scene& scene) : scene_(scene) {}

    std::vector<Finding> run() {
        checkParameter(findings_, "", "", kProxyRadius, scene_.proxyRadius);
        checkParameter(findings_, "", "", kShellRadius, scene_.reach.shell);
        if (!scene_.mechanics.bodies.empty())
            for (const WorldField& field : kWorldFields)
                checkParameter(findings_, "", "", *field.parameter, scene_.mechanics.*field.value);
        if (scene_.objects.empty() && scene_.mechanics.bodies.empty())
            say(Severity::Warning, "", "the scene is empty", "open a model");
        else if (scene_.objects.empty())
            say(Severity::Warning, "", "has bodies that can be simulated, but no mesh to see or touch",
                "give their nodes meshes");
        for (const SceneObject& object : scene_.objects)
            check(object);
        checkSize();
        appendLightBodies(findings_, scene_);
        return std::move(findings_);
    }

private:
    void say(Severity severity, const std::string& object, std::string sentence, std::string remedy) {
        findings_.push_back({severity, object, std::move(sentence), std::move(remedy)});
    }

    void check(const SceneObject& object) {
        for (const Surface& surface : object.surfaces)
            checkMaterial(object.name, surface);
        checkTextures(findings_, object);
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
        if (health->second.flippedEdges > 0) checkSides(object);
        checkMotion(object);
    }

    /// On a mesh whose triangles face opposite ways.
    void checkSides(const SceneObject& object) {
        for (const Surface& surface : object.surfaces)
            if (surface.sides != Sides::Both)
                say(Severity::Warning, object.name,
                    "surface \"" + surface.name + "\" is felt from its " +
                        std::string(nameOf(surface.sides)) +
                        " alone, but neighbouring triangles face opposite ways",
                    "make the normals consistent, or let both sides be felt");
    }

    void checkMotion(const SceneObject& object) {
        constexpr double kFastest = 10; // m/s: what a hand can still meet, with room to spare
        const auto motion = describeMotion(object);
        if (!motion) return;
        if (motion->topSpeed > kFastest)
            say(Severity::Warning, object.name,
                "moves at up to " + withUnit(motion->topSpeed, "m/s") + ", faster than " +
                    withUnit(kFastest, "m/s"),
                "slow its animation down, or check the scene's unit");
        if (motion->jumps)
            say(Severity::Note, object.name, "jumps from one pose to another during its motion",
                "what touches it there is let go; let the last pose be the first for a motion without an "
                "end");
    }

    void checkMaterial(const std::string& object, const Surface& surface) {
        const std::string of = " of surface \"" + surface.name + "\"";
        for (const MaterialField& field : kMaterialFields)
            checkParameter(findings_, object, of, *field.parameter, surface.material.*field.value);
        const Material& m = surface.material;
        if (m.dynamicFriction > m.staticFriction)
            say(Severity::Warning, object,
                "dynamic friction" + of + " (" + withUnit(m.dynamicFriction, "") +
                    ") is above static friction (" + withUnit(m.staticFriction, "") + ")",
                "clamped to it when touched; raise static or lower dynamic friction");
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
