// What a gamepad's motors are told: sines by the formulas of Butterworth's filters, which the code computes
// tick by tick; impacts, and when it ends.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/vibration/pad_motors.h"
#include "core/vibration/vibration.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_pad_motors {

using namespace tactum;

namespace {

constexpr double kRate = 1000; // Hz

/// Feels a force for some seconds; at the end of each tick what the motors do may be looked at.
template <class Force, class Look>
void feel(PadMotors& motors, double seconds, Force force, Look look, double rate = kRate) {
    for (int i = 0; i < int(std::lround(seconds * rate)); ++i) {
        motors.tick(force(i / rate), true);
        look(i / rate);
    }
}

void apart(PadMotors& motors) {
    for (int i = 0; i <= int(PadMotors::kApart * kRate); ++i)
        motors.tick(Vec3::Zero(), false);
}

double sine(double frequency, double t) {
    return std::sin(2 * std::numbers::pi * frequency * t);
}

/// What filters of second order leave of a sine's amplitude, by the ratio of its frequency and their corner
/// as the bilinear transform bends it.
double passed(double corner, double frequency, bool high, double rate) {
    const double bent =
        std::tan(std::numbers::pi * frequency / rate) / std::tan(std::numbers::pi * corner / rate);
    return 1 / std::sqrt(1 + std::pow(high ? 1 / bent : bent, 4));
}

/// The mean of the amplitudes that the motors stand for, once they are steady.
struct Steady {
    double low = 0, high = 0, lowest = 1e9, highest = 0; ///< N; the last two of both together
};

template <class Force> Steady steadyOf(Force force, double rate = kRate) {
    PadMotors motors(rate);
    Steady steady;
    int count = 0;
    feel(
        motors, 1, force,
        [&](double t) {
            if (t < 0.5) return;
            const auto [low, high] = motors.strengths(1);
            steady.low += low * low;
            steady.high += high * high;
            const double both = std::hypot(low * low, high * high);
            steady.lowest = std::min(steady.lowest, both);
            steady.highest = std::max(steady.highest, both);
            ++count;
        },
        rate);
    steady.low /= count;
    steady.high /= count;
    return steady;
}

} // namespace

class TestPadMotors : public QObject {
    Q_OBJECT
private slots:
    void aSineTurnsTheMotorsOfItsBand_data() {
        QTest::addColumn<double>("frequency");
        QTest::addColumn<double>("rate");
        for (const double rate : {1000.0, 4000.0})
            for (const double f : {40.0, 100.0, 160.0, 320.0})
                QTest::addRow("%g Hz at %g", f, rate) << f << rate;
    }
    void aSineTurnsTheMotorsOfItsBand() {
        QFETCH(double, frequency);
        QFETCH(double, rate);
        constexpr double kAmplitude = 0.5; // N
        const Vec3 along = Vec3(2, -1, 0.5).normalized();
        const Steady steady = steadyOf(
            [&](double t) { return Vec3(Vec3(0, 4, 0) + kAmplitude * sine(frequency, t) * along); }, rate);
        const double shaking = kAmplitude * passed(kSlowestVibration, frequency, true, rate);
        const double low = shaking * passed(PadMotors::kSplit, frequency, false, rate),
                     high = shaking * passed(PadMotors::kSplit, frequency, true, rate);
        COMPARE_NEAR(steady.low, low, 0.02 * kAmplitude, "N");
        COMPARE_NEAR(steady.high, high, 0.02 * kAmplitude, "N");
        // One vibration is one strength, and its power goes to the two motors and nowhere else.
        COMPARE_NEAR(std::hypot(steady.low, steady.high), shaking, 0.02 * kAmplitude, "N");
        QVERIFY2(steady.highest < 1.2 * steady.lowest,
                 qPrintable(QString("%1 to %2 N").arg(steady.lowest).arg(steady.highest)));
    }

    void itsDirectionCountsForNothing() {
        const auto turning =
            steadyOf([](double t) { return Vec3(0.3 * sine(60, t), 3, 0.3 * sine(60, t + 1.0 / 240)); });
        // Two axes of the same strength have twice the power of one.
        const double one = 0.3 * passed(kSlowestVibration, 60, true, kRate);
        COMPARE_NEAR(std::hypot(turning.low, turning.high), std::numbers::sqrt2 * one, 0.01, "N");
    }

    void aPushIsNoVibration() {
        PadMotors motors;
        MotorStrengths last;
        feel(
            motors, 2, [](double t) { return Vec3(0, 3 + sine(1, t), 0); },
            [&](double) { last = motors.strengths(1); });
        QCOMPARE_LT(std::max(last.low, last.high), 0.06); // the root of 4 mN
    }

    void fullStrengthIsANewtonByThePersonsStrength() {
        const auto told = [](double newtons, double strength) {
            PadMotors motors;
            double most = 0;
            feel(
                motors, 1, [&](double t) { return Vec3(newtons * sine(300, t), 0, 0); },
                [&](double t) {
                    if (t > 0.9) most = std::max(most, motors.strengths(strength).high);
                });
            return most;
        };
        COMPARE_NEAR(told(0.25, 1), 0.5, 0.02, ""); // the root: the motor's mass pushes with the square
        COMPARE_NEAR(told(0.25, 2), std::sqrt(0.5), 0.02, "");
        COMPARE_NEAR(told(0.0625, 4), 0.5, 0.02, "");
        QCOMPARE(told(5, 1), 1.0);
        QCOMPARE(told(0.25, 0), 0.0);
    }

    void anImpactIsAShortPulse() {
        PadMotors motors;
        apart(motors);
        double during = 0, after = 1;
        // 0.64 N within 5 ms, and then they stay.
        feel(
            motors, 1, [](double t) { return Vec3(0, 0.64 * std::min(1.0, t / 0.005), 0); },
            [&](double t) {
                if (t > 0.01 && t < PadMotors::kPulse - 0.002)
                    during = std::min(
                        {during == 0 ? 1 : during, motors.strengths(1).low, motors.strengths(1).high});
                if (t > 0.3) after = std::max(motors.strengths(1).low, motors.strengths(1).high);
            });
        COMPARE_NEAR(during, 0.8, 0.02, "");
        QCOMPARE_LT(after, 0.02);
    }

    void onlyWhatWasApartMeetsAgain() {
        PadMotors motors;
        const auto pulseAfter = [&](double apart) {
            motors.rest();
            const Vec3 push(0, 0.5, 0);
            feel(
                motors, 0.5, [&](double) { return push; }, [](double) {});
            for (int i = 0; i < int(std::lround(apart * kRate)); ++i)
                motors.tick(push, false);
            motors.tick(push, true);
            return motors.strengths(1).high;
        };
        QCOMPARE_LT(pulseAfter(0.01), 0.05); // a groove's other side
        COMPARE_NEAR(pulseAfter(0.2), std::sqrt(0.5), 0.02, "");
    }

    void whatIsTouchedFromTheBeginningIsNoImpact() {
        PadMotors motors;
        const auto push = [&] {
            motors.tick(Vec3(0, 0.5, 0), true);
            return std::max(motors.strengths(1).low, motors.strengths(1).high);
        };
        QCOMPARE_LT(push(), 1e-6);
        apart(motors);
        COMPARE_NEAR(push(), std::sqrt(0.5), 0.02, "");
        motors.rest();
        QCOMPARE_LT(push(), 1e-6);
    }

    void nothingVibratesSoonAfterTheTouch() {
        PadMotors motors;
        feel(
            motors, 0.5, [](double t) { return Vec3(0.5 * sine(80, t), 1, 0); }, [](double) {});
        QCOMPARE_GT(motors.strengths(1).low, 0.4);
        for (int i = 0; i <= int(PadMotors::kRelease * kRate); ++i)
            motors.tick(Vec3(0.5 * sine(80, i / kRate), 1, 0), false);
        QVERIFY(motors.strengths(1) == MotorStrengths{});
    }

    void whatIsNoForceIsLeftOut() {
        PadMotors motors, other;
        feel(
            motors, 0.3, [](double t) { return Vec3(0, t > 0.2 ? qQNaN() : 2.0, 0); }, [](double) {});
        feel(
            other, 0.3, [](double) { return Vec3(0, 2.0, 0); }, [](double) {});
        QVERIFY(motors.strengths(1) == other.strengths(1));
    }
};

TACTUM_TEST(TestPadMotors)

} // namespace test_pad_motors

#include "test_pad_motors.moc"
