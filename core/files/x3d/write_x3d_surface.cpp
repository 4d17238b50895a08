#include "core/files/x3d/write_x3d_surface.h"

#include <algorithm>
#include <array>

#include "core/base/numbers.h"
#include "core/files/images/write_png.h"
#include "core/files/x3d/x3d_metadata.h"
#include "core/surface/friction.h"

namespace tactum {
namespace {

/// A number of a surface that H3D reads from a map, and the names of its fields.
struct MapField {
    FlatPicture X3dSurface::*picture;
    std::string_view map, least, most;
    std::string_view ending; ///< of the picture's name
};
constexpr std::array<MapField, 3> kMapFields{
    {{&X3dSurface::stiffness, "stiffnessMap", "minStiffness", "maxStiffness", "stiffness"},
     {&X3dSurface::staticFriction, "staticFrictionMap", "minStaticFriction", "maxStaticFriction",
      "static-friction"},
     {&X3dSurface::dynamicFriction, "dynamicFrictionMap", "minDynamicFriction", "maxDynamicFriction",
      "dynamic-friction"}}};

void writeImage(XmlElement& surface, std::string_view field, const TextureImage& image,
                std::string_view ending, const X3dPictures& pictures) {
    pictures.images.push_back(
        {pictures.stem + "-" + std::string(ending) + ".png", encodePng(image, 8, pictures.progress)});
    XmlElement(surface, "ImageTexture")
        .set("containerField", field)
        .setStrings("url", {pictures.images.back().name})
        .set("repeatS", false)
        .set("repeatT", false);
}

/// What is no number of its range is written as the one that is felt instead.
void writeNumber(XmlElement& set, const Parameter& parameter, double value) {
    XmlElement number(set, "MetadataDouble");
    number.set("containerField", "value").set("name", parameter.key);
    if (!parameter.unit.empty()) // X3D knows no units of metadata
        number.set("reference", "unit " + std::string(parameter.unit));
    number.set("value", parameter.clamped(value));
}

void writeWord(XmlElement& set, std::string_view name, std::string_view word) {
    XmlElement(set, "MetadataString")
        .set("containerField", "value")
        .set("name", name)
        .setStrings("value", {word});
}

void writePattern(XmlElement& set, const TexturePattern& pattern) {
    writeWord(set, "source", kTextureSources[std::size_t(pattern.source)].key);
    if (pattern.image) writeWord(set, "image", pattern.image->name());
    writeWord(set, "mapping", kTextureMappings[std::size_t(pattern.mapping)].key);
    for (const PatternField& field : kPatternFields)
        writeNumber(set, *field.parameter, pattern.*field.value);
}

void writeLayer(XmlElement& metadata, const TextureLayer& layer) {
    XmlElement set(metadata, "MetadataSet");
    set.set("containerField", "value").set("name", "layer");
    writeWord(set, "name", layer.name);
    writeWord(set, "target", kTextureTargets[std::size_t(layer.target)].key);
    writeWord(set, "blend", kTextureBlends[std::size_t(layer.blend)].key);
    writeWord(set, "enabled", layer.enabled ? "true" : "false");
    writeWord(set, "own-plane", layer.ownPlane ? "true" : "false");
    writeNumber(set, strengthParameter(layer.target), layer.strength);
    writeNumber(set, kTextureOpacity, layer.opacity);
    writePattern(set, layer.pattern);
    if (!layer.mask) return;
    XmlElement mask(set, "MetadataSet");
    mask.set("containerField", "value").set("name", "mask");
    writePattern(mask, *layer.mask);
}

/// What H3D has no field for.
void writeMetadata(XmlElement& node, const Surface& surface) {
    XmlElement set(node, "MetadataSet");
    set.set("containerField", "metadata").set("name", kX3dSurfaceSet);
    writeWord(set, "name", surface.name);
    writeNumber(set, kViscosity, surface.material.viscosity);
    writeWord(set, "force-shading", surface.shading.on ? "true" : "false");
    if (surface.shading.on) writeNumber(set, kCreaseAngle, surface.shading.creaseAngle);
    for (const TextureLayer& layer : surface.layers)
        writeLayer(set, layer);
}

std::string_view nodeOf(const X3dSurface& flat, const Surface& surface) {
    if (flat.height.image) return "DepthMapSurface";
    if (flat.hasPictures()) return "HapticTexturesSurface";
    return surface.material.staticFriction > 0 || surface.material.dynamicFriction > 0 ? "FrictionalSurface"
                                                                                       : "SmoothSurface";
}

std::string percent(double part) {
    std::string text;
    appendNumber(text, std::round(part * 1000) / 10);
    return text + " %";
}

/// A map that has no room beside the height leaves its mean.
void loseMaps(X3dSurface& flat) {
    for (const MapField& field : kMapFields) {
        FlatPicture& picture = flat.*field.picture;
        if (!picture.image) continue;
        flat.lost.push_back("the map of " + std::string(field.ending) +
                            " is its mean, for H3D feels height or maps: off by " +
                            percent(std::max(picture.high - picture.mean, picture.mean - picture.low) /
                                    std::max(picture.mean, 1e-9)) +
                            " at most");
        picture.image = nullptr;
    }
}

void keepRounding(X3dSurface& flat) {
    std::string step;
    appendNumber(step, std::round((flat.height.high - flat.height.low) / 255 * 1e9) / 1e3);
    flat.lost.push_back("the height has steps of " + step + " um: H3D reads 8 bits");
}

} // namespace

bool X3dSurface::hasPictures() const {
    return height.image ||
           std::ranges::any_of(kMapFields, [&](auto& field) { return bool((this->*field.picture).image); });
}

const UvCanvas& X3dSurface::canvas() const {
    for (const MapField& field : kMapFields)
        if ((this->*field.picture).image) return (this->*field.picture).canvas;
    return height.canvas;
}

X3dSurface x3dSurfaceOf(const SceneObject& object, Index surface, const Progress& progress) {
    X3dSurface flat;
    const auto quarter = [&](int i) {
        return Flattening{kLargestFlatSide, partOf(progress, 0.25 * i, 0.25 * (i + 1))};
    };
    flat.height = flattenHeight(object, surface, quarter(0));
    flat.stiffness = flattenFelt(object, surface, &Material::stiffness, quarter(1));
    flat.staticFriction = flattenFelt(object, surface, &Material::staticFriction, quarter(2));
    flat.dynamicFriction = flattenFelt(object, surface, &Material::dynamicFriction, quarter(3));
    for (const FlatPicture* picture :
         {&flat.height, &flat.stiffness, &flat.staticFriction, &flat.dynamicFriction})
        for (const std::string& sentence : picture->lost)
            if (std::ranges::find(flat.lost, sentence) == flat.lost.end()) flat.lost.push_back(sentence);
    if (!flat.height.image) return flat;
    loseMaps(flat);
    keepRounding(flat);
    return flat;
}

void writeUnfeltSurface(XmlElement& appearance, const Surface& surface) {
    writeMetadata(appearance, surface);
}

void writeSurface(XmlElement& appearance, const X3dSurface& flat, const Surface& surface,
                  const X3dPictures& pictures) {
    const std::string_view kind = nodeOf(flat, surface);
    XmlElement node(appearance, kind);
    node.set("useRelativeValues", false)
        .set("stiffness", flat.stiffness.mean)
        .set("damping", kDamping.clamped(surface.material.damping));
    if (kind != "SmoothSurface")
        node.set("staticFriction", flat.staticFriction.mean)
            .set("dynamicFriction", flat.dynamicFriction.mean);
    if (flat.height.image) node.set("maxDepth", flat.height.high - flat.height.low).set("whiteIsOut", true);
    for (const MapField& field : kMapFields)
        if (const FlatPicture& picture = flat.*field.picture; picture.image)
            node.set(field.least, picture.low).set(field.most, picture.high);
    writeMetadata(node, surface);
    if (flat.height.image) writeImage(node, "depthMap", *flat.height.image, "height", pictures);
    for (const MapField& field : kMapFields)
        if (const FlatPicture& picture = flat.*field.picture; picture.image)
            writeImage(node, field.map, *picture.image, field.ending, pictures);
}

} // namespace tactum
