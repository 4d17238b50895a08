#include "core/files/scene_of_arrays.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactum {

Result<LoadedScene> sceneOfArrays(std::string_view name, TriangleSoup soup, const Progress& progress) {
    const std::string shown = printable(name, kLongestName);
    std::vector<Surface> surfaces(std::size_t(std::ranges::max(soup.surfaceOf)) + 1);
    for (std::size_t i = 0; i < surfaces.size(); ++i)
        surfaces[i].name = surfaces.size() == 1 ? shown : "surface " + std::to_string(i);
    auto loaded = sceneOfMesh(shown, std::move(soup), std::move(surfaces), progress);
    if (loaded && loaded->scene.objects.empty()) return inputError("the mesh has nothing that can be felt");
    return loaded;
}

} // namespace tactum
