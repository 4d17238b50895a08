// What an ordinary account is granted: each limit in a process of its own, without any right.
#include <cerrno>
#include <cstdio>
#include <functional>
#include <grp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/utsname.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include "core/loop/realtime_thread.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_urgency {

using namespace tactum;

/// What a thread sees of itself.
struct Seen {
    Urgency told;
    int policy = -1, priority = -1, nice = 99, slack = -1;
    bool started = false, rights = true;
};

/// With no right and these hard limits; false where this account has not so much to give.
bool dropTo(rlim_t priority, rlim_t nice) {
    const rlimit ofPriority{priority, priority}, ofNice{nice, nice};
    if (setrlimit(RLIMIT_RTPRIO, &ofPriority) != 0 || setrlimit(RLIMIT_NICE, &ofNice) != 0) return false;
    constexpr uid_t kNobody = 65534;
    if (geteuid() != 0) return true;
    return setgroups(0, nullptr) == 0 && setresgid(kNobody, kNobody, kNobody) == 0 &&
           setresuid(kNobody, kNobody, kNobody) == 0;
}

Seen seenUnder(rlim_t priority, rlim_t nice) {
    int ends[2];
    if (pipe(ends) != 0) qFatal("no pipe");
    Seen seen;
    const pid_t child = fork();
    if (child == 0) {
        Seen own;
        if (dropTo(priority, nice)) {
            sched_param realtime{.sched_priority = int(priority) + 1};
            own.rights = sched_setscheduler(0, SCHED_FIFO, &realtime) == 0;
            RealtimeThread thread;
            own.started = thread
                              .start("tactum-test", 80,
                                     [&own] {
                                         sched_param parameters{};
                                         pthread_getschedparam(pthread_self(), &own.policy, &parameters);
                                         own.priority = parameters.sched_priority;
                                         own.nice = getpriority(PRIO_PROCESS, 0);
                                         own.slack = prctl(PR_GET_TIMERSLACK, 0, 0, 0, 0);
                                     })
                              .has_value();
            thread.join();
            own.told = thread.urgency();
        }
        _exit(write(ends[1], &own, sizeof own) == sizeof own ? 0 : 1);
    }
    close(ends[1]);
    if (read(ends[0], &seen, sizeof seen) != sizeof seen) seen.started = false;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return seen;
}

class TestUrgency : public QObject {
    Q_OBJECT

private slots:
    void aLowerLimitIsARungAndNoFall_data() {
        QTest::addColumn<int>("limit");
        for (const int limit : {90, 80, 50, 20, 1})
            QTest::addRow("%d", limit) << limit;
    }

    void aLowerLimitIsARungAndNoFall() {
        QFETCH(int, limit);
        const Seen seen = seenUnder(rlim_t(limit), 0);
        if (!seen.started) QSKIP("this account has no such limit to give");
        QVERIFY2(!seen.rights, "the child kept a right");
        QCOMPARE(seen.policy, SCHED_FIFO);
        QCOMPARE(seen.priority, std::min(limit, 80));
        QCOMPARE(seen.told.priority, std::min(limit, 80));
        QCOMPARE(seen.told.refusal, limit >= 80 ? 0 : EPERM);
    }

    void eachRungIsTriedThatIsAllowed() {
        QCOMPARE(rungsOf(80, 95), (std::vector<int>{80, 50, 20, 0}));
        QCOMPARE(rungsOf(80, 80), (std::vector<int>{80, 50, 20, 0}));
        QCOMPARE(rungsOf(80, 60), (std::vector<int>{80, 60, 50, 20, 0}));
        QCOMPARE(rungsOf(80, 50), (std::vector<int>{80, 50, 20, 0}));
        QCOMPARE(rungsOf(80, 30), (std::vector<int>{80, 30, 20, 0}));
        QCOMPARE(rungsOf(80, 5), (std::vector<int>{80, 5, 0}));
        QCOMPARE(rungsOf(10, 50), (std::vector<int>{10, 0}));
        QCOMPARE(rungsOf(80, 0), (std::vector<int>{80, 0})); // an administrator needs no limit
    }

    void withoutPriorityNiceIsTaken() {
        const Seen seen = seenUnder(0, 31); // down to -11
        if (!seen.started) QSKIP("this account has no such limit to give");
        QCOMPARE(seen.policy, SCHED_OTHER);
        QCOMPARE(seen.nice, -11);
        QCOMPARE(seen.told.nice, -11);
    }

    void withoutAnyRightItIsHastened() {
        const Seen seen = seenUnder(0, 0);
        QVERIFY(seen.started);
        QVERIFY(!seen.rights);
        QCOMPARE(seen.told.priority, 0);
        QCOMPARE(seen.told.refusal, EPERM);
        QCOMPARE(seen.policy, SCHED_OTHER);
        QCOMPARE(seen.slack, 1); // ns, where others have 50,000
        utsname kernel{};
        uname(&kernel);
        int major = 0, minor = 0;
        QCOMPARE(std::sscanf(kernel.release, "%d.%d", &major, &minor), 2);
        if (std::pair(major, minor) < std::pair(6, 12)) QSKIP("this kernel knows no slices");
        QVERIFY(seen.told.slice);
    }

    void oneSentenceSaysWhatAndWhatHelps() {
        QCOMPARE(sentenceOf({.asked = 80, .priority = 80}, 0),
                 std::string("Real-time priority and locked memory were granted."));
        const std::string half = sentenceOf({.asked = 80, .priority = 50, .refusal = EPERM}, 0);
        COMPARE_CONTAINS(half, "real-time priority 50");
        const std::string none =
            sentenceOf({.asked = 80, .refusal = EPERM, .nice = -11, .slice = true}, ENOMEM);
        for (const char* part : {"no real-time priority", "nice -11", "0.1 ms", "swapped", "rtprio 90"})
            COMPARE_CONTAINS(none, part);
        COMPARE_LACKS(none, "\n");
    }
};

TACTUM_TEST(TestUrgency)

} // namespace test_urgency

#include "test_urgency.moc"
