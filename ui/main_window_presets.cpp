// The library of presets: its dock, its commands, and what is dropped from it onto the model.
#include <QAction>
#include <QDockWidget>
#include <QFileDialog>
#include <QMimeData>
#include <QStandardPaths>

#include "core/presets/preset_file.h"
#include "ui/apply_preset.h"
#include "ui/ask_where.h"
#include "ui/main_window.h"
#include "ui/panels/notice_bar.h"
#include "ui/panels/preset_form.h"
#include "ui/panels/preset_library.h"
#include "ui/playback.h"
#include "ui/preset_store.h"
#include "ui/view/scene_view.h"

namespace tactum {

namespace {

QString presetEnding() {
    return QString::fromUtf8(kPresetEnding);
}

} // namespace

void MainWindow::addPresetDock() {
    presets_ = new PresetLibrary(*presetStore_);
    addTabBeside(*this, *findChild<QDockWidget*>(QStringLiteral("dock-problems")),
                 QStringLiteral("dock-presets"), tr("Presets"), presets_);
    findChild<QDockWidget*>(QStringLiteral("dock-presets"))->raise();
}

void MainWindow::connectPresets() {
    const auto on = [this](const char* id, void (MainWindow::*act)()) {
        connect(&actions_[id], &QAction::triggered, this, act);
    };
    on("preset-apply", &MainWindow::applyChosenPreset);
    on("preset-save", &MainWindow::savePreset);
    on("preset-import", &MainWindow::askForPresets);
    on("preset-export", &MainWindow::exportPreset);
    actions_["preset-apply"].setIconText(tr("Apply"));
    actions_["preset-save"].setIconText(tr("Save as..."));
    presets_->addActions(&actions_["preset-apply"], &actions_["preset-save"],
                         {&actions_["preset-import"], &actions_["preset-export"]});
    connect(presets_, &PresetLibrary::applyAsked, this, &MainWindow::applyChosenPreset);
    connect(presets_, &PresetLibrary::chosenChanged, this, &MainWindow::showPresetCommands);
    connect(&document_, &Document::changed, this, &MainWindow::showPresetCommands);
    connect(presets_, &PresetLibrary::removed, this, [this](const QString& name) {
        notice_->offer(tr("The preset %1 was removed.").arg(name), QStringLiteral("note"), tr("Take back"),
                       [this] { presetStore_->takeBack(); });
    });
    connect(presetStore_, &PresetStore::failed, this, [this](const QString& sentence) {
        droppedOn_.reset();
        notice_->showError(sentence);
    });
    connect(presetStore_, &PresetStore::imported, this,
            [this](const QString& file, const LoadedPreset& made) {
                showKept(file, made);
                if (const auto surface = std::exchange(droppedOn_, std::nullopt))
                    applyPresetTo(*surface, made.preset);
            });
    view_->setDropTypes({QString::fromLatin1(kPresetMime)});
    connect(view_, &SceneView::droppedOn, this, [this](SurfaceRef surface, const QMimeData& dropped) {
        const QByteArray text = dropped.data(QString::fromLatin1(kPresetMime));
        if (text.isEmpty() || playback_->active()) return; // a recording shows surfaces of another scene
        const auto read = parsePreset(text.toStdString(), "the dropped preset");
        if (!read) return notice_->showError(QString::fromStdString(read.error().text));
        applyPresetTo(surface, read->preset);
    });
    showPresetCommands();
}

void MainWindow::showPresetCommands() {
    const bool chosen = presets_->chosen(), selected = document_.selection().has_value();
    actions_["preset-apply"].setEnabled(chosen && selected);
    actions_["preset-save"].setEnabled(selected);
    actions_["preset-export"].setEnabled(chosen);
}

void MainWindow::applyPresetTo(const SurfaceRefs& surfaces, const Preset& preset) {
    const QString name = QString::fromStdString(preset.name);
    if (applyPreset(document_, surfaces, preset, presetStore_->presets())) return;
    bool locked = false;
    for (const SurfaceRef ref : surfaces)
        if (const Surface* surface = document_.surface(ref)) locked = locked || surface->locked;
    notice_->showNote(locked ? tr("Nothing was changed: locked surfaces stay as they are. Unlock them (L).")
                             : tr("Nothing was changed: it feels like %1 already.").arg(name));
}

void MainWindow::showKept(const QString& file, const LoadedPreset& made) {
    QString text = tr("%1 is in the library now.").arg(QString::fromStdString(made.preset.name));
    for (const std::string& note : made.notes)
        text += u' ' + QString::fromStdString(note) + u'.';
    notice_->showNote(text);
    presets_->choose(file);
}

void MainWindow::applyChosenPreset() {
    const StoredPreset* stored = presets_->chosen();
    if (!stored || playback_->active()) return;
    if (!document_.selection())
        return notice_->showNote(tr("Select the surfaces that are to feel like %1, or drag it onto one.")
                                     .arg(QString::fromStdString(stored->preset.name)));
    applyPresetTo(document_.selected(), stored->preset);
}

void MainWindow::savePreset() {
    const auto active = document_.selection();
    const Surface* surface = active ? document_.surface(*active) : nullptr;
    if (!surface) return;
    auto* form = new PresetForm(*surface, this);
    connect(form, &QDialog::accepted, this, [this, form] {
        const LoadedPreset made = form->made();
        const QString file = presetStore_->add(made.preset);
        if (!file.isEmpty()) showKept(file, made);
    });
    form->show();
}

void MainWindow::askForPresets() {
    presetStore_->importFiles(
        QFileDialog::getOpenFileNames(this, tr("Import presets"), {},
                                      tr("Presets and texture models (*.%1 *.xml);;Presets (*.%1);;Texture "
                                         "models of the Penn toolkit (*.xml)")
                                          .arg(presetEnding())));
}

void MainWindow::exportPreset() {
    const StoredPreset* stored = presets_->chosen();
    if (!stored) return;
    const Preset preset = stored->preset; // as it is now, whatever is chosen while the dialog is open
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    const QString name = QString::fromStdString(presetFileName(preset.name)) + u'.' + presetEnding();
    const QString file =
        askWhere(this, tr("Export the preset"), {{tr("Presets"), presetEnding()}}, folder + u'/' + name);
    if (!file.isEmpty() && presetStore_->write(preset, file))
        notice_->showNote(tr("The preset was written to %1.").arg(file));
}

bool MainWindow::takePreset(const QString& file, std::optional<SurfaceRef> surface) {
    const bool isPreset = file.endsWith(u'.' + presetEnding(), Qt::CaseInsensitive);
    if (!isPreset && !file.endsWith(QStringLiteral(".xml"), Qt::CaseInsensitive)) return false;
    droppedOn_ = playback_->active() ? std::nullopt : surface;
    presetStore_->importFiles({file});
    return true;
}

} // namespace tactum
