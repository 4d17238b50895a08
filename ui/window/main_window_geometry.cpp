// Shapes that another program has changed, with the feel that the scene has.
#include "ui/window/main_window.h"

#include <algorithm>

#include <QAction>
#include <QDialog>
#include <QFileDialog>

#include "ui/base/ask_where.h"
#include "ui/base/numbers.h"
#include "ui/base/words.h"
#include "ui/document/source_watch.h"
#include "ui/panels/finding_list.h"
#include "ui/showing/playback.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

QString nameOf(const std::filesystem::path& file) {
    return QString::fromStdU16String(file.filename().u16string());
}

QString countText(std::size_t count, const char* noun) {
    return QString::fromStdString(counted(count, noun));
}

QString unitName(const FileAxes& axes) {
    const auto unit = std::ranges::find(kLengthUnits, axes.unit, &LengthUnit::metres);
    return unit == std::end(kLengthUnits) ? QString() : asIs(unit->name);
}

/// "1000 times smaller"
QString timesText(double grown) {
    const double times = grown < 1 ? 1 / grown : grown;
    return (grown < 1 ? MainWindow::tr("%1 times smaller") : MainWindow::tr("%1 times larger"))
        .arg(numberText(times, times < 9.95 ? 1 : 0));
}

/// What a person would miss who was told that everything feels as before.
QStringList missingOf(const GeometryUpdate& update) {
    QStringList missing;
    if (const auto lost = update.surfacesLost)
        missing << (lost == 1 ? MainWindow::tr("%1 of %2 is not there any more")
                              : MainWindow::tr("%1 of %2 are not there any more"))
                       .arg(QString::number(lost), countText(update.surfacesBefore, "surface"));
    if (const auto added = update.surfaces - update.withFeel)
        missing << (added == 1 ? MainWindow::tr("%1 has no feel from here")
                               : MainWindow::tr("%1 have no feel from here"))
                       .arg(countText(added, "surface"));
    const auto leftOut = [&](std::size_t count, const char* noun) {
        if (count > 0)
            missing << (count == 1 ? MainWindow::tr("%1 was left out") : MainWindow::tr("%1 were left out"))
                           .arg(countText(count, noun));
    };
    leftOut(update.layersLost, "painted layer");
    leftOut(update.bodiesLost, "body");
    return missing;
}

QString sentenceFor(const GeometryUpdate& update) {
    const QString name = nameOf(update.file);
    if (!update.changed) return MainWindow::tr("%1 has the shapes that are here already.").arg(name);
    QString more;
    if (update.axes)
        more += MainWindow::tr(" One unit is taken as 1 %1 and no longer as 1 %2, by which it would be %3 "
                               "than before.")
                    .arg(unitName(*update.axes), unitName(*update.axesBefore), timesText(update.grown));
    else if (update.grown > 3 || update.grown < 1.0 / 3)
        more += MainWindow::tr(" They are %1 than before.").arg(timesText(update.grown));
    if (update.back > 0)
        more +=
            MainWindow::tr(" %1 came back with the feel of before.").arg(countText(update.back, "surface"));
    const QStringList missing = missingOf(update);
    if (missing.isEmpty() && more.isEmpty())
        return MainWindow::tr("The shapes are those of %1 now and feel as before. Undo takes them back.")
            .arg(name);
    const QString rest =
        missing.isEmpty() ? MainWindow::tr("They feel as before") : missing.join(MainWindow::tr(", "));
    return MainWindow::tr("The shapes are those of %1 now.%2 %3.").arg(name, more, rest);
}

} // namespace

void MainWindow::connectGeometry() {
    connect(&actions_["update-geometry"], &QAction::triggered, this, &MainWindow::askForGeometry);
    connect(&document_, &Document::geometryUpdated, this, &MainWindow::showUpdated);
    connect(new SourceWatch(document_, this), &SourceWatch::changed, this, &MainWindow::offerUpdate);
    // Another scene, or the file as it is now: nothing is left of the offer.
    const auto withdraw = [this] { notice_->withdraw(tr("Update geometry")); };
    connect(&document_, &Document::opened, this, withdraw);
    connect(&document_.history(), &QUndoStack::indexChanged, this, &MainWindow::followTold);
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
    if (updateList_) updateList_->close(); // of the update before
    const QString sentence = sentenceFor(update);
    told_ = sentence;
    toldStep_ = update.changed ? document_.history().index() : 0;
    const bool plain = update.findings.empty();
    if (plain)
        notice_->showNote(sentence);
    else
        notice_->offer(sentence, QStringLiteral("note"), tr("What is not as before"),
                       [this, sentence, update] {
                           updateList_ = showFindings(tr("Geometry of %1").arg(nameOf(update.file)), sentence,
                                                      update.findings, this);
                       });
    if (!plain && update.changed) notice_->alsoOffer(tr("Undo"), [this] { document_.history().undo(); });
}

/// What is told of an update goes when it is undone; after another edit Undo would take that back.
void MainWindow::followTold(int step) {
    if (toldStep_ == 0 || step == toldStep_) return;
    if (step > toldStep_) return notice_->takeBackAlso(told_);
    toldStep_ = 0;
    notice_->takeBack(told_);
    if (updateList_) updateList_->close();
}

} // namespace tactum
