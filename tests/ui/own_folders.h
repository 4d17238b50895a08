// Folders of a test's own, where the program keeps what is a person's.
#pragma once

#include <QCoreApplication>
#include <QDir>
#include <QSettings>
#include <QString>
#include <QTemporaryDir>

namespace tactum {

/// Settings, data (journals, presets) and cache (pictures of recent files) are in `folder` from now on.
inline void useFoldersIn(const QString& folder) {
    QCoreApplication::setOrganizationName(QStringLiteral("TactumTest"));
    QCoreApplication::setApplicationName(QStringLiteral("TactumTest"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
    qputenv("XDG_DATA_HOME", folder.toLocal8Bit());
    qputenv("XDG_CACHE_HOME", folder.toLocal8Bit());
}

/// A new one for each test function.
class FoldersOfEach {
public:
    /// Empty; settings, data and cache are in it from now on.
    QString next() {
        const QString folder = root_.filePath(QString::number(count_++));
        QDir().mkpath(folder);
        useFoldersIn(folder);
        return folder;
    }

private:
    QTemporaryDir root_;
    int count_ = 0;
};

} // namespace tactum
