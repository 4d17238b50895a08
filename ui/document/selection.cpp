#include "ui/document/selection.h"

#include <algorithm>
#include <iterator>

namespace tactum {

FaceSelection joined(const FaceSelection& now, const FaceSelection& chosen, SelectMode mode) {
    const bool same = now.object == chosen.object;
    if (mode == SelectMode::Replace || (mode == SelectMode::Add && !same)) return chosen;
    if (!same) return now;
    FaceSelection result{now.object, {}};
    if (mode == SelectMode::Add)
        std::ranges::set_union(now.faces, chosen.faces, std::back_inserter(result.faces));
    else
        std::ranges::set_difference(now.faces, chosen.faces, std::back_inserter(result.faces));
    return result;
}

SurfaceRefs joined(const SurfaceRefs& now, const SurfaceRefs& chosen, SelectMode mode) {
    if (mode == SelectMode::Replace) return chosen;
    SurfaceRefs result = now;
    std::erase_if(result, [taken = SurfaceSet(chosen)](SurfaceRef ref) { return taken.has(ref); });
    if (mode == SelectMode::Add) result.insert(result.end(), chosen.begin(), chosen.end());
    return result;
}

} // namespace tactum
