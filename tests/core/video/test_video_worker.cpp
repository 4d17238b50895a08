// A video is written beside whoever makes its pictures: nobody waits for it, and what is too much is left out
// and counted.
#include <mutex>

#include <QTest>

#include "core/video/video_worker.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"

namespace test_video_worker {

using namespace tactum;
using namespace tactum::test;

namespace {

/// What came to the file.
struct Written {
    std::mutex held; ///< while it is locked, the file takes its time
    std::vector<double> times;
    double end = -1;
    double fullAt = 1e9; ///< s
};

class KeptVideo : public VideoFile {
public:
    explicit KeptVideo(Written& written) : written_(written) {}
    Result<void> add(const VideoPicture&, double time) override {
        const std::lock_guard lock(written_.held);
        if (time >= written_.fullAt) return machineError("full.webm: no more can be written; make room");
        written_.times.push_back(time);
        return {};
    }
    Result<void> finish(double end) override {
        written_.end = end;
        return {};
    }

private:
    Written& written_;
};

VideoPicture nothing() {
    return {};
}

} // namespace

class TestVideoWorker : public QObject {
    Q_OBJECT

private slots:
    void itWritesWhatItIsOffered();
    void itRefusesWhatItCannotFollow();
    void aFullDiskEndsIt();
};

void TestVideoWorker::itWritesWhatItIsOffered() {
    Written written;
    VideoWorker worker(std::make_unique<KeptVideo>(written));
    for (const double time : {0.0, 0.1, 0.2})
        QVERIFY(worker.offer(nothing, time));
    worker.finish(0.3);
    QVERIFY(waitFor([&] { return worker.state().ended; }));
    QCOMPARE(written.times, (std::vector<double>{0, 0.1, 0.2}));
    QCOMPARE(written.end, 0.3);
    QCOMPARE(worker.state().written, std::size_t(3));
    QVERIFY(!worker.state().error);
    QVERIFY(!worker.offer(nothing, 0.4));
}

void TestVideoWorker::itRefusesWhatItCannotFollow() {
    Written written;
    VideoWorker worker(std::make_unique<KeptVideo>(written), 3);
    std::size_t taken = 0;
    {
        const std::lock_guard slow(written.held);
        for (int i = 0; i < 20; ++i) // comes back although the file stands still
            taken += worker.offer(nothing, 0.1 * i);
    }
    QCOMPARE_GE(taken, std::size_t(3));
    QCOMPARE_LE(taken, std::size_t(4)); // one is being written
    QCOMPARE(worker.state().refused, 20 - taken);
    worker.finish(2);
    QVERIFY(waitFor([&] { return worker.state().ended; }));
    QCOMPARE(written.times.size(), taken); // at the times that they had
    QCOMPARE(written.end, 2.0);
}

void TestVideoWorker::aFullDiskEndsIt() {
    Written written;
    written.fullAt = 0.1;
    VideoWorker worker(std::make_unique<KeptVideo>(written));
    for (const double time : {0.0, 0.1, 0.2})
        worker.offer(nothing, time);
    QVERIFY(waitFor([&] { return worker.state().ended; }));
    QCOMPARE(worker.state().error->text, std::string("full.webm: no more can be written; make room"));
    QCOMPARE(written.times, (std::vector<double>{0}));
    QVERIFY(!worker.offer(nothing, 0.3));
    worker.finish(0.4); // and nobody hangs
}

TACTUM_TEST(TestVideoWorker)

} // namespace test_video_worker

#include "test_video_worker.moc"
