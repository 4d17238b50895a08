#include <iostream>

#include "app/commands.h"
#include "app/results.h"
#include "app/streams.h"
#include "core/files/save_scene.h"
#include "core/files/source.h"
#include "core/scene/carry_feel.h"

namespace tactum {

Result<int> runFeel(const FeelOptions& options) {
    if (options.out.extension() != ".glb")
        return tl::unexpected(Error{Error::Kind::Usage, shownPath(options.out) +
                                                            ": cannot be written by its ending; only .glb "
                                                            "keeps how everything feels"});
    const auto from = importGiven(options.from);
    if (!from) return tl::unexpected(from.error());
    auto onto = importGiven(options.onto);
    if (!onto) return tl::unexpected(onto.error());
    if (const auto taken = takeLike(*onto, options.axes, from->scene, options.onto); !taken)
        return tl::unexpected(taken.error());
    const CarriedFeel carried = carryFeel(from->scene, onto->scene);
    if (carried.surfaces == 0)
        return inputError(shownPath(options.onto) + ": no surface has the name of one in " +
                          shownPath(options.from) + "; name the materials alike");
    if (const auto saved = saveScene(onto->scene, options.out, {}, 0); !saved)
        return tl::unexpected(saved.error());
    for (const Finding& finding : onto->findings)
        std::cerr << lineOf(finding) << '\n';
    for (const Finding& finding : carried.findings)
        std::cerr << lineOf(finding) << '\n';
    std::cout << counted(carried.surfaces, "surface") << " as in " << shownPath(options.from) << '\n';
    return 0;
}

} // namespace tactum
