// Which files are meant: where one is to be written, and what can be read.
#pragma once

#include <QList>
#include <QString>

class QWidget;

namespace tactum {

/// Of a dialog that asks for models: every ending that is read.
QString modelFilter();

/// What people call such files, and how their names end, without the dot.
struct FileKind {
    QString name, ending;
};

/// Empty when the person thinks better of it. Not by the static function: its dialog would not add the
/// ending. An ending of no `kind` would promise another format, so that of the chosen kind goes behind it.
/// @param now a file of the first kind, or one whose name it takes over
QString askWhere(QWidget* parent, const QString& title, const QList<FileKind>& kinds, const QString& now);

} // namespace tactum
