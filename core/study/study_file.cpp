#include "core/study/study_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/archive/zip_archive.h"
#include "core/base/atomic_file.h"
#include "core/base/scratch_folder.h"
#include "core/base/text.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/guarded.h"
#include "core/import/import_scene.h"

namespace tactum {

namespace {

constexpr const char *kVersionKey = "tactumStudy", *kDesignFile = "study.json";
constexpr std::uint64_t kLargestStudy = std::uint64_t(1) << 30; // bytes
constexpr const char* kNoMemory = "for the study; close other programs";

std::string versionText() {
    return std::to_string(kStudyMajor) + "." + std::to_string(kStudyMinor);
}
std::string sceneFile(std::size_t index) {
    return "condition-" + std::to_string(index + 1) + ".glb";
}

/// Members of an object, each with what it may be; what is not there stays as it is.
class Members {
public:
    Members(const Source& source, const Json& object, std::string inside)
        : source_(source), object_(object), inside_(std::move(inside)) {
        if (!object.is_object()) source.fail(inside_ + " is no object; repair or remove it");
    }

    void take(const char* key, std::string& value) const {
        const Json* found = member(object_, key);
        if (found && !found->is_string()) fail(key, "is not a text; put it in quotes");
        if (found) value = textOf(*found);
    }
    void take(const char* key, bool& value) const {
        const Json* found = member(object_, key);
        if (found && !found->is_boolean()) fail(key, "is not true or false; repair it");
        if (found) value = found->get<bool>();
    }
    void take(const char* key, double& value) const {
        const Json* found = member(object_, key);
        if (found && (!found->is_number() || !std::isfinite(found->get<double>())))
            fail(key, "is not a number; repair it");
        if (found) value = found->get<double>();
    }
    void take(const char* key, int& value) const {
        constexpr double kMost = 1e9;
        const Json* found = member(object_, key);
        if (!found) return;
        const double whole = found->is_number_integer() ? found->get<double>() : 0.5;
        if (whole != std::floor(whole) || std::abs(whole) > kMost)
            fail(key, "is not a whole number; repair it");
        value = found->get<int>();
    }
    void take(const char* key, std::uint64_t& value) const {
        const Json* found = member(object_, key);
        if (found && !found->is_number_unsigned()) fail(key, "is not a whole number from 0; repair it");
        if (found) value = found->get<std::uint64_t>();
    }
    void take(const char* key, std::vector<std::string>& values) const {
        for (const Json& one : list(key, values)) {
            if (!one.is_string()) fail(key, "is not a list of texts; repair it");
            values.push_back(textOf(one));
        }
    }
    void take(const char* key, std::vector<double>& values) const {
        for (const Json& one : list(key, values)) {
            if (!one.is_number() || !std::isfinite(one.get<double>()))
                fail(key, "is not a list of numbers; repair it");
            values.push_back(one.get<double>());
        }
    }
    template <class Enum, std::size_t n>
    void take(const char* key, Enum& value, const char* const (&names)[n]) const {
        std::string said;
        take(key, said);
        if (said.empty()) return;
        const auto found = std::ranges::find(names, said);
        std::string all;
        for (const char* name : names)
            all += (all.empty() ? "" : ", ") + std::string(name);
        if (found == std::end(names)) fail(key, "is " + inQuotes(said) + "; take one of " + all);
        value = Enum(found - std::begin(names));
    }
    [[noreturn]] void fail(const char* key, const std::string& what) const {
        source_.fail(inside_ + key + " " + what);
    }

private:
    /// Its lines, each safe to show.
    static std::string textOf(const Json& json) {
        const std::string text = json.get<std::string>();
        std::string kept;
        std::string_view line;
        for (Lines lines(text); lines.next(line);)
            kept += (kept.empty() ? "" : "\n") + printable(line, kLongestStudyText);
        return kept;
    }

    template <class T> Json list(const char* key, std::vector<T>& values) const {
        constexpr std::size_t kMost = 1000;
        const Json* found = member(object_, key);
        if (!found) return Json::array();
        if (!found->is_array() || found->size() > kMost)
            fail(key, "is not a list of at most 1000; repair it");
        values.clear();
        return *found;
    }

    const Source& source_;
    const Json& object_;
    std::string inside_;
};

void checkVersion(const Source& source, const Json& root) {
    const Json* version = member(root, kVersionKey);
    const std::string said = version && version->is_string() ? version->get<std::string>() : std::string();
    std::int64_t major = 0;
    if (!parseNumber(std::string_view(said).substr(0, said.find('.')), major) || major < 1)
        source.fail(std::string("is no study: it has no \"") + kVersionKey + "\" as \"" + versionText() +
                    "\"; choose a file that ends in ." + std::string(kStudyEnding));
    if (major > kStudyMajor)
        source.fail("is a study of format " + printable(said, 20) +
                    ", which is later than this program; get a newer Tactum");
}

StaircaseRule staircaseOf(const Source& source, const Json& json) {
    const Members members(source, json, "staircase.");
    StaircaseRule rule;
    members.take("surface", rule.surface);
    members.take("object", rule.object);
    members.take("parameter", rule.parameter);
    members.take("compares", rule.compares);
    members.take("reference", rule.reference);
    members.take("start", rule.start);
    members.take("smallest", rule.smallest);
    members.take("largest", rule.largest);
    members.take("steps", rule.steps);
    members.take("ratio", rule.ratio);
    members.take("down", rule.down);
    members.take("reversals", rule.reversals);
    members.take("used", rule.used);
    members.take("trials", rule.trials);
    return rule;
}

StudyQuestion questionOf(const Source& source, const Json& json, std::size_t index) {
    const Members members(source, json, "questions[" + std::to_string(index) + "].");
    StudyQuestion question;
    members.take("kind", question.kind, kQuestionNames);
    members.take("text", question.text);
    members.take("low", question.low);
    members.take("high", question.high);
    members.take("steps", question.steps);
    members.take("choices", question.choices);
    return question;
}

std::vector<StudyQuestion> questionsOf(const Source& source, const Json& json) {
    if (!json.is_array() || json.size() > std::size_t(kMaxQuestions))
        source.fail("questions is not a list of at most " + std::to_string(kMaxQuestions) + "; repair it");
    std::vector<StudyQuestion> questions;
    for (const Json& one : json)
        questions.push_back(questionOf(source, one, questions.size()));
    return questions;
}

StudyDesign designOf(const Source& source) {
    const GltfFile file = openGltf(source);
    if (file.isBinary) source.fail("is a glb file; open it as a scene");
    checkVersion(source, file.json);
    const Members members(source, file.json, "");
    StudyDesign design;
    members.take("name", design.name);
    members.take("instructions", design.instructions);
    members.take("conditions", design.conditions);
    members.take("procedure", design.procedure, kProcedureNames);
    members.take("order", design.order, kOrderNames);
    members.take("repeats", design.repeats);
    members.take("seed", design.seed);
    members.take("prompt", design.prompt);
    members.take("stimulusSeconds", design.stimulusSeconds);
    members.take("pauseSeconds", design.pauseSeconds);
    members.take("again", design.again);
    members.take("forcesOffBetween", design.forcesOffBetween);
    members.take("view", design.view, kViewNames);
    members.take("touchEvery", design.touchEvery);
    if (const Json* rule = member(file.json, "staircase")) design.staircase = staircaseOf(source, *rule);
    if (const Json* questions = member(file.json, "questions"))
        design.questions = questionsOf(source, *questions);
    if (design.conditions.size() > std::size_t(kMaxConditions))
        members.fail("conditions", "are more than " + std::to_string(kMaxConditions) + "; remove some");
    return design;
}

Json jsonOf(const StudyQuestion& question) {
    Json json{{"kind", kQuestionNames[int(question.kind)]}, {"text", question.text}};
    if (question.kind == StudyQuestion::Kind::Rating)
        json.update({{"low", question.low}, {"high", question.high}, {"steps", question.steps}});
    if (question.kind == StudyQuestion::Kind::Choice) json["choices"] = question.choices;
    return json;
}

Json jsonOf(const StaircaseRule& rule) {
    return {{"surface", rule.surface},   {"object", rule.object},       {"parameter", rule.parameter},
            {"compares", rule.compares}, {"reference", rule.reference}, {"start", rule.start},
            {"smallest", rule.smallest}, {"largest", rule.largest},     {"steps", rule.steps},
            {"ratio", rule.ratio},       {"down", rule.down},           {"reversals", rule.reversals},
            {"used", rule.used},         {"trials", rule.trials}};
}

/// The scene of a condition, read where a hostile one breaks nothing.
Scene conditionOf(const Source& source, const ZipEntry& entry, const std::filesystem::path& folder,
                  const Progress& progress) {
    const std::filesystem::path file = folder / entry.name;
    if (const auto written = writeFileAtomically(file, entry.bytes, 0); !written)
        throw ReadFault{written.error()};
    auto loaded = importScene(file, progress);
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    if (!loaded) source.fail(entry.name + " in it cannot be read as a scene; save the study again");
    return std::move(loaded->scene);
}

/// Conditions of one mesh share it, as states of one scene do: then contacts last from one to the next.
void shareGeometry(std::vector<Scene>& conditions) {
    std::vector<std::shared_ptr<const TriangleSoup>> known;
    for (Scene& scene : conditions)
        for (SceneObject& object : scene.objects) {
            if (!object.geometry) continue;
            const auto same =
                std::ranges::find_if(known, [&](const auto& soup) { return *soup == *object.geometry; });
            if (same == known.end())
                known.push_back(object.geometry);
            else
                object.geometry = *same;
        }
}

Study studyOf(const Source& source, const Progress& progress) {
    const auto entries = readZip(source.bytes());
    if (!entries) source.fail(entries.error().text);
    const auto entryOf = [&](const std::string& name) -> const ZipEntry& {
        const auto found = std::ranges::find(*entries, name, &ZipEntry::name);
        if (found == entries->end()) source.fail("has no " + name + " in it; save the study again");
        return *found;
    };
    Study study{designOf(Source::ofBytes(source.path(), entryOf(kDesignFile).bytes)), {}};
    const ScratchFolder folder("study");
    if (folder.path().empty())
        source.fail("cannot be unpacked: there is no room for temporary files; make some");
    for (std::size_t i = 0; i < study.design.conditions.size(); ++i)
        study.conditions.push_back(conditionOf(source, entryOf(sceneFile(i)), folder.path(), progress));
    shareGeometry(study.conditions);
    return study;
}

} // namespace

std::string designText(const StudyDesign& design) {
    Json json{{kVersionKey, versionText()},
              {"name", design.name},
              {"instructions", design.instructions},
              {"conditions", design.conditions},
              {"procedure", kProcedureNames[int(design.procedure)]},
              {"order", kOrderNames[int(design.order)]},
              {"repeats", design.repeats},
              {"seed", design.seed},
              {"prompt", design.prompt},
              {"staircase", jsonOf(design.staircase)},
              {"questions", Json::array()},
              {"stimulusSeconds", design.stimulusSeconds},
              {"pauseSeconds", design.pauseSeconds},
              {"again", design.again},
              {"forcesOffBetween", design.forcesOffBetween},
              {"view", kViewNames[int(design.view)]},
              {"touchEvery", design.touchEvery}};
    for (const StudyQuestion& question : design.questions)
        json["questions"].push_back(jsonOf(question));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<StudyDesign> parseDesign(std::string_view text, const std::filesystem::path& where) {
    return guarded<StudyDesign>(where, kNoMemory, [&] { return designOf(Source::ofBytes(where, text)); });
}

Result<Study> readStudy(const std::filesystem::path& file, const Progress& progress) {
    return guarded<Study>(file, kNoMemory,
                          [&] { return studyOf(Source::open(file, kLargestStudy), progress); });
}

Result<void> writeStudy(const Study& study, const std::filesystem::path& file, const Progress& progress) {
    try {
        std::vector<ZipEntry> entries{{kDesignFile, designText(study.design)}};
        for (std::size_t i = 0; i < study.conditions.size(); ++i) {
            auto glb = glbOf(study.conditions[i], progress);
            if (!glb) return tl::unexpected<Error>(glb.error());
            entries.push_back({sceneFile(i), std::move(*glb)});
        }
        return writeFileAtomically(file, writeZip(entries), 0);
    } catch (const std::bad_alloc&) {
        return machineError(shownPath(file) + ": not enough memory to save the study; close other programs");
    }
}

} // namespace tactum
