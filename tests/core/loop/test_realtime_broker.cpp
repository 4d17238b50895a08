// Priority for an account without a limit, from a service that is strict as RealtimeKit is. The test itself
// would be wrong if the service gave what the real one refuses: its checks are those of rtkit's README.
#include <QElapsedTimer>
#include <QTest>

#include <linux/capability.h>
#include <sys/prctl.h>

#include "core/loop/realtime_broker.h"
#include "tests/core/loop/message_bus.h"
#include "tests/core/loop/seen_thread.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_realtime_broker {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kPatience = 5000; // ms, where half a second is the program's own for each question

} // namespace

class TestRealtimeBroker : public QObject {
    Q_OBJECT

private slots:
    void init() {
        if (prctl(PR_CAPBSET_READ, CAP_SYS_NICE) == 0) QSKIP("this machine gives nobody a priority");
        if (geteuid() != 0) QSKIP("only an administrator can play a service that gives priority");
        if (bus_.address().isEmpty()) QSKIP("there is no dbus-daemon here");
    }

    void whoHasNoLimitIsGivenPriority_data() {
        QTest::addColumn<bool>("portal");
        QTest::addColumn<int>("asked");
        QTest::addColumn<int>("given");
        QTest::newRow("servo by RealtimeKit") << false << kServoPriority << 20;
        QTest::newRow("proxy by RealtimeKit") << false << 70 << 19;
        QTest::newRow("servo by the portal") << true << kServoPriority << 20;
    }

    void whoHasNoLimitIsGivenPriority() {
        QFETCH(bool, portal);
        QFETCH(int, asked);
        QFETCH(int, given);
        const PriorityService service(bus_, portal ? kPortalManners : BrokerManners{});
        QVERIFY(service.ready());
        const Seen seen = seenBy({.asked = asked,
                                  .systemBus = portal ? kNoBus : bus_.address().constData(),
                                  .userBus = portal ? bus_.address().constData() : kNoBus});
        QVERIFY2(seen.started && !seen.rights, "the child has no right of its own");
        QCOMPARE(seen.policy, SCHED_RR);
        QCOMPARE(seen.priority, given);
        QVERIFY2(seen.reset, "what it starts has no priority");
        QCOMPARE(seen.told.priority, given);
        QCOMPARE(seen.told.broker, portal ? PriorityBroker::Portal : PriorityBroker::RealtimeKit);
        COMPARE_CONTAINS(sentenceOf(seen.told, 0), portal ? "by the desktop portal" : "by RealtimeKit");
    }

    void whoHasALimitAsksNobody() {
        const PriorityService service(bus_, {});
        const Seen seen = seenBy({.priority = 30, .systemBus = bus_.address().constData()});
        if (!seen.started) QSKIP("this account has no such limit to give");
        QCOMPARE(seen.policy, SCHED_FIFO);
        QCOMPARE(seen.told.broker, PriorityBroker::None);
    }

    void aRefusalIsNoFault_data() {
        QTest::addColumn<bool>("refuses");
        QTest::addColumn<bool>("answers");
        QTest::newRow("refuses") << true << true;
        QTest::newRow("does not answer") << false << false;
    }

    void aRefusalIsNoFault() {
        QFETCH(bool, refuses);
        QFETCH(bool, answers);
        const PriorityService service(bus_, {.refuses = refuses, .answers = answers});
        QElapsedTimer timer;
        timer.start();
        const Seen seen = seenBy({.systemBus = bus_.address().constData()});
        QVERIFY(seen.started);
        QCOMPARE(seen.policy, SCHED_OTHER);
        QCOMPARE(seen.told.priority, 0);
        QCOMPARE(seen.slack, 1); // hastened all the same
        COMPARE_NEAR(double(timer.elapsed()), 0, kPatience, "ms");
    }

    /// At half of what the service allows; beyond all of it the kernel would have ended the program.
    void aLoopThatNeverWaitsLosesItAndGoesOn() {
        const PriorityService service(bus_, {});
        const Seen seen = seenBy({.systemBus = bus_.address().constData(), .busy = 1});
        QVERIFY2(seen.started, "the program was ended");
        QCOMPARE(seen.told.priority, 20);
        QCOMPARE(seen.policy, SCHED_OTHER);
    }

private:
    MessageBus bus_;
};

TACTUM_TEST(TestRealtimeBroker)

} // namespace test_realtime_broker

#include "test_realtime_broker.moc"
