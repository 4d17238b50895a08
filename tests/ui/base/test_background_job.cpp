// Work on another thread: its result arrives here, and that of what was given up never.
//
// What would show that a test here is wrong: the work waits until the test lets it go on, so that each order
// of events is made and not hoped for.
#include <semaphore>

#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "ui/base/background_job.h"

namespace test_background_job {

using namespace tactum;
using namespace tactum::test;

namespace {

/// Work that goes on as far as it is let.
struct Held {
    std::binary_semaphore begun{0}, goesOn{0};
    std::atomic<bool> wasCancelled{false};
    int delivered = 0;
    QThread* worker = nullptr;

    std::function<BackgroundJob::Delivery(const Progress&)> work() {
        return [this](const Progress& progress) -> BackgroundJob::Delivery {
            worker = QThread::currentThread();
            progress.report(0.25);
            begun.release();
            goesOn.acquire();
            wasCancelled = progress.isCancelled();
            return [this] { ++delivered; };
        };
    }
};

} // namespace

class TestBackgroundJob : public QObject {
    Q_OBJECT

private slots:
    void theResultArrivesHere() {
        BackgroundJob job;
        Held held;
        QSignalSpy finished(&job, &BackgroundJob::finished);
        QVERIFY(!job.running());
        job.start(held.work());
        QVERIFY(job.running());
        held.begun.acquire();
        QVERIFY(held.worker != QThread::currentThread());
        held.goesOn.release();
        QVERIFY(waitFor([&] { return held.delivered == 1; }));
        QCOMPARE(finished.size(), 1);
        QVERIFY(!job.running());
        QVERIFY(!held.wasCancelled);
    }

    // A quarter is done: three times as long is left as it took.
    void itTellsHowFarItIs() {
        BackgroundJob job;
        Held held;
        QSignalSpy told(&job, &BackgroundJob::progressed);
        QElapsedTimer clock;
        clock.start();
        job.start(held.work());
        held.begun.acquire();
        QVERIFY(waitFor([&] { return told.size() >= 3; }));
        const double most = 1e-3 * double(clock.elapsed());
        QCOMPARE_EQ(told[2][0].toDouble(), 0.25);
        QCOMPARE_GT(told[2][1].toDouble(), 3 * 0.2);
        QCOMPARE_LE(told[2][1].toDouble(), 3 * most + 0.01);
        QCOMPARE_GE(told[2][1].toDouble(), told[1][1].toDouble());
        held.goesOn.release();
        QVERIFY(waitFor([&] { return held.delivered == 1; }));
        const qsizetype before = told.size();
        QTest::qWait(250); // two ticks and more: it tells nothing any more
        QCOMPARE(told.size(), before);
    }

    void aTimeIsNotGuessedFromNothing() {
        BackgroundJob job;
        std::binary_semaphore goesOn{0};
        QSignalSpy told(&job, &BackgroundJob::progressed);
        job.start([&](const Progress& progress) -> BackgroundJob::Delivery {
            progress.report(0.02);
            goesOn.acquire();
            return [] {};
        });
        QVERIFY(waitFor([&] { return !told.empty(); }));
        QCOMPARE_LT(told[0][1].toDouble(), 0);
        goesOn.release();
        QVERIFY(waitFor([&] { return !job.running(); }));
    }

    void whatIsCancelledStillDelivers() {
        BackgroundJob job;
        Held held;
        job.start(held.work());
        held.begun.acquire();
        job.cancel();
        QVERIFY(job.running());
        held.goesOn.release();
        QVERIFY(waitFor([&] { return held.delivered == 1; }));
        QVERIFY(held.wasCancelled);
    }

    void whatIsBegunAnewForgetsTheOld() {
        BackgroundJob job;
        Held old, now;
        QSignalSpy finished(&job, &BackgroundJob::finished);
        job.start(old.work());
        old.begun.acquire();
        job.start(now.work());
        now.begun.acquire();
        old.goesOn.release();
        QVERIFY(waitFor([&] { return old.wasCancelled.load(); }));
        now.goesOn.release();
        QVERIFY(waitFor([&] { return now.delivered == 1; }));
        QVERIFY(!now.wasCancelled);
        QCOMPARE(old.delivered, 0);
        QCOMPARE(finished.size(), 1);
    }

    void whoIsGoneGetsNothing() {
        Held held;
        {
            BackgroundJob job;
            job.start(held.work());
            held.begun.acquire();
        }
        held.goesOn.release();
        QVERIFY(waitFor([&] { return held.wasCancelled.load(); }));
        QTest::qWait(20); // what it returned has come by then
        QCOMPARE(held.delivered, 0);
    }
};

TACTUM_TEST(TestBackgroundJob)

} // namespace test_background_job

#include "test_background_job.moc"
