// What is believed of the Falcon's reports, by itself.
#include <QTest>

#include "device/falcon/falcon_readings.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_falcon_readings {

using namespace tactum;

namespace {

constexpr double kTick = 1e-3;

/// What an arm at `p` reports.
FalconReport at(const Vec3& p, unsigned homed = FalconReport::kAllHomed) {
    FalconReport report{.homed = std::uint8_t(homed)};
    const Vec3 counts =
        (falconArmAt(p)->angles - falconAngles({})) / (falconAngles({1, 1, 1}) - falconAngles({})).x();
    for (int leg = 0; leg < 3; ++leg)
        report.counts[std::size_t(leg)] = std::int16_t(std::lround(counts[leg]));
    return report;
}
const FalconReport kHere = at(Vec3::Zero());

/// How many of so many exchanges are valid.
int valid(FalconReadings& readings, int times, const std::optional<FalconReport>& report, double dt = kTick) {
    int count = 0;
    for (int i = 0; i < times; ++i)
        count += readings(report, dt).valid;
    return count;
}

} // namespace

class TestFalconReadings : public QObject {
    Q_OBJECT

private slots:
    void aReadingIsWhereTheArmIs() {
        FalconReadings readings;
        QVERIFY(!readings.whereToPush());
        FalconReport report = at({0.01, -0.02, 0.015});
        report.buttons = 5;
        const DeviceSample sample = readings(report, kTick);
        QVERIFY(sample.valid);
        QVERIFY(!sample.jumped);
        COMPARE_NEAR(sample.position, Vec3(0.01, -0.02, 0.015), 5e-5, "m");
        QCOMPARE(sample.buttons, 5u);
        const Mat3* jacobian = readings.whereToPush();
        QVERIFY(jacobian);
        QVERIFY(jacobian->isApprox(falconArmAt(sample.position)->jacobian));
        QCOMPARE_EQ(readings.trouble(), FalconTrouble::None);
    }

    void withoutAReportNothingIsNew() {
        FalconReadings readings;
        QCOMPARE(valid(readings, 10, kHere), 10);
        QCOMPARE(valid(readings, 3, {}), 0);
        QVERIFY(readings.whereToPush()); // one may be late
        QCOMPARE(valid(readings, 3, {}), 0);
        QVERIFY(!readings.whereToPush());
        QCOMPARE_EQ(readings.trouble(), FalconTrouble::None);
        valid(readings, 100, {});
        QCOMPARE_EQ(readings.trouble(), FalconTrouble::Silent);
        QCOMPARE(valid(readings, 1, kHere), 1);
        QCOMPARE_EQ(readings.trouble(), FalconTrouble::None);
        QVERIFY(readings.whereToPush());
    }

    void withoutHomeNothingIsTrue() {
        FalconReadings readings;
        for (unsigned homed = 0; homed < 7; ++homed) {
            QCOMPARE(valid(readings, 1, kHere), 1);
            QCOMPARE(valid(readings, 5, at(Vec3::Zero(), homed)), 0);
            QVERIFY(!readings.whereToPush());
            QVERIFY(!readings.homed());
            QCOMPARE_EQ(readings.trouble(), FalconTrouble::NotHomed);
        }
        // The counts leap to where they mean something.
        QCOMPARE(valid(readings, 1, at({0, 0.03, 0})), 1);
    }

    void noHandIsFasterThanThat() {
        for (const double speed : {1.0, 2.9, 3.2, 10.0}) {
            FalconReadings readings;
            valid(readings, 10, kHere);
            const bool believed = readings(at({speed * kTick, 0, 0}), kTick).valid;
            QCOMPARE(believed, speed < 3);
        }
    }

    /// It is where it is after all; but for as long as it takes to count as lost nobody pushes.
    void afterAJumpNothingIsBelievedForAWhile() {
        FalconReadings readings;
        valid(readings, 10, kHere);
        const FalconReport there = at({0.02, 0, 0});
        QCOMPARE(valid(readings, FalconReadings::kDistrust, there), 0);
        QVERIFY(!readings.whereToPush());
        QCOMPARE_EQ(readings.trouble(), FalconTrouble::Jumped);
        QCOMPARE(valid(readings, 10, there), 10);
        QVERIFY(readings.whereToPush());
        valid(readings, 2000, there);
        QCOMPARE_EQ(readings.trouble(), FalconTrouble::None);
    }

    void aSlowStreamIsNoJump() {
        FalconReadings readings;
        valid(readings, 10, kHere);
        valid(readings, 9, {});
        QVERIFY(readings(at({0.02, 0, 0}), kTick).valid);  // 20 mm in 10 ms
        QVERIFY(!readings(at({0.06, 0, 0}), kTick).valid); // but not 40 in one
    }

    /// The report that waited during a stall is of before it, the next one of after it.
    void afterAStallTheFingerIsElsewhere() {
        FalconReadings readings;
        valid(readings, 10, kHere);
        QVERIFY(readings(kHere, 0.02).valid);
        QVERIFY(readings(at({0.02, 0, 0}), kTick).valid);
    }

    /// Between opening and the servo's first tick; it is over with the second report.
    void afterAPauseOfUnknownLengthItIsTheSame() {
        FalconReadings readings;
        valid(readings, 10, kHere);
        readings.pause();
        QVERIFY(readings(kHere, kTick).valid);
        QVERIFY(readings(at({0.02, 0, 0}), kTick).valid);
        QVERIFY(!readings(at({-0.02, 0, 0}), kTick).valid);
    }

    void anArmThatCannotBeIsNotBelieved() {
        FalconReadings readings;
        valid(readings, 10, kHere);
        FalconReport absurd = kHere;
        absurd.counts = {30'000, -30'000, 30'000};
        QCOMPARE(valid(readings, 30, absurd), 0);
        QVERIFY(!readings.whereToPush());
        QCOMPARE_EQ(readings.trouble(), FalconTrouble::Impossible);
    }

    void aRestartForgets() {
        FalconReadings readings;
        valid(readings, 10, kHere);
        readings.restart();
        QVERIFY(!readings.whereToPush());
        QVERIFY(!readings.homed());
        QVERIFY(readings(at({0.03, 0, 0}), kTick).valid);
    }
};

TACTUM_TEST(TestFalconReadings)

} // namespace test_falcon_readings

#include "test_falcon_readings.moc"
