#include "tests/support/as_shown.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace tactum::test {

bool isAsShown(const QString& text, const char* name, const Comparison& at) {
    const QDir folder(QFileInfo(QString::fromUtf8(at.file)).dir().filePath(QStringLiteral("shown")));
    const QString path = folder.filePath(QString::fromUtf8(name) + QStringLiteral(".txt"));
    static QStringList written; // what is compared twice has to be the same twice
    if (qEnvironmentVariableIsSet("TACTUM_WRITE_SHOWN") && !written.contains(path)) {
        written << path;
        QFile file(path);
        if (!folder.mkpath(QStringLiteral(".")) || !file.open(QIODevice::WriteOnly)) qFatal("no file");
        file.write(text.toUtf8());
        return true;
    }
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return QTest::qVerify(false, qPrintable(path), "There is no such file; see tests/support/as_shown.h",
                              at.file, at.line);
    const QStringList now = text.split(u'\n'), wanted = QString::fromUtf8(file.readAll()).split(u'\n');
    qsizetype i = 0;
    while (i < now.size() && i < wanted.size() && now[i] == wanted[i])
        ++i;
    if (i == now.size() && i == wanted.size()) return true;
    const QString message =
        QStringLiteral("%1.txt:%2\nnow    %3\nwanted %4")
            .arg(QString::fromUtf8(name))
            .arg(i + 1)
            .arg(now.value(i, QStringLiteral("(its end)")), wanted.value(i, QStringLiteral("(its end)")));
    return QTest::qVerify(false, at.actual, qPrintable(message), at.file, at.line);
}

} // namespace tactum::test
