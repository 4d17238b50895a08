#include <algorithm>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/results.h"
#include "app/streams.h"
#include "core/files/source.h"

namespace tactum {

namespace {

using Json = nlohmann::ordered_json;

std::vector<Finding> findingsOf(const LoadedScene& loaded) {
    std::vector<Finding> findings = loaded.findings;
    for (Finding& finding : validate(loaded.scene)) // the reader has said some of it already
        if (std::ranges::find(loaded.findings, finding) == loaded.findings.end())
            findings.push_back(std::move(finding));
    return findings;
}

std::size_t countOf(const std::vector<Finding>& findings, Finding::Severity severity) {
    return std::size_t(std::ranges::count(findings, severity, &Finding::severity));
}

Json entryOf(const std::string& name, std::size_t errors, const std::vector<Finding>& findings) {
    return {{"file", name},
            {"errors", errors},
            {"warnings", countOf(findings, Finding::Severity::Warning)},
            {"findings", findingsJson(findings)}};
}

void print(const std::string& prefix, const std::vector<Finding>& findings) {
    for (const std::string& line : linesOf(findings))
        std::cout << prefix << line << '\n';
    if (findings.empty()) std::cout << prefix << "no findings\n";
}

} // namespace

Result<int> runCheck(const CheckOptions& options) {
    Json files = Json::array();
    int worst = 0;
    for (const std::filesystem::path& scene : options.scenes) {
        const std::string name = shownPath(scene);
        const auto loaded = importGiven(scene, options.axes);
        if (!loaded) { // the others are checked all the same
            worst = std::max(worst, sayError(loaded.error()));
            files.push_back(entryOf(name, 1, {}));
            files.back()["error"] = loaded.error().text;
            continue;
        }
        const std::vector<Finding> findings = findingsOf(*loaded);
        const std::size_t errors = countOf(findings, Finding::Severity::Error);
        if (errors > 0 || (options.strict && countOf(findings, Finding::Severity::Warning) > 0))
            worst = std::max(worst, 1);
        files.push_back(entryOf(name, errors, findings));
        if (!options.json) print(options.scenes.size() > 1 ? name + ": " : "", findings);
    }
    if (options.json)
        std::cout << Json{{"version", 1}, {"ok", worst == 0}, {"files", files}}.dump(
                         2, ' ', false, Json::error_handler_t::replace)
                  << '\n';
    return worst;
}

} // namespace tactum
