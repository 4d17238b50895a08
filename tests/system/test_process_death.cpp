// However the program ends, the device gets zero force: seen from outside, in memory that outlives it.
#include <csignal>
#include <sys/wait.h>

#include <QtTest>

#include "tests/system/watched_device.h"

using namespace tactum::test;

namespace {

constexpr int kPatience = 20'000; // ms
constexpr std::int64_t kMillisecond = 1'000'000;

/// How often each way of dying is tried; more on demand: TACTUM_DEATHS=1000.
int deaths() {
    const int wanted = qEnvironmentVariableIntValue("TACTUM_DEATHS");
    return wanted > 0 ? wanted : 5;
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
        return QTest::qWaitFor([&] { return motors->push > 1; }, kPatience);
    }
    bool isStopped() const {
        return QTest::qWaitFor([&] { return motors->stops > 0; }, kPatience);
    }

    QTemporaryDir dir;
    Motors* motors = nullptr;
    pid_t pid = -1;
};

std::int64_t median(std::vector<std::int64_t> times) {
    std::ranges::sort(times);
    qInfo("stopped after %.2f ms in the median, %.2f ms at most of %zu",
          1e-6 * double(times[times.size() / 2]), 1e-6 * double(times.back()), times.size());
    return times[times.size() / 2];
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
            const std::int64_t killed = nanoseconds();
            QCOMPARE(kill(program.pid, signal), 0);
            QVERIFY(program.isStopped());
            QCOMPARE(program.motors->push.load(), 0.0);
            delays.push_back(program.motors->stoppedAt - killed);
            int status = 0;
            QCOMPARE(waitpid(program.pid, &status, 0), program.pid);
            QVERIFY(WIFSIGNALED(status) && WTERMSIG(status) == signal); // the signal still had its way
            QCOMPARE(program.motors->push.load(), 0.0);
        }
        QVERIFY2(median(delays) < 50 * kMillisecond, qPrintable(QString::number(median(delays))));
    }

    void itsOwnMistakesDoToo_data() {
        QTest::addColumn<QByteArray>("way");
        for (const char* way : {"segv", "abort", "throw", "exit", "stack"})
            QTest::newRow(way) << QByteArray(way);
    }

    void itsOwnMistakesDoToo() {
        QFETCH(QByteArray, way);
        Program program(way.constData());
        QVERIFY(program.isStopped());
        QCOMPARE(waitpid(program.pid, nullptr, 0), program.pid);
        QCOMPARE(program.motors->push.load(), 0.0);
    }

    void aProgramThatStandsStillIsStoppedToo() {
        std::vector<std::int64_t> delays;
        for (int i = 0; i < deaths(); ++i) {
            Program program("wait");
            QVERIFY(program.presses());
            const std::int64_t begun = nanoseconds();
            QCOMPARE(kill(program.pid, SIGSTOP), 0);
            QVERIFY(program.isStopped());
            QCOMPARE(program.motors->push.load(), 0.0);
            delays.push_back(program.motors->stoppedAt - begun);
            // It goes on as after any stall: gently, by itself.
            QCOMPARE(kill(program.pid, SIGCONT), 0);
            QVERIFY(program.presses());
        }
        QVERIFY2(median(delays) < 50 * kMillisecond, qPrintable(QString::number(median(delays))));
    }

    void nobodyIsLeftBehind() {
        Program program("wait");
        QVERIFY(program.presses());
        const QString children = QStringLiteral("/proc/%1/task/%1/children").arg(program.pid);
        QFile file(children);
        if (!file.open(QIODevice::ReadOnly)) QSKIP("this kernel does not list children");
        const pid_t guardian = file.readAll().trimmed().toInt();
        QVERIFY(guardian > 0);
        kill(program.pid, SIGKILL);
        QVERIFY(QTest::qWaitFor([&] { return kill(guardian, 0) != 0; }, kPatience));
    }
};

QTEST_GUILESS_MAIN(TestProcessDeath)
#include "test_process_death.moc"
