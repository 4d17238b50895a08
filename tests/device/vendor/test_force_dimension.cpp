// Force Dimension's devices against a library that stands in for theirs: axes, limits, faults and partings.
#include <cmath>
#include <dlfcn.h>
#include <limits>
#include <numbers>

#include <QTest>

#include "device/vendor/force_dimension.h"
#include "tests/device/vendor/fake_dhd.h"
#include "tests/device/vendor/hand.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_force_dimension {

using namespace tactum;
using namespace tactum::test;

class TestForceDimension : public QObject {
    Q_OBJECT

    FakeDhd* fake_ = nullptr;

    static DeviceInfo profile() { return {.name = "", .maxForce = 12, .buttons = 1}; }
    static Result<DeviceInfo> figures(std::string_view model) {
        DeviceInfo info = profile();
        if (info.name.empty()) info.name = model;
        return info;
    }
    static std::unique_ptr<HapticDevice> device(const std::string& id = "forcedimension:0") {
        auto made = makeForceDimension(id, figures);
        return made ? std::move(*made) : nullptr;
    }
    static std::unique_ptr<HapticDevice> opened() {
        auto made = device();
        if (const auto ok = made->open(); !ok) qWarning("%s", ok.error().text.c_str());
        return made;
    }
    Vec3 motors() const { return {fake_->motors[0], fake_->motors[1], fake_->motors[2]}; }

private slots:
    void initTestCase() {
        void* library = dlopen(TACTUM_FAKE_DHD, RTLD_NOW | RTLD_NODELETE);
        QVERIFY2(library, dlerror());
        const auto get = reinterpret_cast<FakeDhdGetter>(dlsym(library, "fakeDhd"));
        QVERIFY(get);
        fake_ = &get();
    }
    void init() {
        new (fake_) FakeDhd;
        qputenv("TACTUM_LIBDHD", TACTUM_FAKE_DHD);
    }
    void cleanup() {
        QCOMPARE(fake_->misuses.load(), 0);
        QCOMPARE(fake_->notFinite.load(), 0);
        QCOMPARE(fake_->torque.load(), 0.0);
        QCOMPARE(fake_->opened.load(), fake_->closed.load());
    }

    /// Theirs: x toward the user, y right, z up. Ours: x right, y up, z toward the user.
    void readingsComeInOurFrame() {
        fake_->position[0] = 0.01;
        fake_->position[1] = 0.02;
        fake_->position[2] = 0.03;
        fake_->velocity[0] = -0.1;
        fake_->buttons = 1;
        const auto device = opened();
        const DeviceSample sample = device->exchange({}, 1e-3);
        QVERIFY(sample.valid);
        COMPARE_NEAR(sample.position, Vec3(0.02, 0.03, 0.01), 1e-12, "m");
        COMPARE_NEAR(sample.velocity, Vec3(0, 0, -0.1), 1e-12, "m/s");
        QCOMPARE(sample.buttons, 1u);
        QCOMPARE(device->info().name, std::string("omega.3"));
        QVERIFY(device->info().real);
        QVERIFY(device->trouble().empty());
    }

    void forcesArriveInTheirs() {
        const auto device = opened();
        device->exchange({{1, 2, 3}}, 1e-3);
        COMPARE_NEAR(motors(), Vec3(3, 1, 2), 1e-12, "N");
        QVERIFY(fake_->force);
    }

    /// What pushes the finger along an axis moves it along the same axis.
    void theAxesOfForceAndPositionAgree() {
        const auto device = opened();
        for (int axis = 0; axis < 3; ++axis) {
            device->exchange({Vec3::Unit(axis)}, 1e-3);
            for (std::size_t i = 0; i < 3; ++i)
                fake_->position[i] = 0.01 * fake_->motors[i];
            COMPARE_NEAR(device->exchange({}, 1e-3).position, 0.01 * Vec3::Unit(axis), 1e-12, "m");
        }
    }

    /// A quarter turn about each of their axes, counter-clockwise seen against it, is one about the same axis
    /// of ours; and a gripper's opening.
    void aTurnedHandleComesInOurFrame() {
        QVERIFY(!opened()->handle().turns); // an omega.3 has nothing that turns
        fake_->wrist = fake_->gripper = true;
        fake_->gap = 0.012;
        const Vec3 ours[] = {Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
        for (int theirs = 0; theirs < 3; ++theirs) {
            const int next = (theirs + 1) % 3, last = (theirs + 2) % 3;
            for (auto& each : fake_->rows)
                each = 0;
            fake_->rows[std::size_t(4 * theirs)] = 1;
            fake_->rows[std::size_t(3 * last + next)] =
                1; // what pointed along the next points along the last
            fake_->rows[std::size_t(3 * next + last)] = -1;
            const auto device = opened();
            QVERIFY(device->exchange({}, 1e-3).valid);
            const HandleReading handle = device->handle();
            QVERIFY(handle.turns && handle.grips);
            QCOMPARE(handle.opening, 0.012);
            const Quat expected(Eigen::AngleAxisd(std::numbers::pi / 2, ours[theirs]));
            QCOMPARE_LT(handle.orientation.angularDistance(expected), 1e-12);
        }
    }

    /// Nothing that is felt rests on it.
    void aHandleThatCannotBeReadTakesNoForce() {
        fake_->wrist = fake_->gripper = true;
        fake_->handleError = 7; // a timeout
        const auto device = opened();
        const DeviceSample sample = device->exchange({{1, 2, 3}}, 1e-3);
        QVERIFY(sample.valid);
        COMPARE_NEAR(motors(), Vec3(3, 1, 2), 1e-12, "N");
        QVERIFY(!device->handle().turns);
        QVERIFY(!device->handle().grips);
        QCOMPARE(QByteArray::fromStdString(device->trouble()), QByteArray());
    }

    /// None where the profile knows no limit, and no more than that; a number that is none is nothing.
    void torqueAndPinchAreHeldToTheProfile() {
        const DeviceCommand wild{Vec3::Zero(), {Vec3(0.3, 0, 0.4), -50}};
        opened()->exchange(wild, 1e-3);
        for (const auto& each : fake_->handle)
            QCOMPARE(each.load(), 0.0);
        const auto strong = [](std::string_view) -> Result<DeviceInfo> {
            DeviceInfo info = profile();
            info.maxTorque = 0.1;
            info.maxPinch = 8;
            return info;
        };
        auto device = std::move(*makeForceDimension("forcedimension:0", strong));
        VERIFY_RESULT(device->open());
        device->exchange(wild, 1e-3);
        COMPARE_NEAR(Vec3(fake_->handle[0], fake_->handle[1], fake_->handle[2]), Vec3(0.08, 0.06, 0), 1e-12,
                     "N m"); // theirs: toward the user, right, up
        QCOMPARE(fake_->handle[3].load(), -8.0);
        const double nan = std::nan("");
        device->exchange({Vec3::Zero(), {Vec3(nan, 0, 0), nan}}, 1e-3);
        for (const auto& each : fake_->handle)
            QCOMPARE(each.load(), 0.0);
        device->exchange(wild, 1e-3);
        device->close(); // and zero at the end
        QCOMPARE(fake_->handle[3].load(), 0.0);
    }

    void noForceIsAboveTheLimitOrNoNumber() {
        const auto device = opened();
        const double inf = std::numeric_limits<double>::infinity();
        for (const Vec3& wild : {Vec3(100, 0, 0), Vec3(0, -1e300, 1e300), Vec3(std::nan(""), 1, 0),
                                 Vec3(inf, 0, 0), Vec3(9, 9, 9)})
            device->exchange({wild}, 1e-3);
        QCOMPARE_LE(fake_->strongest, 12 + 1e-9);
        QCOMPARE_GT(fake_->strongest, 11.9);
    }

    void successHasThreeNumbers() {
        const auto device = opened();
        for (const int success : {0, 1, 2}) {
            fake_->success = success;
            QVERIFY(device->exchange({}, 1e-3).valid);
        }
    }

    void anErrorTakesReadingsAndForceAway_data() {
        QTest::addColumn<int>("error");
        QTest::addColumn<bool>("sending");
        QTest::addColumn<QString>("word");
        const std::pair<int, const char*> errors[] = {
            {2, "answer"},         {3, "busy"},      {4, "rule"},
            {5, "not there"},      {6, "cannot do"}, {7, "too late"},
            {8, "arms"},           {11, "memory"},   {12, "ready"},
            {14, "configuration"}, {18, "sensors"},  {19, "forces of the device are off"},
            {20, "in use"},        {99, "99"}};
        for (const auto& [error, word] : errors)
            for (const bool sending : {true, false})
                QTest::addRow("%d %d", error, int(sending)) << error << sending << QString(word);
    }

    void anErrorTakesReadingsAndForceAway() {
        QFETCH(int, error);
        QFETCH(bool, sending);
        QFETCH(QString, word);
        const auto device = opened();
        device->exchange({{0, 1, 0}}, 1e-3);
        QVERIFY(!motors().isZero());
        (sending ? fake_->sendError : fake_->readError) = error;
        QVERIFY(!device->exchange({{0, 1, 0}}, 1e-3).valid);
        if (!sending) COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N"); // at once, in the same exchange
        const QString said = QString::fromStdString(device->trouble());
        QVERIFY2(said.contains(word) && said.endsWith('.'), qPrintable(said));
        fake_->sendError = fake_->readError = 0;
        QVERIFY(!device->exchange({{0, 1, 0}}, 1e-3).valid);
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        int waited = 0;
        while (!device->exchange({{0, 1, 0}}, 1e-3).valid && waited < 10'000)
            ++waited;
        QCOMPARE_GT(waited, 100);
        QCOMPARE_LT(waited, 1000);
        QVERIFY(device->trouble().empty());
    }

    void aReadingThatIsNoNumberIsNone() {
        const auto device = opened();
        fake_->velocity[1] = std::nan("");
        QVERIFY(!device->exchange({}, 1e-3).valid);
    }

    void closeSendsZeroAndGivesTheDeviceBack() {
        const auto device = opened();
        device->exchange({{1, 0, 0}}, 1e-3);
        device->close();
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QVERIFY(!fake_->force);
        QCOMPARE(fake_->closed.load(), 1);
        const long before = fake_->commands;
        QVERIFY(!device->exchange({{1, 0, 0}}, 1e-3).valid); // of one that is closed: nothing
        QCOMPARE(fake_->commands.load(), before);
        VERIFY_RESULT(device->open());
        QVERIFY(device->exchange({}, 1e-3).valid);
    }

    void pulledOutAndBackItOpensAgain() {
        const auto device = opened();
        fake_->sendError = fake_->readError = 2;
        QVERIFY(!device->exchange({{1, 0, 0}}, 1e-3).valid);
        device->close();
        fake_->openError = 5;
        const auto gone = device->open();
        QVERIFY(!gone);
        COMPARE_CONTAINS(gone.error().text, "not there");
        fake_->openError = fake_->sendError = fake_->readError = 0;
        VERIFY_RESULT(device->open());
        QVERIFY(device->exchange({}, 1e-3).valid);
        QVERIFY(device->trouble().empty());
    }

    void whatBrokeIsBegunAnew() {
        const auto device = opened();
        fake_->readError = 2;
        QVERIFY(!device->exchange({}, 1e-3).valid);
        fake_->readError = 0;
        VERIFY_RESULT(device->open());
        QCOMPARE(fake_->opened.load(), 2);
        QCOMPARE(fake_->closed.load(), 1);
        QVERIFY(device->exchange({}, 1e-3).valid);
    }

    void preparedItGivesNoForceYet() {
        fake_->force = true; // as another program left it
        const auto made = device();
        Watcher watcher;
        VERIFY_RESULT(made->prepare(watcher));
        QVERIFY(!fake_->force);
        QVERIFY(!made->exchange({{1, 0, 0}}, 1e-3).valid);
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
        QVERIFY(watcher.steps == made->steps());
        QVERIFY(watcher.request.empty());
    }

    void calibrationIsAskedForAndWaitedFor() {
        fake_->resetMode = true;
        fake_->supported = false;
        fake_->calibrateAt = 3;
        const auto made = device();
        Watcher watcher;
        VERIFY_RESULT(made->prepare(watcher));
        COMPARE_CONTAINS(watcher.request, "rest");
        QCOMPARE(fake_->looks.load(), 3);
        QCOMPARE(fake_->moved.load(), 0);
    }

    void whatDoesNotCalibrateItselfIsMovedOnceThePersonLetGo() {
        fake_->resetMode = true;
        const auto made = device();
        Watcher watcher;
        VERIFY_RESULT(made->prepare(watcher));
        COMPARE_CONTAINS(watcher.request, "Let go");
        QCOMPARE(fake_->moved.load(), 1);
        QVERIFY(!fake_->regulating);
        QVERIFY(!fake_->force);
        QVERIFY2(watcher.parts.size() > 10, "no time to let go");
        VERIFY_RESULT(made->open());
        QVERIFY(made->exchange({}, 1e-3).valid);
    }

    void whoGivesUpWhileItWaitsIsNotPushed() {
        fake_->resetMode = true;
        const auto made = device();
        Watcher watcher;
        watcher.onRequest = [&](std::string_view) { watcher.givesUp = true; };
        QVERIFY(!made->prepare(watcher));
        QCOMPARE(fake_->moved.load(), 0);
    }

    void whatCannotCalibrateItselfSaysSo() {
        fake_->resetMode = true;
        fake_->moveError = 7;
        const auto made = device();
        Watcher watcher;
        const auto prepared = made->prepare(watcher);
        QVERIFY(!prepared);
        COMPARE_CONTAINS(prepared.error().text, "could not calibrate itself");
        QVERIFY(!fake_->regulating);
        QVERIFY(!fake_->force);
    }

    void nobodyAtHandIsNotWaitedFor() {
        fake_->resetMode = true;
        const auto result = device()->open();
        QVERIFY(!result);
        COMPARE_CONTAINS(result.error().text, "not calibrated");
        QVERIFY(!fake_->force);
        QCOMPARE(fake_->moved.load(), 0);
    }

    void theDeviceItselfWatchesToo() {
        const auto device = opened();
        QCOMPARE_GE(fake_->watchdog * 0.125, 10);
        QCOMPARE_LE(fake_->watchdog * 0.125, 50); // ms
        QVERIFY2(device->caution().empty(), device->caution().c_str());
        QVERIFY(!fake_->expert); // only for that one call
        device->exchange({{0, 2, 0}}, 1e-3);
        QCOMPARE_GT(motors().norm(), 1.9);
        fake_->standStill(80);
        COMPARE_NEAR(motors(), Vec3(0, 0, 0), 1e-12, "N");
    }

    void whatHasNoWatchdogSaysSo() {
        fake_->watchdogError = 6;
        const auto device = opened();
        COMPARE_CONTAINS(device->caution(), "does not watch");
        COMPARE_CONTAINS(device->caution(), "firmware");
        device->close();
        qputenv("TACTUM_LIBDHD", TACTUM_FAKE_DHD_OLD); // which has no such function
        const auto old = TestForceDimension::device();
        VERIFY_RESULT(old->open());
        COMPARE_CONTAINS(old->caution(), "3.3.2");
    }

    /// The firmware took the forces away, and every call succeeds nonetheless.
    void forcesThatTheFirmwareTookComeBackWithoutPushing() {
        const auto device = opened();
        device->exchange({{0, 2, 0}}, 1e-3);
        fake_->standStill(80);
        int without = 0;
        while (device->exchange({{0, 2, 0}}, 1e-3).valid && without < 1000)
            ++without;
        QCOMPARE_LT(without, 50); // "valid", without a force
        COMPARE_CONTAINS(device->trouble(), "30 ms");
        QVERIFY(!fake_->force);
        int waited = 0;
        while (!device->exchange({{0, 2, 0}}, 1e-3).valid && waited < 10'000)
            ++waited;
        QCOMPARE_LT(waited, 2000);
        QVERIFY(fake_->force);
        QVERIFY(device->trouble().empty());
        QCOMPARE(fake_->enabledWith.load(), 0.0); // given back at zero
        device->exchange({{0, 2, 0}}, 1e-3);
        COMPARE_NEAR(motors(), Vec3(0, 0, 2), 1e-12, "N");
    }

    void whatAPersonSwitchedOffStaysOff_data() {
        QTest::addColumn<int>("cause");
        QTest::addColumn<bool>("filled");
        QTest::addColumn<QString>("word");
        QTest::newRow("button") << 1 << true << "force button of the device was pressed";
        QTest::newRow("dead man") << 6 << true << "dead-man";
        QTest::newRow("an old library") << 3 << false << "forces of the device are off";
    }

    void whatAPersonSwitchedOffStaysOff() {
        QFETCH(int, cause);
        QFETCH(bool, filled);
        QFETCH(QString, word);
        const auto device = opened();
        fake_->fillsCause = filled;
        fake_->takeForces(cause);
        for (int i = 0; i < 3000; ++i)
            device->exchange({{0, 2, 0}}, 1e-3);
        QVERIFY(!device->exchange({{0, 2, 0}}, 1e-3).valid);
        QVERIFY(!fake_->force);
        QCOMPARE(fake_->enabled.load(), 1);
        COMPARE_CONTAINS(device->trouble(), word.toStdString());
        fake_->force = true; // pressed again
        int waited = 0;
        while (!device->exchange({{0, 2, 0}}, 1e-3).valid && waited < 10'000)
            ++waited;
        QCOMPARE_GT(waited, 100);
        QCOMPARE_LT(waited, 1000);
    }

    void aStatusThatCannotBeReadIsAFault() {
        const auto device = opened();
        fake_->statusError = 2;
        int valid = 0;
        while (device->exchange({{0, 1, 0}}, 1e-3).valid && valid < 1000)
            ++valid;
        QCOMPARE_LT(valid, 50);
        COMPARE_CONTAINS(device->trouble(), "answer");
    }

    void withoutTheLibraryThereIsASentence() {
        qputenv("TACTUM_LIBDHD", "/no/such/libdhd.so");
        const auto listings = listForceDimension();
        QCOMPARE(listings.size(), std::size_t(1));
        QVERIFY(!listings.front().usable);
        QVERIFY(listings.front().id.empty());
        for (const char* word : {"Force Dimension", "/no/such/libdhd.so", "install", "TACTUM_LIBDHD"})
            COMPARE_CONTAINS(listings.front().sentence, word);
        QVERIFY(!device()->open());
    }

    void whatIsConnectedIsListed() {
        fake_->devices = 2;
        const auto listings = listForceDimension();
        QCOMPARE(listings.size(), std::size_t(2));
        QCOMPARE(listings[1].id, std::string("forcedimension:1"));
        QVERIFY(listings[1].usable);
        COMPARE_CONTAINS(listings[1].name, "omega.3");
        fake_->openError = 20;
        QVERIFY(!listForceDimension().front().usable);
        fake_->devices = 0;
        QVERIFY(!listForceDimension().front().usable);
    }

    void listingLeavesTheOpenOneAlone() {
        fake_->devices = 2;
        const auto device = opened();
        QCOMPARE(listForceDimension().size(), std::size_t(2));
        QCOMPARE(fake_->opened.load(), 1);
        QCOMPARE(fake_->closed.load(), 0);
        QVERIFY(listForceDimension().front().usable);
        device->close();
        COMPARE_CONTAINS(listForceDimension().front().name, "omega.3");
    }

    void whatIsNoIdIsRefused() {
        for (const char* id : {"forcedimension:", "forcedimension:x", "forcedimension:-1",
                               "forcedimension:400", "falcon:0", ""})
            QVERIFY2(!makeForceDimension(id, figures), id);
    }
};

TACTUM_TEST(TestForceDimension)

} // namespace test_force_dimension

#include "test_force_dimension.moc"
