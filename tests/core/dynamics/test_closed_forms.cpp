// Motions whose laws are known: pendulums, tops, flips, chains and their energy.
//
// What would show that a test here is wrong: the laws are computed by other means than the motion (elliptic
// integrals by the arithmetic-geometric mean, textbook equations of their own), so a mistake in either makes
// them differ; each tolerance is that of the integrator's order, and at half the step the difference must
// fall sixteenfold (thePendulumIsOfFourthOrder).

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"

namespace test_closed_forms {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;

/// The complete elliptic integral K(k).
double completeK(double k) {
    double a = 1, b = std::sqrt(1 - k * k);
    for (int i = 0; i < 30; ++i) {
        const double mean = 0.5 * (a + b);
        b = std::sqrt(a * b);
        a = mean;
    }
    return pi / (2 * a);
}

/// sn, cn and dn of u with modulus k, by descending Landen transformations.
struct Elliptic {
    double sn, cn, dn;
};
Elliptic elliptic(double u, double k) {
    std::array<double, 20> a{}, c{};
    a[0] = 1;
    c[0] = k;
    double b = std::sqrt(1 - k * k);
    int n = 0;
    while (std::abs(c[std::size_t(n)]) > 1e-17 && n < 15) {
        const std::size_t i = std::size_t(n++);
        a[i + 1] = 0.5 * (a[i] + b);
        c[i + 1] = 0.5 * (a[i] - b);
        b = std::sqrt(a[i] * b);
    }
    double phi = std::pow(2, n) * a[std::size_t(n)] * u;
    for (std::size_t i = std::size_t(n); i > 0; --i)
        phi = 0.5 * (phi + std::asin(c[i] / a[i] * std::sin(phi)));
    const double sn = std::sin(phi);
    return {sn, std::cos(phi), std::sqrt(1 - k * k * sn * sn)};
}

/// A rod on a hinge at the origin, let go at an angle from hanging down.
Running pendulum(double angle, double length, double mass, double moment) {
    const Quat turned(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    RigidBody rod = bodyAt(1, turned * Vec3(0, -length, 0), mass, Vec3::Constant(moment));
    rod.pose.rotation = turned;
    const std::vector<RigidBody> bodies{rod};
    return {bodies, {hingeAt(bodies, kWorldBody, 1, Vec3::Zero())}};
}

/// theta(t) = 2 asin(k sn(K - w t)) for a start at rest.
double pendulumAngle(double t, double start, double frequency) {
    const double k = std::sin(start / 2);
    return 2 * std::asin(k * elliptic(completeK(k) - frequency * t, k).sn);
}

/// The largest error of the angle in three seconds.
double pendulumError(double dt) {
    const double length = 0.05, mass = 0.7, moment = 0.0002, start = 2.9;
    Running run = pendulum(start, length, mass, moment);
    const double frequency = std::sqrt(mass * 9.81 * length / (moment + mass * length * length));
    double worst = 0;
    for (int i = 1; i <= 60; ++i) {
        run.run(0.05, dt);
        const Vec3 at = run.bodies()[0].centre;
        const double wanted = pendulumAngle(0.05 * i, start, frequency);
        worst = std::max(worst, std::abs(std::remainder(std::atan2(at.x(), -at.y()) - wanted, 2 * pi)));
    }
    return worst;
}

} // namespace

class ClosedFormsTest : public QObject {
    Q_OBJECT

private slots:
    void aBodyFalls();
    void aThrownBodyTurnsEvenly();
    void aPendulumSwingsByEllipticIntegrals();
    void thePendulumIsOfFourthOrder();
    void theFlipOfDzhanibekov();
    void aTopPrecessesAndNutates();
    void aDoublePendulumIsThatOfTheTextbook();
    void chainsKeepTheirEnergy_data();
    void chainsKeepTheirEnergy();
    void aThrownChainWhipsAtThePaceOfTheLoop();
    void aLongChainFallsAsOne();
    void momentumStays();
    void aStartThatJointsForbidKeepsItsMomentum();
};

void ClosedFormsTest::aBodyFalls() {
    RigidBody body = bodyAt(1, Vec3(1, 2, 3), 2);
    body.centre = Vec3(0.1, 0, 0);
    body.velocity = Vec3(0.5, 4, 0);
    Running run({body}, {});
    run.run(1.5, 1e-3);
    const BodyState now = run.bodies()[0];
    COMPARE_NEAR(now.centre, Vec3(1.1 + 0.75, 2 + 6 - 0.5 * 9.81 * 2.25, 3), 1e-11, "m");
    COMPARE_NEAR(now.pose.translation, Vec3(now.centre - Vec3(0.1, 0, 0)), 1e-12, "m");
    COMPARE_NEAR(now.kinetic, (0.5 * 2 * (0.25 + std::pow(4 - 9.81 * 1.5, 2))), 1e-9, "J");
    COMPARE_NEAR(now.potential, 2 * 9.81 * now.centre.y(), 1e-9, "J");
}

void ClosedFormsTest::aThrownBodyTurnsEvenly() {
    RigidBody body = bodyAt(1, Vec3::Zero(), 0.1, Vec3(1e-5, 2e-5, 3e-5));
    body.angularVelocity = Vec3(0, 0, 7); // about a principal axis
    body.gravityFactor = 0;
    Running run({body}, {});
    run.run(2, 1e-3);
    const Quat wanted(Eigen::AngleAxisd(14, Vec3::UnitZ()));
    COMPARE_NEAR(run.bodies()[0].pose.rotation.angularDistance(wanted), 0, 1e-9, "rad");
    COMPARE_NEAR(run.bodies()[0].velocity, Vec3::Zero(), 1e-15, "m/s");
}

void ClosedFormsTest::aPendulumSwingsByEllipticIntegrals() {
    const double length = 0.25, mass = 1.3, moment = 0.01, start = 2.5;
    Running run = pendulum(start, length, mass, moment);
    const double frequency = std::sqrt(mass * 9.81 * length / (moment + mass * length * length));
    const double first = run.energy();
    double worst = 0;
    for (int i = 1; i <= 100; ++i) {
        run.run(0.1, 1e-3);
        const Vec3 at = run.bodies()[0].centre;
        worst =
            std::max(worst, std::abs(std::atan2(at.x(), -at.y()) - pendulumAngle(0.1 * i, start, frequency)));
    }
    COMPARE_NEAR(worst, 0, 1e-7, "rad");
    COMPARE_NEAR(run.energy(), first, 1e-8 * std::abs(first), "J");
}

void ClosedFormsTest::thePendulumIsOfFourthOrder() {
    const double coarse = pendulumError(5e-3), fine = pendulumError(2.5e-3);
    QVERIFY2(coarse / fine > 14, qPrintable(QString::number(coarse / fine)));
}

// I1 < I2 < I3, thrown about the middle axis: w1 = A cn, w2 = B sn, w3 = C dn (Landau and Lifshitz,
// Mechanics, 37).
void ClosedFormsTest::theFlipOfDzhanibekov() {
    const Vec3 inertia(1e-4, 2e-4, 3.5e-4), w(0.1, 10, 0.2);
    RigidBody body = bodyAt(1, Vec3::Zero(), 0.2, inertia);
    body.angularVelocity = w;
    Running run({body}, {});
    const double energy2 = inertia.dot(w.cwiseProduct(w));
    const double square = inertia.cwiseProduct(w).squaredNorm();
    // For M^2 > 2 E I2, else 1 and 3 change their roles.
    const bool above = square > energy2 * inertia[1];
    const double i1 = above ? inertia[0] : inertia[2], i2 = inertia[1], i3 = above ? inertia[2] : inertia[0];
    const double rate = std::sqrt((i3 - i2) * (square - energy2 * i1) / (i1 * i2 * i3));
    const double k = std::sqrt((i2 - i1) * (energy2 * i3 - square) / ((i3 - i2) * (square - energy2 * i1)));
    const double most2 = std::sqrt((energy2 * i3 - square) / (i2 * (i3 - i2)));
    // Where it starts on sn: by bisection of the one quarter in which sn rises from 0 to 1.
    double low = 0, high = completeK(k);
    for (int i = 0; i < 200; ++i)
        (most2 * elliptic(0.5 * (low + high), k).sn < w[1] ? low : high) = 0.5 * (low + high);
    // The sense: w1 and w3 are positive, w2' = (i3 - i1) w3 w1 / i2 in their true numbering.
    const double sense = (inertia[2] - inertia[0]) * w[2] * w[0] > 0 ? 1 : -1;
    double worst = 0;
    int flips = 0;
    double before = w[1];
    for (int i = 1; i <= 400; ++i) {
        run.run(0.01, 5e-4, Vec3::Zero());
        const BodyState now = run.bodies(Vec3::Zero())[0];
        const double has = (now.pose.rotation.conjugate() * now.angularVelocity)[1];
        // The start is at K - (K - low): it rises if the sense is positive.
        const double u = sense > 0 ? low + rate * 0.01 * i : 2 * completeK(k) - low + rate * 0.01 * i;
        worst = std::max(worst, std::abs(has - most2 * elliptic(u, k).sn));
        flips += has * before < 0;
        before = has;
    }
    QVERIFY(flips >= 3);
    COMPARE_NEAR(worst, 0, 2e-5, "rad/s");
}

// A heavy symmetric top on a ball joint in steady precession: I1 s^2 cos - I3 n s + m g l = 0 for the slow
// precession s and the spin n about its axis; and disturbed a little it nutates.
void ClosedFormsTest::aTopPrecessesAndNutates() {
    const double mass = 0.5, arm = 0.04, about = 4e-4,
                 across = 1.2e-3; // about its axis; about the point below
    const double spin = 200, tilt = 0.5;
    const double a = across * std::cos(tilt), b = about * spin, c = mass * 9.81 * arm;
    const double slow = (b - std::sqrt(b * b - 4 * a * c)) / (2 * a);
    const Quat lean(Eigen::AngleAxisd(-tilt, Vec3::UnitZ())); // from y toward x
    const double own = across - mass * arm * arm;             // about the centre
    RigidBody top = bodyAt(1, lean * Vec3(0, arm, 0), mass, Vec3(own, about, own));
    top.pose.rotation = lean;
    const Vec3 axis = lean * Vec3::UnitY();
    // w = s up + (n - s cos) axis, so that its part along the axis is n.
    top.angularVelocity = slow * Vec3::UnitY() + (spin - slow * std::cos(tilt)) * axis;
    top.velocity = top.angularVelocity.cross(top.pose.translation);
    const std::vector<RigidBody> bodies{top};
    Running run(bodies, {ballAt(bodies, kWorldBody, 1, Vec3::Zero())});
    for (int i = 1; i <= 50; ++i) {
        run.run(0.1, 5e-4);
        const Vec3 now = run.bodies()[0].pose.rotation * Vec3::UnitY();
        const double turned = slow * 0.1 * i;
        // About +y a turn takes x toward -z.
        COMPARE_NEAR(
            now, Vec3(std::sin(tilt) * std::cos(turned), std::cos(tilt), -std::sin(tilt) * std::sin(turned)),
            2e-5, "");
    }
    // A nudge: the tilt swings with the frequency of nutation.
    top.angularVelocity += 0.05 * Vec3::UnitZ();
    top.velocity = top.angularVelocity.cross(top.pose.translation);
    Running nudged({top}, {ballAt(bodies, kWorldBody, 1, Vec3::Zero())});
    int crossings = 0;
    double last = 0, first = 0, end = 0;
    for (int i = 1; i <= 4000; ++i) {
        nudged.run(5e-4, 5e-4);
        const double off = std::acos((nudged.bodies()[0].pose.rotation * Vec3::UnitY()).y()) - tilt;
        if (off > 0 && last <= 0) {
            (crossings++ == 0 ? first : end) = i * 5e-4;
        }
        last = off;
    }
    const double fall = c / across; // E. J. Routh's small oscillations about steady precession
    const double precise = std::sqrt(std::pow(fall / slow, 2) - 2 * fall * std::cos(tilt) + slow * slow);
    const double frequency = 2 * pi * (crossings - 1) / (end - first);
    COMPARE_NEAR(frequency / precise, 1, 5e-3, "");
}

void ClosedFormsTest::aDoublePendulumIsThatOfTheTextbook() {
    const double l1 = 0.2, l2 = 0.15, m1 = 0.3, m2 = 0.2, g = 9.81;
    double p = 2.0, r = 2.6, dp = 0, dr = 0; // angles from hanging down; point masses
    const Quat first(Eigen::AngleAxisd(p, Vec3::UnitZ())), second(Eigen::AngleAxisd(r, Vec3::UnitZ()));
    const double tiny = 1e-12;
    std::vector<RigidBody> bodies{
        bodyAt(1, first * Vec3(0, -l1, 0), m1, Vec3::Constant(tiny)),
        bodyAt(2, first * Vec3(0, -l1, 0) + second * Vec3(0, -l2, 0), m2, Vec3::Constant(tiny))};
    Running run(bodies, {hingeAt(bodies, kWorldBody, 1, Vec3::Zero()),
                         hingeAt(bodies, 1, 2, first * Vec3(0, -l1, 0))});
    run.run(3, 2.5e-4);
    // The textbook's two equations, a hundred times finer.
    const auto slopes = [&](const Eigen::Vector4d& y) {
        const double d = y[0] - y[1], m = m1 + m2, s = std::sin(d), c = std::cos(d);
        const double under = m1 + m2 * s * s;
        const double a = (-m2 * c * (l1 * y[2] * y[2] * s - g * std::sin(y[1])) - m2 * l2 * y[3] * y[3] * s -
                          m * g * std::sin(y[0])) /
                         (l1 * under);
        const double b = (m * (l1 * y[2] * y[2] * s - g * std::sin(y[1]) + g * std::sin(y[0]) * c) +
                          m2 * l2 * y[3] * y[3] * s * c) /
                         (l2 * under);
        return Eigen::Vector4d(y[2], y[3], a, b);
    };
    Eigen::Vector4d y(p, r, dp, dr);
    const double h = 1e-5;
    for (int i = 0; i < 300000; ++i) {
        const Eigen::Vector4d k1 = slopes(y), k2 = slopes(y + h / 2 * k1), k3 = slopes(y + h / 2 * k2),
                              k4 = slopes(y + h * k3);
        y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    const Vec3 upper(l1 * std::sin(y[0]), -l1 * std::cos(y[0]), 0);
    COMPARE_NEAR(run.bodies()[0].centre, upper, 1e-6, "m");
    COMPARE_NEAR(run.bodies()[1].centre, (upper + Vec3(l2 * std::sin(y[1]), -l2 * std::cos(y[1]), 0)), 1e-6,
                 "m");
}

void ClosedFormsTest::chainsKeepTheirEnergy_data() {
    QTest::addColumn<int>("links");
    QTest::addColumn<double>("dt");
    QTest::addColumn<double>("seconds");
    QTest::addColumn<double>("share");
    QTest::newRow("one") << 1 << 1e-3 << 10. << 1e-4 / 6;
    QTest::newRow("three") << 3 << 1e-3 << 10. << 1e-4 / 6;
    QTest::newRow("ten") << 10 << 2e-4 << 10. << 1e-4 / 6;
    QTest::newRow("ten at the pace of the loop") << 10 << 5e-4 << 10. << 1e-4 / 6;
    QTest::newRow("fifty that whip") << 50 << 1e-4 << 3. << 1e-3 / 20;
}

// Of the energy that it swings with: from its height at first down to hanging.
void ClosedFormsTest::chainsKeepTheirEnergy() {
    QFETCH(int, links);
    QFETCH(double, dt);
    QFETCH(double, seconds);
    QFETCH(double, share);
    const Chain chain = chainOf(links);
    Running run(chain.bodies, chain.joints);
    double fall = 0;
    for (int i = 0; i < links; ++i)
        fall += 0.1 * 9.81 * (i + 0.5) * 0.1;
    const double first = run.energy();
    run.run(seconds, dt);
    COMPARE_NEAR((run.energy() - first) / fall, 0, share, "");
}

// Fifty links that are thrown round, so that they crack all the time, in steps of half a millisecond: where
// no step is cut it gains or loses half a percent.
void ClosedFormsTest::aThrownChainWhipsAtThePaceOfTheLoop() {
    Chain chain = chainOf(50);
    for (RigidBody& body : chain.bodies) {
        const double far = body.pose.translation.x();
        body.velocity = {0, 2 * far, 0.6 * far};
        body.angularVelocity = {0, -0.6, 2};
    }
    Running run(chain.bodies, chain.joints);
    const double first = run.energy();
    double most = 0, liveliest = 0;
    const int tenths = std::max(200, longOnly(600));
    for (int i = 0; i < tenths; ++i) {
        run.run(0.1, 5e-4);
        double kinetic = 0;
        for (const BodyState& body : run.bodies())
            kinetic += body.kinetic;
        liveliest = std::max(liveliest, kinetic);
        most = std::max(most, std::abs(run.energy() - first));
    }
    QCOMPARE_LT(most / liveliest, 1e-3); // a minute's bound
}

// Boxes on balls, each a little askew: all fall by g t^2 / 2 and none turns, however many they are. Rounding
// alone is what could part them.
void ClosedFormsTest::aLongChainFallsAsOne() {
    constexpr int kBoxes = 120;
    constexpr double kPitch = 0.2;
    const Vec3 inertia(1.0 / 600, 0.0424 / 12, 0.0424 / 12);
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;
    Vec3 end = Vec3::Zero();
    for (int i = 0; i < kBoxes; ++i) {
        const Quat turn(Eigen::AngleAxisd(0.3 * std::sin(2.1 * i), Vec3(0.2, 1, 0.5).normalized()));
        const Vec3 half = turn * Vec3(0.5 * kPitch, 0, 0);
        bodies.push_back(bodyAt(BodyId(i + 1), end + half, 1, inertia));
        bodies.back().pose.rotation = turn;
        if (i > 0) joints.push_back(ballAt(bodies, BodyId(i), BodyId(i + 1), end));
        end += 2 * half;
    }
    Running run(bodies, joints);
    run.run(0.1, 1e-3);
    for (int i = 0; i < kBoxes; ++i) {
        const BodyState& now = run.bodies()[std::size_t(i)];
        COMPARE_NEAR(now.centre, Vec3(bodies[std::size_t(i)].pose.translation + 0.005 * kDown), 1e-12, "m");
        COMPARE_NEAR(now.angularVelocity, Vec3(0, 0, 0), 1e-10, "rad/s");
    }
}

void ClosedFormsTest::momentumStays() {
    // Two bodies on a spring, thrown: nothing outside acts.
    std::vector<RigidBody> bodies{bodyAt(1, Vec3(0, 0, 0), 1, Vec3(0.01, 0.02, 0.03)),
                                  bodyAt(2, Vec3(0.5, 0, 0), 2, Vec3(0.03, 0.01, 0.02))};
    bodies[0].velocity = Vec3(1, 0, 0.3);
    bodies[1].angularVelocity = Vec3(1, 5, -2);
    Joint spring = jointAt(bodies, 1, 2, Vec3(0.2, 0.1, 0), Quat::Identity(), {});
    JointLimit rope;
    rope.min = 0;
    rope.max = 0;
    rope.stiffness = 300;
    rope.damping = 1;
    spring.limits.push_back(rope);
    Running run(bodies, {spring});
    const auto momentum = [&] {
        Vec3 p = Vec3::Zero(), l = Vec3::Zero();
        const auto& now = run.bodies(Vec3::Zero());
        for (std::size_t i = 0; i < 2; ++i) {
            const Mat3 axes = now[i].pose.rotation.toRotationMatrix();
            p += bodies[i].mass * now[i].velocity;
            l += bodies[i].mass * now[i].centre.cross(now[i].velocity) +
                 axes * bodies[i].inertia.asDiagonal() * axes.transpose() * now[i].angularVelocity;
        }
        return std::pair{p, l};
    };
    const auto [p, l] = momentum();
    COMPARE_NEAR(p, Vec3(1, 0, 0.3), 1e-12, "kg m/s");
    run.run(3, 1e-3, Vec3::Zero());
    const auto [p2, l2] = momentum();
    COMPARE_NEAR(p2, p, 1e-11, "kg m/s");
    COMPARE_NEAR(l2, l, 1e-6, "kg m^2/s");
}

void ClosedFormsTest::aStartThatJointsForbidKeepsItsMomentum() {
    // Along the rod of a pendulum nothing moves; across it the velocity is as given.
    RigidBody rod = bodyAt(1, Vec3(0, -0.5, 0), 2, Vec3::Constant(0.1));
    rod.velocity = Vec3(0.6, 3, 0);
    const std::vector<RigidBody> bodies{rod};
    Running run(bodies, {hingeAt(bodies, kWorldBody, 1, Vec3::Zero())});
    // m v r = (I + m r^2) w, with no turning of its own at first.
    COMPARE_NEAR(run.bodies()[0].angularVelocity, Vec3(0, 0, 2 * 0.6 * 0.5 / (0.1 + 0.5)), 1e-12, "rad/s");
}

TACTUM_TEST(ClosedFormsTest)

} // namespace test_closed_forms

#include "test_closed_forms.moc"
