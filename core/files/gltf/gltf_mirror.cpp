#include "core/files/gltf/gltf_mirror.h"

#include <cctype>

#include "core/files/gltf/gltf_surface.h"

namespace tactum {
namespace {

constexpr std::string_view kPrefix = "tactum_";
constexpr const char* kLayers = "layers";
constexpr std::string_view kShading = "shading_"; // the one member of ours that has members itself
constexpr int kDeepestText = 16;

/// "staticFriction" as "static_friction": as Blender names a property.
std::string flatKey(std::string_view key) {
    std::string flat;
    for (const char c : key) {
        const auto letter = static_cast<unsigned char>(c);
        if (std::isupper(letter)) flat += '_';
        flat += char(std::tolower(letter));
    }
    return flat;
}

std::string memberKey(std::string_view flat) {
    std::string key;
    for (std::size_t i = 0; i < flat.size(); ++i)
        key += flat[i] == '_' && i + 1 < flat.size()
                   ? char(std::toupper(static_cast<unsigned char>(flat[++i])))
                   : flat[i];
    return key;
}

/// Of pictures and painted values another program changes the places.
Json withoutPlaces(Json layers) {
    for (Json& layer : layers)
        for (const char* part : {"pattern", "mask"})
            if (layer.contains(part) && layer[part].is_object())
                layer[part].erase("texture"), layer[part].erase("painted");
    return layers;
}

/// A program without truth values has numbers for them.
Json truth(const std::string& key, const Json& value) {
    const bool isOne = key == "on" || key == "visible" || key == "locked";
    return isOne && value.is_number() ? Json(value != 0) : value;
}

Json parsedText(const Json& text) {
    if (!text.is_string()) return text;
    bool deep = false;
    const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
        deep |= depth > kDeepestText;
        return !deep;
    };
    Json parsed = Json::parse(text.get<std::string>(), shallow, false);
    return deep || parsed.is_discarded() ? text : parsed; // whoever reads it says that it is no list
}

} // namespace

void addMirror(Json& element, const Json& ours) {
    Json& extras = element["extras"];
    if (extras.is_null()) extras = Json::object();
    if (!extras.is_object()) return;
    const auto put = [&](const std::string& key, const Json& value) {
        extras[std::string(kPrefix) + key] = value;
    };
    for (const auto& [key, value] : ours.items()) {
        if (value.is_number() || value.is_boolean() || value.is_string()) put(flatKey(key), value);
        if (key == kLayers && !value.empty()) put(key, withoutPlaces(value).dump());
        if (key != "shading") continue;
        for (const auto& [inner, each] : value.items())
            put(std::string(kShading) + flatKey(inner), each);
    }
}

void eraseMirror(Json& element) {
    if (!member(element, "extras")) return;
    Json& extras = element["extras"];
    if (!extras.is_object()) return;
    const std::size_t before = extras.size();
    for (auto each = extras.begin(); each != extras.end();)
        each = each.key().starts_with(kPrefix) ? extras.erase(each) : std::next(each);
    if (extras.empty() && before > 0) element.erase("extras");
}

Json mirrored(const Json& element) {
    Json ours = Json::object();
    const Json* extras = member(element, "extras");
    if (!extras || !extras->is_object()) return ours;
    for (const auto& [name, value] : extras->items()) {
        if (!name.starts_with(kPrefix)) continue;
        const std::string_view flat = std::string_view(name).substr(kPrefix.size());
        if (flat == kLayers)
            ours[kLayers] = parsedText(value);
        else if (flat.starts_with(kShading)) {
            const std::string key = memberKey(flat.substr(kShading.size()));
            ours["shading"][key] = truth(key, value);
        } else {
            const std::string key = memberKey(flat);
            ours[key] = truth(key, value);
        }
    }
    return ours;
}

} // namespace tactum
