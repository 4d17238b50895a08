// What a sampled wall gives back to the hand: T1 the boundary of the theory, T2 lossless partners, T3
// prescribed motion, where no plant forgives.
#include <algorithm>
#include <cmath>

#include <QTest>

#include "tests/physics/press.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_stability_passive {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kMicrojoule = 1e-6;
constexpr double kNoLimit = 1e9; ///< N

/// Of a mass on a sampled spring: how much more it moves in the second half of eight seconds.
double growth(double mass, double damping, double stiffness, int delay) {
    ClosedLoop loop({{"bare", mass, damping, 0, 0, kNoLimit}, kNoHand, {.delay = delay}},
                    [=](const DeviceSample& sample, double) { return Vec3(-stiffness * sample.position); });
    loop.plant.place({0, 0, 1e-3});
    double early = 0, late = 0;
    loop.run(
        8, [&](const ClosedLoop& now) { (now.time < 4 ? early : late) += now.plant.x[2] * now.plant.x[2]; });
    return late / early;
}

double criticalDamping(double mass, double stiffness, int delay, double expected) {
    double low = 0.5 * expected, high = 2 * expected;
    for (int i = 0; i < 14; ++i)
        (growth(mass, 0.5 * (low + high), stiffness, delay) > 1 ? low : high) = 0.5 * (low + high);
    return 0.5 * (low + high);
}

/// Largest W of a bare device against the wall, over the lossless partners.
double worstGift(double dampingPart) {
    constexpr double kStiffness = 1000, kTick = 1e-3;
    const double damping = dampingPart * kStiffness * kTick / 2;
    double worst = -1;
    for (const double mass : {0.0, 0.1, 1.0})
        for (const double spring : {0.0, 300.0})
            for (const double speed : {0.05, 0.3}) {
                const Bench bench{{"bare", 0.1, damping, 0, 0, kNoLimit}, lossless(mass, spring), {}};
                worst = std::max(worst, pressPlain(bench, {0, speed}, kStiffness, 6).given);
            }
    return worst;
}

/// Readings that the test prescribes, one tick apart, and what the forces gave along straight ways between
/// them, net of the device's losses. `stored`: what the spring still holds counts as given.
double giftAlong(const std::vector<double>& heights, const PlantProfile& device, const Timing& timing,
                 double stiffness, const Control& control, bool stored) {
    double given = 0, most = -1e300;
    Vec3 force = Vec3::Zero();
    double last = heights.front();
    for (const double z : heights) {
        const double way = z - last;
        given +=
            force.z() * way - device.damping * way * way / timing.period() - device.friction * std::abs(way);
        last = z;
        const double depth = std::max(0.0, -z);
        most = std::max(most, given + (stored ? 0.5 * stiffness * depth * depth : 0));
        DeviceSample sample;
        sample.position = counted({0, 0, z}, device.resolution);
        sample.valid = true;
        force = control(sample, timing.period());
    }
    return most;
}

Control plainWall(double stiffness) {
    return [model = wall(stiffness)](const DeviceSample& sample, double) {
        return contactModelForce(model, sample.position, sample.velocity);
    };
}

std::vector<double> randomSteps(int count, double depth, double reach) {
    Rng random(3);
    std::vector<double> z{-depth};
    while (int(z.size()) < count)
        z.push_back(std::clamp(z.back() + uniform(random, -reach, reach), -2 * depth, -1e-6));
    z.push_back(-depth);
    return z;
}

/// To and fro over the boundary of two counts.
std::vector<double> sawtooth(int count, double boundary, double reach) {
    std::vector<double> z;
    for (int i = 0; i < count; ++i)
        z.push_back(boundary + (i % 2 ? reach : -reach));
    return z;
}

} // namespace

class TestStabilityPassive : public QObject {
    Q_OBJECT

private slots:
    void boundaryIsThatOfTheTheory_data() {
        QTest::addColumn<double>("stiffness");
        QTest::addColumn<int>("delay");
        for (const int delay : {0, 1, 2})
            for (const double stiffness : {200.0, 500.0, 1000.0})
                QTest::addRow("%g N/m, %d late", stiffness, delay) << stiffness << delay;
    }

    /// T1: b = K (T / 2 + delay).
    void boundaryIsThatOfTheTheory() {
        QFETCH(double, stiffness);
        QFETCH(int, delay);
        const double expected = stiffness * 1e-3 * (0.5 + delay);
        const double ratio = criticalDamping(1, stiffness, delay, expected) / expected;
        qInfo("b / b_crit = %.4f", ratio);
        QCOMPARE_LE(std::abs(ratio - 1), delay == 0 ? 0.01 : 0.03);
    }

    /// T2: at the boundary no passive partner ever gets energy; below it some do.
    void losslessPartnersGetNothing() {
        const double gift = worstGift(1);
        qInfo("W at the boundary: %.3g J", gift);
        QCOMPARE_LE(gift, kMicrojoule);
        for (const double part : {0.6, 0.4}) {
            const double more = worstGift(part);
            qInfo("W at %.1f of it: %.3g J", part, more);
            QCOMPARE_GT(more, 1e-4); // the test sees it
        }
    }

    void losslessPartnersGetNothingFromTheServo_data() {
        QTest::addColumn<int>("device");
        QTest::addColumn<double>("rate");
        for (int i = 0; i < int(kDevices.size()); ++i)
            for (const double rate : {1000.0, 4000.0})
                QTest::addRow("%s, %g Hz", kDevices[std::size_t(i)].name, rate) << i << rate;
    }

    /// T2 with the product's servo, at the ceiling that it sets itself.
    void losslessPartnersGetNothingFromTheServo() {
        QFETCH(int, device);
        QFETCH(double, rate);
        double worst = -1, stiffness = 0;
        for (const double mass : {0.0, 0.1, 1.0})
            for (const double spring : {0.0, 300.0})
                for (const double speed : {0.05, 0.3})
                    for (const int delay : {0, 1, 2}) {
                        const Bench bench{kDevices[std::size_t(device)],
                                          lossless(mass, spring),
                                          {.rate = rate, .delay = delay}};
                        const Rest rest = pressServo(bench, {0, speed}, 5000, 3);
                        worst = std::max(worst, rest.given);
                        stiffness = std::max(stiffness, rest.stiffness);
                    }
        qInfo("W %.3g J, at most %.0f N/m", worst, stiffness);
        QCOMPARE_LE(worst, kMicrojoule);
    }

    /// T3 a: K T / 2 = 0.25 N s/m decides.
    void randomStepsTurnAtTheBoundary() {
        const std::vector<double> z = randomSteps(200'000, 0.005, 0.002);
        const auto gift = [&](double damping) {
            const PlantProfile device{"bare", 0.1, damping, 0, 0, kNoLimit};
            return giftAlong(z, device, {}, 500, plainWall(500), true) - 0.5 * 500 * 0.005 * 0.005;
        };
        qInfo("b 0.249: %.3g J, 0.251: %.3g J", gift(0.249), gift(0.251));
        QCOMPARE_LE(gift(0.251), kMicrojoule);
        QCOMPARE_GT(gift(0.249), 1e-4);
    }

    /// T3 b: K Delta / 2 = 0.05 N of dry friction decides.
    void sawtoothOverACountTurnsAtTheBoundary() {
        const std::vector<double> z = sawtooth(200'000, -2.5 * 50e-6, 1e-9);
        const auto gift = [&](double friction) {
            const PlantProfile device{"bare", 0.1, 0, friction, 50e-6, kNoLimit};
            return giftAlong(z, device, {}, 2000, plainWall(2000), false);
        };
        qInfo("f 0.049: %.3g J, 0.051: %.3g J", gift(0.049), gift(0.051));
        QCOMPARE_LE(gift(0.051), kMicrojoule);
        QCOMPARE_GT(gift(0.049), kMicrojoule / 10);
    }

    void prescribedMotionGetsNothingFromTheServo_data() {
        QTest::addColumn<double>("damping");
        for (const double damping : {0.0, 2.0, 20.0})
            QTest::addRow("the surface damps with %g N s/m", damping) << damping;
    }

    /// T3 with the product's servo: each device's own losses, at its own ceiling.
    void prescribedMotionGetsNothingFromTheServo() {
        QFETCH(double, damping);
        double most = -1;
        for (const PlantProfile& device : kDevices)
            for (const double rate : {1000.0, 4000.0}) {
                const Timing timing{.rate = rate};
                for (const std::vector<double>& z :
                     {randomSteps(50'000, 0.002, 0.0005), sawtooth(50'000, -2.5 * device.resolution, 1e-9),
                      sawtooth(50'000, -0.5 * device.resolution, 1e-9)}) {
                    GivenModel model(wall(5000, damping));
                    Servo servo(infoOf({device, kNoHand, timing}), model);
                    std::vector<double> warm(std::size_t(rate), 0.0);
                    giftAlong(warm, device, timing, 0, servo.control(), false);
                    std::vector<double> way{0.0};
                    for (double s = 0; s > z.front(); s -= 1e-5)
                        way.push_back(s);
                    way.insert(way.end(), z.begin(), z.end());
                    const double gift = giftAlong(way, device, timing, servo.state.schedule.ceiling().value,
                                                  servo.control(), false);
                    most = std::max(most, gift);
                    QVERIFY2(gift <= kMicrojoule,
                             qPrintable(QString("%1, %2 Hz: %3 J").arg(device.name).arg(rate).arg(gift)));
                }
            }
        qInfo("W %.3g uJ", 1e6 * most);
    }
};

TACTUM_TEST(TestStabilityPassive)

} // namespace test_stability_passive

#include "test_stability_passive.moc"
