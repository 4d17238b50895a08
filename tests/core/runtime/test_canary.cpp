// The canary tells what the machine did: whoever takes its processor for as long as a missed tick is seen.
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
        missed += !canary.wasLate(absence.from, absence.until);
    }
    return missed;
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
        Canary canary;
        QVERIFY(canary.start(rate).has_value());
        int missed = -1;
        RealtimeThread machine;
        QVERIFY(machine
                    .start("machine", 99,
                           [&] {
                               stayOn(sched_getcpu());
                               canary.follow(sched_getcpu());
                               missed = unseen(canary, rate, 300);
                           })
                    .has_value());
        machine.join();
        if (machine.refusal()) QSKIP("nobody goes before the canary here");
        QCOMPARE(missed, 0);
    }

    /// At a rate at which hardly any machine is late.
    void nobodyIsBlamedForNothing() {
        Canary canary;
        QVERIFY(canary.start(1).has_value());
        canary.follow(sched_getcpu());
        const std::int64_t begun = monotonicNanoseconds();
        QTest::qWait(3000);
        QVERIFY(!canary.wasLate(begun, monotonicNanoseconds()));
    }
};

QTEST_GUILESS_MAIN(TestCanary)
#include "test_canary.moc"
