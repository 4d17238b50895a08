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

void print(const std::string& prefix, const std::vector<Finding>& findings) {
    for (const std::string& line : linesOf(findings))
        std::cout << prefix << line << '\n';
    if (findings.empty()) std::cout << prefix << "no findings\n";
}

} // namespace

Result<int> runCheck(const CheckOptions& options) {
    Json files = Json::array();
    std::size_t wrong = 0;
    for (const std::filesystem::path& scene : options.scenes) {
        const auto loaded = importGiven(scene);
        if (!loaded) return tl::unexpected(loaded.error());
        const std::vector<Finding> findings = findingsOf(*loaded);
        const std::size_t errors = countOf(findings, Finding::Severity::Error),
                          warnings = countOf(findings, Finding::Severity::Warning);
        wrong += errors + (options.strict ? warnings : 0);
        const std::string name = shownPath(scene);
        if (options.json)
            files.push_back({{"file", name},
                             {"errors", errors},
                             {"warnings", warnings},
                             {"findings", findingsJson(findings)}});
        else
            print(options.scenes.size() > 1 ? name + ": " : "", findings);
    }
    if (options.json)
        std::cout << Json{{"version", 1}, {"ok", wrong == 0}, {"files", files}}.dump(
                         2, ' ', false, Json::error_handler_t::replace)
                  << '\n';
    return wrong > 0 ? 1 : 0;
}

} // namespace tactum
