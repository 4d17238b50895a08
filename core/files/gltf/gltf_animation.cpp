#include "core/files/gltf/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files/gltf/gltf_surface.h"
#include "core/geometry/soup_builder.h"
#include "core/motion/motion_build.h"

namespace tactum {
namespace {

// In the order of Interpolation, as glTF spells them.
constexpr std::array<const char*, 3> kInterpolations{"STEP", "LINEAR", "CUBICSPLINE"};

/// Single precision, and strictly rising as glTF wants it: a jump is two keys next to each other.
std::vector<float> risingTimes(const std::vector<double>& times) {
    std::vector<float> rising;
    for (const double time : times) {
        const float next = float(time);
        rising.push_back(rising.empty() || next > rising.back()
                             ? next
                             : std::nextafter(rising.back(), std::numeric_limits<float>::infinity()));
    }
    return rising;
}

/// A cubic needs two keys; with one the body stands still.
template <class Value> Interpolation drawnAs(const Track<Value>& track) {
    return track.times.size() < 2 ? Interpolation::Step : track.interpolation;
}

template <class Value> std::vector<float> keyValues(const Track<Value>& track) {
    std::vector<float> values;
    const auto put = [&](const Value& value) {
        for (const double number : value)
            values.push_back(float(number));
    };
    for (std::size_t key = 0; key < track.values.size(); ++key) {
        if (drawnAs(track) != Interpolation::CubicSpline) {
            put(track.values[key]);
            continue;
        }
        put(track.arriving[key]), put(track.values[key]), put(track.leaving[key]);
    }
    return values;
}

template <class Value>
void addChannel(GltfData& data, Json& animation, const Track<Value>& track, int node, const char* path,
                const char* type) {
    if (track.times.empty()) return;
    const int input = data.addNumbers(risingTimes(track.times), "SCALAR", true);
    const int output = data.addNumbers(keyValues(track), type);
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back({{"input", input},
                                     {"output", output},
                                     {"interpolation", kInterpolations[std::size_t(drawnAs(track))]}});
}

template <class Value> Json rows(const std::vector<Value>& values) {
    Json all = Json::array();
    for (const Value& value : values)
        for (const double number : value)
            all.push_back(number);
    return all;
}

template <class Value> Json trackJson(const Track<Value>& track) {
    Json json{{"interpolation", kInterpolations[std::size_t(track.interpolation)]},
              {"times", track.times},
              {"values", rows(track.values)}};
    if (track.interpolation == Interpolation::CubicSpline) {
        json["arriving"] = rows(track.arriving);
        json["leaving"] = rows(track.leaving);
    }
    return json;
}

bool readNumbers(const Json& object, const char* key, std::vector<double>& numbers) {
    const Json* found = member(object, key);
    if (!found || !found->is_array()) return false;
    for (const Json& each : *found) {
        if (!each.is_number()) return false;
        numbers.push_back(each.get<double>());
    }
    return std::ranges::all_of(numbers, isCoordinate); // also of times: a motion of eleven days
}

template <class Value>
bool readRows(const Json& object, const char* key, std::size_t count, std::vector<Value>& values) {
    constexpr std::size_t kWidth = Value::RowsAtCompileTime;
    std::vector<double> numbers;
    if (!readNumbers(object, key, numbers) || numbers.size() != kWidth * count) return false;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(Value(numbers.data() + i * kWidth));
    return true;
}

template <class Value> bool readTrack(const Json& json, Track<Value>& track) {
    const Json* word = member(json, "interpolation");
    const auto named = std::ranges::find_if(
        kInterpolations, [&](const char* each) { return word && word->is_string() && *word == each; });
    if (named == kInterpolations.end() || !readNumbers(json, "times", track.times)) return false;
    track.interpolation = Interpolation(named - kInterpolations.begin());
    const std::size_t keys = track.times.size();
    const bool rising = std::ranges::is_sorted(track.times) && (keys == 0 || track.times.front() >= 0);
    if (!rising || !readRows(json, "values", keys, track.values)) return false;
    return track.interpolation != Interpolation::CubicSpline ||
           (readRows(json, "arriving", keys, track.arriving) &&
            readRows(json, "leaving", keys, track.leaving));
}

bool areRotations(const std::vector<QuatCoefficients>& values) {
    return std::ranges::all_of(values, [](const auto& q) { return q.norm() > 1e-6; });
}

} // namespace

void addAnimation(GltfData& data, const Motion& motion, int node, const std::string& name) {
    Json animation{{"name", name}, {"channels", Json::array()}, {"samplers", Json::array()}};
    addChannel(data, animation, motion.translation, node, "translation", "VEC3");
    addChannel(data, animation, motion.rotation, node, "rotation", "VEC4");
    if (!animation["channels"].empty()) data.add("animations", std::move(animation));
}

Json motionJson(const Motion& motion) {
    return {{"duration", motion.duration},
            {"translation", trackJson(motion.translation)},
            {"rotation", trackJson(motion.rotation)}};
}

std::optional<Motion> motionOf(const Json& json) {
    Track<Vec3> translation;
    Track<QuatCoefficients> rotation;
    const Json* duration = member(json, "duration");
    const Json* slides = member(json, "translation");
    const Json* turns = member(json, "rotation");
    if (!duration || !duration->is_number() || !slides || !turns) return std::nullopt;
    const double seconds = duration->get<double>();
    if (!(seconds >= 0) || !isCoordinate(seconds) || !readTrack(*slides, translation) ||
        !readTrack(*turns, rotation) || !areRotations(rotation.values))
        return std::nullopt;
    return makeMotion(std::move(translation), std::move(rotation), seconds);
}

} // namespace tactum
