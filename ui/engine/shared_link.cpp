#include "ui/engine/shared_link.h"

#include <utility>

#include <QDir>
#include <QRegularExpression>
#include <QStandardPaths>

#include "core/runtime/engine.h"
#include "ui/document/document.h"

namespace tactum {
namespace {

/// The name under which the person is asked to save it.
std::filesystem::path fileFor(QString place) {
    place.replace(QRegularExpression(QStringLiteral("[^A-Za-z0-9.-]")), QStringLiteral("-"));
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    return folder.filePath(SharedLink::tr("scene of %1").arg(place) + QStringLiteral(".glb"))
        .toStdU16String();
}

} // namespace

SharedLink::SharedLink(Document& document, Engine& engine, SharedScene& shared, QObject* parent)
    : QObject(parent), document_(document), engine_(engine), hands_(engine), shared_(shared) {}

void SharedLink::frame() {
    if (auto arrived = shared_.arrived()) take(std::move(*arrived));
    if (const auto why = shared_.refused())
        emit refused(tr("Not done at %1: %2.").arg(state_.place, QString::fromStdString(*why)));
    if (const auto name = shared_.penAskedBy()) emit penAskedBy(QString::fromStdString(*name));
    if (const auto what = shared_.forceSaid())
        emit told(tr("At %1 %2.").arg(state_.place, QString::fromStdString(*what)));
    const SharedState now{QString::fromStdString(shared_.place()),
                          engine_.running(),
                          shared_.holdsPen(),
                          QString::fromStdString(shared_.penHolder()),
                          QString::fromStdString(shared_.penAsker()),
                          int(shared_.attending()),
                          hands_.anyArmed()};
    const SharedState before = std::exchange(state_, now);
    if (before != now) emit changed();
    if (!before.asker.isEmpty() && now.asker.isEmpty()) emit penNotAskedAnyMore();
    if (now.connected && !before.connected && std::exchange(met_, true))
        emit told(
            tr("The connection to %1 was lost, and is there again. The forces are off.").arg(now.place));
}

void SharedLink::take(SharedScene::Arrived arrived) {
    using Arrival = SharedScene::Arrival;
    const QString place = QString::fromStdString(shared_.place());
    const QString who = QString::fromStdString(shared_.penHolder());
    if (arrived.why == Arrival::Begun || document_.empty())
        return document_.adoptShared(std::move(arrived.scene), fileFor(place));
    if (arrived.why == Arrival::Refused) return takeBack(arrived.scene);
    const bool another = arrived.why == Arrival::Another;
    document_.replaceScene(another || who.isEmpty() ? tr("Scene of %1").arg(place)
                                                    : tr("Changed by %1").arg(who),
                           arrived.scene);
    if (another) return emit foundAnother(tr("%1 has another scene, which is shown now.").arg(place));
    emit told(tr("%1 has changed the scene; Undo brings the one before back.")
                  .arg(who.isEmpty() ? tr("Somebody") : who));
}

/// What the server did not take is not shown either: the step, an edit, an undo or a redo, is taken back in
/// the history, and can be done again.
void SharedLink::takeBack(const Scene& scene) {
    constexpr int kSteps = 32; // that were quicker than the refusal
    QUndoStack& history = document_.history();
    const int at = history.index();
    for (int away = 0; away <= kSteps; ++away)
        for (const int index : {at - away, at + away}) {
            if (index < 0 || index > history.count()) continue;
            history.setIndex(index);
            if (document_.scene() == scene) return;
        }
    history.setIndex(at);
    document_.replaceScene(tr("As at %1").arg(QString::fromStdString(shared_.place())), scene);
}

} // namespace tactum
