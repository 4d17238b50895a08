// The recorded hand plays exactly what was recorded.
#include <cmath>

#include <QTest>

#include "device/recorded_hand.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_recorded_hand {

using namespace tactum;

namespace {

const std::vector<RecordedPoint> kPath{{2.0, {0, 0, 0}}, {2.5, {0.1, 0, 0}}, {3.0, {0.1, 0.2, 0}}};

} // namespace

class TestRecordedHand : public QObject {
    Q_OBJECT

private slots:
    void playsEveryPointAtItsTime() {
        RecordedHand hand(kPath);
        QVERIFY(hand.open().has_value());
        const DeviceCommand push{Vec3(5, 5, 5)}; // ignored
        COMPARE_NEAR(hand.exchange(push, 0.7).position, Vec3(0, 0, 0), 1e-12,
                     "m"); // whatever dt: the first point
        const DeviceSample between = hand.exchange(push, 0.125);
        COMPARE_NEAR(between.position, Vec3(0.025, 0, 0), 1e-12, "m");
        COMPARE_NEAR(between.velocity, Vec3(0.2, 0, 0), 1e-12, "m/s");
        COMPARE_NEAR(hand.exchange(push, 0.375).position, Vec3(0.1, 0, 0), 1e-12, "m");
        COMPARE_NEAR(hand.exchange(push, 0.25).position, Vec3(0.1, 0.1, 0), 1e-12, "m");
    }

    void restsAtTheLastPointWhenPlayedOnce() {
        RecordedHand hand(kPath, Playback::Once);
        QVERIFY(hand.open().has_value());
        hand.exchange({}, 0);
        for (const double dt : {1.0, 5.0, 1e9}) {
            const DeviceSample sample = hand.exchange({}, dt);
            QVERIFY(sample.valid);
            QCOMPARE(sample.position, Vec3(0.1, 0.2, 0));
            QCOMPARE(sample.velocity, Vec3(0, 0, 0));
        }
    }

    void startsAgainWhenLooped() {
        RecordedHand hand(kPath, Playback::Looped);
        QVERIFY(hand.open().has_value());
        hand.exchange({}, 0);
        COMPARE_NEAR(hand.exchange({}, 1.25).position, Vec3(0.05, 0, 0), 1e-12, "m");
        COMPARE_NEAR(hand.exchange({}, 100).position, Vec3(0.05, 0, 0), 1e-12, "m");
    }

    void openingAgainRewinds() {
        RecordedHand hand(kPath);
        QVERIFY(hand.open().has_value());
        hand.exchange({}, 0);
        hand.exchange({}, 0.6);
        hand.close();
        QVERIFY(hand.open().has_value());
        COMPARE_NEAR(hand.exchange({}, 0.6).position, Vec3(0, 0, 0), 1e-12, "m");
    }

    void onePointIsAFingerAtRest() {
        for (const Playback playback : {Playback::Once, Playback::Looped}) {
            RecordedHand hand({{1, {0.01, 0, 0}}}, playback);
            QVERIFY(hand.open().has_value());
            QCOMPARE(hand.exchange({}, 1).position, Vec3(0.01, 0, 0));
            QCOMPARE(hand.exchange({}, 1).position, Vec3(0.01, 0, 0));
        }
    }

    void refusesWhatCannotBePlayed_data() {
        QTest::addColumn<int>("fault");
        QTest::newRow("nothing") << 0;
        QTest::newRow("time stands still") << 1;
        QTest::newRow("time runs back") << 2;
        QTest::newRow("position is no number") << 3;
        QTest::newRow("time is no number") << 4;
    }

    void refusesWhatCannotBePlayed() {
        QFETCH(int, fault);
        std::vector<RecordedPoint> path = kPath;
        if (fault == 0) path.clear();
        if (fault == 1) path[1].t = path[0].t;
        if (fault == 2) path[2].t = 0;
        if (fault == 3) path[1].position.y() = std::nan("");
        if (fault == 4) path[2].t = std::nan("");
        const Result<void> opened = RecordedHand(path).open();
        QVERIFY(!opened);
        QCOMPARE(opened.error().kind, Error::Kind::Input);
        QVERIFY(!opened.error().text.empty());
        COMPARE_LACKS(opened.error().text, "\n");
    }
};

TACTUM_TEST(TestRecordedHand)

} // namespace test_recorded_hand

#include "test_recorded_hand.moc"
