#include "core/files/gltf/gltf_standards.h"

#include <algorithm>
#include <cmath>

#include "core/files/images/write_png.h"
#include "core/scene/value_checks.h"

namespace tactum {
namespace {

/// An element of an array of an extension.
const Json* elementOf(const Json* extension, const char* array, const Json* holder, const char* index) {
    const Json* all = extension ? member(*extension, array) : nullptr;
    if (!all || !all->is_array() || !holder) return nullptr;
    const int i = indexIn(*holder, index, all->size());
    return i < 0 ? nullptr : &(*all)[std::size_t(i)];
}

/// The picture of a material's look, which is in the list of copies in our extension of it.
constexpr const char* kLook = "normalTexture";

Index largest(const SceneObject& object) {
    std::vector<std::size_t> triangles(object.surfaces.size(), 0);
    for (const Index surface : object.geometry->surfaceOf)
        ++triangles[surface];
    return Index(std::ranges::max_element(triangles) - triangles.begin());
}

/// The first texture of a property of an MPEG material: its image, and the value of white.
struct MpegValue {
    std::shared_ptr<const TextureImage> image;
    double low = 0, high = 1;
    bool hasRange = false;
};
MpegValue mpegValue(const Json& material, const char* property, const ReadImageAt& imageAt) {
    const Json* all = member(material, property);
    if (!all || !all->is_array() || all->empty()) return {};
    const Json* texture = member((*all)[0], "texture");
    const int index = texture ? indexIn(*texture, "index", std::size_t(1) << 30) : -1;
    if (index < 0) return {};
    MpegValue value{imageAt(index), 0, 1, false};
    const Json* extras = member((*all)[0], "extras");
    const Json* low = extras ? member(*extras, "min") : nullptr;
    const Json* high = extras ? member(*extras, "max") : nullptr;
    if (!low || !high || !low->is_number() || !high->is_number()) return value;
    value.low = low->get<double>(), value.high = high->get<double>();
    value.hasRange = true;
    return value;
}

double meanOf(const TextureImage& image) {
    const auto& coarsest = image.level(image.levelCount() - 1);
    return image.texel(coarsest, 0, 0);
}

} // namespace

StandardCopies::StandardCopies(Json& root, GltfData& data, SurfaceMaps& maps, bool physics)
    : root_(root), data_(data), maps_(maps), mpeg_(mayWrite(kMpegExtension)),
      physics_(physics && mayWrite(kPhysicsExtension)), transform_(mayWrite(kTransformExtension)) {}

bool StandardCopies::mayWrite(const char* extension) const {
    const Json* used = member(root_, "extensionsUsed");
    return !used || !used->is_array() || std::ranges::find(*used, Json(extension)) == used->end();
}

void StandardCopies::use(const char* extension) {
    if (std::ranges::find(wrote_, extension) != wrote_.end()) return;
    wrote_.emplace_back(extension);
    Json& used = root_["extensionsUsed"];
    if (!used.is_array()) used = Json::array();
    used.push_back(extension);
}

/// One texel: MPEG says every value as a texture.
int StandardCopies::valueTexture(double value, double most) {
    const double part = std::clamp(value / most, 0.0, 1.0);
    const std::uint16_t texel = std::uint16_t(std::lround(65535 * part));
    return data_.addSharedTexture(encodePng(1, 1, 1, 16, std::span(&texel, 1)));
}

/// A picture over a rectangle of texture coordinates; v counts downward in glTF.
Json StandardCopies::textureInfo(const std::string& png, const UvCanvas& canvas) {
    Json info{{"index", data_.addSharedTexture(png)}};
    if (canvas.low.isZero(0) && canvas.size == Eigen::Vector2d::Ones()) return info;
    const double top = 1 - canvas.low.y() - canvas.size.y();
    info["extensions"][kTransformExtension] = {
        {"offset", {-canvas.low.x() / canvas.size.x(), -top / canvas.size.y()}},
        {"scale", {1 / canvas.size.x(), 1 / canvas.size.y()}}};
    if (transform_) use(kTransformExtension);
    return info;
}

void StandardCopies::addLook(const SceneObject& object, Index surface, Json& material) {
    if (!canShowBumps(object) || member(material, kLook)) return;
    const std::string png = maps_.normalsPng(object, surface);
    if (png.empty()) return;
    material[kLook] = textureInfo(png, maps_.height(object, surface).canvas);
    material["extensions"][kExtension]["copies"] = {kLook};
}

Json StandardCopies::mpegTexture(Json info, double low, double high, std::string_view unit) {
    return Json::array({{{"texture", std::move(info)},
                         {"type", "High_Resolution"},
                         {"extras", {{"min", low}, {"max", high}, {"unit", unit}}}}});
}

Json StandardCopies::mpegValue(const SceneObject& object, Index surface, double Material::*value,
                               const Parameter& parameter) {
    const FlatPicture felt = maps_.felt(object, surface, value);
    if (felt.image)
        return mpegTexture(textureInfo(encodePng(*felt.image, 16), felt.canvas), felt.low, felt.high,
                           parameter.unit);
    const double same = object.surfaces[surface].material.*value;
    return mpegTexture({{"index", valueTexture(same, parameter.maximum)}}, 0, parameter.maximum,
                       parameter.unit);
}

int StandardCopies::mpegMaterial(const SceneObject& object, Index surface) {
    Json material{{"name", object.surfaces[surface].name},
                  {"stiffness", mpegValue(object, surface, &Material::stiffness, kStiffness)},
                  {"friction", mpegValue(object, surface, &Material::dynamicFriction, kDynamicFriction)}};
    if (const FlatPicture& height = maps_.height(object, surface); height.image)
        material["vibrotactileTexture"] = mpegTexture(
            textureInfo(encodePng(*height.image, 16), height.canvas), height.low, height.high, "m");
    Json& materials = root_["extensions"][kMpegExtension]["materials"];
    materials.push_back(std::move(material));
    use(kMpegExtension);
    return int(materials.size()) - 1;
}

int StandardCopies::physicsMaterial(const Surface& surface) {
    Json& materials = root_["extensions"][kPhysicsExtension]["physicsMaterials"];
    materials.push_back({{"staticFriction", surface.material.staticFriction},
                         {"dynamicFriction", surface.material.dynamicFriction},
                         {"restitution", 0.0},
                         {"frictionCombine", "multiply"}}); // the finger counts as 1
    use(kPhysicsExtension);
    return int(materials.size()) - 1;
}

void StandardCopies::add(const SceneObject& object, int node, int mesh) {
    if (mesh < 0) return;
    const Index surface = largest(object);
    if (mpeg_)
        root_["meshes"][std::size_t(mesh)]["extensions"][kMpegExtension]["hapticMaterialIndex"] =
            mpegMaterial(object, surface);
    if (physics_)
        root_["nodes"][std::size_t(node)]["extensions"][kPhysicsExtension]["collider"] = {
            {"geometry", {{"mesh", mesh}, {"convexHull", false}}},
            {"physicsMaterial", physicsMaterial(object.surfaces[surface])}};
}

std::vector<std::string> copiesIn(const Json& root) {
    std::vector<std::string> names;
    const Json* ours = extensionOf(root);
    const Json* copies = ours ? member(*ours, "copies") : nullptr;
    if (copies && copies->is_array())
        for (const Json& name : *copies)
            if (name == kMpegExtension || name == kPhysicsExtension || name == kTransformExtension)
                names.push_back(name.get<std::string>());
    return names;
}

/// Beside what our writer says by them another program may have put in more.
void eraseCopies(Json& element, const std::vector<std::string>& wrote) {
    for (const std::string& name : wrote) {
        eraseUse(element, name);
        if (!extensionOf(element, name.c_str())) continue;
        Json& copy = element["extensions"][name];
        for (const char* key : {"materials", "hapticMaterialIndex", "physicsMaterials", "collider"})
            copy.erase(key);
        if (copy.empty()) eraseExtension(element, name);
    }
}

void eraseLook(Json& material) {
    const Json* ours = extensionOf(material);
    const Json* copies = ours ? member(*ours, "copies") : nullptr;
    if (!copies) return;
    if (copies->is_array() && std::ranges::find(*copies, Json(kLook)) != copies->end()) material.erase(kLook);
    material["extensions"][kExtension].erase("copies");
}

void readStandards(const Json& root, const Json& node, const Json& mesh, const ReadImageAt& imageAt,
                   Surface& surface, std::vector<std::string>& said) {
    Material& material = surface.material;
    const Json* body = extensionOf(node, kPhysicsExtension);
    const Json* rubs = elementOf(extensionOf(root, kPhysicsExtension), "physicsMaterials",
                                 body ? member(*body, "collider") : nullptr, "physicsMaterial");
    const auto take = [](const Json& from, const char* key, double& value) {
        if (const Json* found = member(from, key); found && found->is_number()) value = found->get<double>();
    };
    if (rubs) {
        material.staticFriction = material.dynamicFriction =
            0.6; // what the extension has where it says nothing
        take(*rubs, "staticFriction", material.staticFriction);
        take(*rubs, "dynamicFriction", material.dynamicFriction);
        said.push_back(std::string("friction is that of ") + kPhysicsExtension + ", against a finger of 1");
    }
    const Json* felt = elementOf(extensionOf(root, kMpegExtension), "materials",
                                 extensionOf(mesh, kMpegExtension), "hapticMaterialIndex");
    if (!felt) return;
    // The extension has no units: without a range of its own, white is a hard surface and a friction of 1.
    constexpr double kHard = 2000, kSlow = 1, kBump = 1e-3;
    const auto number = [&](const char* property, const Parameter& parameter, double white, double& value) {
        const MpegValue found = mpegValue(*felt, property, imageAt);
        if (!found.image) return;
        const double low = found.hasRange ? found.low : 0, high = found.hasRange ? found.high : white;
        value = low + meanOf(*found.image) * (high - low);
        said.push_back(std::string(property) + " of " + kMpegExtension + " is taken as its mean, " +
                       withUnit(value, parameter.unit) + (found.hasRange ? "" : ", as it has no unit"));
    };
    number("stiffness", kStiffness, kHard, material.stiffness);
    const double before = material.dynamicFriction;
    number("friction", kDynamicFriction, kSlow, material.dynamicFriction);
    if (material.dynamicFriction != before && !rubs) material.staticFriction = material.dynamicFriction;
    const MpegValue bumps = mpegValue(*felt, "vibrotactileTexture", imageAt);
    if (!bumps.image) return;
    TextureLayer layer;
    layer.name = bumps.image->name().empty() ? "vibrotactile texture" : bumps.image->name();
    layer.pattern.source = TextureSource::Image;
    layer.pattern.image = bumps.image;
    layer.pattern.mapping = TextureMapping::UvUnit;
    layer.strength = bumps.hasRange ? bumps.high - bumps.low : kBump;
    surface.layers.push_back(std::move(layer));
    said.push_back(std::string("vibrotactileTexture of ") + kMpegExtension + " is taken as heights of " +
                   withUnit(surface.layers.back().strength, "m"));
}

} // namespace tactum
