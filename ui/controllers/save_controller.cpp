#include "ui/controllers/save_controller.h"

#include <QAction>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include "core/bundle/bundle.h"
#include "core/files/save_scene.h"
#include "ui/base/ask_where.h"
#include "ui/document/document.h"
#include "ui/document/recent_files.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

QString fileOf(const Document& document) {
    return QString::fromStdU16String(document.path().u16string());
}

std::filesystem::path pathOf(const QString& file) {
    return std::filesystem::path(file.toStdU16String());
}

} // namespace

SaveController::SaveController(const Workbench& bench, const QStringList& samples)
    : QObject(&bench.window), bench_(bench), samples_(samples) {
    Document& document = bench.document;
    bench.on("save", this, [this] { save(); });
    bench.on("save-as", this, [this] { saveAs(); });
    bench.on("export", this, [this] { exportBundle(); });
    connect(&document, &Document::exported, this, [this](const QString& file) {
        bench_.notice.showNote(tr("The bundle was written to %1.").arg(file));
    });
    connect(&document, &Document::saveProgressed, this, [this](double fraction, double secondsLeft) {
        bench_.notice.showProgress(tr("Saving"), fraction, secondsLeft, true);
    });
    connect(&bench.notice, &NoticeBar::cancelled, &document, &Document::cancelSave);
    connect(&document, &Document::saveFailed, this, [this](const QString& sentence) {
        afterSave_ = nullptr;
        bench_.notice.showError(sentence);
    });
    connect(&document, &Document::saved, this, &SaveController::goOnAfter);
    connect(&document, &Document::opened, this, [this] { bench_.notice.takeBack(wasSaved_); });
    connect(&document.history(), &QUndoStack::cleanChanged, this, [this](bool clean) {
        bench_.window.setWindowModified(!clean);
        if (!clean) bench_.notice.takeBack(wasSaved_);
    });
}

void SaveController::goOnAfter(const QString& file) {
    showFile();
    wasSaved_ = tr("The scene was saved to %1.").arg(file);
    bench_.notice.showNote(wasSaved_);
    if (const auto goOn = std::exchange(afterSave_, nullptr)) goOn();
}

void SaveController::save() {
    if (!bench_.document.hasOwnFile()) return saveAs();
    if (bench_.document.changedOutside()) return askToOverwrite();
    bench_.document.save(bench_.document.path());
}

void SaveController::askToOverwrite() {
    auto* question = new QMessageBox(QMessageBox::Warning, tr("Changed by another program"),
                                     tr("%1 has been changed or removed since it was opened.")
                                         .arg(QFileInfo(fileOf(bench_.document)).fileName()),
                                     QMessageBox::Save | QMessageBox::Cancel, &bench_.window);
    question->setObjectName(QStringLiteral("changed-outside"));
    question->setInformativeText(
        tr("Saving writes this scene over it; what it holds now is kept beside it as the first backup."));
    auto* elsewhere = question->addButton(tr("Save As..."), QMessageBox::ActionRole);
    question->setDefaultButton(elsewhere); // who presses Enter out of habit loses nothing
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [this, question, elsewhere](int answer) {
        if (question->clickedButton() == elsewhere) return saveAs();
        if (answer == QMessageBox::Save) return bench_.document.save(bench_.document.path());
        afterSave_ = nullptr;
    });
    question->open();
}

void SaveController::saveAs() {
    const QString file =
        askWhere(&bench_.window, tr("Save the scene"), {{tr("Scenes"), QString::fromUtf8(kSceneEnding)}},
                 placeToSave(bench_.document.path(), samples_));
    if (file.isEmpty())
        afterSave_ = nullptr;
    else
        bench_.document.save(pathOf(file));
}

void SaveController::exportBundle() {
    const QString file = askWhere(&bench_.window, tr("Export a bundle"),
                                  {{tr("Bundles"), QString::fromUtf8(kBundleEnding)},
                                   {tr("Bundles as zip"), QString::fromUtf8(kBundleZipEnding)}},
                                  placeToSave(bench_.document.path(), samples_));
    if (!file.isEmpty()) bench_.document.exportBundle(pathOf(file));
}

void SaveController::showFile() {
    const QFileInfo file(fileOf(bench_.document));
    const bool isNew = bench_.document.path().empty();
    bench_.window.setWindowTitle(tr("%1[*] - Tactum").arg(bench_.document.title()));
    bench_.window.setWindowFilePath(isNew ? QString() : file.absoluteFilePath());
    bench_.window.setWindowModified(bench_.document.modified());
    if (!isNew) rememberFile(file.absoluteFilePath());
    emit filesChanged();
}

void SaveController::leave(const QString& intent, const std::function<void()>& goOn) {
    if (!bench_.document.modified()) return goOn();
    const bool empty = bench_.document.empty(); // a file of nothing could not be opened again
    auto* question = new QMessageBox(
        QMessageBox::Question, tr("Unsaved changes"),
        empty ? tr("%1 is empty now: throw the changes away before %2?").arg(bench_.document.title(), intent)
              : tr("Save the changes to %1 before %2?").arg(bench_.document.title(), intent),
        (empty ? QMessageBox::NoButton : QMessageBox::Save) | QMessageBox::Discard | QMessageBox::Cancel,
        &bench_.window);
    question->setObjectName(QStringLiteral("unsaved"));
    question->setInformativeText(tr("They are lost otherwise."));
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [=, this](int answer) {
        if (answer == QMessageBox::Discard) return goOn();
        if (answer != QMessageBox::Save) return;
        afterSave_ = [=, this] { leave(intent, goOn); }; // who edited meanwhile is asked again
        save();
    });
    question->open();
}

} // namespace tactum
