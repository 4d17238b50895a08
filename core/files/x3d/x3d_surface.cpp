#include "core/files/x3d/x3d_surface.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/text.h"
#include "core/files/readers.h"
#include "core/files/x3d/x3d_metadata.h"
#include "core/scene/value_checks.h"

namespace tactum {
namespace {

using Severity = Finding::Severity;

/// The largest stiffness that H3D knows of a device: what its relative values are parts of.
struct DeviceStiffness {
    const char* node;
    double value; ///< N/m
};
constexpr DeviceStiffness kDevices[] = {{"FalconDevice", 800},
                                        {"ForceDimensionDevice", 1450},
                                        {"VirtuoseDevice", 1450},
                                        {"EntactDevice", 1450},
                                        {"HapticMasterDevice", 10000}};

const std::initializer_list<std::string_view> kSurfaces = {
    "SmoothSurface",   "FrictionalSurface",  "DepthMapSurface",    "HapticTexturesSurface",
    "MagneticSurface", "OpenHapticsSurface", "MultiDeviceSurface",
};
const std::initializer_list<std::string_view> kTextures = {"ImageTexture", "MovieTexture", "PixelTexture",
                                                           "GeneratedTexture", "MultiTexture"};

const MaterialField& fieldOf(const Parameter& parameter) {
    return *std::ranges::find(kMaterialFields, &parameter, &MaterialField::parameter);
}

/// A child texture in a named role.
X3dNode roleOf(const X3dDocument& document, X3dNode node, std::string_view role) {
    for (const X3dNode each : node.children()) {
        const bool texture = std::ranges::find(kTextures, std::string_view(each.name())) != kTextures.end();
        if (texture && role == each.attribute("containerField").value()) return document.resolved(each);
    }
    return {};
}

} // namespace

X3dSurfaces::X3dSurfaces(const X3dDocument& document, const Source& source, std::vector<Finding>& findings)
    : document_(document), findings_(findings), pictures_(source.path().parent_path()) {
    for (const DeviceStiffness& device : kDevices)
        if (!document.all({device.node}).empty()) {
            deviceStiffness_ = device.value;
            device_ = device.node;
            break;
        }
    for (const X3dNode settings : document.all({"GlobalSettings"}))
        if (const X3dNode options = document.child(settings, {"HapticsOptions"}))
            touchable_ = options.attribute("touchableFace").as_string("AS_GRAPHICS");
}

void X3dSurfaces::say(Severity severity, const Surface& surface, const std::string& sentence,
                      const std::string& remedy) {
    const std::string whole = "surface " + inQuotes(surface.name) + ": " + sentence;
    const bool said = std::ranges::any_of(findings_, [&](const Finding& f) { return f.sentence == whole; });
    if (!said) findings_.push_back({severity, "", whole, remedy});
}

std::optional<double> X3dSurfaces::proxyRadius() {
    for (const X3dNode renderer : document_.all({"RuspiniRenderer"})) {
        const double radius = document_.number(renderer, "proxyRadius", 0.0025);
        const double safe = kProxyRadius.clamped(radius);
        if (safe != radius)
            findings_.push_back({Severity::Warning, "",
                                 "proxy radius " + withUnit(radius, "m") + " is out of range",
                                 "taken as " + withUnit(safe, "m")});
        return safe;
    }
    return std::nullopt;
}

Surface X3dSurfaces::surfaceOf(X3dNode shape) {
    Surface surface = namedSurface("surface");
    const X3dNode geometryless = document_.child(shape, {"Appearance"});
    const X3dNode material = geometryless ? document_.child(geometryless, {"Material"}) : X3dNode();
    for (const X3dNode named : {geometryless, material})
        if (named && named.attribute("DEF") && surface.name == "surface")
            surface.name = named.attribute("DEF").value();
    if (material) {
        const auto colour = document_.tuple(material, "diffuseColor", {0.8, 0.8, 0.8});
        surface.colour = Vec3(colour.data()).cwiseMax(0).cwiseMin(1).cast<float>();
    }
    const X3dNode haptic = geometryless ? document_.child(geometryless, kSurfaces) : X3dNode();
    readOurs(haptic ? haptic : geometryless, surface);
    if (haptic) feel(haptic, surface);
    for (const X3dNode geometry : shape.children())
        if (const auto sides = sidesOf(document_.resolved(geometry), bool(haptic))) surface.sides = *sides;
    if (!haptic && X3dDocument::metadata(geometryless, kX3dSurfaceSet, "name")) surface.sides = Sides::None;
    return surface;
}

/// What our writer puts into metadata, for H3D has no field for it.
void X3dSurfaces::readOurs(X3dNode node, Surface& surface) {
    const auto name = X3dDocument::metadata(node, kX3dSurfaceSet, "name");
    if (!name) return;
    surface.name = *name;
    const auto number = [&](const Parameter& parameter, double& value) {
        if (const auto found = document_.metadataNumber(node, kX3dSurfaceSet, parameter.key))
            value = kept(parameter, *found, surface);
    };
    number(kViscosity, surface.material.viscosity);
    surface.shading.on = X3dDocument::metadata(node, kX3dSurfaceSet, "force-shading") == "true";
    number(kCreaseAngle, surface.shading.creaseAngle);
}

/// H3D feels what is drawn where it says nothing else: back faces are neither when the geometry is solid.
std::optional<Sides> X3dSurfaces::sidesOf(X3dNode geometry, bool haptic) const {
    if (!geometry || geometry.name() == std::string_view("Appearance")) return std::nullopt;
    const X3dNode options = document_.child(geometry, {"HapticsOptions"});
    std::string word = options ? options.attribute("touchableFace").as_string("AS_GRAPHICS") : touchable_;
    if (word.empty() && haptic) word = "AS_GRAPHICS";
    if (word == "AS_GRAPHICS") word = X3dDocument::flag(geometry, "solid", true) ? "FRONT" : "";
    return word == "FRONT" ? Sides::Front : word == "BACK" ? Sides::Back : Sides::Both;
}

double X3dSurfaces::kept(const Parameter& parameter, double value, const Surface& surface) {
    const double safe = parameter.clamped(value);
    if (safe != value)
        say(Severity::Warning, surface,
            lowerCase(parameter.label) + " " + withUnit(value, parameter.unit) + " is out of range",
            "taken as " + withUnit(safe, parameter.unit));
    return safe;
}

double X3dSurfaces::stiffnessOf(X3dNode node, const char* field, double initial, const Surface& surface) {
    const bool openHaptics = std::string_view(node.name()) == "MagneticSurface" ||
                             std::string_view(node.name()) == "OpenHapticsSurface";
    const double value = document_.number(node, field, initial);
    if (!openHaptics && !X3dDocument::flag(node, "useRelativeValues", true)) return value;
    say(Severity::Note, surface,
        std::string(field) + " " + withUnit(value, "") + " is a part of what the device can do",
        "multiplied by " + withUnit(deviceStiffness_, "N/m") + ", the most of " + device_);
    return value * deviceStiffness_;
}

/// Where sliding holds back more than standing does, H3D's proxy stops at once: it holds like the larger one.
void X3dSurfaces::setFriction(Surface& surface, double fixed, double sliding) {
    if (sliding > fixed)
        say(Severity::Note, surface,
            "dynamic friction " + withUnit(sliding, "") + " is above static friction " + withUnit(fixed, ""),
            "static friction raised to it, which feels as it does in H3D");
    surface.material.staticFriction = kept(kStaticFriction, std::max(fixed, sliding), surface);
    surface.material.dynamicFriction = kept(kDynamicFriction, sliding, surface);
}

void X3dSurfaces::feel(X3dNode node, Surface& surface) {
    const std::string_view kind = node.name();
    if (kind == "MultiDeviceSurface") {
        say(Severity::Note, surface, "has a feel for each of several devices", "that of the first one taken");
        if (const X3dNode first = document_.child(node, kSurfaces);
            first && first != node && first.name() != std::string_view("MultiDeviceSurface"))
            feel(first, surface);
        return;
    }
    const double stiffness = stiffnessOf(node, "stiffness", 0.5, surface);
    surface.material.stiffness = kept(kStiffness, stiffness, surface);
    surface.material.damping = kept(kDamping, document_.number(node, "damping", 0), surface);
    if (kind != "SmoothSurface")
        setFriction(surface, document_.number(node, "staticFriction", 0.1),
                    document_.number(node, "dynamicFriction", 0.4));
    if (kind == "DepthMapSurface") depthMap(node, surface);
    if (kind == "HapticTexturesSurface") {
        const bool relative = X3dDocument::flag(node, "useRelativeValues", true);
        parameterMap(node, surface, "Stiffness", TextureTarget::Stiffness, fieldOf(kStiffness),
                     relative ? deviceStiffness_ : 1);
        parameterMap(node, surface, "StaticFriction", TextureTarget::StaticFriction, fieldOf(kStaticFriction),
                     1);
        parameterMap(node, surface, "DynamicFriction", TextureTarget::DynamicFriction,
                     fieldOf(kDynamicFriction), 1);
        if (roleOf(document_, node, "dampingMap"))
            say(Severity::Warning, surface, "has a map of damping",
                "left out: damping is even over a surface");
        if (surface.material.dynamicFriction > surface.material.staticFriction)
            setFriction(surface, surface.material.staticFriction, surface.material.dynamicFriction);
    }
    const bool magnetic = kind == "MagneticSurface" || X3dDocument::flag(node, "magnetic", false);
    if (magnetic)
        say(Severity::Warning, surface,
            "pulls the finger from " + withUnit(document_.number(node, "snapDistance", 0.01), "m") + " away",
            "left out: surfaces here only push");
}

std::optional<TextureLayer> X3dSurfaces::layerOf(X3dNode texture) {
    for (const std::string& url : X3dDocument::strings(texture, "url")) {
        MtlBump picture;
        picture.file = url;
        std::vector<Finding> said;
        auto layer = pictures_.layerOf(picture, said);
        for (Finding& finding : said) // the rest is about material libraries: here heights have a unit
            if (finding.severity != Severity::Note) findings_.push_back(std::move(finding));
        if (layer) return layer;
    }
    return std::nullopt;
}

void X3dSurfaces::depthMap(X3dNode node, Surface& surface) {
    const X3dNode texture = roleOf(document_, node, "depthMap");
    if (!texture) return;
    auto layer = layerOf(texture);
    if (!layer)
        return say(Severity::Warning, surface, "its depth map cannot be read",
                   "left out; choose a picture for it");
    const double sign = X3dDocument::flag(node, "whiteIsOut", true) ? 1 : -1;
    layer->strength = kept(kTextureHeight, sign * document_.number(node, "maxDepth", 0.001), surface);
    surface.layers.push_back(std::move(*layer));
}

/// From `least` (black) to `most` (white): the material has the lower end, and the layer adds a part of it. A
/// layer adds ten times at most, so the lower end is never below an eleventh of the upper one.
void X3dSurfaces::parameterMap(X3dNode node, Surface& surface, const char* what, TextureTarget target,
                               const MaterialField& field, double unit) {
    std::string role = std::string(what) + "Map";
    role[0] = char(std::tolower(role[0]));
    const X3dNode texture = roleOf(document_, node, role);
    if (!texture) return;
    auto layer = layerOf(texture);
    if (!layer)
        return say(Severity::Warning, surface, "its " + role + " cannot be read",
                   "left out; choose a picture for it");
    const double least = unit * document_.number(node, ("min" + std::string(what)).c_str(), 0),
                 most = unit * document_.number(node, ("max" + std::string(what)).c_str(), 1);
    const double low = kept(*field.parameter, std::max(least, most / (1 + kTextureRatio.maximum)), surface);
    if (low != least)
        say(Severity::Note, surface, role + " goes down to " + withUnit(least, field.parameter->unit),
            "it ends at " + withUnit(low, field.parameter->unit) + ", as low as a layer can go");
    surface.material.*field.value = low;
    layer->target = target;
    layer->strength = low > 0 ? kTextureRatio.clamped(most / low - 1) : 0;
    surface.layers.push_back(std::move(*layer));
}

} // namespace tactum
