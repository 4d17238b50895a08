#include "core/scene/value_checks.h"

#include <charconv>
#include <cmath>

#include "core/base/text.h"
#include "core/surface/texture_stack.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

bool isRotation(const Quat& q) {
    return std::abs(q.norm() - 1) < 1e-3;
}

/// One surface's layers.
class TextureChecks {
public:
    TextureChecks(std::vector<Finding>& findings, const SceneObject& object, Index surface)
        : findings_(findings), object_(object), index_(surface), surface_(object.surfaces[surface]) {}

    void run() {
        int felt = 0, planes = 0;
        for (const TextureLayer& layer : surface_.layers) {
            if (!layer.enabled) continue;
            check(layer);
            ++felt;
            planes += layer.ownPlane && layer.target == TextureTarget::Height;
        }
        if (felt > kMaxTextureLayers)
            warn("surface " + inQuotes(surface_.name) + " has " + counted(std::size_t(felt), "layer") +
                     ", of which " + std::to_string(kMaxTextureLayers) + " are felt",
                 "switch some of them off, or bake them into one picture");
        if (planes > kMaxOwnPlanes)
            warn("surface " + inQuotes(surface_.name) + " has " + counted(std::size_t(planes), "layer") +
                     " with a plane of its own; " + std::to_string(kMaxOwnPlanes) + " get one",
                 "the others join the blend; switch their own plane off");
    }

private:
    void warn(std::string sentence, std::string remedy) {
        findings_.push_back({Severity::Warning, object_.name, std::move(sentence), std::move(remedy)});
    }

    void check(const TextureLayer& layer) {
        const std::string of = " of layer " + inQuotes(layer.name) + " of surface " + inQuotes(surface_.name);
        checkParameter(findings_, object_.name, of, strengthParameter(layer.target), layer.strength);
        checkParameter(findings_, object_.name, of, kTextureOpacity, layer.opacity);
        check(layer.pattern, of);
        if (layer.mask) check(*layer.mask, " of the mask" + of);
        if (layer.ownPlane && layer.target != TextureTarget::Height)
            warn("own plane" + of + " means nothing: the layer is no height", "switch it off");
        // A wave of this height and length is as steep as a proxy can be guided by.
        constexpr double kSteepWave = 1 / 3.14159265358979;
        if (layer.target == TextureTarget::Height && layer.pattern.source != TextureSource::Image &&
            layer.pattern.source != TextureSource::Painted &&
            std::abs(layer.strength) > kSteepWave * layer.pattern.size)
            warn("height" + of + " is large for its size: " + withUnit(layer.strength, "m") +
                     " in repeats of " + withUnit(layer.pattern.size, "m"),
                 "slopes above 45 degrees are cut to that; lower the height or enlarge the size");
    }

    void check(const TexturePattern& pattern, const std::string& of) {
        for (const PatternField& field : kPatternFields)
            checkParameter(findings_, object_.name, of, *field.parameter, pattern.*field.value);
        if (pattern.source == TextureSource::Image && !pattern.image)
            warn("image" + of + " is missing, so the layer is not felt",
                 "choose a picture, or another source");
        if (pattern.source == TextureSource::Painted) return checkPainted(pattern, of);
        if (usesUvs(pattern) && !hasUvs())
            warn("mapping" + of + " needs texture coordinates, which the mesh has not, so it is not felt",
                 "choose the triplanar mapping, or unwrap the mesh in the modelling program");
        if (!usesUvs(pattern) &&
            !(isRotation(pattern.frame.rotation) && pattern.frame.translation.allFinite()))
            findings_.push_back({Severity::Error, object_.name, "mapping frame" + of + " is not a pose",
                                 "set its position and rotation again"});
    }

    void checkPainted(const TexturePattern& pattern, const std::string& of) {
        const std::size_t corners = object_.geometry ? object_.geometry->positions.size() : 0;
        if (!pattern.painted.values)
            warn("nothing is painted" + of + ", so it is not felt", "paint it, or choose another source");
        else if (pattern.painted.values->size() != corners)
            warn("what is painted" + of + " is of a mesh with " +
                     counted(pattern.painted.values->size(), "position") + ", and this one has " +
                     std::to_string(corners) + ", so it is not felt",
                 "paint it again, or undo the change of the mesh");
    }

    bool hasUvs() {
        if (metresPerUv_ < 0) metresPerUv_ = object_.geometry ? metresPerUvOf(*object_.geometry, index_) : 0;
        return metresPerUv_ > 0;
    }

    std::vector<Finding>& findings_;
    const SceneObject& object_;
    Index index_;
    const Surface& surface_;
    double metresPerUv_ = -1;
};

} // namespace

std::string withUnit(double value, std::string_view unit) {
    char buffer[32];
    char* end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 6).ptr;
    return std::string(buffer, end) + (unit.empty() ? "" : " ") + std::string(unit);
}

void checkParameter(std::vector<Finding>& findings, const std::string& object, const std::string& of,
                    const Parameter& parameter, double value) {
    if (parameter.allows(value)) return;
    const std::string what = std::string(parameter.label) + of + " is ";
    if (!std::isfinite(value)) {
        findings.push_back({Severity::Error, object, what + "not a number",
                            "set it, for example to " + withUnit(parameter.initial, parameter.unit)});
        return;
    }
    const std::string range =
        withUnit(parameter.minimum, "") + " to " + withUnit(parameter.maximum, parameter.unit);
    // Where negative values have a meaning, too low is no worse than too high.
    const bool senseless = value < parameter.minimum && parameter.minimum >= 0;
    const Severity severity = senseless ? Severity::Error : Severity::Warning;
    findings.push_back({severity, object, what + withUnit(value, parameter.unit) + ", outside " + range,
                        "set it inside that range; " + withUnit(parameter.clamped(value), parameter.unit) +
                            " is used when touched"});
}

void checkTextures(std::vector<Finding>& findings, const SceneObject& object) {
    for (Index surface = 0; surface < object.surfaces.size(); ++surface)
        TextureChecks(findings, object, surface).run();
}

} // namespace tactum
