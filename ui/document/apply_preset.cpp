#include "ui/document/apply_preset.h"

#include <algorithm>

namespace tactum {

bool applyPreset(Document& document, const SurfaceRefs& refs, const Preset& preset,
                 const std::vector<StoredPreset>& library) {
    using What = SceneChange::What;
    SurfaceRefs changing;
    for (const SurfaceRef ref : refs)
        if (const Surface* now = document.surface(ref))
            if (!now->locked && !(applied(*now, preset) == *now)) changing.push_back(ref);
    if (changing.empty()) return false;
    const QString name = shownName(preset, library);
    // Each part is announced as what it is: a World follows values at once, normals take a worker.
    document.history().beginMacro(Document::tr("Preset %1").arg(name));
    const auto edit = [&](bool sets, What what, auto change) {
        if (sets) document.editSurfaces(changing, what, name, change);
    };
    edit(std::ranges::any_of(preset.values, [](const auto& value) { return value.has_value(); }),
         What::Material, [&](Surface& each) {
             const Surface now = applied(each, preset);
             each.material = now.material;
             each.colour = now.colour; // of materials alone, which have values
         });
    edit(preset.layers.has_value(), What::Layers, [&](Surface& each) { each.layers = *preset.layers; });
    edit(preset.shading.has_value(), What::Shading, [&](Surface& each) { each.shading = *preset.shading; });
    document.history().endMacro();
    return true;
}

} // namespace tactum
