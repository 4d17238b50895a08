// The files opened last, remembered between sessions, and where the next one goes.
#pragma once

#include <filesystem>

#include <QDateTime>
#include <QStringList>

namespace tactum {

struct RecentFile {
    QString path;
    QDateTime opened; ///< or saved, the last time; invalid where nobody noted it
    bool operator==(const RecentFile&) const = default;
};

/// Newest first, also those that are gone by now. Kept in the program's settings. Thread: ui.
QList<RecentFile> recentlyOpened();
/// The paths of those that still exist.
QStringList recentFiles();
void rememberFile(const QString& absolutePath);
void forgetFile(const QString& absolutePath);
void forgetRecentFiles();

/// Where a person is asked to save at first: over the scene's own file, `scene`; among the documents when it
/// has none yet, and when it is one of `samples`, for what is made of a sample belongs to the person.
QString placeToSave(const std::filesystem::path& scene, const QStringList& samples);

} // namespace tactum
