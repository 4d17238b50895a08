// Where a file is to be written.
#pragma once

#include <QString>

class QWidget;

namespace tactum {

/// Empty when the person thinks better of it. Not by the static function: its dialog would not add the
/// ending. Another ending than the kind's would promise another format, so it gets this one behind it.
QString askWhere(QWidget* parent, const QString& title, const QString& kind, const char* ending,
                 const QString& now);

} // namespace tactum
