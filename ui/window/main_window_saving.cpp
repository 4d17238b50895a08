// Saving the scene, and not losing it.
#include "ui/window/main_window.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "core/bundle/bundle.h"
#include "core/files/save_scene.h"
#include "ui/base/ask_where.h"
#include "ui/document/recent_files.h"
#include "ui/panels/start_page.h"
#include "ui/showing/playback.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

QString fileOf(const Document& document) {
    return QString::fromStdU16String(document.path().u16string());
}

std::filesystem::path pathOf(const QString& file) {
    return std::filesystem::path(file.toStdU16String());
}

/// Beside the scene's file; what is made of a sample belongs to the person, not beside the samples.
QString placeToSave(const Document& document, const QStringList& samples) {
    const QFileInfo file(fileOf(document));
    const bool isNew = document.path().empty();
    if (!isNew && !samples.contains(file.canonicalFilePath())) return file.filePath();
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    return (documents.exists() ? documents : QDir::home())
        .filePath(isNew ? QStringLiteral("scene.glb") : file.fileName());
}

} // namespace

void MainWindow::connectSaving() {
    connect(&actions_["save"], &QAction::triggered, this, &MainWindow::save);
    connect(&actions_["save-as"], &QAction::triggered, this, &MainWindow::saveAs);
    connect(&actions_["export-report"], &QAction::triggered, this, &MainWindow::exportReport);
    connect(&actions_["export"], &QAction::triggered, this, &MainWindow::exportBundle);
    connect(&document_, &Document::exported, this, [this](const QString& file) {
        notice_->showNote(tr("The bundle was written to %1.").arg(file));
    });
    connect(&document_, &Document::saveProgressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(tr("Saving"), fraction, secondsLeft, true);
    });
    connect(notice_, &NoticeBar::cancelled, &document_, &Document::cancelSave);
    connect(&document_, &Document::saveFailed, this, [this](const QString& sentence) {
        afterSave_ = nullptr;
        notice_->showError(sentence);
    });
    connect(&document_, &Document::saved, this, [this](const QString& file) {
        showFile();
        notice_->showNote(tr("The scene was saved to %1.").arg(file));
        if (const auto goOn = std::exchange(afterSave_, nullptr)) goOn();
    });
    connect(&document_.history(), &QUndoStack::cleanChanged, this,
            [this](bool clean) { setWindowModified(!clean); });
}

void MainWindow::save() {
    if (!document_.hasOwnFile()) return saveAs();
    if (document_.changedOutside()) return askToOverwrite();
    document_.save(document_.path());
}

void MainWindow::askToOverwrite() {
    auto* question = new QMessageBox(QMessageBox::Warning, tr("Changed by another program"),
                                     tr("%1 has been changed or removed since it was opened.")
                                         .arg(QFileInfo(fileOf(document_)).fileName()),
                                     QMessageBox::Save | QMessageBox::Cancel, this);
    question->setObjectName(QStringLiteral("changed-outside"));
    question->setInformativeText(
        tr("Saving writes this scene over it; what it holds now is kept beside it as the first backup."));
    auto* elsewhere = question->addButton(tr("Save As..."), QMessageBox::ActionRole);
    question->setDefaultButton(elsewhere); // who presses Enter out of habit loses nothing
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QMessageBox::finished, this, [this, question, elsewhere](int answer) {
        if (question->clickedButton() == elsewhere) return saveAs();
        if (answer == QMessageBox::Save) return document_.save(document_.path());
        afterSave_ = nullptr;
    });
    question->open();
}

void MainWindow::saveAs() {
    const QString file =
        askWhere(this, tr("Save the scene"), {{tr("Scenes"), QString::fromUtf8(kSceneEnding)}},
                 placeToSave(document_, samples_));
    if (file.isEmpty())
        afterSave_ = nullptr;
    else
        document_.save(pathOf(file));
}

void MainWindow::exportBundle() {
    const QString file = askWhere(this, tr("Export a bundle"),
                                  {{tr("Bundles"), QString::fromUtf8(kBundleEnding)},
                                   {tr("Bundles as zip"), QString::fromUtf8(kBundleZipEnding)}},
                                  placeToSave(document_, samples_));
    if (!file.isEmpty()) document_.exportBundle(pathOf(file));
}

void MainWindow::exportReport() {
    const QString file =
        askWhere(this, tr("Export a report"),
                 {{tr("Pages"), QStringLiteral("html")}, {tr("Printed pages"), QStringLiteral("pdf")}},
                 placeToSave(document_, samples_));
    if (!file.isEmpty()) writeReport(file);
}

void MainWindow::showFile() {
    const QFileInfo file(fileOf(document_));
    const bool isNew = document_.path().empty();
    setWindowTitle(tr("%1[*] - Tactum").arg(document_.title()));
    setWindowFilePath(isNew ? QString() : file.absoluteFilePath());
    setWindowModified(document_.modified());
    if (!isNew) rememberFile(file.absoluteFilePath());
    start_->setRecent(recentFiles());
}

void MainWindow::leave(const QString& intent, std::function<void()> goOn) {
    if (!document_.modified()) return goOn();
    const bool empty = document_.empty(); // a file of nothing could not be opened again
    auto* question = new QMessageBox(
        QMessageBox::Question, tr("Unsaved changes"),
        empty ? tr("%1 is empty now: throw the changes away before %2?").arg(document_.title(), intent)
              : tr("Save the changes to %1 before %2?").arg(document_.title(), intent),
        (empty ? QMessageBox::NoButton : QMessageBox::Save) | QMessageBox::Discard | QMessageBox::Cancel,
        this);
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
