#include "ui/controllers/selection_sets_menu.h"

#include <algorithm>

#include <QMenu>
#include <QToolButton>

#include "core/scene/selection_sets.h"
#include "ui/base/mnemonics.h"
#include "ui/base/words.h"
#include "ui/controllers/kept_names.h"
#include "ui/document/document.h"
#include "ui/showing/playback.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

SelectionSetsMenu::SelectionSetsMenu(const Workbench& bench, QMenu& place)
    : QObject(&bench.window), bench_(bench) {
    auto* menu = new QMenu(tr("Sets b&y name"), &place);
    menu->setObjectName(QStringLiteral("sets"));
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill(*menu); });
    place.insertMenu(&bench_.actions["set-keep"], menu);
    bench.on("set-keep", this, [this] { keep(); });
}

QToolButton* SelectionSetsMenu::makeButton() {
    auto* button = new QToolButton;
    button->setObjectName(QStringLiteral("sets-button"));
    button->setText(tr("Sets"));
    button->setToolTip(tr("Selections that are kept under names, with the scene"));
    button->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill(*menu); });
    button->setMenu(menu);
    return button;
}

QStringList SelectionSetsMenu::names() const {
    QStringList names;
    for (const std::string& name : setNames(bench_.document.scene()))
        names << asIs(name);
    return names;
}

// Anew each time: sets come and go with undo, and with objects.
void SelectionSetsMenu::fill(QMenu& menu) {
    menu.clear();
    qDeleteAll(menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
    const bool live = !bench_.playback.active(), chosen = !bench_.document.selectedTriangles().empty();
    for (const QString& name : names()) {
        QAction* action = menu.addAction(inMenu(name), this, [this, name] { select(name); });
        action->setEnabled(live);
    }
    if (menu.isEmpty()) menu.addAction(tr("No selection is kept yet"))->setEnabled(false);
    menu.addSeparator();
    menu.addAction(&bench_.actions["set-keep"]);
    addVerb(menu, tr("Add the selection to"), "set-add", live && chosen, &SelectionSetsMenu::add);
    addVerb(menu, tr("Replace by the selection"), "set-replace", live && chosen, &SelectionSetsMenu::replace);
    addVerb(menu, tr("Rename the set"), "set-rename", live, &SelectionSetsMenu::rename);
    addVerb(menu, tr("Remove the set"), "set-remove", live, &SelectionSetsMenu::remove);
    giveMnemonics(menu);
}

void SelectionSetsMenu::addVerb(QMenu& menu, const QString& verb, const char* id, bool possible, Does does) {
    addNamesMenu(menu, verb, id, names(), possible,
                 [this, does](const QString& name) { (this->*does)(name); });
}

/// `taken`: what is said of a name that another one has, which is its %1.
QString SelectionSetsMenu::askFor(const QString& title, const QString& now, const QString& taken) {
    return askForName(&bench_.window, title, tr("Name of the set"), now, [&](const QString& name) {
        return name != now && names().contains(name) ? taken.arg(name) : QString();
    });
}

void SelectionSetsMenu::keep() {
    if (bench_.playback.active()) return;
    if (bench_.document.selectedTriangles().empty())
        return bench_.notice.showNote(tr("Select what is to be kept first: surfaces, or triangles (Q)."));
    const QString name =
        askFor(tr("Keep the selection"), nextName(tr("Set %1"), names()),
               tr("There is a set %1 already; Sets > Replace by the selection makes it another one."));
    if (!name.isEmpty()) replace(name);
}

void SelectionSetsMenu::select(const QString& name) {
    if (bench_.playback.active()) return;
    const SceneTriangles triangles = trianglesOfSet(bench_.document.scene(), name.toStdString());
    if (triangles.empty()) return;
    const std::size_t left = bench_.document.selectTriangles(triangles);
    if (left == 0) return;
    const SceneObject& object = *bench_.document.scene().find(bench_.document.selectedFaces().object);
    bench_.notice.showNote(tr("%1 has parts on %2 objects, and triangles are selected on one: on %3. Select "
                              "another of them first for its part.")
                               .arg(name, QString::number(triangles.size()), asIs(object.name)));
}

void SelectionSetsMenu::add(const QString& name) {
    edit(tr("Add to the set %1").arg(name),
         [&](Scene& scene) { addToSet(scene, name.toStdString(), bench_.document.selectedTriangles()); });
}

void SelectionSetsMenu::replace(const QString& name) {
    edit(tr("Keep the set %1").arg(name),
         [&](Scene& scene) { putSet(scene, name.toStdString(), bench_.document.selectedTriangles()); });
}

void SelectionSetsMenu::rename(const QString& name) {
    const QString other =
        askFor(tr("Rename the set"), name, tr("There is a set %1 already; choose another name."));
    if (other.isEmpty() || other == name) return;
    edit(tr("Rename to %1").arg(other),
         [&](Scene& scene) { renameSet(scene, name.toStdString(), other.toStdString()); });
}

void SelectionSetsMenu::remove(const QString& name) {
    edit(tr("Remove the set %1").arg(name), [&](Scene& scene) { removeSet(scene, name.toStdString()); });
}

/// Not beyond what is read again from a file.
void SelectionSetsMenu::edit(const QString& text, const std::function<void(Scene&)>& change) {
    Scene next = bench_.document.scene();
    change(next);
    const auto fits = [](const SceneObject& object) {
        return areSetsOf(object.sets, object.geometry->triangles.size());
    };
    if (!std::ranges::all_of(next.objects, fits))
        return bench_.notice.showError(
            tr("An object can have %1 sets, and not too many scattered ones; remove one that is not used.")
                .arg(kMaxSets));
    bench_.document.editScene(text, SceneChange::What::Names, [&](Scene& scene) { scene = std::move(next); });
}

} // namespace tactum
