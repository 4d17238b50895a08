// 3D Systems' devices against a library that stands in for theirs: units, limits, faults and partings.
#include <algorithm>
#include <cmath>
#include <dlfcn.h>
#include <limits>
#include <numbers>
#include <thread>

#include <QTemporaryDir>
#include <QTest>

#include "device/vendor/open_haptics.h"
#include "tests/device/vendor/fake_hd.h"
#include "tests/device/vendor/hand.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"

namespace test_open_haptics {

using namespace tactum;
using namespace tactum::test;

class TestOpenHaptics : public QObject {
    Q_OBJECT

    FakeHd* fake_ = nullptr;

    static DeviceInfo profile() {
        return {.name = "Touch", .maxForce = 3, .maxStiffness = 1000, .workspaceRadius = 0.075, .buttons = 2};
    }
    static Result<DeviceInfo> figures(std::string_view model) {
        DeviceInfo info = profile();
        if (info.name.empty()) info.name = model;
        return info;
    }
    static std::unique_ptr<HapticDevice> device(const std::string& id = "openhaptics:default") {
        auto made = makeOpenHaptics(id, figures);
        return made ? std::move(*made) : nullptr;
    }
    Vec3 motors() const { return {fake_->motors[0], fake_->motors[1], fake_->motors[2]}; }
    void place(const Vec3& millimetres) {
        for (int i = 0; i < 3; ++i)
            fake_->position[std::size_t(i)] = millimetres[i];
    }
    /// Opened, and a first reading has come.
    std::unique_ptr<HapticDevice> opened() {
        auto made = device();
        if (const auto ok = made->open(); !ok) qWarning("%s", ok.error().text.c_str());
        Hand hand(*made);
        hand.until([&] { return hand.last.valid; });
        return made;
    }

private slots:
    void initTestCase() {
        void* library = dlopen(TACTUM_FAKE_HD, RTLD_NOW | RTLD_NODELETE);
        QVERIFY2(library, dlerror());
        const auto get = reinterpret_cast<FakeHdGetter>(dlsym(library, "fakeHd"));
        QVERIFY(get);
        fake_ = &get();
    }
    void init() {
        new (fake_) FakeHd;
        qputenv("TACTUM_LIBHD", TACTUM_FAKE_HD);
        qputenv("GTDD_HOME", "/no/such/folder");
    }
    void cleanup() {
        QCOMPARE(fake_->misuses.load(), 0);
        QCOMPARE(fake_->notFinite.load(), 0);
    }

    void readingsComeInMetresAndOurFrame() {
        place({10, -20, 30});
        fake_->velocity[2] = -250;
        fake_->buttons = 2;
        const auto device = opened();
        Hand hand(*device);
        QVERIFY(hand.until([&] { return hand.last.buttons == 2; }));
        COMPARE_NEAR(hand.last.position, Vec3(0.01, -0.02, 0.03), 1e-12, "m");
        COMPARE_NEAR(hand.last.velocity, Vec3(0, 0, -0.25), 1e-12, "m/s");
        QVERIFY(device->trouble().empty());
    }

    /// Columns are the axes of the stylus: one that was turned a quarter about y has its z along x.
    void aTurnedStylusIsCarried() {
        const double turned[] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 7, 8, 9, 1};
        for (std::size_t i = 0; i < 16; ++i)
            fake_->transform[i] = turned[i];
        const auto device = opened();
        QTRY_VERIFY(device->exchange({}, 1e-3).valid && device->handle().turns);
        const Quat expected(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()));
        QCOMPARE_LT(device->handle().orientation.angularDistance(expected), 1e-12);
        QVERIFY(!device->handle().grips);
        fake_->transform[0] = std::nan(""); // then it is not known
        QTRY_VERIFY(device->exchange({}, 1e-3).valid && !device->handle().turns);
    }

    void forcesArriveAsTheyAre() {
        const auto device = opened();
        Hand hand(*device, {0.5, -1, 2});
        QVERIFY(hand.until([&] { return motors() == Vec3(0.5, -1, 2); }));
    }

    void noForceIsAboveTheLimitOrNoNumber() {
        const auto device = opened();
        const double inf = std::numeric_limits<double>::infinity();
        for (const Vec3& wild : {Vec3(100, 0, 0), Vec3(0, -1e300, 1e300), Vec3(std::nan(""), 1, 0),
                                 Vec3(inf, 0, 0), Vec3(0, -inf, 0)}) {
            Hand hand(*device, wild);
            hand.forTicks(20);
        }
        QCOMPARE_LE(fake_->strongest, 3 + 1e-9);
        QCOMPARE_GT(fake_->strongest, 2.9);
    }

    void itsOwnWordLowersTheLimits() {
        fake_->maxForce = 0.88;
        const auto device = opened();
        QCOMPARE(device->info().maxForce, 0.88);
        QCOMPARE(device->info().maxStiffness, 420.0);
        QCOMPARE(device->info().workspaceRadius, 0.065);
        Hand(*device, {3, 0, 0}).forTicks(20);
        QCOMPARE_LE(fake_->strongest, 0.88 + 1e-9);
    }

    void itsOwnWordRaisesNone() {
        fake_->maxForce = 40;
        fake_->maxStiffness = 40;
        const auto device = opened();
        QCOMPARE(device->info().maxForce, 3.0);
        QCOMPARE(device->info().maxStiffness, 1000.0);
        QCOMPARE(device->info().delay, 1.0); // the scheduler's frames wake the servo
        QVERIFY(device->info().real);
    }

    void anErrorTakesReadingsAndForceAway_data() {
        QTest::addColumn<unsigned>("code");
        QTest::addColumn<QString>("word");
        const std::pair<unsigned, const char*> errors[] = {
            {0x0104, "not there"}, {0x0200, "warm"},     {0x0201, "more force"},
            {0x0202, "faster"},    {0x0203, "too fast"}, {0x0204, "fault of its force"},
            {0x0300, "cable"},     {0x0302, "answer"},   {0x0303, "setup"},
            {0x0304, "timer"},     {0x0600, "licence"},  {0x0777, "1911"},
        };
        for (const auto& [code, word] : errors)
            QTest::newRow(word) << code << QString(word);
    }

    void anErrorTakesReadingsAndForceAway() {
        QFETCH(unsigned, code);
        QFETCH(QString, word);
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        fake_->frameError = code;
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        QVERIFY(hand.until([&] { return motors().isZero(); }));
        const QString said = QString::fromStdString(device->trouble());
        QVERIFY2(said.contains(word) && said.endsWith('.'), qPrintable(said));
        // Gone again, it is believed after a while, and not at once.
        fake_->frameError = 0;
        hand.forTicks(50);
        QVERIFY(!hand.last.valid);
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QVERIFY(hand.until([&] { return hand.last.valid; }));
        QVERIFY(device->trouble().empty());
    }

    void aReadingThatIsNoNumberIsNone() {
        const auto device = opened();
        Hand hand(*device);
        fake_->position[1] = std::nan("");
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
    }

    void aSchedulerThatStandsStillGivesNoOldReadings() {
        const auto device = opened();
        Hand hand(*device);
        fake_->frozen = true;
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        QVERIFY(hand.until([&] { return !device->trouble().empty(); }));
        fake_->frozen = false;
        QVERIFY(hand.until([&] { return hand.last.valid; }));
    }

    void aServoThatStandsStillLosesItsForce() {
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        QVERIFY(test::waitFor([&] { return motors().isZero(); }));
    }

    void theDeviceWatchdogStopsItAtOnce() {
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        device->emergencyStop();
        const long stopped = fake_->frames;
        QVERIFY(test::waitFor([&] { return fake_->frames >= stopped + 2; }));
        QVERIFY(motors().isZero());
        QVERIFY(hand.until([&] { return motors().x() == 1; })); // a later command counts again
    }

    void closeSendsZeroAndGivesTheDeviceBack() {
        const auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        device->close();
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QVERIFY(!fake_->output);
        QCOMPARE(fake_->closed.load(), 1);
        VERIFY_RESULT(device->open()); // and once more
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
    }

    void anObjectThatDiesClosesToo() {
        auto device = opened();
        Hand hand(*device, {1, 0, 0});
        QVERIFY(hand.until([&] { return motors().x() == 1; }));
        device.reset();
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QCOMPARE(fake_->closed.load(), 1);
    }

    void preparedItGivesNoForceYet() {
        const auto made = device();
        Watcher watcher;
        VERIFY_RESULT(made->prepare(watcher));
        Hand hand(*made, {1, 0, 0});
        hand.forTicks(30);
        QVERIFY(!fake_->output);
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QVERIFY(!hand.last.valid);
        QVERIFY(watcher.steps == made->steps());
    }

    void theInkwellIsAskedFor() {
        fake_->calibration = 0x5002;
        const auto made = device();
        Watcher watcher;
        watcher.onRequest = [&](std::string_view) { fake_->calibration = 0x5001; }; // the person does so
        VERIFY_RESULT(made->prepare(watcher));
        COMPARE_CONTAINS(watcher.request, "inkwell");
        QCOMPARE(fake_->calibrated.load(), 1);
    }

    // Arms that are held at right angles for five seconds are zero there; how long is left is shown.
    void theArmsAreHeldStill() {
        fake_->calibrationStyle = 1;
        fake_->calibration = 0x5002;
        const auto made = device();
        Watcher watcher;
        VERIFY_RESULT(made->prepare(watcher));
        COMPARE_CONTAINS(watcher.request, "right angles");
        QCOMPARE(fake_->calibrated.load(), 1);
        const std::vector<double>& parts = watcher.parts;
        QCOMPARE_GT(parts.size(), std::size_t(500));
        QVERIFY(std::ranges::is_sorted(parts));
        COMPARE_NEAR(parts.front(), 0, 1e-12, "");
        QCOMPARE_GT(parts.back(), 0.9);
        QCOMPARE_LE(parts.back(), 1);
        COMPARE_NEAR(parts[parts.size() / 2], 0.5, 0.05, "");
    }

    void aPersonMayGiveUp() {
        fake_->calibration = 0x5002;
        const auto made = device();
        Watcher watcher;
        watcher.onRequest = [&](std::string_view) { watcher.givesUp = true; };
        const auto result = made->prepare(watcher);
        QVERIFY(!result);
        COMPARE_CONTAINS(result.error().text, "inkwell");
    }

    void nobodyAtHandIsNotWaitedFor() {
        fake_->calibration = 0x5002;
        const auto made = device();
        const auto result = made->open();
        QVERIFY(!result);
        COMPARE_CONTAINS(result.error().text, "inkwell");
        QVERIFY(!fake_->output);
    }

    void aDeviceThatIsNotThereIsSaid() {
        fake_->initError = 0x0302;
        const auto result = device()->open();
        QVERIFY(!result);
        COMPARE_CONTAINS(result.error().text, "does not answer");
        QCOMPARE(fake_->closed.load(), 0);
    }

    void theNameGoesToTheLibrary() {
        VERIFY_RESULT(device("openhaptics:Left Device")->open());
        QCOMPARE(std::string(fake_->name.data()), std::string("Left Device"));
        VERIFY_RESULT(device()->open());
        QCOMPARE(std::string(fake_->name.data()), std::string("(default)"));
        QVERIFY(!makeOpenHaptics("falcon:1", figures));
        QVERIFY(!makeOpenHaptics("openhaptics:", figures));
    }

    void withoutTheLibraryThereIsASentence() {
        qputenv("TACTUM_LIBHD", "/no/such/libHD.so");
        const auto listings = listOpenHaptics();
        QCOMPARE(listings.size(), std::size_t(1));
        QVERIFY(!listings.front().usable);
        QVERIFY(listings.front().id.empty());
        for (const char* word : {"OpenHaptics", "/no/such/libHD.so", "install", "TACTUM_LIBHD"})
            COMPARE_CONTAINS(listings.front().sentence, word);
        QVERIFY(!device()->open());
        qunsetenv("TACTUM_LIBHD");
        COMPARE_CONTAINS(listOpenHaptics().front().sentence, "libHD.so");
    }

    void aLibraryWithoutAFunctionIsRefused() {
        qputenv("TACTUM_LIBHD", TACTUM_FAKE_HD_TOO_OLD);
        const auto listings = listOpenHaptics();
        QVERIFY(!listings.front().usable);
        COMPARE_CONTAINS(listings.front().sentence, "hdStartScheduler");
        QVERIFY(!device()->open());
    }

    void devicesThatWereSetUpAreListed() {
        QCOMPARE(listOpenHaptics().front().id, std::string("openhaptics:default"));
        QTemporaryDir home;
        QDir(home.path()).mkpath("config");
        for (const char* name : {"config/Right.config", "config/Left Device.config", "config/other.txt"}) {
            QFile file(home.filePath(name));
            QVERIFY(file.open(QIODevice::WriteOnly));
        }
        qputenv("GTDD_HOME", home.path().toLocal8Bit());
        const auto listings = listOpenHaptics();
        QCOMPARE(listings.size(), std::size_t(2));
        QCOMPARE(listings[0].id, std::string("openhaptics:Left Device"));
        QCOMPARE(listings[1].id, std::string("openhaptics:Right"));
        QVERIFY(listings[0].usable);
    }
};

TACTUM_TEST(TestOpenHaptics)

} // namespace test_open_haptics

#include "test_open_haptics.moc"
