// The files opened last, remembered between sessions.
#pragma once

#include <QStringList>

namespace tactum {

/// Newest first; only files that still exist. Kept in the program's settings. Thread: ui.
QStringList recentFiles();
void rememberFile(const QString& absolutePath);
void forgetRecentFiles();

} // namespace tactum
