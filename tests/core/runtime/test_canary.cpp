// The canary tells what the machine did: whoever takes its processor for as long as a missed tick is seen.
#include <optional>
#include <sched.h>
#include <thread>
#include <unistd.h>

#include <QtTest>

#include "core/base/clock.h"
#include "core/runtime/canary.h"

using namespace tactum;

namespace {

struct Absence {
    std::int64_t from = 0, until = 0; ///< ns
};

/// Has the processor for so long, as a machine has it that stands still.
Absence take(std::int64_t nanoseconds) {
    Absence absence{monotonicNanoseconds(), 0};
    do
        absence.until = monotonicNanoseconds();
    while (absence.until - absence.from < nanoseconds);
    return absence;
}

/// Absences of 1.1 periods at ever other moments of the canary's beat, and how many of them it did not note.
int unseen(const Canary& canary, double rate, int count) {
    constexpr std::int64_t kBetween = 10'000, kShift = 37; // us: a beat's parts one after another
    int missed = 0;
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(kBetween + i * kShift % 1000));
        const Absence absence = take(std::int64_t(1.1e9 / rate));
        std::this_thread::sleep_for(std::chrono::microseconds(500)); // it notes that first
        missed += !canary.explains(absence.from, absence.until, false);
    }
    return missed;
}

/// Absences of three times 0.9 periods with so little between them that nobody but the canary gets to run,
/// and how many of them it did not note.
int unseenTorn(const Canary& canary, double rate, int count) {
    int missed = 0;
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(10'000 + i * 37 % 1000));
        const Absence first = take(std::int64_t(0.9e9 / rate));
        std::this_thread::sleep_for(std::chrono::microseconds(10));
        take(std::int64_t(0.9e9 / rate));
        std::this_thread::sleep_for(std::chrono::microseconds(10));
        const Absence last = take(std::int64_t(0.9e9 / rate));
        std::this_thread::sleep_for(std::chrono::microseconds(500));
        missed += !canary.explains(first.from, last.until, false);
    }
    return missed;
}

/// Of so many overruns of a servo that takes five periods for its work, those that the machine is blamed for.
int excused(const Canary& canary, double rate, int count) {
    int blamed = 0;
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const Absence overrun = take(std::int64_t(5e9 / rate));
        std::this_thread::sleep_for(std::chrono::microseconds(500));
        blamed += canary.explains(overrun.from + std::int64_t(1e9 / rate), overrun.until, false);
    }
    return blamed;
}

/// The same of a servo that sleeps while somebody between it and the canary takes a period and a half.
int excusedAsleep(const Canary& canary, double rate, int count) {
    int blamed = 0;
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const Absence other = take(std::int64_t(1.5e9 / rate));
        std::this_thread::sleep_for(std::chrono::microseconds(500));
        blamed += canary.explains(other.from, other.until, true);
    }
    return blamed;
}

/// What count(canary, rate, 300) is on a thread of this priority, or nothing where nobody has one.
template <class Count> std::optional<int> counted(double rate, int priority, Count&& count) {
    Canary canary;
    int result = 0;
    RealtimeThread thread;
    if (!canary.start(rate)) return {};
    const auto body = [&] {
        stayOn(sched_getcpu());
        canary.follow(sched_getcpu());
        result = count(canary, rate, 300);
    };
    if (!thread.start("machine or servo", priority, body)) return {};
    thread.join();
    return thread.refusal() ? std::optional<int>() : result;
}

} // namespace

class TestCanary : public QObject {
    Q_OBJECT

private slots:
    void whoTakesTheProcessorIsSeen_data() {
        QTest::addColumn<double>("rate");
        for (const double rate : {1000.0, 4000.0})
            QTest::addRow("%g Hz", rate) << rate;
    }

    void whoTakesTheProcessorIsSeen() {
        QFETCH(double, rate);
        const std::optional<int> missed = counted(rate, 99, unseen);
        if (!missed) QSKIP("nobody goes before the canary here");
        QCOMPARE(*missed, 0);
    }

    void whoTakesItInPiecesIsSeen_data() { whoTakesTheProcessorIsSeen_data(); }

    void whoTakesItInPiecesIsSeen() {
        QFETCH(double, rate);
        const std::optional<int> missed = counted(rate, 99, unseenTorn);
        if (!missed) QSKIP("nobody goes before the canary here");
        QVERIFY2(*missed <= 3, qPrintable(QString::number(*missed))); // of 300, where the machine is away too
    }

    void ownOverrunsAreOurs_data() { whoTakesTheProcessorIsSeen_data(); }

    void ownOverrunsAreOurs() {
        QFETCH(double, rate);
        const std::optional<int> blamed = counted(rate, 80, excused);
        if (!blamed) QSKIP("the canary goes before nobody here");
        QVERIFY2(*blamed <= 3, qPrintable(QString::number(*blamed))); // a machine may stand still meanwhile
    }

    void whoGoesBeforeASleepingServoIsNoMachine_data() { whoTakesTheProcessorIsSeen_data(); }

    void whoGoesBeforeASleepingServoIsNoMachine() {
        QFETCH(double, rate);
        const std::optional<int> blamed = counted(rate, 80, excusedAsleep);
        if (!blamed) QSKIP("the canary goes before nobody here");
        // Of 300: a quarter of a period is little at 4 kHz, and a busy machine is late by it now and then.
        qInfo("%d", *blamed);
        QVERIFY2(*blamed <= 100, qPrintable(QString::number(*blamed)));
    }

    /// At a rate at which hardly any machine is late.
    void nobodyIsBlamedForNothing() {
        Canary canary;
        QVERIFY(canary.start(1).has_value());
        canary.follow(sched_getcpu());
        QTest::qWait(3000);
        const std::int64_t now = monotonicNanoseconds();
        QVERIFY(!canary.explains(now - 1'000'000'000, now, true));
    }
};

QTEST_GUILESS_MAIN(TestCanary)
#include "test_canary.moc"
