#include "ui/document/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace tactum {

namespace {
const auto kKey = QStringLiteral("recentFiles");
constexpr int kMax = 8;
} // namespace

QStringList recentFiles() {
    QStringList files = QSettings().value(kKey).toStringList();
    files.removeIf([](const QString& file) { return !QFileInfo::exists(file); });
    return files;
}

void rememberFile(const QString& absolutePath) {
    QStringList files = recentFiles();
    files.removeAll(absolutePath);
    files.prepend(absolutePath);
    QSettings().setValue(kKey, QStringList(files.mid(0, kMax)));
}

void forgetRecentFiles() {
    QSettings().remove(kKey);
}

QString placeToSave(const std::filesystem::path& scene, const QStringList& samples) {
    const QFileInfo file(QString::fromStdU16String(scene.u16string()));
    if (!scene.empty() && !samples.contains(file.canonicalFilePath())) return file.filePath();
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    return (documents.exists() ? documents : QDir::home())
        .filePath(scene.empty() ? QStringLiteral("scene.glb") : file.fileName());
}

} // namespace tactum
