#include "core/scene/findings.h"

#include <algorithm>

namespace tactum {

std::string_view nameOf(Finding::Severity severity) {
    constexpr std::string_view kNames[] = {"note", "warning", "error"};
    return kNames[std::size_t(severity)];
}

std::string lineOf(const Finding& finding) {
    std::string line = std::string(nameOf(finding.severity)) + ": ";
    if (!finding.object.empty()) line += finding.object + ": ";
    line += finding.sentence;
    if (!finding.remedy.empty()) line += "; " + finding.remedy;
    return line;
}

std::string counted(std::size_t count, std::string_view noun) {
    std::string word(noun);
    if (count == 1) return "1 " + word;
    if (word == "vertex")
        word = "vertices";
    else if (word == "body")
        word = "bodies";
    else
        word += "s";
    return std::to_string(count) + " " + word;
}

void CountedFindings::add(Finding::Severity severity, std::size_t count, std::string_view noun,
                          const std::string& predicate, const std::string& remedy) {
    if (count > 0) findings_.push_back({severity, object_, counted(count, noun) + " " + predicate, remedy});
}

void appendHealth(std::vector<Finding>& findings, const std::string& object, const MeshHealth& health) {
    CountedFindings notes(findings, object);
    const auto note = Finding::Severity::Note, warning = Finding::Severity::Warning;
    notes.add(note, health.slivers, "triangle", "too thin to see",
              "kept; merge close vertices to remove them");
    notes.add(warning, health.duplicateFaces, "triangle", "equal to another one",
              "kept; remove doubles in the modelling program");
    notes.add(warning, health.flippedEdges, "edge", "whose two triangles face opposite ways",
              "kept; both sides can be touched, but make the normals consistent for shading");
    if (health.boundaryEdges > 0)
        notes.add(note, health.holes, "open rim", "with " + counted(health.boundaryEdges, "edge"),
                  "kept open; the finger can pass through if it is larger than the proxy");
    notes.add(note, health.unreferencedVertices, "vertex", "that no face uses", "ignored");
}

bool saysHealth(const Finding& finding) {
    static const std::vector<Finding> all = [] {
        MeshHealth every;
        every.slivers = every.duplicateFaces = every.flippedEdges = 1;
        every.boundaryEdges = every.holes = 1;
        std::vector<Finding> findings;
        appendHealth(findings, {}, every);
        return findings;
    }();
    return std::ranges::any_of(all, [&](const Finding& one) { return one.remedy == finding.remedy; });
}

} // namespace tactum
