// A thread that goes before all others: it runs, is waited for, is left alone.
#include <atomic>
#include <pthread.h>
#include <sched.h>
#include <thread>

#include <QTest>

#include "core/base/clock.h"
#include "core/loop/realtime_thread.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_realtime_thread {

using namespace tactum;

class TestRealtimeThread : public QObject {
    Q_OBJECT

private slots:
    void itRunsUnderItsNameAndPriority() {
        std::string name;
        int policy = -1, priority = -1;
        std::atomic<bool> named{false};
        RealtimeThread thread;
        VERIFY_RESULT(thread.start("tactum-test", 42, [&] {
            while (!named) // it gets its name after it began
                sched_yield();
            char text[16]{};
            pthread_getname_np(pthread_self(), text, sizeof text);
            name = text;
            sched_param parameters{};
            pthread_getschedparam(pthread_self(), &policy, &parameters);
            priority = parameters.sched_priority;
        }));
        named = true;
        thread.join();
        QCOMPARE(name, "tactum-test");
        const Urgency& granted = thread.urgency();
        QCOMPARE(granted.asked, 42);
        QCOMPARE(granted.refusal, granted.priority == 42 ? 0 : EPERM);
        QCOMPARE(policy, granted.priority > 0 ? SCHED_FIFO : sched_getscheduler(0)); // as whoever started it
        QCOMPARE(priority, granted.priority);
    }

    /// Refused or not: a priority that there is not is refused, and the thread runs all the same.
    void withoutPriorityItRunsAsWell() {
        std::atomic<int> ran{0};
        int policy = -1;
        RealtimeThread thread;
        VERIFY_RESULT(thread.start("tactum-test", 1000, [&] {
            policy = sched_getscheduler(0);
            ++ran;
        }));
        QCOMPARE(thread.urgency().refusal, EINVAL);
        thread.join();
        QCOMPARE(ran.load(), 1); // not by each attempt
        QCOMPARE(policy, thread.urgency().priority > 0 ? SCHED_FIFO : sched_getscheduler(0));
    }

    void startingAnewWaitsForTheBodyBefore() {
        std::atomic<int> running{0}, most{0}, ran{0};
        RealtimeThread thread;
        for (int i = 0; i < 5; ++i)
            VERIFY_RESULT(thread.start("tactum-test", 1, [&] {
                most = std::max(most.load(), ++running);
                ++ran;
                --running;
            }));
        thread.join();
        thread.join(); // safe again
        QCOMPARE(most.load(), 1);
        QCOMPARE(ran.load(), 5);
    }

    void joiningWithinATimeTells() {
        RealtimeThread none;
        QVERIFY(none.joinWithin(0));
        std::atomic<bool> end{false};
        RealtimeThread thread;
        VERIFY_RESULT(thread.start("tactum-test", 1, [&] {
            while (!end)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }));
        const std::int64_t begun = monotonicNanoseconds();
        QVERIFY(!thread.joinWithin(0.02));
        QCOMPARE_GE(monotonicNanoseconds() - begun, 20'000'000);
        end = true;
        QVERIFY(thread.joinWithin(60));
        QVERIFY(thread.joinWithin(0)); // has ended
        thread.join();
    }

    void whoeverIsLeftAloneIsNotWaitedFor() {
        const auto end = std::make_shared<std::atomic<bool>>(false),
                   ended = std::make_shared<std::atomic<bool>>(false);
        {
            RealtimeThread thread;
            VERIFY_RESULT(thread.start("tactum-test", 1, [end, ended] {
                while (!*end)
                    std::this_thread::sleep_for(std::chrono::milliseconds(1));
                *ended = true;
            }));
            thread.abandon();
            thread.join(); // waits for nobody
            QVERIFY(thread.joinWithin(0));
        }
        QVERIFY(!*ended);
        *end = true;
        QVERIFY(test::eventually([&] { return ended->load(); }));
    }
};

TACTUM_TEST(TestRealtimeThread)

} // namespace test_realtime_thread

#include "test_realtime_thread.moc"
