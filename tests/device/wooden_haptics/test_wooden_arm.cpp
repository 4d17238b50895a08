// The mechanics of WoodenHaptics agree with themselves, with turning the bodies one by one, and with energy.
#include <cmath>

#include <QTest>

#include "device/wooden_haptics/arm.h"
#include "device/wooden_haptics/report.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_wooden_arm {

using namespace tactum;

namespace {

const double kPi = std::acos(-1.0);
const WoodenArm kArm;

/// A grid over the whole workspace, a ball of 10 cm.
std::vector<Vec3> workspace() {
    std::vector<Vec3> points;
    for (int x = -5; x <= 5; ++x)
        for (int y = -5; y <= 5; ++y)
            for (int z = -5; z <= 5; ++z)
                if (const Vec3 p(0.02 * x, 0.02 * y, 0.02 * z); p.norm() <= 0.1) points.push_back(p);
    return points;
}

/// The largest of the three differences.
double apart(const Vec3& a, const Vec3& b) {
    return (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

} // namespace

class TestWoodenArm : public QObject {
    Q_OBJECT

private slots:
    void standsWhereTheDrawingHasIt() {
        // At rest the forearm hangs beside the column: above its foot, as high as column and arm less the
        // forearm.
        QCOMPARE_LE(apart(positionOf(kArm, Vec3::Zero()) + kArm.origin, {0, 0.080 + 0.205 - 0.245, 0}),
                    1e-12);
        // Both horizontal: stretched out toward the person.
        const double right = kPi / 2;
        QCOMPARE_LE(apart(positionOf(kArm, {0, right, right}) + kArm.origin, {0, 0.080, 0.450}), 1e-12);
        // The column turned to the right.
        QCOMPARE_LE(apart(positionOf(kArm, {right, right, right}) + kArm.origin, {0.450, 0.080, 0}), 1e-12);
    }

    void inverseAndForwardAgree() {
        for (const Vec3& p : workspace()) {
            const auto joints = jointsAt(kArm, p);
            QVERIFY(joints.has_value());
            QCOMPARE_LE(apart(positionOf(kArm, *joints), p), 1e-12);
            QCOMPARE_LT((*joints)[1], kPi - (*joints)[2]); // the elbow is up
        }
        QVERIFY(!jointsAt(kArm, {0, 0, 0.3}));
        QVERIFY(!jointsAt(kArm, Vec3::Constant(std::nan(""))));
    }

    void jacobianIsTheDerivative() {
        constexpr double h = 1e-4;
        for (const Vec3& p : workspace()) {
            const Vec3 joints = *jointsAt(kArm, p);
            const Mat3 jacobian = jacobianOf(kArm, joints);
            for (Eigen::Index i = 0; i < 3; ++i) {
                const auto at = [&](double steps) {
                    return positionOf(kArm, joints + steps * h * Vec3::Unit(i));
                };
                const Vec3 slope = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
                QCOMPARE_LE(apart(jacobian.col(i), slope), 1e-9);
            }
        }
    }

    void countsTurnJoints() {
        // One turn of a motor is 10/160 of a turn of the column, the other way round.
        const Vec3 joints = jointsOf(kArm, {2000, -4000, 0}, {0, 0, 0});
        QCOMPARE_LE(apart(joints, {-2 * kPi / 16, 4 * kPi / 12, 0}), 1e-12);
        // Counts wrap: from 32700 by 100 forward.
        QCOMPARE_LE(
            apart(jointsOf(kArm, {-32736, 0, 0}, {32700, 0, 0}), jointsOf(kArm, {100, 0, 0}, {0, 0, 0})),
            1e-12);
    }

    void motorsDoTheWorkOfTheForce() {
        for (const Vec3& p : workspace()) {
            const Vec3 joints = *jointsAt(kArm, p);
            const Vec3 force(0.3, -0.5, 0.7);
            const Vec3 currents = currentsFor(kArm, force, joints);
            for (int motor = 0; motor < 3; ++motor) {
                Counts counts{};
                counts[static_cast<std::size_t>(motor)] = 1; // moved by one count
                const Vec3 turn = jointsOf(kArm, counts, {});
                constexpr double kPart = 1e-3; // of a count, for the path is curved
                const Vec3 way =
                    positionOf(kArm, joints + kPart * turn) - positionOf(kArm, joints - kPart * turn);
                const double angle = 2 * kPart * 2 * kPi / kArm.countsPerTurn;
                const double work = kArm.torqueConstant * currents[motor] * angle;
                COMPARE_NEAR(work, force.dot(way), 1e-12, "J");
            }
        }
    }

    void limitedCurrentsKeepTheDirection() {
        const Vec3 joints = *jointsAt(kArm, {0, 0, 0});
        const Vec3 small = currentsFor(kArm, {0.1, 0.2, 0.1}, joints);
        const Vec3 large = currentsFor(kArm, {100, 200, 100}, joints);
        COMPARE_NEAR(large.cwiseAbs().maxCoeff(), kArm.maxCurrent, 1e-12, "A");
        QCOMPARE_LT(small.cross(large).norm(), 1e-12);
        QCOMPARE_GT(small.dot(large), 0);
        QCOMPARE_LE(apart(currentsFor(kArm, {std::nan(""), 0, 0}, joints), Vec3::Zero()), 1e-12);
        QCOMPARE_LE(apart(currentsFor(kArm, Vec3::Constant(HUGE_VAL), joints), Vec3::Zero()), 1e-12);
    }

    void reportsKeepTheirNumbers() {
        for (const int value : {0, 1, -1, 255, 256, -256, 2000, -2000, 32767, -32768}) {
            WoodenReport report;
            report.values = {static_cast<std::int16_t>(value), 2, -3};
            report.counter = static_cast<std::uint16_t>(value);
            QVERIFY(decode(encode(report)) == report);
        }
        const WoodenBytes expected{0x34, 0x12, 0xff, 0xff, 0x00, 0x80, 0xfe, 0xff};
        QVERIFY(encode({{0x1234, -1, -32768}, 0xfffe}) == expected);
        const std::uint8_t longer[9] = {};
        QVERIFY(!decode(longer));
        QVERIFY(!decode(std::span(longer).first(7)));
        QCOMPARE(milliamperes({1.2346, -2, 0})[0], std::int16_t(1235));
        QCOMPARE(milliamperes({1.2346, -2, 0})[1], std::int16_t(-2000));
    }
};

TACTUM_TEST(TestWoodenArm)

} // namespace test_wooden_arm

#include "test_wooden_arm.moc"
