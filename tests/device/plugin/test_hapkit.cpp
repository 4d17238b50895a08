// The second example of docs/drivers.md: a driver in C and the sketch that its board runs, which share their
// wire.
#include <random>

#include <QFile>
#include <QTest>

#include "device/plugin/plugin.h"
#include "docs/examples/driver/hapkit/hapkit_wire.h"
#include "tests/device/plugin/fake_hapkit.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_hapkit {

using namespace tactum;
using namespace tactum::test;

class TestHapkit : public QObject {
    Q_OBJECT

    std::unique_ptr<FakeHapkit> board_;
    std::unique_ptr<HapticDevice> device_;

    void open() {
        board_ = std::make_unique<FakeHapkit>();
        device_ = makePlugin(listPlugins().at(0).id).value();
        VERIFY_RESULT(device_->open());
    }
    bool until(const Vec3& force, const std::function<bool(const DeviceSample&)>& isSo) const {
        for (Patience patience; !patience.isOver(); std::this_thread::sleep_for(std::chrono::milliseconds(1)))
            if (isSo(device_->exchange({force}, 1e-3))) return true;
        return false;
    }
    bool reads(double x) const {
        return until(Vec3::Zero(), [x](const DeviceSample& sample) {
            return sample.valid && (sample.position - Vec3(x, 0, 0)).norm() < 3e-5;
        });
    }
    bool pushes(const Vec3& force, const Vec3& wanted) const {
        return until(force, [&](const DeviceSample&) { return (board_->pushed() - wanted).norm() < 0.05; });
    }

private slots:
    void initTestCase() { qputenv("TACTUM_DRIVERS", TACTUM_FOLDER_OF_HAPKIT); }
    void cleanupTestCase() { qunsetenv("TACTUM_DRIVERS"); }
    void cleanup() {
        device_.reset();
        board_.reset();
    }

    void itIsFoundWithItsFigures() {
        board_ = std::make_unique<FakeHapkit>();
        const auto listings = listPlugins();
        QCOMPARE(listings.size(), 1U);
        QVERIFY2(listings[0].usable, listings[0].sentence.c_str());
        QCOMPARE(listings[0].name, std::string("Hapkit"));
        QCOMPARE(makePlugin(listings[0].id).value()->info().maxForce, 3.0);
    }

    /// Over several half turns of the pulley, 11.8 mm each, at which its sensor begins anew; a step is 0.013
    /// mm.
    void itIsWhereItsHandleIs() {
        open();
        for (const double x : {0.0, 0.004, 0.03, 0.045, 0.01, -0.02, -0.045, 0.0}) {
            board_->hold(x);
            QVERIFY2(reads(x), qPrintable(QString::number(x)));
        }
    }

    /// In steps of its motor's duty: at most 0.05 N.
    void itPushesAsItIsAsked() {
        open();
        for (const double x : {2.5, 0.3, 0.0, -0.3, -2.5})
            QVERIFY2(pushes({x, 0, 0}, {x, 0, 0}), qPrintable(QString::number(x)));
        QVERIFY(pushes({0, 2, -1}, {0, 0, 0})); // its handle goes along x
        QVERIFY(pushes({100, 0, 0}, {3, 0, 0}));
    }

    void whoSaysNothingPushesNobody() {
        open();
        QVERIFY(pushes({2, 0, 0}, {2, 0, 0}));
        QVERIFY(eventually([this] { return board_->pushed().norm() == 0; })); // by the board
    }

    void garbageBetweenAnswersIsPassedOver() {
        open();
        board_->hold(0.02);
        QVERIFY(reads(0.02));
        int read = 0;
        const char noise[] = "\xA5\xA5\x10\x20\x01\xC3"
                             "Error\n\xA5"; // begins as an answer does
        QVERIFY(until({0, 0, 0}, [&](const DeviceSample& sample) {
            board_->say({noise, sizeof noise - 1});
            if (sample.valid && std::abs(sample.position.x() - 0.02) > 3e-5)
                qFatal("noise was taken for a place");
            return (read += sample.valid) > 100;
        }));
    }

    void whatRunsNoSketchIsRefused() {
        qputenv("HAPKIT", "/dev/null");
        const auto opened = makePlugin(listPlugins().at(0).id).value()->open();
        qunsetenv("HAPKIT");
        QVERIFY(!opened);
        COMPARE_CONTAINS(opened.error().text, "/dev/null");
    }

    /// Any one packet in noise is found again, and none that has lost or changed a byte.
    void itsWireKeepsWhatWasSaid() {
        std::mt19937 random(22);
        HapkitReader reader{};
        for (int trial = 0; trial < 20'000; ++trial) {
            std::array<std::uint8_t, HAPKIT_SIZE> packet{};
            const auto said = std::int16_t(std::uniform_int_distribution<int>(-32768, 32767)(random));
            hapkit_put(packet.data(), HAPKIT_COMMAND, said);
            const std::size_t wrong = trial % 6;
            if (wrong < packet.size()) packet[wrong] ^= std::uint8_t(1U << (random() % 8));
            std::int16_t heard = 0;
            int taken = 0;
            for (const std::uint8_t byte : packet)
                taken += hapkit_take(&reader, HAPKIT_COMMAND, byte, &heard);
            QCOMPARE(taken, wrong < packet.size() ? 0 : 1);
            if (taken) QCOMPARE(heard, said);
            if (!taken) // until the reader has nothing left of it
                for (int i = 0; i < HAPKIT_SIZE; ++i)
                    QCOMPARE(hapkit_take(&reader, HAPKIT_COMMAND, 0, &heard), 0);
        }
    }
};

TACTUM_TEST(TestHapkit)

} // namespace test_hapkit

#include "test_hapkit.moc"
