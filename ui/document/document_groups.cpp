// The document and its groups, and the order of its objects.
#include <algorithm>

#include "core/scene/groups.h"
#include "ui/base/words.h"
#include "ui/document/document.h"

namespace tactum {

// Where all stay in their places nothing that is felt or drawn is another.
void Document::editOrder(const QString& text, const std::function<void(Scene&)>& change) {
    Scene value = scene_;
    change(value);
    gatherGroups(value);
    const bool stays =
        std::ranges::equal(scene_.objects, value.objects, {}, &SceneObject::id, &SceneObject::id);
    editScene(text, stays ? SceneChange::What::Names : SceneChange::What::Objects,
              [&](Scene& scene) { scene = std::move(value); });
}

void Document::group(const std::vector<ObjectId>& objects) {
    editOrder(tr("Group %1").arg(namesOf(objects)), [&](Scene& scene) { groupTogether(scene, objects); });
}

void Document::ungroup(const std::vector<ObjectId>& objects) {
    editOrder(tr("Take a group apart"), [&](Scene& scene) { tactum::ungroup(scene, objects); });
}

void Document::renameGroup(const std::string& group, const QString& name) {
    editOrder(tr("Rename to %1").arg(name),
              [&](Scene& scene) { tactum::renameGroup(scene, group, name.toStdString()); });
}

void Document::setGroupVisible(const std::string& group, bool visible) {
    if (objectsOfGroup(scene_, group).empty()) return;
    editObjects((visible ? tr("Show %1") : tr("Hide %1")).arg(asIs(group)), {SceneChange::What::Objects},
                [&](SceneObject& object) {
                    if (object.group == group) object.visible = visible;
                });
}

} // namespace tactum
