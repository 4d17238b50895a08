#include <algorithm>
#include <iostream>

#include "app/commands.h"
#include "app/results.h"
#include "core/import/import_scene.h"

namespace tactum {

Result<int> runCheck(const std::filesystem::path& scene) {
    auto loaded = importScene(scene);
    if (!loaded) return tl::unexpected(loaded.error());
    const std::vector<Finding>& said = loaded->findings;
    std::vector<Finding> findings = said;
    for (Finding& finding : validate(loaded->scene)) // the reader has said some of it already
        if (std::ranges::find(said, finding) == said.end()) findings.push_back(std::move(finding));
    int errors = 0;
    for (const Finding& finding : findings) {
        std::cout << lineOf(finding) << '\n';
        errors += finding.severity == Finding::Severity::Error;
    }
    if (findings.empty()) std::cout << "no findings\n";
    return errors > 0 ? 1 : 0;
}

} // namespace tactum
