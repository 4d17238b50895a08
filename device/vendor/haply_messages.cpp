#include "device/vendor/haply_messages.h"

#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace tactum::haply {
namespace {

using Json = nlohmann::json;

constexpr double kFarthest = 10;       ///< m, and beyond it no arm reaches
constexpr double kFastestSaid = 100;   ///< m/s
constexpr double kStrongestSaid = 1e3; ///< N

// Theirs: x right, y forward, z up. D: x right, y up, z toward the user.
Vec3 haplyInD(const Vec3& theirs) {
    return {theirs.x(), theirs.z(), -theirs.y()};
}
Vec3 asHaplys(const Vec3& force_D) {
    return {force_D.x(), -force_D.z(), force_D.y()};
}

/// The member, or nothing that has members.
const Json& member(const Json& object, const char* name) {
    static const Json nothing;
    if (!object.is_object()) return nothing;
    const auto found = object.find(name);
    return found == object.end() ? nothing : *found;
}

/// Three numbers that can be; nothing when one is missing, for what is left out might be anything.
std::optional<Vec3> vector(const Json& object, double most) {
    Vec3 value;
    constexpr const char* kNames[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
        const Json& number = member(object, kNames[i]);
        if (!number.is_number()) return {};
        value[i] = number.get<double>();
        if (!(std::abs(value[i]) <= most)) return {};
    }
    return value;
}

std::uint32_t buttonsOf(const Json& message) {
    std::uint32_t held = 0;
    for (const char* kind : {"wireless_verse_grip", "verse_grip"}) {
        const Json& grips = member(message, kind);
        if (!grips.is_array() || grips.empty()) continue;
        const Json& buttons = member(member(grips.front(), "state"), "buttons");
        std::uint32_t bit = 1;
        for (const char* name : {"a", "b", "c"}) {
            const Json& button = member(buttons, name);
            if (button.is_boolean() && button.get<bool>()) held |= bit;
            bit <<= 1;
        }
    }
    return held;
}

State stateOf(const Json& device) {
    State state;
    state.id = member(device, "device_id").get<std::string>();
    const Json& said = member(device, "state");
    const auto position = vector(member(said, "cursor_position"), kFarthest);
    const auto velocity = vector(member(said, "cursor_velocity"), kFastestSaid);
    state.sample.valid = position.has_value();
    if (position) state.sample.position = haplyInD(*position);
    if (velocity) state.sample.velocity = haplyInD(*velocity);
    const auto force = vector(member(said, "current_cursor_force"), kStrongestSaid);
    if (force) state.force = haplyInD(*force);
    const Json& preset = member(member(device, "config"), "preset");
    if (preset.is_string()) state.preset = preset.get<std::string>();
    const Json& calibrated = member(member(device, "status"), "calibrated");
    state.calibrated = !calibrated.is_boolean() || calibrated.get<bool>();
    return state;
}

} // namespace

std::vector<State> read(std::string_view text) {
    const Json message = Json::parse(text, nullptr, false);
    const Json& devices = member(message, "inverse3");
    std::vector<State> states;
    if (!devices.is_array()) return states;
    const std::uint32_t buttons = buttonsOf(message);
    for (const Json& device : devices) {
        if (!member(device, "device_id").is_string()) continue;
        states.push_back(stateOf(device));
        states.back().sample.buttons = buttons;
    }
    return states;
}

Version versionOf(std::string_view answer) {
    const Json said = Json::parse(answer, nullptr, false);
    Version version;
    for (const char* name : {"git_tag", "project_version"}) {
        const Json& text = member(said, name);
        Version found;
        if (text.is_string() &&
            std::sscanf(text.get<std::string>().c_str(), "%d.%d", &found.major, &found.minor) == 2)
            version = found;
    }
    return version;
}

std::string write(const std::string& id, const Vec3& force_D, Asking asking, Version version) {
    const Vec3 force = asHaplys(force_D);
    const bool newWords = version >= kNewWords;
    const Json numbers{{"x", force.x()}, {"y", force.y()}, {"z", force.z()}};
    Json device{
        {"device_id", id},
        {"commands", {{"set_cursor_force", Json::object({{newWords ? "vector" : "values", numbers}})}}}};
    Json message;
    if (asking == Asking::Workspace) {
        device["configure"]["preset"] = newWords ? Json::object({{"preset", kPreset}}) : Json(kPreset);
        message["session"]["configure"] = {{"profile", {{"name", "tactum"}}},
                                           {"basis", {{"permutation", "XYZ"}}}};
    }
    if (asking != Asking::Nothing) message["session"]["force_render_full_state"] = Json::object();
    message["inverse3"] = Json::array({device});
    return message.dump(-1, ' ', true, Json::error_handler_t::replace);
}

} // namespace tactum::haply
