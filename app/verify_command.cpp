#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/bundle/bundle.h"
#include "core/bundle/verify_bundle.h"
#include "core/files/source.h"
#include "core/import/import_scene.h"

namespace tactum {

namespace {

std::string number(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string jsonOf(const BundleVerdict& verdict) {
    const nlohmann::ordered_json json{{"true", verdict.differences.empty()},
                                      {"steps", verdict.steps},
                                      {"touches", verdict.touches},
                                      {"largest_force_N", verdict.largestForce},
                                      {"largest_difference_N", verdict.largestDifference},
                                      {"differences", verdict.differences}};
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

void print(const std::string& name, const BundleVerdict& verdict) {
    for (const std::string& difference : verdict.differences)
        std::cout << name << ": " << difference << '\n';
    std::cout << name << ": " << verdict.steps << " steps, largest force " << number(verdict.largestForce)
              << " N, largest difference " << number(verdict.largestDifference)
              << " N: " << (verdict.differences.empty() ? "as the scene feels" : "not as the scene feels")
              << '\n';
    if (!verdict.touches) std::cout << name << ": the finger path touches nothing\n";
}

} // namespace

Result<int> runVerify(const std::filesystem::path& bundle, bool json) {
    const std::string name = shownPath(bundle);
    const std::string ending = lowerCase(bundle.extension().string());
    if (ending != ".zip" && ending != std::string(".") + kBundleEnding)
        return inputError(name + ": is no bundle by its ending; name a .tactum or .zip that was exported");
    const auto loaded = importScene(bundle);
    if (!loaded) return tl::unexpected(loaded.error());
    const auto verdict = verifyBundle(bundle, loaded->scene);
    if (!verdict) return tl::unexpected(verdict.error());
    if (json)
        std::cout << jsonOf(*verdict) << '\n';
    else
        print(name, *verdict);
    return verdict->differences.empty() ? 0 : 1;
}

} // namespace tactum
