// Files that tests of the ui open.
#pragma once

#include <QFile>
#include <QString>
#include <QTemporaryDir>

namespace tactum {

/// Returns the file; empty where it could not be written.
inline QString writeFile(const QTemporaryDir& folder, const QString& name, const QByteArray& content) {
    const QString path = folder.filePath(name);
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size()) return {};
    return path;
}

/// A cube of 0.1 m about the origin with a surface for each of its six sides, in the order of their names:
/// right, left, top, bottom, front, back. Returns the file.
inline QString writeCube(const QTemporaryDir& folder, double scale = 1) {
    QByteArray text;
    for (int i = 0; i < 8; ++i)
        text += QStringLiteral("v %1 %2 %3\n")
                    .arg((i & 1 ? 0.05 : -0.05) * scale)
                    .arg((i & 2 ? 0.05 : -0.05) * scale)
                    .arg((i & 4 ? 0.05 : -0.05) * scale)
                    .toLatin1();
    text += "g right\nf 2 4 8 6\ng left\nf 1 5 7 3\ng top\nf 3 7 8 4\ng bottom\nf 1 2 6 5\n"
            "g front\nf 5 6 8 7\ng back\nf 1 3 4 2\n";
    return writeFile(folder, scale == 1 ? QStringLiteral("cube.obj") : QStringLiteral("large.obj"), text);
}

} // namespace tactum
