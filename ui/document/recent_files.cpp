#include "ui/document/recent_files.h"

#include <QFileInfo>
#include <QSettings>

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

} // namespace tactum
