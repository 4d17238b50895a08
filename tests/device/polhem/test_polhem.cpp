// A Polhem on its wire, with each firmware that its maker has published: where it is, how it pushes, and what
// a broken board does to nobody.
#include <cmath>

#include <QTest>

#include "device/polhem/polhem.h"
#include "tests/device/polhem/fake_polhem.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_polhem {

using namespace tactum;
using namespace tactum::test;
using Firmware = FakePolhem::Firmware;

namespace {

DeviceInfo profile() {
    return {.name = "Polhem", .maxForce = 5, .workspaceRadius = 0.09, .real = true};
}

/// One that was opened, at its board.
struct Bench {
    explicit Bench(Firmware firmware) : board(firmware) {}

    /// Exchanges until it is so.
    bool until(const Vec3& force, const std::function<bool(const DeviceSample&)>& isSo) {
        for (Patience patience; !patience.isOver(); std::this_thread::sleep_for(std::chrono::milliseconds(1)))
            if (isSo(device->exchange({force}, 1e-3))) return true;
        return false;
    }
    bool reads(const Vec3& place, const Vec3& force = Vec3::Zero()) {
        return until(force, [&](const DeviceSample& sample) {
            return sample.valid && (sample.position - place).norm() < 1e-4;
        });
    }
    bool pushes(const Vec3& force, double within = 0.02) {
        return until(force, [&](const DeviceSample&) { return (board.pushed() - force).norm() < within; });
    }

    FakePolhem board;
    std::unique_ptr<HapticDevice> device = makePolhem(listPolhem().at(0).id, profile()).value();
};

std::string paddedTo(std::size_t size, std::string text) {
    text.resize(size - 1, ' ');
    return text + '\n';
}

} // namespace

class TestPolhem : public QObject {
    Q_OBJECT

    static void everyFirmware() {
        QTest::addColumn<int>("firmware");
        QTest::newRow("2020, places") << int(Firmware::Of2020);
        QTest::newRow("2021, places") << int(Firmware::Of2021);
        QTest::newRow("2023, counts") << int(Firmware::Of2023);
    }
    std::unique_ptr<Bench> bench_;

    void take() {
        QFETCH(int, firmware);
        bench_ = std::make_unique<Bench>(Firmware(firmware));
        VERIFY_RESULT(bench_->device->open());
    }

private slots:
    void cleanup() { bench_.reset(); }

    void itIsFoundWhereABoardIs() {
        FakePolhem board(Firmware::Of2023);
        const auto listings = listPolhem();
        QCOMPARE(listings.size(), 1U);
        QVERIFY(listings[0].usable);
        QCOMPARE(listings[0].id, std::string("polhem:polhem"));
        COMPARE_CONTAINS(listings[0].sentence, board.port().string());
        board.unplug();
        QVERIFY(listPolhem().empty());
        const auto gone = makePolhem("polhem:polhem", profile());
        QVERIFY(!gone);
        COMPARE_CONTAINS(gone.error().text, "not connected");
    }

    void itIsWhereItsFingerIs_data() { everyFirmware(); }
    void itIsWhereItsFingerIs() {
        take();
        for (const Vec3& place :
             {Vec3(0, 0, 0), Vec3(0.05, 0.02, 0.03), Vec3(-0.06, -0.04, 0.02), Vec3(0, 0.08, 0),
              Vec3(0.01, -0.08, -0.02), Vec3(-0.02, 0.01, -0.08), Vec3(0, 0, 0.08)}) {
            bench_->board.hold(place);
            QVERIFY(bench_->reads(place));
        }
        QCOMPARE(bench_->board.complaints(), 0);
    }

    /// Where its board leaves the arm to the driver, the arm's weight is lifted beside it: 2.3 N at the
    /// finger.
    void itPushesAsItIsAsked_data() { everyFirmware(); }
    void itPushesAsItIsAsked() {
        take();
        for (const Vec3& place : {Vec3(0, 0, 0), Vec3(0.05, 0.02, 0.03), Vec3(-0.03, -0.05, -0.03)}) {
            bench_->board.hold(place);
            QVERIFY(bench_->reads(place));
            for (const Vec3& force :
                 {Vec3(0.5, 0, 0), Vec3(0, -1.5, 0), Vec3(0, 1, 0), Vec3(-1, 0.5, 2), Vec3(0, 0, 0)})
                QVERIFY2(bench_->pushes(force),
                         qPrintable(QString("%1 N up").arg(bench_->board.pushed().y())));
        }
        QCOMPARE(bench_->board.complaints(), 0);
    }

    /// Straight, the stylus goes on where the forearm points to; bent, it leaves its upright plane only when
    /// the wrist was turned. A step of the wrist is 0.35 degrees.
    void itsStylusIsTurnedAsItIs_data() { everyFirmware(); }
    void itsStylusIsTurnedAsItIs() {
        take();
        const Vec3 place(0.05, -0.02, 0.03);
        bench_->board.hold(place);
        QVERIFY(bench_->reads(place));
        const auto pointsTo = [this](const Vec3& own, const Vec3& wanted) {
            return bench_->until({0, 0, 0}, [&](const DeviceSample& sample) {
                const HandleReading handle = bench_->device->handle();
                return sample.valid && handle.turns && (handle.orientation * own - wanted).norm() < 0.01;
            });
        };
        const Vec3 along = Vec3::UnitZ(), forearm = bench_->board.forearm();
        const Vec3 aside = Vec3::UnitY().cross(forearm).normalized();
        QVERIFY(pointsTo(along, forearm));
        bench_->board.turn({0, M_PI / 2, 0});
        QVERIFY(pointsTo(along, aside.cross(forearm)));
        bench_->board.turn({M_PI / 2, M_PI / 2, 0});
        QVERIFY(pointsTo(along, aside));
        bench_->board.turn({0, 0, 0.4});
        QVERIFY(pointsTo(along, forearm));
        const double known =
            QByteArray(QTest::currentDataTag()).startsWith("2023") ? 0.4 : 0; // the older do not tell
        QVERIFY(pointsTo(Vec3::UnitX(), std::cos(known) * aside + std::sin(known) * forearm.cross(aside)));
    }

    void answersThatComeInPiecesAreWhole_data() { everyFirmware(); }
    void answersThatComeInPiecesAreWhole() {
        take();
        const Vec3 place(0.0312, -0.0213, 0.0412);
        bench_->board.hold(place);
        QVERIFY(bench_->reads(place));
        bench_->board.inPieces = true;
        int read = 0;
        QVERIFY(bench_->until({0, 0, 1}, [&](const DeviceSample& sample) {
            if (sample.valid && (sample.position - place).norm() > 1e-4)
                qFatal("a piece was taken for a place");
            return (read += sample.valid) > 50;
        }));
        QCOMPARE(bench_->board.complaints(), 0);
    }

    void whatIsNoPlaceIsNoReading_data() {
        QTest::addColumn<int>("firmware");
        QTest::addColumn<QByteArray>("line");
        const auto add = [](const char* name, Firmware firmware, const std::string& line) {
            QTest::newRow(name) << int(firmware) << QByteArray::fromStdString(line);
        };
        add("no numbers", Firmware::Of2020, paddedTo(63, "nan nan nan 0.1 0.1 0.1 0.1 0"));
        add("endless", Firmware::Of2020, paddedTo(63, "inf 0 0 0.1 0.1 0.1 0.1 0"));
        add("absurd", Firmware::Of2021, paddedTo(64, "1e308 -1e308 1e308 0 0 0 0 0"));
        add("out of reach", Firmware::Of2021, paddedTo(64, "-1204.500 0 0 0 0 0 0 0"));
        add("too few", Firmware::Of2020, paddedTo(63, "1 2 3 0.1 0.1 0.1 0"));
        add("too many", Firmware::Of2020, paddedTo(63, "1 2 3 0.1 0.1 0.1 0.1 0 7"));
        add("words", Firmware::Of2021, "OK\r\nERROR\r\n");
        add("no line", Firmware::Of2021, std::string(500, '1'));
        add("a long line", Firmware::Of2021, paddedTo(200, "1 2 3 0 0 0 0 0"));
        add("bytes", Firmware::Of2023, std::string("\xff\xfe[\0\n]1,,\n", 11));
        add("out of its reach", Firmware::Of2023, "[1,0,-4585,-4846,0,0,0,0]\n");
        add("too large a count", Firmware::Of2023, "[1,99999999999999999999,0,0,0,0,0,0]\n");
        add("too far a count", Firmware::Of2023, "[1,2000000000,0,0,0,0,0,0]\n");
        add("too few counts", Firmware::Of2023, "[1,0,0,0,0,0,0]\n");
        add("too many counts", Firmware::Of2023, "[1,0,0,0,0,0,0,0,0]\n");
        add("another arm", Firmware::Of2023, "[2,0,0,0,0,0,0,0]\n");
        add("no brackets", Firmware::Of2023, "1,0,0,0,0,0,0,0\n");
    }
    void whatIsNoPlaceIsNoReading() {
        take();
        QFETCH(QByteArray, line);
        QVERIFY(bench_->pushes({0, 0, 1}));
        bench_->board.sayInstead(line.toStdString());
        QVERIFY(bench_->until({0, 0, 1}, [&](const DeviceSample& sample) {
            return !sample.valid && bench_->board.pushed().norm() == 0 && !bench_->device->trouble().empty();
        }));
        for (int i = 0; i < 50; ++i) {
            QVERIFY(!bench_->device->exchange({Vec3(0, 0, 1)}, 1e-3).valid);
            QCOMPARE(bench_->board.pushed().norm(), 0.0);
        }
        bench_->board.sayInstead({});
        QVERIFY(bench_->reads({0, 0, 0}));
        QVERIFY(
            bench_->until({0, 0, 0}, [&](const DeviceSample&) { return bench_->device->trouble().empty(); }));
    }

    void aBoardThatFallsSilentIsCalledSo_data() { everyFirmware(); }
    void aBoardThatFallsSilentIsCalledSo() {
        take();
        QVERIFY(bench_->pushes({0, 1, 0}));
        bench_->board.mute = true;
        QVERIFY(bench_->until({0, 1, 0},
                              [&](const DeviceSample&) { return !bench_->device->trouble().empty(); }));
        COMPARE_CONTAINS(bench_->device->trouble(), "says nothing");
        QCOMPARE(bench_->board.pushed().norm(), 0.0);
        bench_->board.mute = false;
        QVERIFY(bench_->reads({0, 0, 0}));
        QCOMPARE(bench_->board.complaints(), 0);
    }

    /// The firmware of places takes the force away by itself.
    void whoHangsPushesNobody() {
        FakePolhem board(Firmware::Of2020);
        const auto device = makePolhem("polhem:polhem", profile()).value();
        VERIFY_RESULT(device->open());
        QVERIFY(eventually([&] {
            device->exchange({Vec3(0, 0, 1)}, 1e-3);
            return board.pushed().norm() > 0.9;
        }));
        QVERIFY(eventually([&] { return board.pushed().norm() == 0; }));
    }

    void whatIsNoPolhemIsRefused() {
        qputenv("TACTUM_POLHEM", "/dev/null");
        const auto nothing = makePolhem("polhem:null", profile()).value()->open();
        QVERIFY(!nothing);
        COMPARE_CONTAINS(nothing.error().text, "/dev/null");
        FakePolhem board(Firmware::Of2023);
        const auto device = makePolhem("polhem:polhem", profile()).value();
        board.model = 3;
        const auto another = device->open();
        QVERIFY(!another);
        COMPARE_CONTAINS(another.error().text, "model 3");
        board.mute = true;
        const auto silent = device->open();
        QVERIFY(!silent);
        COMPARE_CONTAINS(silent.error().text, "does not answer");
        board.mute = false;
        board.model = 1;
        board.sayInstead("[1,0,-4585,-4846,0,0,0,0]\n");
        const auto lost = device->open();
        QVERIFY(!lost);
        COMPARE_CONTAINS(lost.error().text, "put the arm into its rest");
        board.sayInstead({});
        VERIFY_RESULT(device->open());
        QCOMPARE(board.complaints(), 0);
    }

    void whatNobodyHasPublishedIsSaid() {
        FakePolhem older(Firmware::Of2021);
        const auto known = makePolhem("polhem:polhem", profile()).value();
        VERIFY_RESULT(known->open());
        QCOMPARE(known->caution(), std::string());
        FakePolhem newer(Firmware::Of2023);
        const auto unknown = makePolhem("polhem:polhem", profile()).value();
        QCOMPARE(unknown->caution(), std::string());
        VERIFY_RESULT(unknown->open());
        COMPARE_CONTAINS(unknown->caution(), "is not published");
    }

    void whatItsBoardCallsAnErrorIsSaid() {
        FakePolhem board(Firmware::Of2023);
        const auto device = makePolhem("polhem:polhem", profile()).value();
        VERIFY_RESULT(device->open());
        board.error = 42;
        QVERIFY(eventually([&] {
            device->exchange({}, 1e-3);
            return device->caution().find("error 42") != std::string::npos;
        }));
    }
};

TACTUM_TEST(TestPolhem)

} // namespace test_polhem

#include "test_polhem.moc"
