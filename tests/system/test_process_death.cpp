// However the program ends, the device gets zero force: seen from outside, in memory that outlives it.
#include <csignal>
#include <sys/wait.h>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/quiet.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/system/watched_device.h"

namespace test_process_death {

using namespace tactum::test;

namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

/// How often each way of dying is tried; more on demand: TACTUM_DEATHS=1000.
int deaths() {
    return repeats("TACTUM_DEATHS", 5);
}

/// The program, pressing with more than a newton.
struct Program {
    explicit Program(const char* way) {
        dir.setAutoRemove(true);
        const QByteArray file = dir.filePath("motors").toLocal8Bit();
        motors = mapMotors(file.constData());
        pid = fork();
        if (pid == 0) {
            execl(TACTUM_DYING_PROGRAM, "dying_program", file.constData(), way, nullptr);
            _exit(127);
        }
    }
    ~Program() {
        kill(pid, SIGKILL);
        waitpid(pid, nullptr, 0);
        munmap(static_cast<void*>(motors), sizeof(Motors));
    }
    bool presses() const {
        return waitFor([&] { return motors->push > 1; });
    }
    /// Its one child; 0 when the kernel does not tell.
    pid_t watchdog() const {
        QFile file(QStringLiteral("/proc/%1/task/%1/children").arg(pid));
        return file.open(QIODevice::ReadOnly) ? file.readAll().trimmed().toInt() : 0;
    }
    /// Waits until it has died or was stopped: only then does nobody but the device watchdog command the
    /// motors. A stop of before may be one of a servo that was late, and the servo goes on.
    int fate() const {
        int status = 0;
        return waitpid(pid, &status, WUNTRACED) == pid ? status : -1;
    }
    bool isAtRest() const {
        return waitFor([&] { return motors->push == 0; });
    }
    /// How long after `moment` the force was taken away; 0 when there was none any more. Unit: ns.
    std::int64_t restedAfter(std::int64_t moment) const {
        return std::max<std::int64_t>(motors->stoppedAt - moment, 0);
    }

    QTemporaryDir dir;
    Motors* motors = nullptr;
    pid_t pid = -1;
};

/// As the kernel tells it in one letter; X where there is none any more.
char stateOf(pid_t process) {
    QFile file(QStringLiteral("/proc/%1/stat").arg(process));
    const QByteArray told = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    return told.isEmpty() ? 'X' : told[told.lastIndexOf(')') + 2];
}

/// Whether all of them were within 50 ms, but for one in five: the machine too may stand still, though not
/// for a second.
bool prompt(std::vector<std::int64_t> times) {
    std::ranges::sort(times);
    qInfo("stopped after %.2f ms in the median, %.2f ms at most of %zu",
          1e-6 * double(times[times.size() / 2]), 1e-6 * double(times.back()), times.size());
    const auto late =
        std::ranges::count_if(times, [](std::int64_t time) { return time >= 50 * kMillisecond; });
    return 5 * std::size_t(late) <= times.size() && times.back() < 1000 * kMillisecond;
}

} // namespace

class TestProcessDeath : public QObject {
    Q_OBJECT

private slots:
    void anySignalTakesTheForceAway_data() {
        QTest::addColumn<int>("signal");
        for (const int signal : {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGSEGV, SIGBUS, SIGABRT, SIGFPE})
            QTest::newRow(strsignal(signal)) << signal;
    }

    void anySignalTakesTheForceAway() {
        QFETCH(int, signal);
        std::vector<std::int64_t> delays;
        for (int i = 0; i < deaths(); ++i) {
            Program program("wait");
            QVERIFY(program.presses());
            QTest::qWait(i * 7 % 20); // at different moments of the servo's tick
            const std::int64_t killed = tactum::monotonicNanoseconds();
            QCOMPARE(kill(program.pid, signal), 0);
            const int fate = program.fate();
            QVERIFY(WIFSIGNALED(fate));
            QCOMPARE_EQ(WTERMSIG(fate), signal); // it had its way
            QVERIFY(program.isAtRest());
            delays.push_back(program.restedAfter(killed));
        }
        QVERIFY(prompt(delays) || mayBeBusy());
    }

    void itsOwnMistakesDoToo_data() {
        QTest::addColumn<QByteArray>("way");
        for (const char* way : {"segv", "abort", "throw", "exit", "stack"})
            QTest::newRow(way) << QByteArray(way);
    }

    void itsOwnMistakesDoToo() {
        QFETCH(QByteArray, way);
        std::vector<std::int64_t> delays;
        for (int i = 0; i < deaths(); ++i) {
            Program program(way.constData());
            QCOMPARE_GE(program.fate(), 0);
            QVERIFY(program.isAtRest());
            delays.push_back(program.restedAfter(program.motors->diesAt));
        }
        QVERIFY(prompt(delays) || mayBeBusy());
    }

    void aProgramThatStandsStillIsStoppedToo() {
        std::vector<std::int64_t> delays;
        for (int i = 0; i < deaths(); ++i) {
            Program program("wait");
            QVERIFY(program.presses());
            const std::int64_t begun = tactum::monotonicNanoseconds();
            QCOMPARE(kill(program.pid, SIGSTOP), 0);
            QVERIFY(WIFSTOPPED(program.fate()));
            QVERIFY(program.isAtRest());
            delays.push_back(program.restedAfter(begun));
            // It goes on as after any stall: gently, by itself.
            QCOMPARE(kill(program.pid, SIGCONT), 0);
            QVERIFY(program.presses());
        }
        QVERIFY(prompt(delays) || mayBeBusy());
    }

    /// A crash would leave the force on: without a device watchdog there is none.
    void withoutADeviceWatchdogThereIsNoForce_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("killed") << SIGKILL;
        QTest::newRow("stopped") << SIGSTOP;
    }

    void withoutADeviceWatchdogThereIsNoForce() {
        QFETCH(int, signal);
        Program program("wait");
        QVERIFY(program.presses());
        const pid_t watchdog = program.watchdog();
        if (watchdog == 0) QSKIP("this kernel does not list children");
        QCOMPARE(kill(watchdog, signal), 0);
        QVERIFY(waitFor([&] { return QByteArray("TZX").contains(stateOf(watchdog)); })); // has it heard
        const int stops = program.motors->stops;
        const auto goesOn = [&](std::uint64_t exchanges) {
            const std::uint64_t before = program.motors->exchanges;
            return waitFor([&] { return program.motors->exchanges > before + exchanges; });
        };
        QVERIFY(waitFor([&] { return program.motors->push == 0; }));
        QVERIFY(goesOn(600)); // somebody arms again and again meanwhile
        QCOMPARE(program.motors->push.load(), 0.0);
        QCOMPARE(program.motors->stops.load(), stops); // it was the servo
        kill(watchdog, SIGKILL);
    }

    void nobodyIsLeftBehind() {
        Program program("wait");
        QVERIFY(program.presses());
        const pid_t watchdog = program.watchdog();
        if (watchdog == 0) QSKIP("this kernel does not list children");
        kill(program.pid, SIGKILL);
        QVERIFY(waitFor([&] { return kill(watchdog, 0) != 0; }));
    }
};

TACTUM_TEST(TestProcessDeath)

} // namespace test_process_death

#include "test_process_death.moc"
