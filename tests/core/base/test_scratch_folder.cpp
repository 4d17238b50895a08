// A folder that is there as long as its object.
#include <cstdlib>
#include <fstream>
#include <sys/stat.h>

#include <QTemporaryDir>
#include <QTest>

#include "core/base/scratch_folder.h"
#include "tests/support/test_program.h"

namespace test_scratch_folder {

using namespace tactum;

class TestScratchFolder : public QObject {
    Q_OBJECT

    QTemporaryDir all_;

private slots:
    void init() { qputenv("TMPDIR", all_.path().toLocal8Bit()); }

    void isThereAsLongAsItsObject() {
        std::filesystem::path first, second;
        {
            const ScratchFolder one("scan"), other("scan");
            first = one.path(), second = other.path();
            QVERIFY(first != second);
            for (const auto& each : {first, second}) {
                QCOMPARE(each.parent_path(), std::filesystem::path(all_.path().toStdString()));
                QVERIFY(each.filename().string().starts_with("tactum-scan-"));
                struct stat said {};
                QCOMPARE(stat(each.c_str(), &said), 0);
                QVERIFY(S_ISDIR(said.st_mode));
                QCOMPARE(said.st_mode & 0777u, 0700u); // for this person alone
            }
            std::filesystem::create_directory(first / "inner");
            std::ofstream(first / "inner/file") << "with all that is in it";
        }
        QVERIFY(!std::filesystem::exists(first));
        QVERIFY(!std::filesystem::exists(second));
        QVERIFY(std::filesystem::is_empty(all_.path().toStdString()));
    }

    void thereIsNoneWithoutAPlace() {
        qputenv("TMPDIR", all_.filePath(QStringLiteral("none")).toLocal8Bit());
        QCOMPARE(ScratchFolder("scan").path(), std::filesystem::path());
        qputenv("TMPDIR", all_.path().toLocal8Bit());
        QCOMPARE(ScratchFolder("none/such").path(), std::filesystem::path());
    }
};

TACTUM_TEST(TestScratchFolder)

} // namespace test_scratch_folder

#include "test_scratch_folder.moc"
