#include "ui/controllers/cameras_menu.h"

#include <QMenu>
#include <QMenuBar>

#include "ui/base/mnemonics.h"
#include "ui/base/words.h"
#include "ui/controllers/kept_names.h"
#include "ui/document/document.h"
#include "ui/showing/playback.h"
#include "ui/view/saved_view.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr int kKeys = 9;

QKeySequence keyOf(int number) {
    return QKeySequence(Qt::ALT | Qt::Key(Qt::Key_0 + number));
}

} // namespace

CamerasMenu::CamerasMenu(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
    auto* menu = bench.window.menuBar()->findChild<QMenu*>(QStringLiteral("View/&Camera/&Kept cameras"));
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fill(*menu); });
    bench.on("camera-keep", this, [this] { keep(); });
    addKeys();
}

void CamerasMenu::addKeys() {
    for (int number = 1; number <= kKeys; ++number) {
        auto* action = new QAction(this);
        action->setShortcut(keyOf(number));
        connect(action, &QAction::triggered, this, [this, number] { show(names().value(number - 1)); });
        bench_.window.addAction(action);
    }
}

QStringList CamerasMenu::names() const {
    QStringList names;
    for (const SavedCamera& camera : bench_.document.scene().cameras)
        names << asIs(camera.name);
    return names;
}

// Anew each time: cameras come and go with undo.
void CamerasMenu::fill(QMenu& menu) {
    menu.clear();
    qDeleteAll(menu.findChildren<QMenu*>(Qt::FindDirectChildrenOnly));
    const QStringList all = names();
    for (int i = 0; i < all.size(); ++i) {
        const QString key = i < kKeys ? u'\t' + keyOf(i + 1).toString(QKeySequence::NativeText) : QString();
        menu.addAction(inMenu(all[i]) + key, this, [this, name = all[i]] { show(name); });
    }
    if (all.isEmpty()) menu.addAction(tr("No view is kept yet"))->setEnabled(false);
    menu.addSeparator();
    menu.addAction(&bench_.actions["camera-keep"]);
    const bool live = !bench_.playback.active();
    for (const Verb& verb : verbs())
        addNamesMenu(menu, verb.text, verb.id, all, live, verb.does);
    giveMnemonics(menu);
}

std::vector<CamerasMenu::Verb> CamerasMenu::verbs() {
    return {{"camera-replace", tr("Replace by this view"), tr("The camera looks from here from now on"),
             [this](const QString& name) { put(tr("Replace the view %1").arg(name), name); }},
            {"camera-rename", tr("Rename the camera"), tr("The camera under another name"),
             [this](const QString& name) { rename(name); }},
            {"camera-remove", tr("Remove the camera"), tr("The view from there is no longer kept"),
             [this](const QString& name) { remove(name); }}};
}

void CamerasMenu::show(const QString& name) {
    const SavedCamera* saved = findCamera(bench_.document.scene(), name.toStdString());
    if (!saved) return;
    bench_.view.flyTo(viewOf(*saved, bench_.view.camera()));
}

/// `taken`: what is said of a name that another one has, which is its %1.
QString CamerasMenu::askFor(const QString& title, const QString& now, const QString& taken) {
    return askForName(&bench_.window, title, tr("Name of the camera"), now, [&](const QString& name) {
        return name != now && names().contains(name) ? taken.arg(name) : QString();
    });
}

void CamerasMenu::keep() {
    if (bench_.playback.active()) return;
    const QStringList taken = names();
    if (taken.size() >= int(kMaxCameras))
        return bench_.notice.showError(
            tr("A scene can have %1 cameras; remove one that is not used.").arg(kMaxCameras));
    const QString name = askFor(tr("Keep this view"), nextName(tr("View %1"), taken),
                                tr("There is a camera %1 already; View > Camera > Kept cameras > Replace by "
                                   "this view makes it another one."));
    if (!name.isEmpty()) put(tr("Keep the view %1").arg(name), name);
}

void CamerasMenu::put(const QString& text, const QString& name) {
    const SavedCamera camera = savedCamera(bench_.view.camera(), name.toStdString());
    bench_.document.editScene(text, SceneChange::What::Names,
                              [&](Scene& scene) { putCamera(scene, camera); });
}

void CamerasMenu::rename(const QString& name) {
    const QString other =
        askFor(tr("Rename the camera"), name, tr("There is a camera %1 already; choose another name."));
    if (other.isEmpty() || other == name) return;
    bench_.document.editScene(tr("Rename to %1").arg(other), SceneChange::What::Names, [&](Scene& scene) {
        renameCamera(scene, name.toStdString(), other.toStdString());
    });
}

void CamerasMenu::remove(const QString& name) {
    bench_.document.editScene(tr("Remove the view %1").arg(name), SceneChange::What::Names,
                              [&](Scene& scene) { removeCamera(scene, name.toStdString()); });
}

} // namespace tactum
