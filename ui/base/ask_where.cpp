#include "ui/base/ask_where.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QSettings>

#include <algorithm>
#include <iterator>

#include "core/files/load_scene.h"

namespace tactum {

namespace {

bool mayReplace(QWidget* parent, const QString& file) {
    return QMessageBox::question(parent, QObject::tr("Replace the file"),
                                 QObject::tr("%1 is there already. Replace it?").arg(file)) ==
           QMessageBox::Yes;
}

QString filterOf(const FileKind& kind) {
    return QStringLiteral("%1 (*.%2)").arg(kind.name, kind.ending);
}

bool isOf(const FileKind& kind, const QString& file) {
    return file.endsWith(u'.' + kind.ending, Qt::CaseInsensitive);
}

} // namespace

QString modelFilter() {
    QStringList patterns;
    for (const std::string& ending : readableEndings())
        patterns << QStringLiteral("*.") + QString::fromStdString(ending);
    return QObject::tr("Models (%1)").arg(patterns.join(u' '));
}

namespace {
const auto kFolder = QStringLiteral("files/folder");

/// Where the last file was written, for a name without a place.
QString folderFor(const QString& now) {
    if (QFileInfo(now).isAbsolute()) return QFileInfo(now).path();
    const QString last = QSettings().value(kFolder).toString();
    return QFileInfo(last).isDir() ? last : QDir::homePath();
}
} // namespace

QString askWhere(QWidget* parent, const QString& title, const QList<FileKind>& kinds, const QString& now) {
    QFileDialog dialog(parent, title, folderFor(now));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    QStringList filters;
    std::ranges::transform(kinds, std::back_inserter(filters), filterOf);
    dialog.setNameFilters(filters);
    const auto chosen = [&]() -> const FileKind& {
        return kinds[std::max<qsizetype>(0, filters.indexOf(dialog.selectedNameFilter()))];
    };
    dialog.setDefaultSuffix(chosen().ending);
    // The dialog itself changes the ending of a name that has one.
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                     [&] { dialog.setDefaultSuffix(chosen().ending); });
    dialog.selectFile(isOf(chosen(), now) ? QFileInfo(now).fileName()
                                          : QFileInfo(now).completeBaseName() + u'.' + chosen().ending);
    if (dialog.exec() != QDialog::Accepted) return {};
    QString file = dialog.selectedFiles().value(0);
    QSettings().setValue(kFolder, QFileInfo(file).path());
    if (std::ranges::any_of(kinds, [&](const FileKind& kind) { return isOf(kind, file); })) return file;
    file += u'.' + chosen().ending;
    return !QFileInfo::exists(file) || mayReplace(parent, file) ? file : QString();
}

} // namespace tactum
