#include "ui/controllers/group_controller.h"

#include <algorithm>
#include <array>

#include "core/scene/groups.h"
#include "ui/document/document.h"
#include "ui/showing/playback.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

GroupController::GroupController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
    Document& document = bench_.document;
    bench_.on("group", this, [this, &document] {
        const std::vector<ObjectId> chosen = document.selectedObjects();
        if (chosen.empty())
            return bench_.notice.showNote(tr("Select the objects that are to be a group first."));
        document.group(chosen);
    });
    bench_.on("ungroup", this, [this, &document] {
        const std::vector<ObjectId> chosen = document.selectedObjects();
        if (isAny(chosen)) document.ungroup(chosen);
    });
    bench_.on("select-group", this, [this, &document] {
        const std::vector<ObjectId> chosen = document.selectedObjects();
        if (isAny(chosen)) document.selectObjects(withTheirGroups(document.scene(), chosen));
    });
    bench_.view.setDoubleClick([this](const PickHit& hit) {
        const bool selects = bench_.actions["select"].isChecked() || bench_.actions["arrange"].isChecked();
        return selects && !bench_.playback.active() && selectGroupOf(hit.surface.object);
    });
}

/// Says so where none of them is in a group.
bool GroupController::isAny(const std::vector<ObjectId>& objects) const {
    const bool any = std::ranges::any_of(
        objects, [this](ObjectId id) { return !bench_.document.scene().find(id)->group.empty(); });
    if (!any) bench_.notice.showNote(tr("Nothing of a group is selected."));
    return any;
}

bool GroupController::selectGroupOf(ObjectId object) {
    const SceneObject* found = bench_.document.scene().find(object);
    if (!found || found->group.empty()) return false;
    bench_.document.selectFaces({});
    bench_.document.selectObjects(withTheirGroups(bench_.document.scene(), std::array{object}));
    return true;
}

} // namespace tactum
