// The files opened last, remembered between sessions, and where the next one goes.
#pragma once

#include <filesystem>

#include <QStringList>

namespace tactum {

/// Newest first; only files that still exist. Kept in the program's settings. Thread: ui.
QStringList recentFiles();
void rememberFile(const QString& absolutePath);
void forgetRecentFiles();

/// Where a person is asked to save at first: over the scene's own file, `scene`; among the documents when it
/// has none yet, and when it is one of `samples`, for what is made of a sample belongs to the person.
QString placeToSave(const std::filesystem::path& scene, const QStringList& samples);

} // namespace tactum
