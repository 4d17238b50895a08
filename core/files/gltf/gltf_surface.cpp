#include "core/files/gltf/gltf_surface.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactum {
namespace {

constexpr std::array<NamedChoice, 2> kNormalSources{{{"file", "File"}, {"computed", "Computed"}}};

/// Reads the members of one object; `where` names it in complaints.
class Members {
public:
    Members(const Json& object, std::string where, std::vector<std::string>& complaints)
        : object_(object), where_(std::move(where)), complaints_(complaints) {
        if (!object.is_object()) complain("is not an object");
    }

    void operator()(const char* key, bool& value) { take(key, &Json::is_boolean, "true or false", value); }
    void operator()(const char* key, double& value) { take(key, &Json::is_number, "a number", value); }
    void operator()(const char* key, std::string& value) {
        if (take(key, &Json::is_string, "a text", value)) value = printable(value, kLongestName);
    }
    template <class Choice, std::size_t N>
    void operator()(const char* key, Choice& value, const std::array<NamedChoice, N>& choices) {
        std::string word;
        if (!take(key, &Json::is_string, "a word", word)) return;
        for (std::size_t i = 0; i < N; ++i)
            if (choices[i].key == word) return void(value = Choice(i));
        complain(std::string(key) + " has the unknown word " + inQuotes(word));
    }
    template <class Table, class Values> void table(const Table& fields, Values& values) {
        for (const auto& field : fields)
            (*this)(jsonKey(field.parameter->key).c_str(), values.*field.value);
    }
    /// The numbers of an array of exactly N.
    template <std::size_t N> bool operator()(const char* key, std::array<double, N>& values) {
        const Json* found = member(object_, key);
        if (!found) return false;
        const bool fits = found->is_array() && found->size() == N &&
                          std::ranges::all_of(*found, [](const Json& each) { return each.is_number(); });
        if (fits)
            for (std::size_t i = 0; i < N; ++i)
                values[i] = (*found)[i].get<double>();
        else
            complain(std::string(key) + " is not a list of " + std::to_string(N) + " numbers");
        return fits;
    }
    const Json* object(const char* key) const { return member(object_, key); }
    std::string inside(const std::string& key) const { return where_ + "." + key; }
    void complain(const std::string& what) { complaints_.push_back(where_ + " " + what); }
    std::vector<std::string>& complaints() { return complaints_; }

private:
    template <class T>
    bool take(const char* key, bool (Json::*is)() const noexcept, const char* kind, T& value) {
        if (!object_.is_object()) return false;
        const auto found = object_.find(key);
        if (found == object_.end()) return false;
        if (!((*found).*is)()) {
            complain(std::string(key) + " is not " + kind);
            return false;
        }
        value = found->get<T>();
        return true;
    }

    const Json& object_;
    std::string where_;
    std::vector<std::string>& complaints_;
};

template <class Table, class Values> void putTable(Json& to, const Table& fields, const Values& values) {
    for (const auto& field : fields)
        to[jsonKey(field.parameter->key)] = values.*field.value;
}

Json patternJson(const TexturePattern& pattern, const WriteShared& shared) {
    Json json{{"source", kTextureSources[std::size_t(pattern.source)].key},
              {"mapping", kTextureMappings[std::size_t(pattern.mapping)].key},
              {"frame", poseJson(pattern.frame)}};
    putTable(json, kPatternFields, pattern);
    if (pattern.image) json["texture"] = {{"index", shared.textureOf(pattern.image)}};
    if (pattern.painted.values && pattern.painted.values->size() > 0)
        json["painted"] = shared.paintOf(pattern.painted.values);
    return json;
}

void readPose(Members parts, Pose& pose) {
    std::array<double, 3> t{};
    std::array<double, 4> r{};
    if (parts("translation", t)) pose.translation = Vec3(t.data());
    if (!parts("rotation", r)) return;
    const Quat rotation(r[3], r[0], r[1], r[2]);
    if (!(rotation.norm() > 1e-6)) return parts.complain("has a rotation of no length");
    pose.rotation = unitLength(rotation);
}

void readPose(Members& members, const char* key, Pose& pose) {
    const Json* found = members.object(key);
    if (!found) return;
    readPose(Members(*found, members.inside(key), members.complaints()), pose);
}

void readPattern(Members& members, const ReadShared& shared, TexturePattern& pattern) {
    members("source", pattern.source, kTextureSources);
    members("mapping", pattern.mapping, kTextureMappings);
    members.table(kPatternFields, pattern);
    readPose(members, "frame", pattern.frame);
    if (const Json* painted = members.object("painted")) pattern.painted.values = shared.paintAt(*painted);
    const Json* texture = members.object("texture");
    if (!texture) return;
    pattern.image = shared.imageAt(indexIn(*texture, "index", std::size_t(1) << 30));
}

Json layerJson(const TextureLayer& layer, const WriteShared& shared) {
    return {{"name", layer.name},
            {"enabled", layer.enabled},
            {"pattern", patternJson(layer.pattern, shared)},
            {"target", kTextureTargets[std::size_t(layer.target)].key},
            {"strength", layer.strength},
            {"blend", kTextureBlends[std::size_t(layer.blend)].key},
            {"opacity", layer.opacity},
            {"mask", layer.mask ? patternJson(*layer.mask, shared) : Json(nullptr)},
            {"ownPlane", layer.ownPlane}};
}

TextureLayer readLayer(Members members, const ReadShared& shared) {
    TextureLayer layer;
    members("name", layer.name);
    members("enabled", layer.enabled);
    members("target", layer.target, kTextureTargets);
    layer.strength = strengthParameter(layer.target).initial;
    members("strength", layer.strength);
    members("blend", layer.blend, kTextureBlends);
    members("opacity", layer.opacity);
    members("ownPlane", layer.ownPlane);
    if (const Json* pattern = members.object("pattern")) {
        Members parts(*pattern, members.inside("pattern"), members.complaints());
        readPattern(parts, shared, layer.pattern);
    }
    if (const Json* mask = members.object("mask")) {
        Members parts(*mask, members.inside("mask"), members.complaints());
        readPattern(parts, shared, layer.mask.emplace());
    }
    return layer;
}

const Json* versionIn(const Json& root) {
    const Json* ours = extensionOf(root);
    const auto found = ours ? ours->find("version") : Json::const_iterator();
    return ours && found != ours->end() ? &*found : nullptr;
}

std::string textOf(const Json& version) {
    return version.is_string() ? version.get<std::string>() : version.dump();
}

/// -1 for what is no number.
std::int64_t majorOf(const std::string& version) {
    std::int64_t major = -1;
    return parseNumber(version.substr(0, version.find('.')), major) ? major : -1;
}

} // namespace

int paintNumber(std::string_view attribute) {
    std::int64_t number = -1;
    if (!attribute.starts_with(kPaintAttribute)) return -1;
    const bool isOne = parseNumber(attribute.substr(kPaintAttribute.size()), number);
    return isOne && number >= 0 && number < kMaxPaints ? int(number) : -1;
}

const Json* member(const Json& object, const char* key) {
    if (!object.is_object()) return nullptr;
    const auto found = object.find(key);
    return found == object.end() || found->is_null() ? nullptr : &*found;
}

const Json* extensionOf(const Json& element, const char* name) {
    const Json* all = member(element, "extensions");
    const Json* found = all ? member(*all, name) : nullptr;
    return found && found->is_object() ? found : nullptr;
}

void eraseExtension(Json& element, const std::string& name) {
    if (!element.is_object() || !member(element, "extensions")) return;
    Json& all = element["extensions"];
    if (all.is_object()) all.erase(name);
    if (all.empty()) element.erase("extensions");
}

void eraseUse(Json& root, const std::string& name) {
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
        if (!root.is_object() || !member(root, list)) continue;
        Json& used = root[list];
        if (used.is_array()) used.erase(std::remove(used.begin(), used.end(), Json(name)), used.end());
        if (used.empty()) root.erase(list);
    }
}

int indexIn(const Json& object, const char* key, std::size_t end) {
    const Json* found = member(object, key);
    if (!found || !found->is_number_integer()) return -1;
    const auto index = found->get<std::int64_t>();
    return index >= 0 && std::uint64_t(index) < end ? int(index) : -1;
}

std::size_t sizeIn(const Json& object, const char* key) {
    const Json* found = member(object, key);
    if (!found || !found->is_number_integer()) return 0;
    return std::size_t(std::max(found->get<std::int64_t>(), std::int64_t(0)));
}

std::optional<std::string> laterFormat(const Json& root) {
    const Json* version = versionIn(root);
    if (!version || !(majorOf(textOf(*version)) > kFormatMajor)) return std::nullopt;
    return printable(textOf(*version), 20);
}

std::optional<std::string> strangeVersion(const Json& root) {
    const Json* version = versionIn(root);
    if (!version || laterFormat(root)) return std::nullopt;
    const std::string text = textOf(*version);
    const std::size_t point = text.find('.');
    std::int64_t minor = -1;
    const bool usual = version->is_string() && point != std::string::npos && majorOf(text) >= 1 &&
                       parseNumber(text.substr(point + 1), minor) && minor >= 0;
    return usual ? std::nullopt : std::optional(inQuotes(printable(text, 20)));
}

std::string jsonKey(std::string_view key) {
    std::string text;
    for (std::size_t i = 0; i < key.size(); ++i)
        text += key[i] == '-' && i + 1 < key.size() ? char(key[++i] - 'a' + 'A') : key[i];
    return text;
}

Json vectorJson(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

Json quaternionJson(const Quat& q) {
    return {q.x(), q.y(), q.z(), q.w()};
}

Json poseJson(const Pose& pose) {
    return {{"translation", vectorJson(pose.translation)}, {"rotation", quaternionJson(pose.rotation)}};
}

Json nodePoseJson(const Pose& pose) {
    const bool fits = pose.rotation.coeffs().cwiseAbs().maxCoeff() <= 1;
    return poseJson(fits ? pose : Pose{pose.rotation.normalized(), pose.translation});
}

std::optional<Pose> exactPose(const Json& ours, const Pose& near) {
    constexpr double kSame = 1e-6;
    const Json* json = member(ours, "pose");
    if (!json) return std::nullopt;
    std::vector<std::string> complaints;
    Pose pose;
    readPose(Members(*json, "pose", complaints), pose);
    const bool same = (pose.translation - near.translation).norm() < kSame * (1 + near.translation.norm()) &&
                      pose.rotation.angularDistance(near.rotation) < kSame;
    return same ? std::optional(pose) : std::nullopt;
}

Json surfaceJson(const Surface& surface, const WriteShared& shared) {
    Json json{{"sides", nameOf(surface.sides)},
              {"shading",
               {{"on", surface.shading.on},
                {"normals", kNormalSources[std::size_t(surface.shading.normals)].key},
                {jsonKey(kCreaseAngle.key), surface.shading.creaseAngle}}},
              {"layers", Json::array()}};
    if (!surface.visible) json["visible"] = false;
    if (surface.locked) json["locked"] = true;
    putTable(json, kMaterialFields, surface.material);
    for (const TextureLayer& layer : surface.layers)
        json["layers"].push_back(layerJson(layer, shared));
    return json;
}

void readSurfaceJson(const Json& json, const char* where, const ReadShared& shared, Surface& surface,
                     std::vector<std::string>& complaints) {
    Members members(json, where, complaints);
    members.table(kMaterialFields, surface.material);
    std::string sides(nameOf(surface.sides));
    members("sides", sides);
    if (const auto named = sidesNamed(sides))
        surface.sides = *named;
    else
        members.complain("sides has the unknown word " + inQuotes(sides));
    members("visible", surface.visible);
    members("locked", surface.locked);
    if (const Json* shading = members.object("shading")) {
        Members parts(*shading, members.inside("shading"), complaints);
        parts("on", surface.shading.on);
        parts("normals", surface.shading.normals, kNormalSources);
        parts(jsonKey(kCreaseAngle.key).c_str(), surface.shading.creaseAngle);
    }
    const Json* layers = members.object("layers");
    if (!layers) return;
    if (!layers->is_array()) return members.complain("layers is not a list");
    for (std::size_t i = 0; i < layers->size(); ++i)
        surface.layers.push_back(readLayer(
            Members((*layers)[i], members.inside("layers[" + std::to_string(i) + "]"), complaints), shared));
}

} // namespace tactum
