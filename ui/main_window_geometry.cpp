// Shapes that another program has changed, with the feel that the scene has.
#include "ui/main_window.h"

#include <QAction>
#include <QFileDialog>

#include "ui/panels/finding_list.h"
#include "ui/panels/notice_bar.h"
#include "ui/playback.h"
#include "ui/source_watch.h"

namespace tactum {

namespace {

QString nameOf(const std::filesystem::path& file) {
    return QString::fromStdU16String(file.filename().u16string());
}

QString modelFilter() {
    QStringList patterns;
    for (const std::string& ending : readableEndings())
        patterns << QStringLiteral("*.") + QString::fromStdString(ending);
    return QObject::tr("Models (%1)").arg(patterns.join(u' '));
}

QString sentenceFor(const GeometryUpdate& update) {
    const QString name = nameOf(update.file);
    if (update.withFeel == update.surfaces)
        return MainWindow::tr("The shapes are those of %1 now and feel as before. Undo takes them back.")
            .arg(name);
    return MainWindow::tr("The shapes are those of %1 now; %2 of %3 surfaces feel as before. Undo takes "
                          "them back.")
        .arg(name, QString::number(update.withFeel), QString::number(update.surfaces));
}

} // namespace

void MainWindow::connectGeometry() {
    connect(&actions_["update-geometry"], &QAction::triggered, this, &MainWindow::askForGeometry);
    connect(&document_, &Document::geometryUpdated, this, &MainWindow::showUpdated);
    connect(new SourceWatch(document_, this), &SourceWatch::changed, this, &MainWindow::offerUpdate);
    // Another scene, or the file as it is now: nothing is left of the offer.
    const auto withdraw = [this] { notice_->withdraw(tr("Update geometry")); };
    connect(&document_, &Document::opened, this, withdraw);
}

void MainWindow::askForGeometry() {
    const auto& source = document_.source().path.empty() ? document_.path() : document_.source().path;
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Update geometry from a file"),
                                     QString::fromStdU16String(source.u16string()), modelFilter());
    if (!file.isEmpty()) updateGeometry(std::filesystem::path(file.toStdU16String()));
}

void MainWindow::updateGeometry(const std::filesystem::path& file) {
    playback_->end();
    document_.updateGeometry(file, rememberedAxes(file));
}

void MainWindow::offerUpdate() {
    const std::filesystem::path file = document_.source().path;
    notice_->offer(tr("%1 was changed by another program. Its new shapes can take the feel of this scene.")
                       .arg(nameOf(file)),
                   QStringLiteral("note"), tr("Update geometry"), [this, file] { updateGeometry(file); });
}

void MainWindow::showUpdated(const GeometryUpdate& update) {
    const QString sentence = sentenceFor(update);
    if (update.findings.empty()) return notice_->showNote(sentence);
    notice_->offer(sentence, QStringLiteral("note"), tr("What is not as before"), [this, sentence, update] {
        showFindings(tr("Geometry of %1").arg(nameOf(update.file)), sentence, update.findings, this);
    });
}

} // namespace tactum
