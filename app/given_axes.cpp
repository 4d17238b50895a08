#include "app/given_axes.h"

#include <algorithm>

#include "core/scene/value_checks.h"

namespace tactum {
namespace {

/// "millimetres, with z up"
std::string wordsOf(const GivenAxes& given) {
    constexpr std::pair<double, const char*> kWords[] = {
        {1, "metres"}, {1e-2, "centimetres"}, {1e-3, "millimetres"}, {0.0254, "inches"}};
    std::string words;
    for (const auto& [unit, word] : kWords)
        if (given.unit == unit) words = word;
    if (given.zUp)
        words += std::string(words.empty() ? "" : ", ") + "with " + (*given.zUp ? "z" : "y") + " up";
    return words;
}

void say(LoadedScene& loaded, std::string sentence, std::string remedy) {
    loaded.findings.push_back({Finding::Severity::Note, "", std::move(sentence), std::move(remedy)});
}

std::string across(const Scene& scene) {
    return withUnit(boundsOf(scene).diagonal(), "m") + " across";
}

Result<void> take(LoadedScene& loaded, const GivenAxes& given, const std::filesystem::path& file) {
    if (given.unit) {
        std::erase_if(loaded.findings, saysUnit);
        scaleScene(loaded.scene, *given.unit, Vec3::Zero());
    }
    if (given.zUp.value_or(false) && !turnUpright(loaded.scene))
        return tl::unexpected(
            Error{Error::Kind::Usage,
                  "--up: " + file.string() + " has bodies, which stand as their gravity is; leave it out"});
    return {};
}

} // namespace

Result<void> takeAsGiven(LoadedScene& loaded, const GivenAxes& given, const std::filesystem::path& file) {
    if (!given.unit && !given.zUp) return {};
    if (const auto taken = take(loaded, given, file); !taken) return taken;
    if (given.unit && !loaded.unitGuessed)
        say(loaded, "says its unit itself, and was scaled by --unit all the same; " + across(loaded.scene),
            "leave --unit out if that is not its size");
    else
        say(loaded, "is taken as you said, " + wordsOf(given) + "; " + across(loaded.scene),
            "say otherwise by --unit and --up");
    return {};
}

Result<void> takeLike(LoadedScene& loaded, GivenAxes given, const Scene& like,
                      const std::filesystem::path& file) {
    const bool unit = loaded.unitGuessed && !given.unit, up = loaded.upGuessed && !given.zUp;
    if (!unit && !up) return takeAsGiven(loaded, given, file);
    const FileAxes axes = axesLike(loaded.scene, like, given.unit, given.zUp);
    if (unit) given.unit = axes.unit;
    if (up) given.zUp = axes.zUp;
    if (const auto taken = take(loaded, given, file); !taken) return taken;
    say(loaded,
        "leaves open what was taken to be like the model of before: " + wordsOf(given) + "; " +
            across(loaded.scene),
        "say otherwise by --unit and --up");
    return {};
}

} // namespace tactum
