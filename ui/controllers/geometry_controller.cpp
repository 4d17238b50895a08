#include "ui/controllers/geometry_controller.h"

#include <algorithm>

#include <QAction>
#include <QDialog>
#include <QFileDialog>

#include "ui/base/ask_where.h"
#include "ui/base/numbers.h"
#include "ui/base/words.h"
#include "ui/controllers/edit_notice.h"
#include "ui/document/document.h"
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
    return (grown < 1 ? GeometryController::tr("%1 times smaller")
                      : GeometryController::tr("%1 times larger"))
        .arg(numberText(times, times < 9.95 ? 1 : 0));
}

/// What a person would miss who was told that everything feels as before.
QStringList missingOf(const GeometryUpdate& update) {
    QStringList missing;
    if (const auto lost = update.surfacesLost)
        missing << (lost == 1 ? GeometryController::tr("%1 of %2 is not there any more")
                              : GeometryController::tr("%1 of %2 are not there any more"))
                       .arg(QString::number(lost), countText(update.surfacesBefore, "surface"));
    if (const auto added = update.surfaces - update.withFeel)
        missing << (added == 1 ? GeometryController::tr("%1 has no feel from here")
                               : GeometryController::tr("%1 have no feel from here"))
                       .arg(countText(added, "surface"));
    const auto leftOut = [&](std::size_t count, const char* noun) {
        if (count > 0)
            missing << (count == 1 ? GeometryController::tr("%1 was left out")
                                   : GeometryController::tr("%1 were left out"))
                           .arg(countText(count, noun));
    };
    leftOut(update.layersLost, "painted layer");
    leftOut(update.bodiesLost, "body");
    return missing;
}

QString sentenceFor(const GeometryUpdate& update) {
    const QString name = nameOf(update.file);
    if (!update.changed) return GeometryController::tr("%1 has the shapes that are here already.").arg(name);
    QString more;
    if (update.axes)
        more += GeometryController::tr(
                    " One unit is taken as 1 %1 and no longer as 1 %2, by which it would be %3 "
                    "than before.")
                    .arg(unitName(*update.axes), unitName(*update.axesBefore), timesText(update.grown));
    else if (update.grown > 3 || update.grown < 1.0 / 3)
        more += GeometryController::tr(" They are %1 than before.").arg(timesText(update.grown));
    if (update.back > 0)
        more += GeometryController::tr(" %1 came back with the feel of before.")
                    .arg(countText(update.back, "surface"));
    const QStringList missing = missingOf(update);
    if (missing.isEmpty() && more.isEmpty())
        return GeometryController::tr(
                   "The shapes are those of %1 now and feel as before. Undo takes them back.")
            .arg(name);
    const QString rest = missing.isEmpty() ? GeometryController::tr("They feel as before")
                                           : missing.join(GeometryController::tr(", "));
    return GeometryController::tr("The shapes are those of %1 now.%2 %3.").arg(name, more, rest);
}

} // namespace

GeometryController::GeometryController(const Workbench& bench) : QObject(&bench.window), bench_(bench) {
    Document& document = bench.document;
    bench.on("update-geometry", this, [this] { askForFile(); });
    connect(&document, &Document::geometryUpdated, this, &GeometryController::show);
    connect(new SourceWatch(document, this), &SourceWatch::changed, this, &GeometryController::offer);
    // Another scene, or the file as it is now: nothing is left of the offer.
    connect(&document, &Document::opened, this, [this] { bench_.notice.withdraw(tr("Update geometry")); });
    connect(&bench.told, &EditNotice::undone, this, [this] {
        if (list_) list_->close();
    });
}

void GeometryController::askForFile() {
    const auto& source =
        bench_.document.source().path.empty() ? bench_.document.path() : bench_.document.source().path;
    const QString file =
        QFileDialog::getOpenFileName(&bench_.window, tr("Update geometry from a file"),
                                     QString::fromStdU16String(source.u16string()), modelFilter());
    if (!file.isEmpty()) update(std::filesystem::path(file.toStdU16String()));
}

void GeometryController::update(const std::filesystem::path& file) {
    bench_.playback.end();
    bench_.document.updateGeometry(file, rememberedAxes(file));
}

void GeometryController::offer() {
    const std::filesystem::path file = bench_.document.source().path;
    bench_.notice.offer(
        tr("%1 was changed by another program. Its new shapes can take the feel of this scene.")
            .arg(nameOf(file)),
        QStringLiteral("note"), tr("Update geometry"), [this, file] { update(file); });
}

void GeometryController::show(const GeometryUpdate& update) {
    if (list_) list_->close(); // of the update before
    const QString sentence = sentenceFor(update);
    if (update.changed)
        bench_.told.keep(sentence);
    else
        bench_.told.forget();
    const bool plain = update.findings.empty();
    if (plain)
        bench_.notice.showNote(sentence);
    else
        bench_.notice.offer(sentence, QStringLiteral("note"), tr("What is not as before"),
                            [this, sentence, update] {
                                list_ = showFindings(tr("Geometry of %1").arg(nameOf(update.file)), sentence,
                                                     update.findings, &bench_.window);
                            });
    if (!plain && update.changed)
        bench_.notice.alsoOffer(tr("Undo"), [this] { bench_.document.history().undo(); });
}

} // namespace tactum
