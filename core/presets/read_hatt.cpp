#include "core/presets/read_hatt.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <pugixml.hpp>

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/guarded.h"
#include "core/presets/vibration_model.h"

namespace tactum {
namespace {

constexpr std::uint64_t kLargestFile = 64 << 20;               // bytes
constexpr std::size_t kMaxModels = 10000, kHighestOrder = 256; // far above what the toolkit has
constexpr const char* kPaper = "https://doi.org/10.1109/HAPTICS.2014.6775475";

using Node = pugi::xml_node;

std::string shortNumber(double value) {
    std::string text;
    appendNumber(text, std::round(value * 1000) / 1000);
    return text;
}

class HattReader {
public:
    explicit HattReader(const Source& source) : source_(source) {
        const std::string_view bytes = source.bytes();
        const auto result = document_.load_buffer(bytes.data(), bytes.size(), pugi::parse_default);
        if (!result) {
            const auto at = std::min(std::size_t(std::max<std::ptrdiff_t>(result.offset, 0)), bytes.size());
            source_.failAtLine(source_.lineAt(bytes.data() + at),
                               std::string("is no XML: ") + result.description() + "; copy the file again");
        }
        set_ = document_.document_element();
        if (std::string_view(set_.name()) != "modelSet") set_ = set_.child("modelSet");
        if (!set_)
            source_.fail("has no <modelSet>; choose a file of models of the Penn Haptic Texture Toolkit");
    }

    LoadedPreset read() {
        demandUnits();
        Preset& preset = made_.preset;
        preset.name = printable(trimmed(set_.child_value("material")), kLongestName);
        if (preset.name.empty()) preset.name = printable(source_.path().stem().string());
        preset.category = "Measured";
        preset.tags = {"measured", "Penn", "tool tip"};
        readFriction();
        readRelief();
        made_.notes.push_back("The toolkit's licence is for research and forbids passing its data on; keep "
                              "the preset to yourself");
        return std::move(made_);
    }

private:
    [[noreturn]] void failAt(Node node, const std::string& what) const {
        const std::string text = "<" + printable(node.name()) + "> " + what;
        const auto at = node.offset_debug();
        if (at < 0 || std::size_t(at) > source_.bytes().size()) source_.fail(text);
        source_.failAtLine(source_.lineAt(source_.bytes().data() + at), text);
    }

    double number(Node node, double least, double most) const {
        const auto value = parseNumber(trimmed(node.child_value()));
        if (!value || *value < least || *value > most)
            failAt(node, "is " + inQuotes(node.child_value()) + " and should be a number from " +
                             shortNumber(least) + " to " + shortNumber(most) + "; copy the file again");
        return *value;
    }

    double number(const char* name, double least, double most) const {
        const Node node = set_.child(name);
        if (!node) source_.fail(std::string("has no <") + name + ">; copy the file again");
        return number(node, least, most);
    }

    void demandUnits() const {
        const std::pair<const char*, std::string_view> units[] = {
            {"AccelUnits", "m/s^2"}, {"SpeedUnits", "mm/s"}, {"ForceUnits", "N"}};
        for (const auto& [name, unit] : units)
            if (const Node node = set_.child(name))
                if (const std::string_view said = trimmed(node.child_value()); said != unit)
                    failAt(node, "is " + inQuotes(said) + "; only " + std::string(unit) + " is read");
    }

    void readFriction() {
        const double mu = number("mu", kDynamicFriction.minimum, kDynamicFriction.maximum);
        for (std::size_t i = 0; i < kMaterialFields.size(); ++i) {
            const Parameter* parameter = kMaterialFields[i].parameter;
            if (parameter != &kDynamicFriction && parameter != &kStaticFriction) continue;
            made_.preset.values[i] = mu;
            made_.preset.sources[jsonKey(parameter->key)] =
                parameter == &kDynamicFriction
                    ? PresetSource{"Kinetic friction of a tool held in the hand, measured for the Penn "
                                   "Haptic Texture Toolkit (Culbertson et al. 2014)",
                                   kPaper, false}
                    : PresetSource{
                          "Not among the toolkit's values: set by us to the dynamic friction", {}, false};
        }
    }

    void note(const char* sentence) { made_.notes.emplace_back(sentence); }

    void readRelief() {
        if (set_.child("numMACoeff") && number("numMACoeff", 0, double(kHighestOrder)) > 0)
            return note(
                "The models have a moving-average part, which is not read: friction came over, the texture "
                "did not");
        const auto models = readModels();
        if (models.empty())
            return note("The file has no models: friction came over, the texture did "
                        "not");
        // The toolkit's files are of 10 kHz, and some do not say so.
        const double rate = set_.child("SampleRate") ? number("SampleRate", 100, 1e6) : 1e4;
        const VibrationModel& model = middleOf(models);
        const ReliefFigures figures = reliefOf(model, rate);
        if (!std::isfinite(figures.height) || !std::isfinite(figures.slope) || !(figures.slope > 0))
            return note("The models do not vibrate: friction came over, there is no "
                        "texture");
        const TextureLayer layer = noiseLike(figures);
        made_.preset.layers = {layer};
        made_.preset.sources[kLayersPart] = {
            "Noise with the rms height (" + shortNumber(1e6 * figures.height) + " um) and mean wavelength (" +
                shortNumber(1e3 * figures.wavelength()) + " mm) that the toolkit's model for " +
                shortNumber(1e3 * model.speed) + " mm/s and " + shortNumber(model.force) +
                " N implies; how it changes with speed and force is not carried over",
            kPaper, false};
    }

    std::vector<VibrationModel> readModels() const {
        std::vector<VibrationModel> models;
        for (const Node node : set_.children("model")) {
            if (models.size() == kMaxModels)
                failAt(node, "is one more than the " + std::to_string(kMaxModels) +
                                 " that are read; copy the file again");
            models.push_back(readModel(node));
        }
        return models;
    }

    VibrationModel readModel(Node node) const {
        VibrationModel model;
        const auto value = [&](const char* name, double least, double most) {
            const Node child = node.child(name);
            if (!child) failAt(node, std::string("has no <") + name + ">; copy the file again");
            return number(child, least, most);
        };
        model.variance = value("var", 0, 1e6);
        model.speed = 1e-3 * value("speedMod", 0, 1e5);
        model.force = value("forceMod", 0, 1e3);
        for (const Node each : node.child("ARlsf").children("value")) {
            if (model.lsf.size() == kHighestOrder)
                failAt(each, "makes more than " + std::to_string(kHighestOrder) +
                                 " coefficients; copy the file again");
            const double lsf = number(each, 0, std::numbers::pi);
            const double before = model.lsf.empty() ? 0 : model.lsf.back();
            if (!(lsf > before && lsf < std::numbers::pi))
                failAt(each, "does not lie between the one before it and pi; copy the file again");
            model.lsf.push_back(lsf);
        }
        return model;
    }

    /// Of those that move: at rest nothing vibrates.
    static const VibrationModel& middleOf(const std::vector<VibrationModel>& models) {
        double fastest = 1e-6, strongest = 1e-6;
        for (const VibrationModel& model : models) {
            fastest = std::max(fastest, model.speed);
            strongest = std::max(strongest, model.force);
        }
        const auto distance = [&](const VibrationModel& model) {
            const double still = model.speed > 0 ? 0 : 10;
            return still + std::hypot(model.speed / fastest - 0.5, model.force / strongest - 0.5);
        };
        return *std::ranges::min_element(models, {}, distance);
    }

    const Source& source_;
    pugi::xml_document document_;
    Node set_;
    LoadedPreset made_;
};

constexpr const char* kHattNoMemory = "for the texture model; close other programs";

} // namespace

Result<LoadedPreset> readHatt(const std::filesystem::path& file) {
    return guarded<LoadedPreset>(file, kHattNoMemory,
                                 [&] { return HattReader(Source::open(file, kLargestFile)).read(); });
}

Result<LoadedPreset> parseHatt(std::string_view text, const std::filesystem::path& where) {
    return guarded<LoadedPreset>(where, kHattNoMemory,
                                 [&] { return HattReader(Source::ofBytes(where, text)).read(); });
}

} // namespace tactum
