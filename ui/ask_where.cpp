#include "ui/ask_where.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

namespace tactum {

namespace {

bool mayReplace(QWidget* parent, const QString& file) {
    return QMessageBox::question(parent, QObject::tr("Replace the file"),
                                 QObject::tr("%1 is there already. Replace it?").arg(file)) ==
           QMessageBox::Yes;
}

} // namespace

QString askWhere(QWidget* parent, const QString& title, const QString& kind, const char* ending,
                 const QString& now) {
    const QString suffix = QString::fromUtf8(ending);
    QFileDialog dialog(parent, title, QFileInfo(now).path(), QStringLiteral("%1 (*.%2)").arg(kind, suffix));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(suffix);
    dialog.selectFile(QFileInfo(now).completeBaseName() + u'.' + suffix);
    if (dialog.exec() != QDialog::Accepted) return {};
    QString file = dialog.selectedFiles().value(0);
    if (file.endsWith(u'.' + suffix, Qt::CaseInsensitive)) return file;
    file += u'.' + suffix;
    return !QFileInfo::exists(file) || mayReplace(parent, file) ? file : QString();
}

} // namespace tactum
