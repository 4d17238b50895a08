// How far frames are from each other, and what of that a motion changes: every measure against its own
// difference quotient, for frames that lie and move at random. What cannot be simulated is refused.
//
// What would show that a test here is wrong: the quotients know nothing of the wrenches that they are
// compared with, and the values are those of frames that were turned or moved by a known amount.

#include <array>
#include <random>

#include <QTest>

#include "core/dynamics/measure.h"
#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_measures {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;

struct Frames {
    Pose a, b;
    FrameVelocity va, vb;

    explicit Frames(std::mt19937& random) {
        std::normal_distribution<double> normal;
        const auto vector = [&] { return Vec3(normal(random), normal(random), normal(random)); };
        a = {Quat(Eigen::AngleAxisd(normal(random), vector().normalized())), vector()};
        b = {Quat(Eigen::AngleAxisd(normal(random), vector().normalized())), vector()};
        va = {vector(), vector()};
        vb = {vector(), vector()};
    }
    static Pose moved(const Pose& pose, const FrameVelocity& v, double dt) {
        const double turn = v.angular.norm() * dt;
        return {Quat(Eigen::AngleAxisd(turn, v.angular.normalized())) * pose.rotation,
                pose.translation + dt * v.linear};
    }
    Measured after(const Coordinate& of, double dt) const {
        return measure(of, moved(a, va, dt), moved(b, vb, dt));
    }
};

/// The power of a wrench on b, with its opposite on a.
double power(const Wrench& w, const Frames& of) {
    const auto at = [&](const Pose& pose, const FrameVelocity& v) {
        return Vec3(v.linear + v.angular.cross(w.point - pose.translation));
    };
    return w.force.dot(at(of.b, of.vb) - at(of.a, of.va)) + w.torque.dot(of.vb.angular - of.va.angular);
}

/// Its moment about the origin.
Vec3 moment(const Wrench& w) {
    return w.point.cross(w.force) + w.torque;
}

Coordinate coordinate(Measure measure, int axis) {
    Coordinate of;
    of.measure = measure;
    of.axis = axis;
    of.axis2 = (axis + 1) % 3;
    return of;
}

Pose turned(double angle, const Vec3& axis) {
    return {Quat(Eigen::AngleAxisd(angle, axis)), Vec3::Zero()};
}

double valueOf(Measure what, int axis, const Pose& a, const Pose& b) {
    return measure(coordinate(what, axis), a, b).value;
}

std::string refused(const Joint& joint) {
    const std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero())};
    return refusal(compileMechanism(bodies, std::vector{joint}));
}

} // namespace

class MeasuresTest : public QObject {
    Q_OBJECT

private slots:
    void theyAreWhatTheyAreCalled();
    void halfATurnTooMuchIsTheOtherWay();
    void theirRateIsThePowerOfTheirWrench();
    void theWrenchesOfLocksChangeAsTheyAreSaidTo();
    void whereThereIsNoDirectionAnyWillDo();
    void bodiesThatCannotBeAreRefused_data();
    void bodiesThatCannotBeAreRefused();
    void jointsThatCannotBeAreRefused();
    void whatIsJustSoIsTaken();
    void tooManyCollidersAreRefused();
};

void MeasuresTest::theyAreWhatTheyAreCalled() {
    const Pose a{Quat(Eigen::AngleAxisd(0.8, Vec3(3, 1, 2).normalized())), Vec3(0.1, 0.2, 0.3)};
    const auto b = [&](const Vec3& way, double angle, const Vec3& axis) {
        return a * Pose{Quat(Eigen::AngleAxisd(angle, axis)), way};
    };
    const Vec3 way(2, -3, 6);
    for (int axis = 0; axis < 3; ++axis) {
        COMPARE_NEAR(valueOf(Measure::Along, axis, a, b(way, 1, Vec3::UnitX())), way[axis], 1e-12, "m");
        COMPARE_NEAR(valueOf(Measure::Aside, axis, a, b(way, 1, Vec3::UnitX())),
                     std::sqrt(49 - way[axis] * way[axis]), 1e-12, "m");
        COMPARE_NEAR(valueOf(Measure::Distance, axis, a, b(way, 1, Vec3::UnitX())), 7, 1e-12, "m");
        const Vec3 own = Vec3::Unit(axis), other = Vec3::Unit((axis + 1) % 3);
        for (const double angle : {-2.0, -0.3, 0.4, 3.0}) {
            COMPARE_NEAR(valueOf(Measure::Twist, axis, a, b(way, angle, own)), angle, 1e-12, "rad");
            COMPARE_NEAR(valueOf(Measure::Twist, axis, a, b(way, angle, other)), 0, 1e-12, "rad");
            COMPARE_NEAR(valueOf(Measure::Cone, axis, a, b(way, angle, own)), 0, 1e-7, "rad");
            COMPARE_NEAR(valueOf(Measure::Cone, axis, a, b(way, angle, other)), std::abs(angle), 1e-7, "rad");
            COMPARE_NEAR(valueOf(Measure::Turned, axis, a, b(way, angle, Vec3(1, 2, 3).normalized())),
                         std::abs(angle), 1e-12, "rad");
            COMPARE_NEAR(valueOf(Measure::Tilt, axis, a, b(way, angle, Vec3::Unit((axis + 2) % 3))),
                         -std::sin(angle), 1e-12, "");
            COMPARE_NEAR(valueOf(Measure::Residue, axis, a, b(way, angle, own)), 2 * std::sin(angle / 2),
                         1e-12, "");
        }
        QCOMPARE(valueOf(Measure::Way, axis, a, b(way, 1, Vec3::UnitX())), 0.0); // its link knows
    }
}

// The shorter turn counts.
void MeasuresTest::halfATurnTooMuchIsTheOtherWay() {
    const Pose a{}, b = turned(4, Vec3::UnitY());
    COMPARE_NEAR(valueOf(Measure::Twist, 1, a, b), 4 - 2 * pi, 1e-12, "rad");
    COMPARE_NEAR(valueOf(Measure::Turned, 0, a, b), 2 * pi - 4, 1e-12, "rad");
    COMPARE_NEAR(valueOf(Measure::Residue, 1, a, b), 2 * std::sin((4 - 2 * pi) / 2), 1e-12, "");
    const Pose same{Quat(-b.rotation.coeffs()), b.translation}; // the other quaternion of this turn
    COMPARE_NEAR(valueOf(Measure::Twist, 1, a, same), 4 - 2 * pi, 1e-12, "rad");
}

void MeasuresTest::theirRateIsThePowerOfTheirWrench() {
    std::mt19937 random(3);
    const double dt = 1e-5;
    for (int i = 0; i < 200; ++i) {
        const Frames frames(random);
        for (const Measure what : {Measure::Along, Measure::Aside, Measure::Distance, Measure::Twist,
                                   Measure::Cone, Measure::Turned, Measure::Tilt, Measure::Residue}) {
            const Coordinate of = coordinate(what, i % 3);
            const double before = frames.after(of, -dt).value, after = frames.after(of, dt).value;
            const Measured now = measure(of, frames.a, frames.b);
            if (std::abs(after - before) > 1e-2 || now.value > 2.8) continue; // over half a turn
            const double rate = (after - before) / (2 * dt);
            COMPARE_NEAR(power(now.along, frames), rate, 1e-4 * (1 + std::abs(rate)), "");
        }
        // Of a way only its link knows how far; its wrench is a push along the axis of b, at b.
        const Measured way = measure(coordinate(Measure::Way, i % 3), frames.a, frames.b);
        COMPARE_NEAR(way.along.force, Vec3(frames.b.rotation * Vec3::Unit(i % 3)), 1e-12, "");
        COMPARE_NEAR(way.along.point, frames.b.translation, 1e-12, "m");
        COMPARE_NEAR(way.along.torque, Vec3(0, 0, 0), 1e-300, "");
    }
}

void MeasuresTest::theWrenchesOfLocksChangeAsTheyAreSaidTo() {
    std::mt19937 random(4);
    const double dt = 1e-5;
    for (int i = 0; i < 100; ++i) {
        Frames frames(random);
        for (const Measure what : {Measure::Along, Measure::Tilt, Measure::Residue}) {
            if (what == Measure::Residue) frames.vb.angular = frames.va.angular; // locked, both turn as one
            const Coordinate of = coordinate(what, i % 3);
            const Wrench before = frames.after(of, -dt).along, after = frames.after(of, dt).along;
            const Wrench rate = rateOf(of, frames.a, frames.b, frames.va, frames.vb);
            const Vec3 force = (after.force - before.force) / (2 * dt);
            const Vec3 turning = (moment(after) - moment(before)) / (2 * dt);
            COMPARE_NEAR(rate.force, force, 1e-6 * (1 + force.norm()), "");
            COMPARE_NEAR(moment(rate), turning, 1e-6 * (1 + turning.norm()), "");
        }
    }
}

void MeasuresTest::whereThereIsNoDirectionAnyWillDo() {
    const Pose a{Quat(Eigen::AngleAxisd(0.8, Vec3(3, 1, 2).normalized())), Vec3(0.1, 0.2, 0.3)};
    for (int axis = 0; axis < 3; ++axis)
        for (const Measure what :
             {Measure::Aside, Measure::Distance, Measure::Twist, Measure::Cone, Measure::Turned}) {
            const Measured none = measure(coordinate(what, axis), a, a);
            COMPARE_NEAR(none.value, 0, 1e-12, "");
            COMPARE_NEAR(Vec3(none.along.force + none.along.torque).norm(), 1, 1e-12, "");
            if (what == Measure::Aside || what == Measure::Cone) // not along the line
                COMPARE_NEAR(Vec3(none.along.force + none.along.torque).dot(a.rotation * Vec3::Unit(axis)), 0,
                             1e-12, "");
        }
    // Half a turn about another axis: the turn about this one may be any, and is finite.
    const Measured half = measure(coordinate(Measure::Twist, 0), Pose{}, turned(pi, Vec3::UnitY()));
    QVERIFY(half.along.torque.allFinite());
    QCOMPARE_LT(half.along.torque.norm(), 2.0);
}

void MeasuresTest::bodiesThatCannotBeAreRefused_data() {
    QTest::addColumn<RigidBody>("body");
    QTest::addColumn<QString>("why");
    const auto row = [](const char* name, const char* why, auto&& spoil) {
        RigidBody body = bodyAt(1, Vec3::Zero());
        spoil(body);
        QTest::newRow(name) << body << why;
    };
    const char *endless = "has a value that is not a finite number",
               *negative = "has a negative mass or inertia";
    row("centre", endless, [](RigidBody& body) { body.centre.y() = kUnbounded; });
    row("inertia", endless, [](RigidBody& body) { body.inertia.z() = kUnbounded; });
    row("velocity", endless, [](RigidBody& body) { body.velocity.x() = std::nan(""); });
    row("turn", endless, [](RigidBody& body) { body.angularVelocity.x() = kUnbounded; });
    row("mass", endless, [](RigidBody& body) { body.mass = kUnbounded; });
    row("gravity", endless, [](RigidBody& body) { body.gravityFactor = std::nan(""); });
    row("place", endless, [](RigidBody& body) { body.pose.translation.z() = kUnbounded; });
    row("less than no mass", negative, [](RigidBody& body) { body.mass = -1e-9; });
    row("less than no inertia", negative, [](RigidBody& body) { body.inertia.y() = -1e-9; });
}

void MeasuresTest::bodiesThatCannotBeAreRefused() {
    QFETCH(RigidBody, body);
    QFETCH(QString, why);
    const std::string said = refusal(compileMechanism(std::vector{bodyAt(2, Vec3::Zero()), body}, {}));
    COMPARE_BEGINS(said, std::string("body \"body 1\": "));
    COMPARE_CONTAINS(said, why.toStdString());
}

void MeasuresTest::jointsThatCannotBeAreRefused() {
    const std::vector<RigidBody> bodies{bodyAt(1, Vec3::Zero())};
    const Joint fine = hingeAt(bodies, kWorldBody, 1, Vec3::Zero());
    const double nan = std::nan("");
    const auto limit = [&](auto&& spoil) {
        Joint joint = fine;
        joint.limits.push_back({true, 1, -1, 1, 5, 1});
        spoil(joint.limits.back());
        return refused(joint);
    };
    const std::string wrongLimit = "joint \"joint\": has a limit whose minimum is above its maximum or whose "
                                   "stiffness is negative; correct it";
    using L = JointLimit;
    QCOMPARE(limit([&](L& l) { l.min = nan; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.max = nan; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.min = 1.001; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.stiffness = -1; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.stiffness = nan; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.damping = -1; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.damping = nan; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.axes = 0; }), wrongLimit);
    QCOMPARE(limit([&](L& l) { l.axes = 8; }), wrongLimit);
    const auto drive = [&](auto&& spoil) {
        Joint joint = fine;
        joint.drives.push_back({true, 0, 1, 1, 0, 0, 1, false, 0});
        spoil(joint.drives.back());
        return refused(joint);
    };
    const std::string wrongDrive =
        "joint \"joint\": has a drive with a negative or endless value; correct it";
    using D = JointDrive;
    QCOMPARE(drive([&](D& d) { d.stiffness = -1; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.stiffness = nan; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.damping = -1; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.damping = nan; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.maxForce = -1; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.maxForce = nan; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.position = kUnbounded; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.velocity = nan; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.spacing = -1; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.spacing = kUnbounded; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.axis = -1; }), wrongDrive);
    QCOMPARE(drive([&](D& d) { d.axis = 3; }), wrongDrive);
    const auto friction = [&](JointFriction of) {
        Joint joint = fine;
        joint.frictions = {of};
        return refused(joint);
    };
    const std::string wrongFriction = "joint \"joint\": has negative friction; give a force from 0 up";
    QCOMPARE(friction({true, 0, -1}), wrongFriction);
    QCOMPARE(friction({true, 0, nan}), wrongFriction);
    QCOMPARE(friction({true, -1, 1}), wrongFriction);
    QCOMPARE(friction({true, 3, 1}), wrongFriction);
    Joint stray = fine;
    stray.a = 9;
    QCOMPARE(refused(stray), std::string("joint \"joint\": names a body that is not there; choose one"));
    Joint path = fine;
    path.path = {{Vec3(0, 0, 0), Vec3(1, 0, 0)}, {Vec3(0, 1, 0), Vec3(0, nan, 0)}, false};
    QCOMPARE(refused(path),
             std::string("joint \"joint\": has a path with a value that is not a finite number; correct it"));
}

void MeasuresTest::whatIsJustSoIsTaken() {
    RigidBody still = bodyAt(1, Vec3::Zero(), 0, Vec3::Zero());
    const std::vector<RigidBody> bodies{still, bodyAt(2, Vec3::Zero())};
    Joint joint = hingeAt(bodies, 1, 2, Vec3::Zero());
    joint.limits.push_back({true, 1, 0.5, 0.5, 0, 0});
    joint.limits.push_back({true, kAllAxes, -kUnbounded, kUnbounded, 1, 0});
    joint.drives = {{true, 0, 0, 0, 0, 0, 0, false, 0}, {true, 2, 1, 1, 0, 0, kUnbounded, false, 0}};
    joint.frictions = {{true, 0, 0}, {true, 2, 1}};
    const auto made = compileMechanism(bodies, std::vector{joint});
    VERIFY_RESULT(made);
    QCOMPARE(made->vs, 7); // six that nothing changes, and the hinge
    // What has no force at all is no spring and no friction.
    QCOMPARE(made->springs.size(), std::size_t(4)); // two soft limits, a spring and its damper
    QCOMPARE(made->frictions.size(), std::size_t(1));
    QCOMPARE(made->frictions[0].force, 1.0);
}

void MeasuresTest::tooManyCollidersAreRefused() {
    std::vector<Collider> colliders(8193);
    const std::string said = refusal(compileMechanism({}, {}, colliders));
    QCOMPARE(said,
             std::string(
                 "the scene has 8193 colliders, and at most 8192 can touch each other; join some of them"));
}

TACTUM_TEST(MeasuresTest)

} // namespace test_measures

#include "test_measures.moc"
