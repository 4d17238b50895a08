#include "core/files/loss_report.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/base/realtime.h"
#include "core/base/text.h"
#include "core/files/gltf/gltf_file.h"
#include "core/files/loss_table.h"

namespace tactum {
namespace {

template <class Rows>
void appendLosses(std::vector<Loss>& losses, ExportTarget target, const Rows& rows,
                  const LossSubject& subject) {
    std::string name;
    if (subject.object) name = subject.object->name;
    if (subject.surface) name += " / " + subject.surface->name;
    for (const LossRow& row : rows) {
        if (!row.has(subject)) continue;
        const LossRule& rule = row.rules[std::size_t(target)];
        losses.push_back({target, name, std::string(row.what), rule.kind, std::string(rule.sentence)});
    }
}

/// What stands in the kept part of a glTF file. Its nodes and materials are mostly there for our objects and
/// are not spoken of.
ForeignParts foreignPartsOf(const Scene& scene) {
    constexpr const char* kLights = "KHR_lights_punctual";
    ForeignParts parts;
    if (!scene.kept.foreign) return parts;
    const Json root = Json::parse(scene.kept.foreign->json, nullptr, false);
    if (!root.is_object()) return parts;
    const auto has = [&](const char* key) { return root.contains(key) && !root[key].empty(); };
    parts.cameras = has("cameras");
    parts.pictures = has("images");
    parts.others =
        has("animations") || has("skins") || has("extras") || (has("scenes") && root["scenes"].size() > 1);
    if (!has("extensions") || !root["extensions"].is_object()) return parts;
    for (const auto& [name, extension] : root["extensions"].items())
        (name == kLights ? parts.lights : parts.others) = true;
    return parts;
}

/// Text in which Markdown sees nothing but letters. Sentences are whole.
std::string plain(std::string_view text, std::size_t limit = std::string_view::npos) {
    std::string result;
    for (const char c : printable(text, limit)) {
        if (std::string_view("\\`*_{}[]<>()#+-!|~&").find(c) != std::string_view::npos) result += '\\';
        result += c;
    }
    return result;
}

/// "lid, body and 3 more"
std::string namesOf(const std::vector<std::string>& names) {
    constexpr std::size_t kMax = 5, kLongest = 200;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMax); ++i)
        text += (i > 0 ? ", " : "") + plain(names[i], kLongest);
    if (names.size() > kMax) text += " and " + std::to_string(names.size() - kMax) + " more";
    return text;
}

/// What is said alike of several objects.
using Saying = std::tuple<std::string, std::string>; // what, sentence

constexpr std::size_t kLongestSentence = 400; ///< of the table, and of what a scene adds to it

std::string chapter(ExportTarget target, const std::vector<Loss>& losses) {
    std::string text;
    for (const LossKind kind : {LossKind::Lost, LossKind::Degraded, LossKind::Kept}) {
        std::vector<Saying> order;
        std::map<Saying, std::vector<std::string>> namesBy;
        for (const Loss& loss : losses) {
            if (loss.target != target || loss.kind != kind) continue;
            auto& names = namesBy[{loss.what, loss.sentence}];
            if (names.empty()) order.emplace_back(loss.what, loss.sentence);
            names.push_back(loss.object);
        }
        for (const Saying& saying : order) {
            const auto& [what, sentence] = saying;
            text += "| " + std::string(kLossKinds[std::size_t(kind)]) + " | " + plain(what) + " | " +
                    plain(sentence, kLongestSentence) + " | " + namesOf(namesBy[saying]) + " |\n";
        }
    }
    if (text.empty()) return text;
    return "## " + std::string(kExportTargets[std::size_t(target)].label) +
           "\n\n| | what | how | of |\n|---|---|---|---|\n" + text + "\n";
}

} // namespace

std::string lineOf(const Loss& loss) {
    return std::string(kLossKinds[std::size_t(loss.kind)]) + ": " +
           (loss.object.empty() ? "scene" : loss.object) + ": " + loss.what + ": " + loss.sentence;
}

std::vector<Loss> lossesOf(const Scene& scene, ExportTarget target) {
    assertNotRealtime();
    const ForeignParts foreign = foreignPartsOf(scene);
    std::vector<Loss> losses;
    appendLosses(losses, target, loss_table::kSceneRows, {scene, foreign});
    for (const SceneObject& object : scene.objects) {
        appendLosses(losses, target, loss_table::kObjectRows, {scene, foreign, &object});
        for (const Surface& surface : object.surfaces)
            appendLosses(losses, target, loss_table::kSurfaceRows, {scene, foreign, &object, &surface});
    }
    return losses;
}

std::vector<Loss> lossesOf(const Scene& scene) {
    std::vector<Loss> all;
    for (std::size_t i = 0; i < kExportTargets.size(); ++i) {
        const auto losses = lossesOf(scene, ExportTarget(i));
        all.insert(all.end(), losses.begin(), losses.end());
    }
    return all;
}

std::string reportMarkdown(const std::vector<Loss>& losses) {
    std::string text = "# What each format keeps of this scene\n\n";
    for (std::size_t i = 0; i < kExportTargets.size(); ++i)
        text += chapter(ExportTarget(i), losses);
    return text;
}

std::string reportJson(const std::vector<Loss>& losses) {
    Json all = Json::array();
    for (const Loss& loss : losses)
        all.push_back({{"target", kExportTargets[std::size_t(loss.target)].key},
                       {"object", loss.object},
                       {"what", loss.what},
                       {"kind", kLossKinds[std::size_t(loss.kind)]},
                       {"sentence", loss.sentence}});
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace tactum
