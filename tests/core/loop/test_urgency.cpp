// What an ordinary account is granted: each limit in a process of its own, without any right.
#include <cerrno>
#include <cstdio>
#include <sched.h>
#include <sys/utsname.h>

#include <QTest>

#include "tests/core/loop/seen_thread.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_urgency {

using namespace tactum;
using namespace tactum::test;

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
        const Seen seen = seenBy({.priority = rlim_t(limit)});
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
        QCOMPARE(rungsOf(70, 90), (std::vector<int>{70, 49, 19, 0})); // never beside a servo
        QCOMPARE(rungsOf(70, 20), (std::vector<int>{70, 19, 0}));
        QCOMPARE(rungsOf(80, 0), (std::vector<int>{80, 0})); // an administrator needs no limit
    }

    void withoutPriorityNiceIsTaken() {
        const Seen seen = seenBy({.nice = 31}); // down to -11
        if (!seen.started) QSKIP("this account has no such limit to give");
        QCOMPARE(seen.policy, SCHED_OTHER);
        QCOMPARE(seen.nice, -11);
        QCOMPARE(seen.told.nice, -11);
    }

    void withoutAnyRightItIsHastened() {
        const Seen seen = seenBy({});
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
