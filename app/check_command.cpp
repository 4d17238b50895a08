#include <algorithm>
#include <iostream>

#include "app/commands.h"
#include "core/import/import_scene.h"

namespace tactum {

namespace {

const char* nameOf(Finding::Severity severity) {
    switch (severity) {
    case Finding::Severity::Note:
        return "note";
    case Finding::Severity::Warning:
        return "warning";
    case Finding::Severity::Error:
        break;
    }
    return "error";
}

void print(const Finding& finding) {
    std::cout << nameOf(finding.severity) << ": ";
    if (!finding.object.empty()) std::cout << finding.object << ": ";
    std::cout << finding.sentence;
    if (!finding.remedy.empty()) std::cout << "; " << finding.remedy;
    std::cout << '\n';
}

} // namespace

Result<int> runCheck(const std::filesystem::path& scene) {
    auto loaded = importScene(scene);
    if (!loaded) return tl::unexpected(loaded.error());
    const std::vector<Finding>& said = loaded->findings;
    std::vector<Finding> findings = said;
    for (Finding& finding : validate(loaded->scene)) // the reader has said some of it already
        if (std::ranges::find(said, finding) == said.end()) findings.push_back(std::move(finding));
    int errors = 0;
    for (const Finding& finding : findings) {
        print(finding);
        errors += finding.severity == Finding::Severity::Error;
    }
    if (findings.empty()) std::cout << "no findings\n";
    return errors > 0 ? 1 : 0;
}

} // namespace tactum
