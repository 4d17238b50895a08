// What a save keeps and refuses. That nothing interrupts it is shown in tests/system.
#include <fstream>
#include <sstream>

#include <sys/stat.h>
#include <unistd.h>

#include <QTest>

#include "core/base/atomic_file.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_atomic_file {

using namespace tactum;
namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

std::string faultOf(const Result<void>& result) {
    return result ? "none" : result.error().text;
}

} // namespace

class TestAtomicFile : public QObject {
    Q_OBJECT

    QTemporaryDir root_;
    fs::path folder_;
    int count_ = 0;

private slots:
    void init() {
        folder_ = fs::path(root_.path().toStdString()) / std::to_string(count_++);
        fs::create_directory(folder_);
    }

    void writesAnyBytes() {
        const std::string bytes("a\0b\r\n\xff", 6);
        for (const std::string& text : {bytes, std::string(), std::string(3 << 20, 'x')}) {
            QCOMPARE(faultOf(writeFileAtomically(folder_ / "a.glb", text)), "none");
            QCOMPARE(read(folder_ / "a.glb"), text);
        }
    }

    void aNameWithoutAFolderIsInThisOne() {
        const fs::path before = fs::current_path();
        fs::current_path(folder_);
        const auto written = writeFileAtomically("a.glb", "1");
        fs::current_path(before);
        QCOMPARE(faultOf(written), "none");
        QCOMPARE(read(folder_ / "a.glb"), "1");
    }

    void theLastVersionsStay() {
        for (const char* text : {"1", "2", "3", "4", "5"})
            QCOMPARE(faultOf(writeFileAtomically(folder_ / "a.glb", text)), "none");
        QCOMPARE(backupOf("a.glb", 1), fs::path("a.glb1"));
        for (const auto& [name, text] :
             {std::pair("a.glb", "5"), {"a.glb1", "4"}, {"a.glb2", "3"}, {"a.glb3", "2"}})
            QCOMPARE(read(folder_ / name), text);
        QCOMPARE(std::distance(fs::directory_iterator(folder_), {}), 4);
    }

    void asManyVersionsStayAsAreAskedFor() {
        for (const char* text : {"1", "2"})
            VERIFY_RESULT(writeFileAtomically(folder_ / "a.csv", text, 0));
        QCOMPARE(std::distance(fs::directory_iterator(folder_), {}), 1);
        for (const char* text : {"3", "4"})
            VERIFY_RESULT(writeFileAtomically(folder_ / "a.csv", text, 1));
        QCOMPARE(read(folder_ / "a.csv1"), "3");
        QCOMPARE(std::distance(fs::directory_iterator(folder_), {}), 2);
    }

    // As a crash between the two renames leaves it.
    void aBackupThatIsTheFileItselfDoesNoHarm() {
        std::ofstream(folder_ / "a.glb") << "1";
        fs::create_hard_link(folder_ / "a.glb", folder_ / "a.glb1");
        QCOMPARE(faultOf(writeFileAtomically(folder_ / "a.glb", "2", 1)), "none");
        QCOMPARE(read(folder_ / "a.glb"), "2");
        QCOMPARE(read(folder_ / "a.glb1"), "1");
        QCOMPARE(std::distance(fs::directory_iterator(folder_), {}), 2);
    }

    void permissionsStay() {
        const fs::path file = folder_ / "a.glb";
        std::ofstream(file) << "1";
        for (const mode_t mode : {0600, 0640, 0666, 0755}) {
            QCOMPARE(chmod(file.c_str(), mode), 0);
            VERIFY_RESULT(writeFileAtomically(file, "2"));
            struct stat now {};
            QCOMPARE(stat(file.c_str(), &now), 0);
            QCOMPARE(now.st_mode & 07777, mode);
        }
    }

    void aNewFileHasTheUsualPermissions() {
        const mode_t mask = umask(027);
        const auto written = writeFileAtomically(folder_ / "a.glb", "1");
        umask(mask);
        VERIFY_RESULT(written);
        QCOMPARE(int(fs::status(folder_ / "a.glb").permissions()), 0640);
    }

    void theOwnerStays() {
        if (geteuid() != 0) QSKIP("only root can give files away");
        const fs::path file = folder_ / "a.glb";
        std::ofstream(file) << "1";
        QCOMPARE(chown(file.c_str(), 1234, 2345), 0);
        QCOMPARE(chmod(file.c_str(), 02640), 0);
        VERIFY_RESULT(writeFileAtomically(file, "2"));
        struct stat now {};
        QCOMPARE(stat(file.c_str(), &now), 0);
        QCOMPARE(now.st_uid, 1234u);
        QCOMPARE(now.st_gid, 2345u);
        QCOMPARE(now.st_mode & 07777, 02640u);
    }

    void aLinkIsFollowed() {
        fs::create_directories(folder_ / "deep" / "er");
        fs::create_symlink("deep/b.glb", folder_ / "a.glb");
        fs::create_symlink("er/c.glb", folder_ / "deep" / "b.glb");
        for (const char* text : {"1", "2"}) { // first it leads to nothing
            QCOMPARE(faultOf(writeFileAtomically(folder_ / "a.glb", text)), "none");
            QVERIFY(fs::is_symlink(folder_ / "a.glb"));
            QVERIFY(fs::is_symlink(folder_ / "deep" / "b.glb"));
            QCOMPARE(read(folder_ / "deep" / "er" / "c.glb"), text);
        }
        QCOMPARE(read(folder_ / "deep" / "er" / "c.glb1"), "1");
    }

    void aRingOfLinksIsRefused() {
        fs::create_symlink("b.glb", folder_ / "a.glb");
        fs::create_symlink("a.glb", folder_ / "b.glb");
        const std::string fault = faultOf(writeFileAtomically(folder_ / "a.glb", "1"));
        COMPARE_CONTAINS(fault, "symbolic links");
    }

    void aFolderOfNoDiskIsCalledThat() {
        if (!fs::is_directory("/proc/self"))
            QSKIP("no /proc here, the one folder that takes no files of an administrator either");
        QCOMPARE(
            faultOf(writeFileAtomically("/proc/x.glb", "1")),
            std::string("/proc/x.glb: cannot be written: its folder takes no files; choose another folder"));
    }

    void refusesWhatIsNoFile_data() {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("folder") << QByteArray("folder") << QByteArray("it is a folder; choose another name");
        QTest::newRow("folder/") << QByteArray("folder/")
                                 << QByteArray("it is a folder; choose another name");
        QTest::newRow("pipe") << QByteArray("pipe")
                              << QByteArray("it is no ordinary file; choose another name");
        QTest::newRow("read-only") << QByteArray("locked")
                                   << QByteArray("Permission denied; check the permissions of the file and");
        QTest::newRow("no folder") << QByteArray("nowhere/a.glb")
                                   << QByteArray("No such file or directory; check the folder");
        QTest::newRow("below a file") << QByteArray("file/a.glb") << QByteArray("Not a directory; check the");
        QTest::newRow("long name") << QByteArray(300, 'x')
                                   << QByteArray("File name too long; choose another");
    }

    void refusesWhatIsNoFile() {
        QFETCH(QByteArray, name);
        QFETCH(QByteArray, words);
        fs::create_directory(folder_ / "folder");
        QCOMPARE(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
        for (const char* file : {"file", "locked"})
            std::ofstream(folder_ / file) << "1";
        QCOMPARE(chmod((folder_ / "locked").c_str(), 0444), 0);
        const fs::path file = folder_ / name.toStdString();
        const std::string fault = faultOf(writeFileAtomically(file, "2"));
        const std::string expected = file.string() + ": cannot be written: " + words.toStdString();
        COMPARE_BEGINS(fault, expected);
        COMPARE_LACKS(fault, "\n");
        QCOMPARE(read(folder_ / "locked"), "1");
        QCOMPARE(std::distance(fs::directory_iterator(folder_), {}), 4);
    }
};

TACTUM_TEST(TestAtomicFile)

} // namespace test_atomic_file

#include "test_atomic_file.moc"
