#include "ui/controllers/preset_controller.h"

#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QMimeData>
#include <QStandardPaths>

#include "core/presets/preset_file.h"
#include "ui/base/ask_where.h"
#include "ui/controllers/docks.h"
#include "ui/document/apply_preset.h"
#include "ui/document/document.h"
#include "ui/document/preset_store.h"
#include "ui/panels/preset_form.h"
#include "ui/panels/preset_library.h"
#include "ui/showing/playback.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

QString presetEnding() {
    return QString::fromUtf8(kPresetEnding);
}

} // namespace

PresetController::PresetController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), store_(new PresetStore(this)),
      library_(new PresetLibrary(*store_)) {
    addDock();
    bench.on("preset-apply", this, [this] { applyChosen(); });
    bench.on("preset-save", this, [this] { save(); });
    bench.on("preset-import", this, [this] { askForFiles(); });
    bench.on("preset-export", this, [this] { exportChosen(); });
    connectLibrary();
    connectDrops();
    connect(&bench_.document, &Document::changed, this, &PresetController::showCommands);
    showCommands();
}

void PresetController::addDock() {
    addTabBeside(bench_.window, bench_.dock("dock-problems"), QStringLiteral("dock-presets"), tr("Presets"),
                 library_);
    bench_.dock("dock-presets").raise();
    QAction &apply = bench_.actions["preset-apply"], &save = bench_.actions["preset-save"];
    apply.setIconText(tr("Apply"));
    save.setIconText(tr("Save as..."));
    library_->addActions(&apply, &save, {&bench_.actions["preset-import"], &bench_.actions["preset-export"]});
}

void PresetController::connectLibrary() {
    connect(library_, &PresetLibrary::applyAsked, this, &PresetController::applyChosen);
    connect(library_, &PresetLibrary::chosenChanged, this, &PresetController::showCommands);
    connect(library_, &PresetLibrary::removed, this, [this](const QString& name) {
        bench_.notice.offer(tr("The preset %1 was removed.").arg(name), QStringLiteral("note"),
                            tr("Take back"), [this] { store_->takeBack(); });
    });
    connect(store_, &PresetStore::failed, this, [this](const QString& sentence) {
        droppedOn_.reset();
        bench_.notice.showError(sentence);
    });
    connect(store_, &PresetStore::imported, this, [this](const QString& file, const LoadedPreset& made) {
        showKept(file, made);
        if (const auto surface = std::exchange(droppedOn_, std::nullopt)) applyTo(*surface, made.preset);
    });
}

void PresetController::connectDrops() {
    bench_.view.setDropTypes({QString::fromLatin1(kPresetMime)});
    connect(&bench_.view, &SceneView::droppedOn, this, [this](SurfaceRef surface, const QMimeData& dropped) {
        const QByteArray text = dropped.data(QString::fromLatin1(kPresetMime));
        if (text.isEmpty() || bench_.playback.active()) return; // a recording shows surfaces of another scene
        const auto read = parsePreset(text.toStdString(), "the dropped preset");
        if (!read) return bench_.notice.showError(QString::fromStdString(read.error().text));
        applyTo(surface, read->preset);
    });
}

void PresetController::showCommands() {
    const bool chosen = library_->chosen(), selected = bench_.document.selection().has_value();
    bench_.actions["preset-apply"].setEnabled(chosen && selected);
    bench_.actions["preset-save"].setEnabled(selected);
    bench_.actions["preset-export"].setEnabled(chosen);
}

void PresetController::applyTo(const SurfaceRefs& surfaces, const Preset& preset) {
    const QString name = shownName(preset, store_->presets());
    if (applyPreset(bench_.document, surfaces, preset, store_->presets())) return;
    bool locked = false;
    for (const SurfaceRef ref : surfaces)
        if (const Surface* surface = bench_.document.surface(ref)) locked = locked || surface->locked;
    bench_.notice.showNote(locked
                               ? tr("Nothing was changed: locked surfaces stay as they are. Unlock them (L).")
                               : tr("Nothing was changed: it feels like %1 already.").arg(name));
}

void PresetController::showKept(const QString& file, const LoadedPreset& made) {
    QString text = tr("%1 is in the library now.").arg(QString::fromStdString(made.preset.name));
    for (const std::string& note : made.notes)
        text += u' ' + QString::fromStdString(note) + u'.';
    bench_.notice.showNote(text);
    library_->choose(file);
}

void PresetController::applyChosen() {
    const StoredPreset* stored = library_->chosen();
    if (!stored || bench_.playback.active()) return;
    if (!bench_.document.selection())
        return bench_.notice.showNote(
            tr("Select the surfaces that are to feel like %1, or drag it onto one.").arg(stored->name()));
    applyTo(bench_.document.selected(), stored->preset);
}

void PresetController::save() {
    const auto active = bench_.document.selection();
    const Surface* surface = active ? bench_.document.surface(*active) : nullptr;
    if (!surface) return;
    auto* form = new PresetForm(*surface, &bench_.window);
    connect(form, &QDialog::accepted, this, [this, form] {
        const LoadedPreset made = form->made();
        const QString file = store_->add(made.preset);
        if (!file.isEmpty()) showKept(file, made);
    });
    form->show();
}

void PresetController::askForFiles() {
    store_->importFiles(
        QFileDialog::getOpenFileNames(&bench_.window, tr("Import presets"), {},
                                      tr("Presets and texture models (*.%1 *.xml);;Presets (*.%1);;Texture "
                                         "models of the Penn toolkit (*.xml)")
                                          .arg(presetEnding())));
}

void PresetController::exportChosen() {
    const StoredPreset* stored = library_->chosen();
    if (!stored) return;
    const Preset preset = stored->preset; // as it is now, whatever is chosen while the dialog is open
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString name = QString::fromStdString(presetFileName(preset.name)) + u'.' + presetEnding();
    const QString file = askWhere(&bench_.window, tr("Export the preset"), {{tr("Presets"), presetEnding()}},
                                  folder + u'/' + name);
    if (!file.isEmpty() && store_->write(preset, file))
        bench_.notice.showNote(tr("The preset was written to %1.").arg(file));
}

bool PresetController::take(const QString& file, std::optional<SurfaceRef> surface) {
    const bool isPreset = file.endsWith(u'.' + presetEnding(), Qt::CaseInsensitive);
    if (!isPreset && !file.endsWith(QStringLiteral(".xml"), Qt::CaseInsensitive)) return false;
    droppedOn_ = bench_.playback.active() ? std::nullopt : surface;
    store_->importFiles({file});
    return true;
}

} // namespace tactum
