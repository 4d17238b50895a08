#include "ui/shared_link.h"

#include <utility>

#include <QDir>
#include <QRegularExpression>
#include <QStandardPaths>

#include "core/runtime/engine.h"
#include "ui/document.h"

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

SharedLink::SharedLink(Document& document, const Engine& engine, SharedScene& shared, QObject* parent)
    : QObject(parent), document_(document), engine_(engine), shared_(shared) {}

void SharedLink::frame() {
    if (auto scene = shared_.arrived()) take(std::move(*scene));
    if (const auto why = shared_.refused())
        emit refused(tr("Not done at %1: %2.").arg(state_.place, QString::fromStdString(*why)));
    if (const auto name = shared_.penAskedBy()) emit penAskedBy(QString::fromStdString(*name));
    const SharedState now{
        QString::fromStdString(shared_.place()),     engine_.running(),        shared_.holdsPen(),
        QString::fromStdString(shared_.penHolder()), int(shared_.attending()), engine_.armed()};
    if (std::exchange(state_, now) != now) emit changed();
}

/// The first is opened, every later one is a step of the history.
void SharedLink::take(Scene scene) {
    const QString place = QString::fromStdString(shared_.place());
    if (!std::exchange(began_, true) || document_.empty())
        return document_.adoptShared(std::move(scene), fileFor(place));
    const QString who = QString::fromStdString(shared_.penHolder());
    document_.replaceScene(who.isEmpty() ? tr("Changed at %1").arg(place) : tr("Changed by %1").arg(who),
                           scene);
    emit changedByOthers(
        tr("%1 has changed the scene; Undo brings yours back.").arg(who.isEmpty() ? tr("Somebody") : who));
}

} // namespace tactum
