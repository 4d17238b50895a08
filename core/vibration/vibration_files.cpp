#include "core/vibration/vibration_files.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <ctime>

#include <nlohmann/json.hpp>

#include "core/base/numbers.h"
#include "core/vibration/envelope.h"

namespace tactum {
namespace {

using Json = nlohmann::ordered_json;

std::string textOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

/// What full scale is; a vibration of nothing has one, too.
double scaleOf(const Vibration& vibration) {
    const double peak = peakOf(vibration);
    return peak > 0 ? peak : 1;
}

std::string saidOf(const Vibration& vibration, const std::string& source) {
    std::string said = "Vibration of a touch of " + source + "; full scale is ";
    appendNumber(said, float(scaleOf(vibration)));
    return said + " N";
}

/// Four digits after the point: finer than any actuator.
double rounded(double value) {
    return std::round(value * 1e4) / 1e4;
}

void appendLittle(std::string& out, std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
        out += char(value >> (8 * i));
}

/// A part of a RIFF file, padded to an even length.
void appendChunk(std::string& out, const char* name, const std::string& bytes) {
    out += name;
    appendLittle(out, std::uint32_t(bytes.size()), 4);
    out += bytes;
    if (bytes.size() % 2 == 1) out += '\0';
}

std::string wavOf(const Vibration& vibration, const std::string& said) {
    constexpr int kPcm = 1, kChannels = 1, kBytes = 2;
    const auto rate = std::uint32_t(vibration.rate);
    std::string format, samples, comment, body = "WAVE";
    appendLittle(format, kPcm, 2);
    appendLittle(format, kChannels, 2);
    appendLittle(format, rate, 4);
    appendLittle(format, rate * kBytes, 4);
    appendLittle(format, kBytes, 2);
    appendLittle(format, 8 * kBytes, 2);
    const double scale = 32767 / scaleOf(vibration);
    for (const double force : vibration.force)
        appendLittle(samples, std::uint32_t(std::lround(force * scale)), kBytes);
    comment = "INFO";
    appendChunk(comment, "ICMT", said + '\0');
    appendChunk(body, "fmt ", format);
    appendChunk(body, "LIST", comment);
    appendChunk(body, "data", samples);
    std::string file;
    appendChunk(file, "RIFF", body);
    return file;
}

/// As few of the samples as straight lines between them stay within 1/1000 of all: each line goes on for as
/// long as one slope suits all that it passes.
Json keyframesOf(const Vibration& vibration) {
    constexpr double kOff = 5e-4; // and as much again by what is left of the digits
    const double scale = 1 / scaleOf(vibration);
    const auto at = [&](std::size_t i) { return rounded(vibration.force[i] * scale); };
    Json keyframes = Json::array();
    const auto keep = [&](std::size_t i) {
        keyframes.push_back({{"relative_position", i}, {"amplitude_modulation", at(i)}});
    };
    keep(0);
    for (std::size_t from = 0; from + 1 < vibration.force.size();) {
        double least = -1e9, most = 1e9; // of the slopes that have suited so far
        std::size_t to = from + 1;
        for (std::size_t i = from + 1; i < vibration.force.size(); ++i) {
            const double steps = double(i - from), slope = (at(i) - at(from)) / steps;
            if (slope < least || slope > most) break;
            to = i;
            least = std::max(least, slope - kOff / steps);
            most = std::min(most, slope + kOff / steps);
        }
        keep(from = to);
    }
    return keyframes;
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[11];
    std::strftime(text, sizeof text, "%Y-%m-%d", &utc);
    return text;
}

std::string hjifOf(const Vibration& vibration, const std::string& said) {
    const Json effect{{"effect_type", "Basis"}, {"position", 0}, {"keyframes", keyframesOf(vibration)}};
    const Json band{{"band_type", "Curve"},
                    {"curve_type", "Linear"},
                    {"lower_frequency_limit", int(kSlowestVibration)},
                    {"upper_frequency_limit", int(vibration.rate / 2)},
                    {"effects", Json::array({effect})}};
    const Json channel{{"id", 0},
                       {"description", "Along whichever axis the actuator has"},
                       {"gain", 1.0},
                       {"mixing_coefficient", 1.0},
                       {"body_part_mask", 0},
                       {"bands", Json::array({band})}};
    const Json perception{{"id", 0},
                          {"avatar_id", 0},
                          {"description", said},
                          {"perception_modality", "Vibrotactile"},
                          {"reference_devices", Json::array()},
                          {"effect_library", Json::array()},
                          {"channels", Json::array({channel})}};
    return textOf({{"version", "2023"},
                   {"profile", "Main"},
                   {"level", 1},
                   {"date", today()},
                   {"description", said},
                   {"timescale", int(vibration.rate)},
                   {"avatars", Json::array()},
                   {"perceptions", Json::array({perception})},
                   {"syncs", Json::array()}});
}

std::string hapticOf(const Vibration& vibration, const std::string& said, const std::string& source) {
    const double scale = 1 / scaleOf(vibration);
    Json amplitude = Json::array(), frequency = Json::array();
    for (const EnvelopePoint& point : envelopeOf(vibration)) {
        const double octaves = std::log2(std::max(point.frequency, 1.0) / kLowHaptic);
        const double high = octaves / std::log2(kHighHaptic / kLowHaptic);
        amplitude.push_back(
            {{"time", rounded(point.t)}, {"amplitude", rounded(std::min(point.amplitude * scale, 1.0))}});
        frequency.push_back({{"time", rounded(point.t)}, {"frequency", rounded(std::clamp(high, 0.0, 1.0))}});
    }
    const Json envelopes{{"amplitude", amplitude}, {"frequency", frequency}};
    return textOf({{"version", {{"major", 1}, {"minor", 0}, {"patch", 0}}},
                   {"metadata",
                    {{"editor", "Tactum"},
                     {"author", ""},
                     {"source", source},
                     {"project", ""},
                     {"tags", Json::array()},
                     {"description", said}}},
                   {"signals", {{"continuous", {{"envelopes", envelopes}}}}}});
}

} // namespace

Result<void> checkVibrationFile(const std::filesystem::path& file) {
    for (const char* ending : {".wav", ".hjif", ".haptic"})
        if (file.extension() == ending) return {};
    return tl::unexpected(Error{Error::Kind::Usage, file.string() +
                                                        ": a vibration cannot be written by its ending; "
                                                        "give one of .wav, .hjif and .haptic"});
}

Result<std::string> vibrationBytes(const Vibration& vibration, const std::filesystem::path& file,
                                   const std::string& source) {
    if (const auto known = checkVibrationFile(file); !known) return tl::unexpected(known.error());
    const std::string said = saidOf(vibration, source);
    if (file.extension() == ".wav") return wavOf(vibration, said);
    if (file.extension() == ".hjif") return hjifOf(vibration, said);
    return hapticOf(vibration, said, source);
}

} // namespace tactum
