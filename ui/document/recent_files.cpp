#include "ui/document/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace tactum {

namespace {

const auto kKey = QStringLiteral("recentFiles"), kTimes = QStringLiteral("recentTimes");
constexpr int kMax = 8;

QStringList paths() {
    return QSettings().value(kKey).toStringList();
}

/// The times of files that are no longer among these go.
void keep(const QStringList& files, const QVariantMap& times) {
    QVariantMap kept;
    for (const QString& file : files)
        if (times.contains(file)) kept[file] = times[file];
    QSettings().setValue(kKey, files);
    QSettings().setValue(kTimes, kept);
}

} // namespace

QList<RecentFile> recentlyOpened() {
    const QVariantMap times = QSettings().value(kTimes).toMap();
    QList<RecentFile> files;
    for (const QString& path : paths())
        files << RecentFile{path, times.value(path).toDateTime()};
    return files;
}

QStringList recentFiles() {
    QStringList files = paths();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

void rememberFile(const QString& absolutePath) {
    if (!QFileInfo::exists(absolutePath)) return; // it is a server's
    QStringList files = paths();
    files.removeAll(absolutePath);
    files.prepend(absolutePath);
    QVariantMap times = QSettings().value(kTimes).toMap();
    times[absolutePath] = QDateTime::currentDateTime();
    keep(files.mid(0, kMax), times);
}

void forgetFile(const QString& absolutePath) {
    QStringList files = paths();
    files.removeAll(absolutePath);
    keep(files, QSettings().value(kTimes).toMap());
}

void forgetRecentFiles() {
    QSettings().remove(kKey);
    QSettings().remove(kTimes);
}

QString placeToSave(const std::filesystem::path& scene, const QStringList& samples) {
    const QFileInfo file(QString::fromStdU16String(scene.u16string()));
    if (!scene.empty() && !samples.contains(file.canonicalFilePath())) return file.filePath();
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    return (documents.exists() ? documents : QDir::home())
        .filePath(scene.empty() ? QStringLiteral("scene.glb") : file.fileName());
}

} // namespace tactum
