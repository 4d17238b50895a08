// The files opened last, and where the next one goes. Wrong itself if the settings were another program's:
// each run has its own.
#include <QDir>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/ui/cube_file.h"
#include "tests/ui/own_folders.h"
#include "ui/document/recent_files.h"

namespace test_recent_files {

using namespace tactum;

class TestRecentFiles : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString file(int number) { return writeFile(folder_, QStringLiteral("%1.obj").arg(number), "x"); }
    /// By their numbers.
    static QString numbers(const QStringList& files) {
        QString all;
        for (const QString& each : files)
            all += QFileInfo(each).completeBaseName();
        return all;
    }

private slots:
    void init() {
        useFoldersIn(folder_.path());
        forgetRecentFiles();
    }

    void theNewestComeFirst() {
        QCOMPARE(numbers(recentFiles()), "");
        QCOMPARE(recentlyOpened().size(), 0);
        const QDateTime before = QDateTime::currentDateTime();
        for (const int number : {1, 2, 3, 1})
            rememberFile(file(number));
        QCOMPARE(numbers(recentFiles()), "132");
        for (const RecentFile& each : recentlyOpened())
            QVERIFY(each.opened >= before && each.opened <= QDateTime::currentDateTime());
        QCOMPARE(recentlyOpened().front().path, file(1));
        forgetFile(file(3));
        forgetFile(file(9));
        QCOMPARE(numbers(recentFiles()), "12");
        QVERIFY(recentlyOpened()[1].opened.isValid());
        forgetRecentFiles();
        QCOMPARE(numbers(recentFiles()), "");
        QCOMPARE(QSettings().allKeys().join(u' '), ""); // nor their times
    }

    void eightAreKept() {
        for (int number = 1; number <= 9; ++number)
            rememberFile(file(number));
        QCOMPARE(numbers(recentFiles()), "98765432");
        QCOMPARE(QSettings().value(QStringLiteral("recentTimes")).toMap().size(), 8);
    }

    void whatIsGoneIsKnownStill() {
        for (int number = 1; number <= 3; ++number)
            rememberFile(file(number));
        QVERIFY(QFile::remove(file(2)));
        QCOMPARE(numbers(recentFiles()), "31");
        QCOMPARE(recentlyOpened().size(), 3);
        QCOMPARE(recentlyOpened()[1].path, folder_.filePath(QStringLiteral("2.obj")));
        rememberFile(QStringLiteral("/none/such.obj")); // a server's
        QCOMPARE(recentlyOpened().size(), 3);
    }

    void timesOfOlderProgramsAreUnknown() {
        QSettings().setValue(QStringLiteral("recentFiles"), QStringList{file(5)});
        QCOMPARE(recentlyOpened().size(), 1);
        QVERIFY(!recentlyOpened().front().opened.isValid());
    }

    void whereTheNextOneGoes() {
        const QString own = file(1), sample = file(2);
        const auto place = [&](const QString& scene) { return placeToSave(scene.toStdString(), {sample}); };
        QCOMPARE(place(own), own);
        qputenv("HOME", folder_.path().toLocal8Bit());
        qputenv("XDG_CONFIG_HOME",
                folder_.filePath(QStringLiteral("none")).toLocal8Bit());    // no names of folders
        QCOMPARE(place({}), folder_.filePath(QStringLiteral("scene.glb"))); // no folder for documents
        QVERIFY(QDir(folder_.path()).mkdir(QStringLiteral("Documents")));
        QCOMPARE(place({}), folder_.filePath(QStringLiteral("Documents/scene.glb")));
        QCOMPARE(place(sample), folder_.filePath(QStringLiteral("Documents/2.obj")));
        QCOMPARE(place(QStringLiteral("relative.glb")), "relative.glb");
    }
};

TACTUM_TEST(TestRecentFiles)

} // namespace test_recent_files

#include "test_recent_files.moc"
