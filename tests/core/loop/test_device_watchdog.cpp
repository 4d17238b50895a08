// Who takes the force away when nobody else can: when it does, when it does not, and what it leaves behind.
#include <atomic>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <new>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include "core/base/clock.h"
#include "core/loop/device_watchdog.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_device_watchdog {

using namespace tactum;
using test::eventually;

namespace {

/// Counts its stops in memory that both processes have.
class CountedDevice : public HapticDevice {
public:
    CountedDevice() {
        void* memory = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                            MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        stops_ = new (memory) std::atomic<int>(0);
    }
    ~CountedDevice() override { munmap(static_cast<void*>(stops_), sizeof *stops_); }
    DeviceInfo info() const override { return {}; }
    Result<void> open() override { return {}; }
    void close() override {}
    DeviceSample exchange(const DeviceCommand&, double) noexcept override { return {}; }
    void emergencyStop() noexcept override { ++*stops_; }
    int stops() const { return *stops_; }

private:
    std::atomic<int>* stops_;
};

std::vector<pid_t> ownChildren() {
    std::ifstream file("/proc/self/task/" + std::to_string(getpid()) + "/children");
    return {std::istream_iterator<pid_t>(file), {}};
}

std::size_t descriptors() {
    return std::size_t(std::distance(std::filesystem::directory_iterator("/proc/self/fd"), {}));
}

/// Lets the device watchdog look so many times.
void wait(const DeviceWatchdog& watchdog, std::uint64_t looks) {
    const std::uint64_t until = watchdog.looks() + looks;
    QVERIFY(eventually([&] { return watchdog.looks() >= until; }));
}

} // namespace

class TestDeviceWatchdog : public QObject {
    Q_OBJECT

private slots:
    void beforeItStartsNothingIsGuarded() {
        DeviceWatchdog watchdog;
        QVERIFY(!watchdog.guards());
        QCOMPARE(watchdog.looks(), 0u);
        watchdog.beat(); // no harm
        watchdog.rest();
        watchdog.stop();
        watchdog.stop();
        QVERIFY(ownChildren().empty());
    }

    void itStandsApartAndLeavesNothingBehind() {
        CountedDevice device;
        const std::size_t before = descriptors();
        DeviceWatchdog watchdog;
        for (int round = 0; round < 3; ++round) {
            VERIFY_RESULT(watchdog.start(device));
            QVERIFY(watchdog.guards());
            QCOMPARE(ownChildren().size(), 1u);
            const pid_t child = ownChildren().front();
            wait(watchdog, 3);
            QCOMPARE(getpgid(child), child);
            QCOMPARE(getsid(child), getsid(0)); // in one of its own it would stand still (standApart())
            std::string name;
            std::getline(std::ifstream("/proc/" + std::to_string(child) + "/comm"), name);
            QCOMPARE(name, "tactum-watchdog");
            for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGPIPE})
                QCOMPARE(kill(child, signal), 0);
            wait(watchdog, 3); // it goes on
            QCOMPARE(descriptors(), before + 1);
            watchdog.stop();
            QVERIFY(!watchdog.guards());
            QCOMPARE(watchdog.looks(), 0u);
            QVERIFY(ownChildren().empty());
            QCOMPARE(descriptors(), before);
            watchdog.stop(); // again
            QCOMPARE(descriptors(), before);
        }
        QCOMPARE(device.stops(), 0); // a farewell is no death
    }

    /// A port that the child held would be taken for as long as it lives, and a pipe would never end.
    void itHoldsNoPortAndNoPipe() {
        const int listening = socket(AF_INET, SOCK_STREAM, 0);
        QCOMPARE(listen(listening, 1), 0); // at any port that is free
        int pipe[2];
        QCOMPARE(::pipe(pipe), 0);
        CountedDevice device;
        DeviceWatchdog watchdog;
        VERIFY_RESULT(watchdog.start(device));
        wait(watchdog, 3); // it closes them before it looks
        const std::filesystem::path open = "/proc/" + std::to_string(ownChildren().front()) + "/fd";
        int pipes = 0;
        for (const int descriptor : {listening, pipe[0], pipe[1]})
            QVERIFY(!std::filesystem::is_symlink(open / std::to_string(descriptor)));
        for (const auto& entry : std::filesystem::directory_iterator(open))
            pipes += std::filesystem::read_symlink(entry).string().starts_with("pipe:");
        QCOMPARE_EQ(pipes, 1); // its lifeline
        watchdog.stop();
        for (const int descriptor : {listening, pipe[0], pipe[1]})
            close(descriptor);
    }

    void startingAnewEndsTheOneBefore() {
        CountedDevice device;
        const std::size_t before = descriptors();
        {
            DeviceWatchdog watchdog;
            VERIFY_RESULT(watchdog.start(device));
            const pid_t first = ownChildren().front();
            VERIFY_RESULT(watchdog.start(device));
            QCOMPARE(ownChildren().size(), 1u);
            QVERIFY(ownChildren().front() != first);
            QCOMPARE(descriptors(), before + 1);
        }
        QVERIFY(ownChildren().empty()); // with its owner
        QCOMPARE(descriptors(), before);
        QCOMPARE(device.stops(), 0);
    }

    void aServoThatStandsStillIsStoppedOnce() {
        CountedDevice device;
        DeviceWatchdog watchdog;
        VERIFY_RESULT(watchdog.start(device));
        wait(watchdog, 10);
        QCOMPARE(device.stops(), 0); // no beat yet: nobody waits for the next
        for (int round = 1; round <= 3; ++round) {
            const std::int64_t begun = monotonicNanoseconds();
            watchdog.beat();
            QVERIFY(eventually([&] { return device.stops() >= round; }));
            // Less than its patience is no reason.
            QCOMPARE_GE(monotonicNanoseconds() - begun, kWatchdogPatience * 1'000'000);
            wait(watchdog, 10);
            QCOMPARE(device.stops(), round); // once for each standstill
        }
        watchdog.beat();
        watchdog.rest(); // it ends its work in order
        wait(watchdog, 10);
        QCOMPARE_LE(device.stops(), 4); // a busy machine may come between the two lines above
        const int stops = device.stops();
        wait(watchdog, 10);
        QCOMPARE(device.stops(), stops);
        watchdog.stop();
        QCOMPARE(device.stops(), stops);
    }

    void whoeverDiesIsStopped_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("killed") << SIGKILL;
        QTest::newRow("crashed") << SIGABRT;
        QTest::newRow("ended without a farewell") << 0;
    }

    void whoeverDiesIsStopped() {
        QFETCH(int, signal);
        CountedDevice device;
        const pid_t program = fork();
        if (program == 0) {
            prctl(PR_SET_DUMPABLE, 0); // no core
            auto* watchdog = new DeviceWatchdog;
            if (!watchdog->start(device)) _exit(1);
            while (watchdog->looks() < 2)
                usleep(1000);
            std::signal(SIGABRT, SIG_DFL);
            if (signal) raise(signal);
            _exit(0);
        }
        int status = 0;
        QCOMPARE(waitpid(program, &status, 0), program);
        QVERIFY(eventually([&] { return device.stops() > 0; }));
        QCOMPARE(device.stops(), 1);
    }

    void aWatchdogThatWasKilledOrStoppedCanBeEnded() {
        CountedDevice device;
        for (const int signal : {SIGKILL, SIGSTOP}) {
            DeviceWatchdog watchdog;
            VERIFY_RESULT(watchdog.start(device));
            wait(watchdog, 2);
            QCOMPARE(kill(ownChildren().front(), signal), 0);
            WatchdogCheck watch;
            // Its last looks may still come.
            QVERIFY(eventually([&] { return watch.isDead(watchdog, 0.005); }));
            watchdog.stop(); // neither hangs nor dies of SIGPIPE
            QVERIFY(ownChildren().empty());
        }
        QCOMPARE(device.stops(), 0);
    }

    /// Half a second of servo time without a look; what a late tick says counts little.
    void theWatchCountsSilence() {
        DeviceWatchdog none;
        WatchdogCheck idle;
        for (int i = 0; i < 10000; ++i)
            QVERIFY(!idle.isDead(none, 0.01)); // nobody guards
        CountedDevice device;
        DeviceWatchdog watchdog;
        VERIFY_RESULT(watchdog.start(device));
        wait(watchdog, 1);
        const pid_t child = ownChildren().front();
        QCOMPARE(kill(child, SIGSTOP), 0);
        int status = 0;
        QCOMPARE(waitpid(child, &status, WUNTRACED), child);
        const auto ticksUntilDead = [&](WatchdogCheck& watch, double dt) {
            int ticks = 1;
            while (!watch.isDead(watchdog, dt) && ticks < 100000)
                ++ticks;
            return ticks;
        };
        WatchdogCheck usual, late;
        COMPARE_NEAR(ticksUntilDead(usual, 0.001), 502, 2, "ticks"); // the first sees a look
        COMPARE_NEAR(ticksUntilDead(late, 10.0), 52, 2, "ticks");
        QCOMPARE(kill(child, SIGCONT), 0);
        wait(watchdog, 2);
        QVERIFY(!usual.isDead(watchdog, 0.001)); // alive again, from the beginning
        watchdog.stop();
        QVERIFY(!usual.isDead(watchdog, 0.001));
    }
};

TACTUM_TEST(TestDeviceWatchdog)

} // namespace test_device_watchdog

#include "test_device_watchdog.moc"
