// The Falcon's arm: the tables that are known, and inverse, Jacobian and forward against each other.
#include <limits>
#include <random>

#include <QTest>

#include "device/falcon/falcon_kinematics.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_falcon_kinematics {

using namespace tactum;

namespace {

constexpr double kDegree = 0.017453292519943295;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3 fromBase(const Vec3& p) {
    return p - Vec3(0, 0, kFalconCentre);
}

/// Known places: angles in degrees, counts, and torques for 1 N along x, y and z.
struct Known {
    Vec3 position, degrees;
    int counts[3];
    Vec3 torque[3];
};

const Known kKnown[] = {
    {{0, 0, .110},
     {16.1880, 16.1880, 16.1880},
     {-516, -516, -516},
     {{.01549, -.05272, .03724}, {-.05194, .01256, .03938}, {.02418, .02418, .02418}}},
    {{0, 0, .125},
     {27.7093, 27.7093, 27.7093},
     {-200, -200, -200},
     {{.01789, -.06060, .04271}, {-.05965, .01433, .04532}, {.02524, .02524, .02524}}},
    {{0, 0, .150},
     {47.2433, 47.2433, 47.2433},
     {336, 336, 336},
     {{.02127, -.07086, .04958}, {-.06953, .01634, .05319}, {.02277, .02277, .02277}}},
    {{.03, 0, .125},
     {37.1877, 12.5299, 43.4640},
     {60, -617, 232},
     {{.01700, -.04871, .04752}, {-.06458, .01138, .05484}, {.02002, .04046, .01145}}},
    {{0, .03, .125},
     {12.8150, 36.1068, 44.2371},
     {-609, 30, 254},
     {{.01498, -.06589, .05165}, {-.04778, .01327, .05026}, {.04017, .02110, .01071}}},
    {{-.03, -.02, .11},
     {29.9374, 38.3403, -3.9198},
     {-139, 92, -1068},
     {{.01816, -.06384, .02610}, {-.05891, .01749, .02955}, {.01788, .00886, .04055}}},
    {{.02, -.03, .14},
     {61.5754, 29.3231, 40.7645},
     {729, -156, 158},
     {{.02035, -.05626, .04264}, {-.08081, .01517, .05309}, {-.00212, .03907, .03038}}},
};

struct Places {
    explicit Places(unsigned seed) : random(seed) {}
    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    /// Where a hand can be: a ball of 45 mm.
    Vec3 inside() {
        for (;;) {
            const Vec3 p(between(-1, 1), between(-1, 1), between(-1, 1));
            if (p.norm() < 1) return 0.045 * p;
        }
    }
    std::mt19937 random;
};

/// Central differences of the inverse, with an error of the order h^4.
Mat3 differences(const Vec3& p) {
    constexpr double h = 5e-5;
    Mat3 result;
    for (int i = 0; i < 3; ++i) {
        const Vec3 step = h * Vec3::Unit(i);
        const auto at = [&](double times) { return falconArmAt(p + times * step)->angles; };
        result.col(i) = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    }
    return result;
}

/// The largest of the three differences.
double apart(const Vec3& a, const Vec3& b) {
    return (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

Vec3 asVector(const FalconLegs& legs) {
    return {double(legs[0]), double(legs[1]), double(legs[2])};
}

} // namespace

class TestFalconKinematics : public QObject {
    Q_OBJECT

private slots:
    void placesThatAreKnown() {
        for (const Known& known : kKnown) {
            const auto arm = falconArmAt(fromBase(known.position));
            QVERIFY(arm);
            QCOMPARE_LE(apart(arm->angles / kDegree, known.degrees), 6e-5);
            const FalconLegs counts{std::int16_t(known.counts[0]), std::int16_t(known.counts[1]),
                                    std::int16_t(known.counts[2])};
            QCOMPARE_LE(apart(falconAngles(counts), arm->angles), 0.51 * 0.0364347 * kDegree);
            // A fine scale, and a limit that is not reached: rounding leaves 5e-6 of a newton metre.
            for (int axis = 0; axis < 3; ++axis) {
                const auto motors = falconMotors(arm->jacobian, Vec3::Unit(axis), {.countsPerTorque = 4e4});
                QCOMPARE_LE(apart(asVector(motors) / -4e4, known.torque[axis]), 5e-6 + 0.5 / 4e4);
            }
        }
    }

    void countsThatAreKnown() {
        const std::pair<FalconLegs, Vec3> known[] = {{{0, 0, 0}, {0, 0, .134602}},
                                                     {{100, 0, 0}, {.001250, -.004145, .136098}},
                                                     {{0, 100, 0}, {-.004215, .000991, .136098}},
                                                     {{0, 0, 100}, {.002965, .003155, .136098}},
                                                     {{300, -200, 50}, {.013087, -.013208, .135362}}};
        for (const auto& [counts, position] : known) {
            const auto found = falconPosition(falconAngles(counts), Vec3::Zero());
            QVERIFY(found);
            QCOMPARE_LE(apart(*found, fromBase(position)), 6e-7);
        }
    }

    void jacobianIsTheSlopeOfTheInverse() {
        Places places(1);
        double worst = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 p = places.inside();
            const auto arm = falconArmAt(p);
            QVERIFY(arm);
            const double size = arm->jacobian.cwiseAbs().maxCoeff();
            worst = std::max(worst, (arm->jacobian - differences(p)).cwiseAbs().maxCoeff() / size);
        }
        QCOMPARE_LT(worst, 1e-9);
    }

    void forwardFindsWhereTheInverseBegan() {
        Places places(2);
        for (int i = 0; i < 100'000; ++i) {
            const Vec3 p = places.inside();
            const Vec3 nearby = i % 2 ? Vec3(p + 0.003 * Vec3::Random()) : Vec3(0, 0, 0);
            const auto found = falconPosition(falconArmAt(p)->angles, nearby);
            QVERIFY2(found, qPrintable(QString("%1 %2 %3").arg(p.x()).arg(p.y()).arg(p.z())));
            QCOMPARE_LE(apart(*found, p), 1e-11);
        }
    }

    void forwardFindsAlsoFromFarAway() {
        Places places(3);
        int found = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 p = places.inside(), nearby = places.inside();
            if (const auto there = falconPosition(falconArmAt(p)->angles, nearby)) {
                QCOMPARE_LE(apart(*there, p), 1e-11);
                ++found;
            }
        }
        QCOMPARE(found, 20'000);
    }

    /// 125 mm is the middle of the way; all of it can be reached.
    void allTheWayInAndOut() {
        for (double z = 0.075; z <= 0.1751; z += 0.001)
            QVERIFY2(falconArmAt(fromBase({0, 0, z})), qPrintable(QString::number(z)));
    }

    void aStepOfTheEncoderIsOfTheKnownSize() {
        const Vec3 at = *falconPosition(falconAngles({-200, -200, -200}), Vec3::Zero());
        const Vec3 out = *falconPosition(falconAngles({-199, -199, -199}), Vec3::Zero());
        QCOMPARE_LE(apart(out - at, {0, 0, 4.8e-5}), 1e-6);
    }

    /// Virtual work: what the motors do while the legs turn is what the force does while the grip moves.
    void motorsDoTheWorkOfTheForce() {
        Places places(4);
        for (int i = 0; i < 10'000; ++i) {
            const Vec3 p = places.inside(), way = 1e-7 * Vec3::Random(), force = 4 * Vec3::Random();
            const auto arm = falconArmAt(p);
            const Vec3 turned = falconArmAt(p + way)->angles - falconArmAt(p - way)->angles;
            const Vec3 torque =
                asVector(falconMotors(arm->jacobian, force, {.countsPerTorque = 5000})) / -5000;
            // Half a count of each motor is lost to rounding.
            const double rounding = 0.5 / 5000 * turned.cwiseAbs().sum();
            COMPARE_NEAR(torque.dot(turned), force.dot(2 * way), rounding + 1e-6 * 2 * way.norm(), "N m");
        }
    }

    void outwardForceLetsTheMotorsTurnBack() {
        const auto arm = falconArmAt(Vec3::Zero());
        for (const int motor : falconMotors(arm->jacobian, {0, 0, 1}, {}))
            QCOMPARE(motor, -252); // -0.02524 N m times 10000
    }

    void tooMuchIsScaledAsAWhole() {
        Places places(5);
        int limited = 0;
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 p = places.inside();
            const Mat3 jacobian = falconArmAt(p)->jacobian;
            const Vec3 direction = Vec3::Random().normalized();
            const FalconMotorSettings settings{.countsPerTorque = places.between(100, 40'000)};
            const Vec3 force = std::pow(10, i % 100) * 0.1 * direction;
            const Vec3 motors = asVector(falconMotors(jacobian, force, settings));
            QCOMPARE_LE(motors.cwiseAbs().maxCoeff(), kFalconMostMotor);
            Vec3 expected = jacobian.transpose().fullPivLu().solve(std::min(force.norm(), 8.0) * direction);
            expected *= -settings.countsPerTorque;
            const double most = expected.cwiseAbs().maxCoeff();
            limited += most > kFalconMostMotor;
            if (most > kFalconMostMotor) expected *= kFalconMostMotor / most;
            QCOMPARE_LE(apart(motors, expected), 0.5 + 1e-6);
        }
        QCOMPARE_GT(limited, 1000);
    }

    /// A force at the limit goes out as it is, one above as if it were at the limit.
    void forceIsLimited() {
        const Mat3 jacobian = falconArmAt(Vec3::Zero())->jacobian;
        const FalconMotorSettings settings{.countsPerTorque = 2000, .maxForce = 5};
        QCOMPARE(falconMotors(jacobian, {0, 0, 5}, settings), falconMotors(jacobian, {0, 0, 500}, settings));
        QVERIFY(falconMotors(jacobian, {0, 0, 5}, settings) != falconMotors(jacobian, {0, 0, 4}, settings));
    }

    void noNumberComesOutOfNone() {
        const Mat3 jacobian = falconArmAt(Vec3::Zero())->jacobian;
        for (const double bad : {kNan, kInfinity, -kInfinity})
            for (int axis = 0; axis < 3; ++axis) {
                Vec3 v = Vec3::Zero();
                v[axis] = bad;
                QVERIFY(!falconArmAt(v));
                QVERIFY(!falconPosition(v, Vec3::Zero()));
                const auto found = falconPosition(falconAngles({0, 0, 0}), v);
                QVERIFY(found);
                QCOMPARE_LE(apart(*found, fromBase({0, 0, .134602})), 1e-6);
                QCOMPARE(falconMotors(jacobian, v, {}), FalconLegs{});
                QCOMPARE(falconMotors(bad * jacobian, {1, 1, 1}, {}), FalconLegs{});
            }
        QCOMPARE(falconMotors(Mat3::Zero(), {1, 1, 1}, {}), FalconLegs{});
        QCOMPARE(falconMotors(Mat3::Zero(), {0, 0, 0}, {}), FalconLegs{});
        QCOMPARE(falconMotors(jacobian, {1, 1, 1}, {.countsPerTorque = kNan}), FalconLegs{});
    }

    /// Anywhere, also where no hand and no arm can be: an answer of numbers, or none.
    void anywhereNumbersOrNothing() {
        Places places(6);
        int reached = 0, unreached = 0;
        for (int i = 0; i < 200'000; ++i) {
            const double range = std::pow(10, places.between(-3, 1));
            const Vec3 p = range * Vec3::Random();
            if (const auto arm = falconArmAt(p)) {
                ++reached;
                QVERIFY(arm->angles.allFinite());
                QVERIFY(arm->jacobian.allFinite());
            } else {
                ++unreached;
            }
        }
        QCOMPARE_GT(reached, 10'000);
        QCOMPARE_GT(unreached, 10'000);
    }

    /// Whatever the counts: a place that has these angles, or none. No more than a few microseconds either
    /// way.
    void anyCountsAPlaceThatHasThemOrNothing() {
        Places places(7);
        int reached = 0, unreached = 0;
        for (int i = 0; i < 100'000; ++i) {
            FalconLegs counts;
            const double range = std::pow(10, places.between(1, 4.5));
            for (auto& count : counts)
                count = std::int16_t(places.between(-range, range));
            const Vec3 angles = falconAngles(counts);
            const auto found = falconPosition(angles, places.inside());
            if (!found) {
                ++unreached;
                continue;
            }
            ++reached;
            QVERIFY(found->allFinite());
            QCOMPARE_LE(apart(falconArmAt(*found)->angles, angles), 1e-11);
        }
        QCOMPARE_GT(reached, 10'000);
        QCOMPARE_GT(unreached, 1000);
    }
};

TACTUM_TEST(TestFalconKinematics)

} // namespace test_falcon_kinematics

#include "test_falcon_kinematics.moc"
