// A device in a process of its own: what goes through, and what happens when either side dies.
#include <algorithm>
#include <csignal>
#include <limits>
#include <sys/wait.h>

#include <QTest>

#include "device/remote/remote_device.h"
#include "tests/device/remote/served_device.h"
#include "tests/device/vendor/hand.h"
#include "tests/support/compare.h"
#include "tests/support/quiet.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"

namespace test_remote_device {

using namespace tactum;
using namespace tactum::test;

namespace {

/// How often each way of dying is tried; more on demand: TACTUM_DEATHS=1000.
int deaths() {
    return repeats("TACTUM_DEATHS", 12);
}

void say(const char* what, std::vector<std::int64_t> times) {
    std::ranges::sort(times);
    qInfo("%s: zero force after %.2f ms in the median, %.2f ms at most of %zu", what,
          1e-6 * double(times[times.size() / 2]), 1e-6 * double(times.back()), times.size());
}

/// Also one that ended and that nobody has looked after yet.
bool isGone(pid_t process) {
    const auto hasEnded = [&] {
        QFile file(QStringLiteral("/proc/%1/stat").arg(process));
        return !file.open(QIODevice::ReadOnly) || file.readAll().contains(") Z ");
    };
    return test::waitFor(hasEnded);
}

/// Another instant of the loops' millisecond each time.
void anInstant(int i) {
    std::this_thread::sleep_for(std::chrono::microseconds(2000 + 137 * i % 1000));
}

/// A program that pushes, to be killed.
struct Program {
    explicit Program(const QByteArray& file, const char* way = "") {
        pid = fork();
        if (pid == 0) {
            execl(TACTUM_REMOTE_PROGRAM, "remote_program", "push", file.constData(), way, nullptr);
            _exit(127);
        }
    }
    ~Program() {
        kill(pid, SIGKILL);
        waitpid(pid, nullptr, 0);
    }
    pid_t pid = -1;
};

} // namespace

class TestRemoteDevice : public QObject {
    Q_OBJECT

    QTemporaryDir dir_;
    QByteArray file_;
    Served* served_ = nullptr;

    Result<std::unique_ptr<HapticDevice>> make(const char* way = "") const {
        return makeRemoteDevice(TACTUM_REMOTE_PROGRAM, {"serve", file_.toStdString(), way});
    }
    std::unique_ptr<HapticDevice> opened() const {
        auto device = make();
        if (!device || !(*device)->open()) qFatal("it does not open");
        return std::move(*device);
    }
    /// Comes to zero by way of what lies between.
    bool fades() const { return comesToZero() && served_->between > 0; }
    bool comesToZero() const {
        return test::waitFor([&] { return served_->zeroAt != 0; });
    }

private slots:
    void initTestCase() {
        file_ = dir_.filePath("served").toLocal8Bit();
        served_ = mapServed(file_.constData());
        QVERIFY(served_);
    }
    void init() { new (served_) Served; }
    void cleanup() {
        QCOMPARE(served_->notFinite.load(), 0);
        if (served_->server > 0) QVERIFY(isGone(served_->server)); // nobody is left behind
    }

    void figuresAndStepsComeThrough() {
        const auto device = make();
        VERIFY_RESULT(device);
        const DeviceInfo info = (*device)->info(), own = ServedDevice(*served_, "").info();
        QCOMPARE(info.name, own.name);
        QCOMPARE(info.maxStiffness, own.maxStiffness);
        QCOMPARE(info.damping, own.damping);
        QCOMPARE(info.buttons, own.buttons);
        QCOMPARE(info.handDamping, own.handDamping);
        QVERIFY(info.real);
        QVERIFY(info.measuresVelocity);
        QCOMPARE(info.delay, own.delay); // its readings wake the servo
        QVERIFY((*device)->steps() == ServedDevice(*served_, "").steps());
    }

    void readingsAndForcesComeThrough() {
        const auto device = opened();
        Hand hand(*device, {0, 0, 2});
        QVERIFY(hand.until([&] { return hand.last.valid && served_->push == 2; }));
        COMPARE_NEAR(hand.last.position, Vec3(0, 0.01, 0), 1e-12, "m");
        QCOMPARE(hand.last.buttons, 2u);
        const double before = hand.last.velocity.x();
        QVERIFY(hand.until([&] { return hand.last.velocity.x() > before; })); // newer ones
        QVERIFY(device->trouble().empty());
    }

    /// Its own limit is 0.5 N m.
    void handlesAndTorquesComeThrough() {
        const auto device = opened();
        QVERIFY(test::waitFor([&] {
            device->exchange({Vec3::Zero(), {Vec3(0, 2, 0), 0}}, 1e-3);
            return device->handle().turns && std::abs(served_->torque - 0.5) < 1e-9;
        }));
        QCOMPARE(device->handle().opening, 0.02);
        QCOMPARE_LT(device->handle().orientation.angularDistance(Quat(0, 1, 0, 0)), 1e-12);
        QVERIFY(test::waitFor([&] { return served_->torque == 0; })); // nobody commands any more
    }

    /// A maker's scheduler, the device's process and the servo: the answer to a frame goes out with the next
    /// one, as if the servo made the frames itself.
    void threeClocksAreOneTick() {
        const auto device = make("framed");
        VERIFY_RESULT(device);
        QVERIFY((*device)->open());
        DeviceCommand command;
        constexpr int kFrames = 300;
        for (Patience patience; served_->late[1] + served_->late[2] < kFrames && !patience.isOver();) {
            (*device)->awaitFrame(monotonicNanoseconds() + 100'000'000);
            const DeviceSample sample = (*device)->exchange(command, 2e-3);
            if (sample.valid) command.force = {0, 0, sample.position.x()};
            (*device)->announce(command);
        }
        qInfo("1: %d, 2: %d, more: %d", served_->late[1].load(), served_->late[2].load(),
              served_->late[3].load());
        QCOMPARE_GE(served_->late[1] + served_->late[2], kFrames);
        // Whether the three get the processor in time is the machine's; a quiet one misses one now and then.
        if (!mayBeBusy()) QCOMPARE_GT(served_->late[1], 2 * (served_->late[2] + served_->late[3]));
    }

    void noForceIsAboveTheLimitOrNoNumber() {
        const auto device = opened();
        const double inf = std::numeric_limits<double>::infinity();
        for (const Vec3& wild : {Vec3(0, 0, 100), Vec3(0, -1e300, 1e300), Vec3(0, std::nan(""), 1),
                                 Vec3(0, inf, 0), Vec3(0, 0, -inf)})
            Hand(*device, wild).forTicks(20);
        QCOMPARE_LE(served_->strongest, 8 + 1e-9);
        QCOMPARE_GT(served_->strongest, 7.9);
    }

    void preparingIsShown() {
        const auto device = make();
        Watcher watcher;
        VERIFY_RESULT((*device)->prepare(watcher));
        QVERIFY((watcher.steps == std::vector<std::string>{"Wake", "Home"}));
        QCOMPARE(watcher.request, std::string("Pull the handle."));
        QCOMPARE(watcher.parts, std::vector<double>{0.5});
        // The driver is open by then: who opens the device later does not wait for it.
        QCOMPARE(served_->opens.load(), 1);
        VERIFY_RESULT((*device)->open());
        QCOMPARE(served_->opens.load(), 1);
        QCOMPARE(served_->strongest.load(), 0.0);
    }

    /// On the worker that prepares, not where the window opens it.
    void aDriverThatHangsAtOpeningFailsWhilePreparing() {
        const auto device = make("sleeps");
        Watcher watcher;
        const auto prepared = (*device)->prepare(watcher);
        QVERIFY(!prepared);
        COMPARE_CONTAINS(prepared.error().text, "did not answer");
    }

    void aPersonMayGiveUp() {
        const auto device = make("homes");
        Watcher watcher;
        watcher.onRequest = [&](std::string_view) { watcher.givesUp = true; };
        const auto result = (*device)->prepare(watcher);
        QVERIFY(!result);
        QCOMPARE(result.error().text, std::string("The device is not homed. Pull the handle."));
    }

    void nobodyAtHandIsNotWaitedFor() {
        const auto device = make("homes");
        Unattended nobody;
        const auto result = (*device)->prepare(nobody);
        QVERIFY(!result);
        QCOMPARE(result.error().text, std::string("The device is not homed. Pull the handle."));
        Watcher watcher;
        watcher.onRequest = [&](std::string_view) { watcher.givesUp = true; };
        QVERIFY(!(*device)->prepare(watcher)); // and it can still be asked again
        QCOMPARE(served_->prepares.load(), 2);
    }

    void whyItDoesNotOpenComesThrough() {
        const auto device = make("closed");
        const auto result = (*device)->open();
        QVERIFY(!result);
        QCOMPARE(result.error().text, std::string("The lid of the device is shut: open it."));
        QCOMPARE_EQ(result.error().kind, Error::Kind::Input);
    }

    void aDriverThatDiesOpeningIsSaid() {
        const auto device = make("dies");
        const auto result = (*device)->open();
        QVERIFY(!result);
        COMPARE_CONTAINS(result.error().text, "crashed (Aborted)");
        COMPARE_CONTAINS((*device)->trouble(), "crashed");
    }

    void whatCannotBeStartedIsSaid() {
        const auto none = makeRemoteDevice("/no/such/program", {});
        QVERIFY(!none);
        COMPARE_CONTAINS(none.error().text, "cannot be started");
        const auto other = makeRemoteDevice("/bin/true", {});
        QVERIFY(!other);
        COMPARE_CONTAINS(other.error().text, "ended by itself");
        const auto refused = make("unknown");
        QVERIFY(!refused);
        QCOMPARE(refused.error().text, std::string("There is no such device."));
    }

    void itsTroubleComesThrough() {
        const auto device = opened();
        served_->troubled = true;
        QVERIFY(Hand(*device).until([&] { return device->trouble() == "Its motors are warm."; }));
        served_->troubled = false;
        QVERIFY(Hand(*device).until([&] { return device->trouble().empty(); }));
    }

    void aCrashOfTheDriverStaysThere_data() {
        QTest::addColumn<double>("how");
        QTest::newRow("segmentation fault") << kCrash;
        QTest::newRow("abort") << kAbort;
        QTest::newRow("stack overflow") << kOverflow;
    }

    void aCrashOfTheDriverStaysThere() {
        QFETCH(double, how);
        const auto device = opened();
        Hand hand(*device, {0, 0, 2});
        QVERIFY(hand.until([&] { return hand.last.valid && served_->push == 2; }));
        hand.force.x() = how;
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        QVERIFY(comesToZero());
        // Its handler at once, its device watchdog when it is gone.
        QVERIFY(test::waitFor([&] { return served_->stops >= 2; }));
        QVERIFY(hand.until([&] { return device->trouble().find("crashed") != std::string::npos; }));
        hand.forTicks(20);
        QVERIFY(!hand.last.valid);
        // Opened again it is another process.
        hand.force.x() = 0;
        device->close();
        VERIFY_RESULT(device->open());
        QVERIFY(hand.until([&] { return hand.last.valid && served_->push == 2; }));
        QVERIFY(device->trouble().empty());
    }

    void aDriverThatHangsLosesTheForce() {
        const auto device = opened();
        Hand hand(*device, {0, 0, 2});
        QVERIFY(hand.until([&] { return hand.last.valid && served_->push == 2; }));
        hand.force.x() = kHang;
        QVERIFY(hand.until([&] { return !hand.last.valid; }));
        QVERIFY(comesToZero()); // by its device watchdog
        QVERIFY(hand.until([&] { return device->trouble().find("stands still") != std::string::npos; }));
    }

    void killedAtAnyInstantTheDriverLeavesNoForce() {
        std::vector<std::int64_t> delays;
        for (int i = 0; i < deaths(); ++i) {
            const auto device = opened();
            Hand hand(*device, {0, 0, 2});
            QVERIFY(hand.until([&] { return hand.last.valid && served_->push == 2; }));
            anInstant(i);
            const std::int64_t killed = monotonicNanoseconds();
            QCOMPARE(kill(served_->server, SIGKILL), 0);
            QVERIFY(hand.until([&] { return !hand.last.valid; }));
            QVERIFY(comesToZero());
            delays.push_back(served_->zeroAt - killed);
            hand.forTicks(5);
            QVERIFY(!hand.last.valid);
            QCOMPARE(served_->push.load(), 0.0);
            // The word of its death may come later than the end of its readings.
            QVERIFY(hand.until([&] { return !device->trouble().empty(); }));
            COMPARE_CONTAINS(device->trouble(), "crashed (Killed)");
        }
        say("driver killed", delays);
    }

    void frozenTheDriverGivesNoOldReadings() {
        std::vector<std::int64_t> delays;
        const auto device = opened();
        for (int i = 0; i < deaths(); ++i) {
            Hand hand(*device, {0, 0, 2});
            QVERIFY(hand.until([&] { return hand.last.valid && served_->push == 2; }));
            anInstant(i);
            const std::int64_t frozen = monotonicNanoseconds();
            QCOMPARE(kill(served_->server, SIGSTOP), 0);
            QVERIFY(hand.until([&] { return !hand.last.valid; }));
            QVERIFY(comesToZero());
            delays.push_back(served_->zeroAt - frozen);
            QVERIFY(hand.until([&] { return !device->trouble().empty(); }));
            QVERIFY(!hand.last.valid);
            QCOMPARE(kill(served_->server, SIGCONT), 0);
        }
        QVERIFY(Hand(*device).until([&] { return device->trouble().empty(); }));
        say("driver frozen", delays);
    }

    void killedAtAnyInstantTheProgramLeavesNoForce() {
        std::vector<std::int64_t> delays;
        for (int i = 0; i < deaths(); ++i) {
            new (served_) Served;
            Program program(file_, i % 2 == 0 ? "held" : "");
            QVERIFY(test::waitFor([&] { return served_->push == 2; }));
            anInstant(i);
            const std::int64_t killed = monotonicNanoseconds();
            QCOMPARE(kill(program.pid, SIGKILL), 0);
            QVERIFY(comesToZero());
            delays.push_back(served_->zeroAt - killed);
            QVERIFY(isGone(served_->server));    // it ends by itself,
            QCOMPARE(served_->closes.load(), 1); // the device closed
            QCOMPARE_GE(served_->zerosAtClose, 3);
            QCOMPARE(served_->push.load(), 0.0);
            QCOMPARE(served_->stops.load(), 0); // in order
        }
        say("program killed", delays);
    }

    void frozenTheProgramLosesTheForceGently() {
        std::vector<std::int64_t> delays;
        Program program(file_);
        for (int i = 0; i < deaths(); ++i) {
            QVERIFY(test::waitFor([&] { return served_->push == 2; }));
            anInstant(i);
            const std::int64_t frozen = monotonicNanoseconds();
            QCOMPARE(kill(program.pid, SIGSTOP), 0);
            QVERIFY(fades());
            served_->between = 0;
            delays.push_back(served_->zeroAt - frozen);
            QCOMPARE(kill(program.pid, SIGCONT), 0); // and comes back with the next command
        }
        say("program frozen", delays);
        kill(program.pid, SIGKILL);
    }

    void aStopHoldsUntilTheNextCommand() {
        const auto device = opened();
        Hand hand(*device, {0, 0, 2});
        QVERIFY(hand.until([&] { return served_->push == 2; }));
        device->emergencyStop();
        QVERIFY(!fades()); // it is gone at once
        QVERIFY(comesToZero());
        QVERIFY(hand.until([&] { return served_->push == 2; }));
    }

    void closedInOrder() {
        auto device = opened();
        Hand hand(*device, {0, 0, 2});
        QVERIFY(hand.until([&] { return served_->push == 2; }));
        device->close();
        QCOMPARE(served_->push.load(), 0.0);
        QCOMPARE(served_->closes.load(), 1);
        QCOMPARE_GE(served_->zerosAtClose, 3);
        QCOMPARE(served_->stops.load(), 0);
        hand.forTicks(20);
        QVERIFY(!hand.last.valid);
        QCOMPARE(served_->push.load(), 0.0);
        VERIFY_RESULT(device->open());
        QCOMPARE(served_->opens.load(), 2);
        QVERIFY(hand.until([&] { return served_->push == 2; }));
        const pid_t holder = fork(); // of its sockets, as a device watchdog is
        if (holder == 0) {
            pause();
            _exit(0);
        }
        device.reset();
        QCOMPARE(served_->push.load(), 0.0);
        QVERIFY(isGone(served_->server));
        QVERIFY(served_->ended); // by itself
        kill(holder, SIGKILL);
        waitpid(holder, nullptr, 0);
    }
};

TACTUM_TEST(TestRemoteDevice)

} // namespace test_remote_device

#include "test_remote_device.moc"
