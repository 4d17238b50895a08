// The canary tells what the machine did: whoever takes its processor for as long as a missed tick is seen.
#include <optional>
#include <sched.h>
#include <thread>
#include <unistd.h>

#include <QTest>

#include "core/base/clock.h"
#include "core/runtime/canary.h"
#include "tests/support/compare.h"
#include "tests/support/quiet.h"
#include "tests/support/test_program.h"

namespace test_canary {

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

/// Absences in so many pieces of so many periods each, at ever other moments of the canary's beat, and how
/// many of them it did not note. Between two pieces there is so little that nobody but the canary gets to
/// run.
int unseen(const Canary& canary, double rate, int count, int pieces, double periods) {
    constexpr std::int64_t kBetween = 10'000, kShift = 37; // us: a beat's parts one after another
    int missed = 0;
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(std::chrono::microseconds(kBetween + i * kShift % 1000));
        Absence absence = take(std::int64_t(1e9 * periods / rate));
        for (int piece = 1; piece < pieces; ++piece) {
            std::this_thread::sleep_for(std::chrono::microseconds(10));
            absence.until = take(std::int64_t(1e9 * periods / rate)).until;
        }
        std::this_thread::sleep_for(std::chrono::microseconds(500)); // it notes that first
        missed += !canary.explains(absence.from, absence.until, false);
    }
    return missed;
}

/// Of so many times that somebody after the canary has the processor for so many periods, those that the
/// machine is blamed for: the servo at its own work, or somebody else while it is asleep.
int excused(const Canary& canary, double rate, int count, double periods, bool asleep) {
    int blamed = 0;
    for (int i = 0; i < count; ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        const Absence overrun = take(std::int64_t(1e9 * periods / rate));
        std::this_thread::sleep_for(std::chrono::microseconds(500));
        const std::int64_t begun =
            asleep ? 0 : std::int64_t(1e9 / rate); // its own work is due a period later
        blamed += canary.explains(overrun.from + begun, overrun.until, asleep);
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
    void initTestCase() { TACTUM_NEEDS_QUIET(); }

    void whoTakesTheProcessorIsSeen_data() {
        QTest::addColumn<double>("rate");
        for (const double rate : {1000.0, 4000.0})
            QTest::addRow("%g Hz", rate) << rate;
    }

    void whoTakesTheProcessorIsSeen() {
        QFETCH(double, rate);
        const std::optional<int> missed =
            counted(rate, 99, [](auto&&... how) { return unseen(how..., 1, 1.1); });
        if (!missed) QSKIP("nobody goes before the canary here");
        QCOMPARE(*missed, 0);
    }

    void whoTakesItInPiecesIsSeen_data() { whoTakesTheProcessorIsSeen_data(); }

    void whoTakesItInPiecesIsSeen() {
        QFETCH(double, rate);
        const std::optional<int> missed =
            counted(rate, 99, [](auto&&... how) { return unseen(how..., 3, 0.9); });
        if (!missed) QSKIP("nobody goes before the canary here");
        QCOMPARE_LE(*missed, 3); // of 300, where the machine is away too
    }

    void ownOverrunsAreOurs_data() { whoTakesTheProcessorIsSeen_data(); }

    void ownOverrunsAreOurs() {
        QFETCH(double, rate);
        const std::optional<int> blamed =
            counted(rate, 80, [](auto&&... how) { return excused(how..., 5, false); });
        if (!blamed) QSKIP("the canary goes before nobody here");
        QCOMPARE_LE(*blamed, 3); // a machine may stand still meanwhile
    }

    void whoGoesBeforeASleepingServoIsNoMachine_data() { whoTakesTheProcessorIsSeen_data(); }

    void whoGoesBeforeASleepingServoIsNoMachine() {
        QFETCH(double, rate);
        const std::optional<int> blamed =
            counted(rate, 80, [](auto&&... how) { return excused(how..., 1.5, true); });
        if (!blamed) QSKIP("the canary goes before nobody here");
        // Of 300: a quarter of a period is little at 4 kHz, and a busy machine is late by it now and then.
        qInfo("%d", *blamed);
        QCOMPARE_LE(*blamed, 60);
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

TACTUM_TEST(TestCanary)

} // namespace test_canary

#include "test_canary.moc"
