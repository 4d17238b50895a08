// Folders of a test's own, where the program keeps what is a person's.
#pragma once

#include <QCoreApplication>
#include <QSettings>
#include <QString>

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

} // namespace tactum
