// Profiles of devices: what is built in can be believed, and what a person writes changes just that.
#include <fstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/port/device_check.h"
#include "core/safety/safe_stiffness.h"
#include "device/profile.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_profile {

using namespace tactum;

namespace {

std::filesystem::path pathOf(const QTemporaryDir& folder) {
    return folder.path().toStdString();
}

void write(const std::filesystem::path& file, const std::string& text) {
    std::ofstream(file) << text;
}

std::string edited(const std::string& figures) {
    return R"({"format": "tactum-device", "figures": {)" + figures + "}}";
}

} // namespace

class TestProfile : public QObject {
    Q_OBJECT

private slots:
    void measuredFiguresAreLaidOverTheOwnOnes() {
        const QTemporaryDir folder;
        const std::filesystem::path place = std::filesystem::path(folder.path().toStdString()) / "devices";
        const char* const measured =
            R"({"format": "tactum-device", "version": 1, "figures": {"damping_N_s_per_m": 0.9}})";
        const auto first = keepProfile("falcon", measured, place);
        VERIFY_RESULT(first);
        QVERIFY(first->empty());
        QCOMPARE(profileOf("falcon", place)->info.damping, 0.9);
        std::ofstream(place / "falcon.json") << R"({"format": "tactum-device",
            "figures": {"max_force_N": 6, "damping_N_s_per_m": 0.7}})";
        const auto second = keepProfile("falcon", measured, place);
        VERIFY_RESULT(second);
        // The limit that the person set still holds, and the file of before is beside it.
        QCOMPARE(profileOf("falcon", place)->info.damping, 0.9);
        QCOMPARE(profileOf("falcon", place)->info.maxForce, 6.0);
        QCOMPARE(second->filename(), std::filesystem::path("falcon-before-1.json"));
        QVERIFY(std::filesystem::exists(*second));
        QVERIFY(!keepProfile("falcon", R"({"format": "tactum-device", "figures": {"wit": 1}})", place));
        QCOMPARE(profileOf("falcon", place)->info.maxForce, 6.0);
    }

    void builtInOnesArePossible() {
        QCOMPARE_GT(builtInProfiles().size(), 10);
        for (const DeviceProfile& profile : builtInProfiles()) {
            const char* key = profile.key.c_str();
            QVERIFY2(checkDevice(profile.info), key);
            QVERIFY2(profile.info.real, key);
            // A profile that forgot a figure would allow anything.
            QVERIFY2(profile.info.maxForce > 0 && profile.info.maxForce <= 22, key);
            QVERIFY2(profile.info.maxStiffness > 0 && profile.info.workspaceRadius > 0, key);
            QVERIFY2(profile.info.positionResolution > 0 && !profile.info.name.empty(), key);
            QVERIFY2(safeStiffness(loopFigures(profile.info)).value > 100, key);
        }
    }

    void theFalconIsAsItsSourcesSay() {
        const auto falcon = profileOf("falcon", {});
        VERIFY_RESULT(falcon);
        QCOMPARE(falcon->info.name, std::string("Novint Falcon"));
        QCOMPARE(falcon->info.maxForce, 8.0);
        QCOMPARE(falcon->info.maxStiffness, 3000.0);
        QCOMPARE(falcon->info.buttons, 4);
        QCOMPARE(falcon->countsPerTorque, 10000.0);
        QCOMPARE(falcon->commandsOnWay, 1.0); // as libnifalcon
        QCOMPARE(profileOf("touch", {})->countsPerTorque, 0.0);
    }

    void aPersonsFileChangesWhatItNames() {
        const QTemporaryDir folder;
        write(pathOf(folder) / "falcon.json",
              edited(R"("max_force_N": 5, "damping_N_s_per_m": {"value": 0.8})"));
        const auto mine = profileOf("falcon", pathOf(folder));
        VERIFY_RESULT(mine);
        QCOMPARE(mine->info.maxForce, 5.0);
        QCOMPARE(mine->info.damping, 0.8);
        QCOMPARE(mine->info.maxStiffness, 3000.0);
        QCOMPARE(profileOf("touch", pathOf(folder))->info.maxForce, 3.3);
    }

    void aFileThatIsWrongIsRefused_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("said");
        QTest::newRow("no JSON") << "max_force = 5"
                                 << "is no profile";
        QTest::newRow("another format") << R"({"format": "other"})"
                                        << "is no profile";
        QTest::newRow("a list") << "[]"
                                << "is no profile";
        QTest::newRow("unknown figure") << edited(R"("max_fource_N": 5)").c_str() << "max_fource_N";
        QTest::newRow("a word") << edited(R"("max_force_N": "five")").c_str() << "must be a number";
        QTest::newRow("beyond belief") << edited(R"("max_force_N": 1e9)").c_str() << "largest force";
        QTest::newRow("more than it gives") << edited(R"("max_force_N": 8.5)").c_str() << "not raise it";
        QTest::newRow("negative") << edited(R"("damping_N_s_per_m": -1)").c_str() << "damping";
        QTest::newRow("a figure at the wrong place") << R"({"format": "tactum-device", "max_force_N": 1})"
                                                     << "belongs into";
        QTest::newRow("a later version") << R"({"format": "tactum-device", "version": 2})"
                                         << "version";
        QTest::newRow("a thousand buttons") << R"({"format": "tactum-device", "buttons": 1000})"
                                            << "from 0 to 31";
        QTest::newRow("no button at all") << R"({"format": "tactum-device", "buttons": -1})"
                                          << "from 0 to 31";
        QTest::newRow("half a button") << R"({"format": "tactum-device", "buttons": 2.5})"
                                       << "whole";
        QTest::newRow("motors that roar")
            << edited(R"("counts_per_newton_metre": 1e6)").c_str() << "from 1000 to 100000";
        QTest::newRow("many on the way") << edited(R"("commands_on_the_way": 9)").c_str() << "from 1 to 4";
        QTest::newRow("a long pause") << edited(R"("reset_pause_s": 5)").c_str() << "from 0 to 1";
        QTest::newRow("no patience") << edited(R"("longest_unheard_s": 0)").c_str() << "from 0.005 to 0.2";
        QTest::newRow("no rate") << edited(R"("rate_Hz": 0)").c_str() << "rate";
        QTest::newRow("figures as a text") << R"({"format": "tactum-device", "figures": "many"})"
                                           << "figures";
        QTest::newRow("a name that is none") << R"({"format": "tactum-device", "name": 7})"
                                             << "name";
    }
    void aFileThatIsWrongIsRefused() {
        QFETCH(QString, text);
        QFETCH(QString, said);
        const QTemporaryDir folder;
        write(pathOf(folder) / "falcon.json", text.toStdString());
        const auto refused = profileOf("falcon", pathOf(folder));
        QVERIFY(!refused);
        const QString sentence = QString::fromStdString(refused.error().text);
        QVERIFY2(sentence.contains("falcon.json") && sentence.contains(said) && !sentence.contains('\n'),
                 qPrintable(sentence));
    }

    void aNameFindsItsProfile_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("key");
        const std::pair<const char*, const char*> names[] = {
            {"omega.3", "omega"},
            {"OMEGA.7 haptic device", "omega"},
            {"delta.3", "delta"},
            {"Phantom Omni", "phantom-omni"},
            {"PHANTOM Premium 1.5 High Force", "phantom-premium-1.5"},
            {"Touch", "touch"},
            {"Geomagic Touch", "touch"},
            {"Touch X", "touch-x"},
            {"PHANTOM of the opera", "phantom"},
            {"alpha", ""},
            {"", ""}};
        for (const auto& [name, key] : names)
            QTest::newRow(*name ? name : "nothing") << QString(name) << QString(key);
    }
    void aNameFindsItsProfile() {
        QFETCH(QString, name);
        QFETCH(QString, key);
        QCOMPARE(QString::fromStdString(profileFor(name.toStdString())), key);
    }

    void aFolderIsNoProfile() {
        const QTemporaryDir folder;
        std::filesystem::create_directory(pathOf(folder) / "falcon.json");
        const auto refused = profileOf("falcon", pathOf(folder));
        QVERIFY(!refused);
        COMPARE_CONTAINS(refused.error().text, "no file");
    }

    void anUnknownDeviceIsRefused() { QVERIFY(!profileOf("../falcon", {})); }
};

TACTUM_TEST(TestProfile)

} // namespace test_profile

#include "test_profile.moc"
