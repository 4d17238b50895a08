#include "device/profile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "core/base/atomic_file.h"
#include "core/port/device_check.h"
#include "core/port/device_figures.h"
#include "device/built_in_profiles.h"

namespace tactum {
namespace {

using Json = nlohmann::json;

constexpr int kVersion = 1;
constexpr std::array<std::string_view, 7> kMembers{"format",  "version",           "name",   "note",
                                                   "buttons", "measures_velocity", "figures"};

/// What only some driver knows of.
struct DriverSetting {
    std::string_view key;
    double DeviceProfile::*value;
    double least, most;
};
constexpr DriverSetting kDriverSettings[] = {
    {"counts_per_newton_metre", &DeviceProfile::countsPerTorque, 1e3, 1e5},
    {"commands_on_the_way", &DeviceProfile::commandsOnWay, 1, 4},
    {"reset_pause_s", &DeviceProfile::resetPause, 0, 1},
    {"longest_unheard_s", &DeviceProfile::longestUnheard, 0.005, 0.2},
};

tl::unexpected<Error> wrong(const std::filesystem::path& file, const std::string& what) {
    return inputError(file.string() + ": " + what);
}

double DeviceInfo::*figureOf(std::string_view key) {
    const auto* const found =
        std::ranges::find_if(kDeviceFigures, [key](const DeviceFigure& figure) { return key == figure.key; });
    return found == std::end(kDeviceFigures) ? nullptr : found->value;
}

std::string numberOf(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", value);
    return text.data();
}

/// What is wrong with it; empty when nothing is.
std::string take(const std::string& key, const Json& figure, DeviceProfile& profile) {
    double DeviceInfo::*const value = figureOf(key);
    const auto* const setting = std::ranges::find(kDriverSettings, key, &DriverSetting::key);
    const bool ofDriver = setting != std::end(kDriverSettings);
    if (!value && !ofDriver) return "\"" + key + "\" is no figure of a device; docs/devices.md lists them";
    const Json& number = figure.is_object() && figure.contains("value") ? figure["value"] : figure;
    if (!number.is_number()) return "\"" + key + "\" must be a number, or have a number as its value";
    const double said = number.get<double>();
    if (ofDriver && !(said >= setting->least && said <= setting->most))
        return "\"" + key + "\" must be from " + numberOf(setting->least) + " to " + numberOf(setting->most);
    (ofDriver ? profile.*setting->value : profile.info.*value) = said;
    return {};
}

std::string take(const Json& json, DeviceProfile& profile) {
    DeviceInfo& info = profile.info;
    info.name = json.value("name", info.name);
    if (const Json& buttons = json.value("buttons", Json(info.buttons)); !buttons.is_number_integer())
        return "\"buttons\" must be a whole number";
    else if (buttons < 0 || buttons > kMaxButtons)
        return "\"buttons\" must be from 0 to 31";
    info.buttons = json.value("buttons", info.buttons);
    info.measuresVelocity = json.value("measures_velocity", info.measuresVelocity);
    if (json.value("version", kVersion) != kVersion) return "is of a version that this program does not know";
    for (const auto& [key, value] : json.items())
        if (std::ranges::find(kMembers, key) == kMembers.end())
            return "\"" + key + "\" does not belong here; a figure belongs into \"figures\"";
    if (!json.contains("figures")) return {};
    if (!json["figures"].is_object()) return "\"figures\" must be a list with names";
    for (const auto& [key, figure] : json["figures"].items())
        if (std::string fault = take(key, figure, profile); !fault.empty()) return fault;
    return {};
}

std::vector<DeviceProfile> readBuiltIn() {
    std::vector<DeviceProfile> profiles;
    for (const auto& [key, text] : kBuiltInProfiles) {
        DeviceProfile empty{.key = std::string(key), .info = {}};
        empty.info.real = true;
        profiles.push_back(readProfile(text, std::string(key) + ".json", std::move(empty)).value());
    }
    return profiles;
}

/// In small letters, split at what is neither letter, digit nor point.
std::vector<std::string> wordsOf(std::string_view name) {
    std::vector<std::string> words(1);
    for (const char c : name) {
        const auto byte = static_cast<unsigned char>(c);
        if (std::isalnum(byte) || c == '.')
            words.back() += char(std::tolower(byte));
        else if (!words.back().empty())
            words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    return words;
}

/// How many words the key has, if each of them begins a word of the name; else 0.
std::size_t fit(const std::string& key, const std::vector<std::string>& name) {
    const std::vector<std::string> words = wordsOf(key);
    const bool all = std::ranges::all_of(words, [&name](const std::string& word) {
        return std::ranges::any_of(name, [&word](const std::string& has) { return has.starts_with(word); });
    });
    return all ? words.size() : 0;
}

Result<std::string> textOf(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return wrong(file, "is no file; remove it");
    constexpr std::size_t kMax = 1 << 20;
    std::string text(kMax, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(text.data(), std::streamsize(kMax));
    if (in.bad() || (in.fail() && !in.eof())) return wrong(file, "cannot be read; check its permissions");
    text.resize(std::size_t(in.gcount()));
    return text;
}

/// A name beside the file that nothing has yet: "falcon-before-2.json".
std::filesystem::path besides(const std::filesystem::path& file) {
    std::error_code error;
    for (int number = 1;; ++number) {
        const auto name = file.stem().string() + "-before-" + std::to_string(number) + ".json";
        if (!std::filesystem::exists(file.parent_path() / name, error)) return file.parent_path() / name;
    }
}

} // namespace

Result<DeviceProfile> readProfile(std::string_view text, const std::filesystem::path& file,
                                  DeviceProfile profile) {
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object() || json.value("format", Json()) != "tactum-device")
        return wrong(file, "is no profile of a device: it must be JSON with \"format\": \"tactum-device\"");
    std::string fault;
    try {
        fault = take(json, profile);
    } catch (const Json::exception&) {
        fault = "\"name\" must be a text, \"buttons\" and \"version\" whole numbers";
    }
    if (!fault.empty()) return wrong(file, fault);
    if (fault = impossibleFigure(profile.info); !fault.empty()) return wrong(file, fault);
    return profile;
}

const std::vector<DeviceProfile>& builtInProfiles() {
    static const std::vector<DeviceProfile> profiles = readBuiltIn();
    return profiles;
}

Result<DeviceProfile> profileOf(std::string_view key, const std::filesystem::path& folder) {
    const auto& profiles = builtInProfiles();
    const auto found = std::ranges::find(profiles, key, &DeviceProfile::key);
    if (found == profiles.end())
        return inputError("There is no profile of a device called \"" + std::string(key) + "\".");
    const std::filesystem::path file = folder / (std::string(key) + ".json");
    std::error_code error;
    if (folder.empty() || !std::filesystem::exists(file, error)) return *found;
    const Result<std::string> text = textOf(file);
    if (!text) return tl::unexpected<Error>(text.error());
    auto own = readProfile(*text, file, *found);
    if (own && own->info.maxForce > found->info.maxForce)
        return wrong(file, "\"max_force_N\" is " + numberOf(own->info.maxForce) + ", and the device gives " +
                               numberOf(found->info.maxForce) + "; a file may lower it, not raise it");
    return own;
}

Result<std::filesystem::path> keepProfile(std::string_view key, std::string_view text,
                                          const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / (std::string(key) + ".json");
    const auto before = profileOf(key, folder);
    if (!before) return tl::unexpected<Error>(before.error());
    if (const auto after = readProfile(text, file, *before); !after)
        return tl::unexpected<Error>(after.error());
    Json whole = Json::parse(text);
    std::filesystem::path copy;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (std::filesystem::exists(file, error)) {
        const Result<std::string> old = textOf(file);
        if (!old) return tl::unexpected<Error>(old.error());
        copy = besides(file);
        if (const auto copied = writeFileAtomically(copy, *old); !copied)
            return tl::unexpected<Error>(copied.error());
        Json merged = Json::parse(*old);
        merged.merge_patch(whole);
        whole = std::move(merged);
    }
    if (const auto written = writeFileAtomically(file, whole.dump(2) + "\n"); !written)
        return tl::unexpected<Error>(written.error());
    return copy;
}

std::string profileFor(std::string_view model) {
    const std::vector<std::string> name = wordsOf(model);
    std::size_t most = 0;
    std::string best;
    for (const DeviceProfile& profile : builtInProfiles())
        if (const std::size_t words = fit(profile.key, name); words > most) {
            most = words;
            best = profile.key;
        }
    return best;
}

} // namespace tactum
