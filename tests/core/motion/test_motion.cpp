// Motions against closed forms: keys, what is between them, loops and jumps.

#include <QTest>

#include "core/motion/body_motion.h"
#include "core/motion/motion_build.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_motion {

using namespace tactum;

namespace {

constexpr double pi = 3.14159265358979323846;

QuatCoefficients turn(double angle, const Vec3& axis = Vec3::UnitZ()) {
    return Quat(Eigen::AngleAxisd(angle, axis.normalized())).coeffs();
}

Motion sliding(Interpolation interpolation, std::vector<double> times, std::vector<Vec3> values) {
    const double duration = times.back();
    return makeMotion({interpolation, std::move(times), std::move(values), {}, {}}, {}, duration);
}

Motion turning(std::vector<double> times, std::vector<QuatCoefficients> values) {
    const double duration = times.back();
    return makeMotion({}, {Interpolation::Linear, std::move(times), std::move(values), {}, {}}, duration);
}

/// A cubic through samples of a function and its slope.
template <class Place, class Slope> Motion sampled(Place&& place, Slope&& slope, double duration, int keys) {
    Track<Vec3> track{Interpolation::CubicSpline, {}, {}, {}, {}};
    for (int i = 0; i <= keys; ++i) {
        const double t = duration * i / keys;
        track.times.push_back(t);
        track.values.push_back(place(t));
        track.arriving.push_back(slope(t));
        track.leaving.push_back(slope(t));
    }
    return makeMotion(std::move(track), {}, duration);
}

double x(const Motion& motion, double t) {
    return motion.at(t).translation.x();
}

} // namespace

class MotionTest : public QObject {
    Q_OBJECT

private slots:
    void withoutKeysItStandsStill();
    void stepHoldsUntilTheNextKey();
    void linearGoesStraight();
    void beforeTheFirstKeyItHasTheFirstValue();
    void cubicFollowsItsTangents();
    void rotationsTakeTheShortWay();
    void rotationsStayUnit();
    void loopsAfterItsDuration();
    void channelsThatEndEarlyHold();
    void knowsItsJumps();
    void aClosedMotionDoesNotJump();
    void topSpeedBoundsEveryPoint();
    void scalesItsLengths();
    void isAValue();
    void carriesPointsOfTheBody();
};

void MotionTest::withoutKeysItStandsStill() {
    const Motion motion = makeMotion({}, {}, 0);
    for (double t : {-1.0, 0.0, 0.5, 1e9})
        QCOMPARE(motion.at(t), Pose{});
    QVERIFY(!motion.jumpsBetween(0, 1e9));
}

void MotionTest::stepHoldsUntilTheNextKey() {
    const Motion motion = sliding(Interpolation::Step, {0, 1, 2}, {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    QCOMPARE(x(motion, 0), 1.0);
    QCOMPARE(x(motion, std::nextafter(1.0, 0.0)), 1.0);
    QCOMPARE(x(motion, 1), 2.0);
    QCOMPARE(x(motion, 1.999), 2.0);
    QCOMPARE(x(motion, 2), 3.0);
}

void MotionTest::linearGoesStraight() {
    const Motion motion = sliding(Interpolation::Linear, {0, 1, 3}, {{0, 0, 0}, {2, -4, 0}, {2, 0, 6}});
    for (double s : {0.0, 0.25, 0.5, 0.9}) {
        COMPARE_NEAR(motion.at(s).translation, Vec3(2 * s, -4 * s, 0), 1e-15, "m");
        COMPARE_NEAR(motion.at(1 + 2 * s).translation, Vec3(2, -4 + 4 * s, 6 * s), 1e-15, "");
    }
}

void MotionTest::beforeTheFirstKeyItHasTheFirstValue() {
    for (Interpolation kind : {Interpolation::Step, Interpolation::Linear}) {
        const Motion motion = sliding(kind, {0.5, 1}, {{7, 0, 0}, {9, 0, 0}});
        for (double t : {-3.0, 0.0, 0.49, 0.5})
            QCOMPARE(x(motion, t), 7.0);
    }
}

// A cubic is reproduced exactly from its values and slopes, with unevenly long spans.
void MotionTest::cubicFollowsItsTangents() {
    const auto place = [](double t) { return Vec3(1 + t - 2 * t * t * t, t * t, 3 * t); };
    const auto slope = [](double t) { return Vec3(1 - 6 * t * t, 2 * t, 3); };
    Track<Vec3> track{Interpolation::CubicSpline, {}, {}, {}, {}};
    for (double t : {0.0, 0.3, 1.0, 2.5}) {
        track.times.push_back(t);
        track.values.push_back(place(t));
        track.arriving.push_back(slope(t));
        track.leaving.push_back(slope(t));
    }
    const Motion motion = makeMotion(track, {}, 2.5);
    for (double t = 0; t < 2.5; t += 0.01)
        COMPARE_NEAR(motion.at(t).translation, place(t), 1e-13, "m");
    // What arrives at a key says nothing of what leaves it.
    track.leaving[1] += Vec3(0, 10, 0);
    const Motion kinked = makeMotion(track, {}, 2.5);
    COMPARE_NEAR(kinked.at(0.2).translation, place(0.2), 1e-13, "m");
    QCOMPARE_GT(kinked.at(0.35).translation.y() - place(0.35).y(), 0.1);
}

void MotionTest::rotationsTakeTheShortWay() {
    const Motion motion = turning({0, 1}, {turn(0), -turn(pi / 2)}); // the same turn, the other sign
    for (double s : {0.0, 0.3, 0.7, 1.0})
        QCOMPARE_LT(motion.at(s).rotation.angularDistance(Quat(turn(s * pi / 2))), 1e-12);
}

void MotionTest::rotationsStayUnit() {
    Track<QuatCoefficients> track{Interpolation::CubicSpline, {}, {}, {}, {}};
    for (int i = 0; i <= 8; ++i) {
        track.times.push_back(i);
        track.values.push_back(3 * turn(i, Vec3(1, i, -2))); // a file may have it longer
        track.arriving.push_back({0.3, -2, 0.1, 5});
        track.leaving.push_back({-4, 1, 0.5, 0.7});
    }
    const Motion motion = makeMotion({}, track, 8);
    for (double t = 0; t < 8; t += 0.001)
        COMPARE_NEAR(motion.at(t).rotation.norm(), 1, 1e-12, "");
    for (int i = 0; i <= 8; ++i)
        QCOMPARE_LT(motion.at(i).rotation.angularDistance(Quat(turn(i, Vec3(1, i, -2)))), 1e-7);
    // Through zero, where a direction is lost, it is still a rotation.
    const Motion through = makeMotion({},
                                      {Interpolation::CubicSpline,
                                       {0, 1},
                                       {turn(0), -turn(0)},
                                       {QuatCoefficients::Zero(), QuatCoefficients::Zero()},
                                       {QuatCoefficients::Zero(), QuatCoefficients::Zero()}},
                                      1);
    COMPARE_NEAR(through.at(0.5).rotation.norm(), 1, 1e-12, "");
}

void MotionTest::loopsAfterItsDuration() {
    const Motion motion = sliding(Interpolation::Linear, {0, 0.5, 2}, {{0, 0, 0}, {5, 0, 0}, {1, 0, 0}});
    for (double t = 0.01; t < 2; t += 0.07)
        for (int round : {1, 2, 1000})
            COMPARE_NEAR(x(motion, t + 2 * round), x(motion, t), 1e-10, "");
    QCOMPARE(x(motion, 2), 1.0); // the end is still the last key
    QCOMPARE(x(motion, 6), 1.0);
}

void MotionTest::channelsThatEndEarlyHold() {
    const Motion motion = makeMotion({Interpolation::Linear, {0, 1}, {{0, 0, 0}, {4, 0, 0}}, {}, {}}, {}, 3);
    QCOMPARE(x(motion, 2.9), 4.0);
    QCOMPARE(x(motion, 3.5), 2.0);
}

void MotionTest::knowsItsJumps() {
    const Motion step =
        sliding(Interpolation::Step, {0, 1, 2, 3}, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}});
    QVERIFY(!step.jumpsBetween(0.5, 1.5)); // the same value again
    QVERIFY(step.jumpsBetween(1.5, 2));
    QVERIFY(!step.jumpsBetween(2, 2.5));
    QVERIFY(step.jumpsBetween(4.9, 5.1));
    QVERIFY(!step.jumpsBetween(3.5, 4.5));
    QVERIFY(step.jumpsBetween(0, 10));
    const Motion saw = sliding(Interpolation::Linear, {0, 1}, {{0, 0, 0}, {1, 0, 0}});
    QVERIFY(!saw.jumpsBetween(0.1, 0.9));
    QVERIFY(saw.jumpsBetween(0.9, 1.1));
    QVERIFY(saw.jumpsBetween(1, 1.01));
    QVERIFY(!saw.jumpsBetween(1.1, 1.9));
    const Motion pair =
        sliding(Interpolation::Linear, {0, 1, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {5, 0, 0}, {0, 0, 0}});
    QCOMPARE(x(pair, std::nextafter(1.0, 0.0)) < 1.0001, true);
    QCOMPARE(x(pair, 1), 5.0);
    QVERIFY(pair.jumpsBetween(0.99, 1));
    QVERIFY(!pair.jumpsBetween(1, 1.5));
    QVERIFY(!pair.jumpsBetween(1.9, 2.5)); // it closes
}

void MotionTest::aClosedMotionDoesNotJump() {
    const Motion wheel =
        turning({0, 1, 2, 3}, {turn(0), turn(2 * pi / 3), turn(4 * pi / 3), turn(2 * pi)}); // ends at -q
    QVERIFY(wheel.jumps.empty());
    QVERIFY(!wheel.jumpsBetween(2.9, 3.1));
    const double before = wheel.at(2.999).rotation.angularDistance(wheel.at(3.001).rotation);
    COMPARE_NEAR(before, 0.002 * 2 * pi / 3, 1e-9, "");
}

void MotionTest::topSpeedBoundsEveryPoint() {
    const Motion swing = sampled([](double t) { return Vec3(0.1 * std::sin(2 * pi * t), 0, 0); },
                                 [](double t) { return Vec3(0.2 * pi * std::cos(2 * pi * t), 0, 0); }, 1, 32);
    COMPARE_NEAR(topSpeed(swing, 0), 0.2 * pi, 0.005, "m/s");
    const Motion wheel = turning({0, 0.5, 1}, {turn(0), turn(1), turn(3)});
    COMPARE_NEAR(topSpeed(wheel, 0.3), 0.3 * 4, 1e-6, "m/s");
    // A jump has no speed.
    QCOMPARE(topSpeed(sliding(Interpolation::Step, {0, 1}, {{0, 0, 0}, {9, 0, 0}}), 1), 0.0);
    QCOMPARE_LT(topSpeed(sliding(Interpolation::Linear, {0, 1, 1}, {{0, 0, 0}, {1, 0, 0}, {9, 0, 0}}), 1),
                1.001);
}

void MotionTest::scalesItsLengths() {
    const auto place = [](double t) { return Vec3(t * t, 1 - t, 0); };
    const auto slope = [](double t) { return Vec3(2 * t, -1, 0); };
    const Motion motion = sampled(place, slope, 2, 3), larger = scaled(motion, 5);
    for (double t = 0; t < 2; t += 0.1)
        COMPARE_NEAR(larger.at(t).translation, 5 * place(t), 1e-12, "m");
}

void MotionTest::isAValue() {
    const Motion one = turning({0, 1}, {turn(0), turn(1)});
    Motion other = one;
    QVERIFY(one == other);
    other.rotation.times[1] = 2;
    QVERIFY(!(one == other));
}

void MotionTest::carriesPointsOfTheBody() {
    const BodyMotion motion{{Quat(turn(0.3)), {1, 2, 3}}, {Quat(turn(0.8)), {1, 2.5, 3}}};
    const Vec3 p_B(0.4, -0.1, 0.2);
    COMPARE_NEAR(motion.carried(motion.before.apply(p_B)), motion.now.apply(p_B), 1e-14, "");
    QCOMPARE(motion.between(1), motion.now);
    COMPARE_NEAR(motion.between(0).apply(p_B), motion.before.apply(p_B), 1e-14, "");
    QCOMPARE_LT(motion.between(0.5).rotation.angularDistance(Quat(turn(0.55))), 1e-12);
}

TACTUM_TEST(MotionTest)

} // namespace test_motion

#include "test_motion.moc"
