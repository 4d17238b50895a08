// Drivers of other people's: what is found, what is refused and why, and the one that docs/drivers.md is
// about.
#include <QFile>
#include <QTest>

#include "device/plugin/plugin.h"
#include "tests/device/plugin/fake_2diy.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_plugin {

using namespace tactum;
using namespace tactum::test;

class TestPlugin : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    void put(const char* library, const char* name) const {
        QVERIFY(QFile::link(library, folder_.filePath(name)));
    }
    /// Of the one library in the folder.
    DeviceListing only(const char* library) const {
        put(library, "lab.so");
        const auto listings = listPlugins();
        return listings.size() == 1 ? listings[0] : DeviceListing{};
    }
    static bool isOneLine(const std::string& text) {
        return text.size() > 20 && text.find('\n') == std::string::npos;
    }
    /// Until the board has answered with where its handle is now.
    static DeviceSample settled(HapticDevice& device, const Vec3& force = Vec3::Zero()) {
        DeviceSample sample;
        int fresh = 0;
        for (Patience patience; fresh < 5 && !patience.isOver();) {
            if (const DeviceSample now = device.exchange({force}, 1e-3); now.valid) {
                sample = now;
                ++fresh;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        return sample;
    }

private slots:
    void init() {
        folder_ = QTemporaryDir();
        qputenv("TACTUM_DRIVERS", folder_.path().toLocal8Bit());
    }
    void cleanup() { qunsetenv("TACTUM_DRIVERS"); }

    void whereTheyAreLookedFor() {
        using Folders = std::vector<std::filesystem::path>;
        qputenv("TACTUM_DRIVERS", "/one::/two:");
        QVERIFY(driverFolders() == (Folders{"/one", "/two"}));
        qunsetenv("TACTUM_DRIVERS");
        qputenv("XDG_DATA_HOME", "/data");
        QVERIFY(driverFolders() == Folders{"/data/Tactum/drivers"});
        qunsetenv("XDG_DATA_HOME");
        const QByteArray home = qgetenv("HOME");
        qputenv("HOME", "/home/person");
        QVERIFY(driverFolders() == Folders{"/home/person/.local/share/Tactum/drivers"});
        qputenv("HOME", home);
    }

    void noDriverNoDevice() {
        QCOMPARE(listPlugins().size(), 0U);
        const auto none = makePlugin("driver:lab:port");
        QVERIFY(!none);
        QVERIFY2(none.error().text.find("driver:lab:port") != std::string::npos, none.error().text.c_str());
    }

    void whatIsNoDriverIsSaidAndNotUsed_data() {
        QTest::addColumn<QString>("library");
        QTest::addColumn<QString>("says");
        QTest::newRow("no library") << TACTUM_SOURCE_OF_A_DRIVER << "cannot be loaded";
        QTest::newRow("no function") << TACTUM_DRIVER_WITHOUT_ENTRY << "no function tactum_driver()";
        QTest::newRow("another version") << TACTUM_DRIVER_OTHER_VERSION << "another version";
        QTest::newRow("lacks a function")
            << TACTUM_DRIVER_LACKS_EXCHANGE << "lacks find, open, exchange or close";
        QTest::newRow("figures") << TACTUM_DRIVER_WITHOUT_FORCE << "largest force";
    }
    void whatIsNoDriverIsSaidAndNotUsed() {
        QFETCH(QString, library);
        QFETCH(QString, says);
        const DeviceListing listing = only(qPrintable(library));
        QVERIFY(!listing.usable);
        QCOMPARE(listing.id, std::string());
        QVERIFY2(QString::fromStdString(listing.sentence).contains(says), listing.sentence.c_str());
        QVERIFY2(isOneLine(listing.sentence), listing.sentence.c_str());
        QVERIFY(!makePlugin("driver:lab:p"));
    }

    /// Texts without an end, line feeds in names, more devices than there is room for.
    void whatADriverWritesWronglyDoesNoHarm() {
        put(TACTUM_DRIVER_COUNTS_WRONG, "lab.so");
        const auto listings = listPlugins();
        QCOMPARE(listings.size(), 16U);
        QVERIFY(listings[0].usable);
        QCOMPARE_LE(listings[0].id.size(), 300U);
        QVERIFY2(listings[0].name.find('\n') == std::string::npos, listings[0].name.c_str());
        const auto device = makePlugin(listings[0].id);
        VERIFY_RESULT(device);
        const auto opened = (*device)->open();
        QVERIFY(!opened);
        QVERIFY2(isOneLine(opened.error().text), opened.error().text.c_str());
        QVERIFY(!(*device)->exchange({}, 1e-3).valid);
    }

    void theExampleIsFoundWithItsFigures() {
        Fake2diy board;
        const DeviceListing listing = only(TACTUM_HAPLY_2DIY);
        QVERIFY2(listing.usable, listing.sentence.c_str());
        QCOMPARE(listing.name, std::string("Haply 2DIY"));
        const auto device = makePlugin(listing.id);
        VERIFY_RESULT(device);
        QCOMPARE((*device)->info().maxForce, 0.8);
        QCOMPARE((*device)->info().rate, 1000.0);
        QVERIFY((*device)->info().real);
        board.unplug();
        QVERIFY(!makePlugin(listing.id));
    }

    /// A count of its encoders is 0.074 degrees: up to 0.1 mm at the handle.
    void itIsWhereItsHandleIs() {
        Fake2diy board;
        const auto device = makePlugin(only(TACTUM_HAPLY_2DIY).id);
        VERIFY_RESULT(device);
        VERIFY_RESULT((*device)->open());
        for (const Vec3& place :
             {Vec3(0, 0, 0), Vec3(0.02, 0, 0.01), Vec3(-0.03, 0, -0.02), Vec3(0, 0, -0.04)}) {
            board.hold(place);
            const DeviceSample sample = settled(**device);
            QVERIFY(sample.valid);
            QCOMPARE_LE((sample.position - place).norm(), 1e-4);
        }
        QCOMPARE(board.complaints(), 0);
    }

    void itPushesAsItIsAsked() {
        Fake2diy board;
        const auto device = makePlugin(only(TACTUM_HAPLY_2DIY).id);
        VERIFY_RESULT(device);
        VERIFY_RESULT((*device)->open());
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0.02, 0, 0.01), Vec3(-0.02, 0, -0.02)}) {
            board.hold(place);
            settled(**device);
            for (const Vec3& force : {Vec3(0.4, 0, 0), Vec3(0, 0, -0.4), Vec3(-0.3, 0, 0.3)}) {
                settled(**device, force);
                QCOMPARE_LE((board.pushed() - force).norm(), 0.01); // of an angle that is read in steps
            }
            settled(**device, {0, 1, 0}); // its arms lie in a plane
            QCOMPARE_LE(board.pushed().norm(), 1e-6);
        }
        QCOMPARE(board.complaints(), 0);
    }
};

TACTUM_TEST(TestPlugin)

} // namespace test_plugin

#include "test_plugin.moc"
