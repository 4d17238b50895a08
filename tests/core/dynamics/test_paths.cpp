// Bodies on curves, against motions that are known without curves: pendulums, slopes, Huygens' cycloid.
//
// What would show that a test here is wrong: the curves are given as points alone, so the laws know nothing
// of splines; the derivatives are compared with differences of places, the energy with the sum over the
// bodies. Without the rate of the subspace (S') the bead on the ring is off at once, and so are all energies.

#include <cmath>
#include <numbers>
#include <random>

#include <QTest>

#include "core/dynamics/path_curve.h"
#include "core/dynamics/path_places.h"
#include "tests/core/dynamics/mechanisms.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_paths {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;

/// At each of `count` values from `low` to `high`, the last one left out where the path is closed.
template <class At> JointPath pathOf(At&& at, double low, double high, int count, bool closed) {
    JointPath path;
    path.closed = closed;
    for (int i = 0; i < count; ++i)
        path.points.push_back(at(low + (high - low) * i / (closed ? count : count - 1)));
    return path;
}

/// In the plane z = 0, from its lowest point on, to the right at first.
JointPath ring(double radius, int count = 256) {
    return pathOf([&](double a) { return Vec3(radius * std::sin(a), -radius * std::cos(a), 0); }, 0, 2 * pi,
                  count, true);
}

/// A closed curve that winds, banks and crosses over itself.
JointPath knot(double size, int count = 120) {
    JointPath path = pathOf(
        [&](double a) {
            return Vec3(size * (std::sin(a) + 2 * std::sin(2 * a)), -size * std::sin(3 * a),
                        size * (std::cos(a) - 2 * std::cos(2 * a)));
        },
        0, 2 * pi, count, true);
    return path;
}

Joint onPath(BodyId b, const JointPath& path, BodyId a = kWorldBody) {
    Joint joint;
    joint.name = "track";
    joint.a = a, joint.b = b;
    joint.path = path;
    return joint;
}

RigidBody bead(BodyId id, const Vec3& at, double mass = 0.2, double inertia = 1e-12) {
    return bodyAt(id, at, mass, Vec3::Constant(inertia));
}

/// (S, S') at the origin of the curve's frame.
struct Subspace {
    Vec6 way, rate;
};
Subspace subspaceOf(const PathSpot& spot) {
    const Vec3& c = spot.pose.translation;
    return {spatial(spot.turn, spot.way + c.cross(spot.turn)),
            spatial(spot.turnRate, spot.wayRate + spot.way.cross(spot.turn) + c.cross(spot.turnRate))};
}

/// Of a curve by differences: the motion that leads from a place to the next.
Vec6 differenceOf(const PathCurve& curve, double s, double h) {
    const Pose before = curve.at(s - h).pose, after = curve.at(s + h).pose;
    const Eigen::AngleAxisd turn(after.rotation * before.rotation.conjugate());
    const Vec3 rate = turn.angle() * turn.axis() / (2 * h);
    const Vec3 way = (after.translation - before.translation) / (2 * h);
    return spatial(rate, way + curve.at(s).pose.translation.cross(rate));
}

} // namespace

class PathsTest : public QObject {
    Q_OBJECT

private slots:
    void theSubspaceIsTheDerivativeOfThePlace_data();
    void theSubspaceIsTheDerivativeOfThePlace();
    void theWayIsInMetres();
    void upsAreKept();
    void aBeadOnARingIsAPendulum_data();
    void aBeadOnARingIsAPendulum();
    void aBeadOnAHelixSpeedsUpEvenly();
    void aCycloidIsIsochronous();
    void theLoopPressesWithSixTimesTheWeight();
    void aTurningBodyTakesItsTurnAlong();
    void theEnergyStaysForAMinute();
    void randomMechanismsKeepTheirEnergy();
    void theEffectiveMassIsThatOfABlow();
    void aTrackThatIsPushedAwayKeepsMomentum();
    void anOpenPathEndsInStops();
    void whatWorksOnASlideWorksOnAPath();
    void aBodyBesideItsPathIsPutOntoIt();
    void placesAlongAPathAreEvenlyFarApart();
    void theNearestPlaceIsFound();
    void whatIsNoPathIsRefused_data();
    void whatIsNoPathIsRefused();
};

void PathsTest::theSubspaceIsTheDerivativeOfThePlace_data() {
    QTest::addColumn<JointPath>("path");
    QTest::newRow("ring") << ring(0.1, 40);
    QTest::newRow("knot") << knot(0.05);
    JointPath banked = knot(0.05);
    for (std::size_t i = 0; i < banked.points.size(); ++i)
        banked.ups.push_back(Vec3(std::sin(0.2 * double(i)), 3, std::cos(0.1 * double(i))));
    banked.closed = false;
    QTest::newRow("banked, open") << banked;
}

void PathsTest::theSubspaceIsTheDerivativeOfThePlace() {
    QFETCH(JointPath, path);
    const auto curve = PathCurve::through(path);
    QVERIFY2(curve, curve ? "" : curve.error().text.c_str());
    const double h = 1e-5;
    for (double s = 2 * h; s < curve->length() - 2 * h; s += curve->length() / 997) {
        const Subspace now = subspaceOf(curve->at(s));
        COMPARE_NEAR((now.way - differenceOf(*curve, s, h)).norm(), 0, 1e-5 * (1 + now.way.norm()), "");
        const Vec6 change = (subspaceOf(curve->at(s + h)).way - subspaceOf(curve->at(s - h)).way) / (2 * h);
        COMPARE_NEAR((now.rate - change).norm(), 0, 1e-5 * (1 + now.rate.norm()), "");
    }
}

void PathsTest::theWayIsInMetres() {
    COMPARE_NEAR(PathCurve::through(ring(0.1))->length(), 0.2 * pi, 1e-11, "m");
    const auto curve = PathCurve::through(knot(0.05));
    for (double s = 0; s < curve->length(); s += 0.001)
        COMPARE_NEAR(curve->at(s).way.norm(), 1, 1e-6, "");
    // It closes as smoothly as it goes on, and has no end.
    const PathSpot before = curve->at(-1e-9), after = curve->at(curve->length() + 1e-9);
    COMPARE_NEAR(before.pose.translation, after.pose.translation, 1e-8, "m");
    COMPARE_NEAR(before.turnRate, after.turnRate, 1e-3, "rad/m^2");
}

void PathsTest::upsAreKept() {
    JointPath path = ring(0.1, 64);
    for (const Vec3& point : path.points) // in, and more and more to the side
        path.ups.push_back(-point.normalized() + Vec3(0, 0, 0.4));
    const auto curve = PathCurve::through(path);
    for (const Vec3& point : path.points) {
        const Pose at = curve->at(curve->nearest({Quat::Identity(), point})).pose;
        COMPARE_NEAR(at.translation, point, 1e-10, "m");
        COMPARE_NEAR(Vec3(at.rotation * Vec3::UnitY()),
                     Vec3((-point.normalized() + Vec3(0, 0, 0.4)).normalized()), 1e-7, "");
    }
}

void PathsTest::aBeadOnARingIsAPendulum_data() {
    QTest::addColumn<double>("angle");
    QTest::newRow("small") << 0.2;
    QTest::newRow("nearly upright") << 3.0;
}

void PathsTest::aBeadOnARingIsAPendulum() {
    QFETCH(double, angle);
    const double radius = 0.08;
    // Given in another frame than the world's, and riding off its own centre of mass.
    const Pose tilt{Quat(Eigen::AngleAxisd(0.7, Vec3::UnitZ())), Vec3(0.3, 0.1, -0.2)};
    const Vec3 start = radius * Vec3(std::sin(angle), -std::cos(angle), 0);
    RigidBody mass = bodyAt(1, start + tilt.translation, 0.2, Vec3(1e-4, 2e-4, 3e-4));
    Joint track = onPath(1, ring(radius));
    track.frameA = tilt;
    track.frameB =
        mass.pose.inverse() * (tilt * PathCurve::through(track.path)->at(radius * (angle - 0.7)).pose);
    const std::vector<RigidBody> bodies{mass};
    Running rides(bodies, {track});
    Running swings(bodies, {hingeAt(bodies, kWorldBody, 1, tilt.translation)});
    for (int i = 0; i < 40; ++i) {
        COMPARE_NEAR(rides.bodies()[0].centre, swings.bodies()[0].centre, 1e-9, "m");
        COMPARE_NEAR(rides.bodies()[0].angularVelocity, swings.bodies()[0].angularVelocity, 1e-7, "rad/s");
        rides.run(0.05, 1e-4), swings.run(0.05, 1e-4);
    }
}

void PathsTest::aBeadOnAHelixSpeedsUpEvenly() {
    const double radius = 0.05, rise = 0.01; // a turn rises 2 pi times as much
    const auto helix = [&](double a) { return Vec3(radius * std::cos(a), -rise * a, radius * std::sin(a)); };
    const JointPath path = pathOf(helix, 0, 40 * pi, 1200, false);
    Running run({bead(1, helix(10 * pi))}, {onPath(1, path)});
    const double start = run.state().q[0];
    const double a = 9.81 * rise / std::hypot(radius, rise);
    for (int i = 1; i <= 10; ++i) {
        run.run(0.1, 1e-3);
        const double t = 0.1 * i;
        COMPARE_NEAR(run.state().q[0] - start, 0.5 * a * t * t, 1e-8, "m");
        COMPARE_NEAR(run.state().v[0], a * t, 1e-7, "m/s");
    }
}

void PathsTest::aCycloidIsIsochronous() {
    const double r = 0.02;
    const auto cycloid = [&](double a) { return Vec3(r * (a + std::sin(a)), -r * (1 + std::cos(a)), 0); };
    const JointPath path = pathOf(cycloid, -2.9, 2.9, 400, false);
    const double middle = PathCurve::through(path)->length() / 2;
    const double period = 4 * pi * std::sqrt(r / 9.81);
    for (const double a : {0.1, 1.0, 2.0, 2.6}) {
        Running run({bead(1, cycloid(a))}, {onPath(1, path)});
        const double start = run.state().q[0];
        for (int quarter = 1; quarter <= 8; ++quarter) {
            run.run(period / 4, period / 4000);
            const double wanted = quarter % 2 == 1 ? 0 : quarter % 4 == 2 ? -1 : 1;
            COMPARE_NEAR(run.state().q[0] - middle, wanted * (start - middle), 1e-8, "m");
        }
    }
}

// Let go at rest at the top of a ring it comes down with v^2 = 4 g r, and is held by m g + m v^2 / r.
void PathsTest::theLoopPressesWithSixTimesTheWeight() {
    const double r = 0.1, mass = 0.3, dt = 1e-5;
    RigidBody car = bead(1, Vec3(0, -r, 0), mass);
    car.velocity = Vec3(std::sqrt(5 * 9.81 * r), 0, 0); // the least for a whole loop without a rail
    Running run({car}, {onPath(1, ring(r))});
    const auto pressAt = [&](double s) { // from three places
        run.state().q[0] = s;
        const double v2 = 5 * 9.81 * r - 2 * 9.81 * r * (1 - std::cos(s / r));
        run.state().v[0] = std::sqrt(std::max(0.0, v2));
        const Vec3 at = run.bodies()[0].velocity;
        run.run(dt, dt);
        const Vec3 then = run.bodies()[0].velocity;
        return Vec3(mass * ((then - at) / dt - kDown));
    };
    COMPARE_NEAR(pressAt(0).y(), 6 * mass * 9.81, 1e-3, "N");
    COMPARE_NEAR(pressAt(pi * r).y(), 0, 1e-3, "N"); // at the top it just does not fall
}

// Its axes follow the curve, so their turn has energy too: a ball that is held to a ring turns once a round.
void PathsTest::aTurningBodyTakesItsTurnAlong() {
    const double r = 0.1, mass = 0.1, moment = 2e-3;
    RigidBody body = bead(1, Vec3(0, -r, 0), mass);
    body.inertia = Vec3::Constant(moment);
    body.velocity = Vec3(1, 0, 0);
    body.angularVelocity = Vec3(0, 0, 10);
    Running run({body}, {onPath(1, ring(r))});
    COMPARE_NEAR(run.state().v[0], 1, 1e-9, "m/s");
    COMPARE_NEAR(run.bodies()[0].kinetic, 0.5 * mass + 0.5 * moment * 100, 1e-9, "J");
    run.run(0.05, 1e-4);
    const double v2 = 1 - 2 * 9.81 * mass * (run.bodies()[0].centre.y() + r) / (mass + moment / (r * r));
    COMPARE_NEAR(run.state().v[0], std::sqrt(v2), 1e-8, "m/s");
}

void PathsTest::theEnergyStaysForAMinute() {
    const JointPath path = knot(0.05);
    const PathCurve curve = *PathCurve::through(path);
    RigidBody car = bodyAt(1, curve.at(0).pose.translation, 0.1, Vec3(1e-5, 3e-5, 2e-5));
    car.centre = Vec3(0.002, 0.01, -0.004);
    car.velocity = 1.5 * curve.at(0).way;
    car.angularVelocity = 1.5 * curve.at(0).turn;
    Running run({car}, {onPath(1, path)});
    QCOMPARE_GT(run.bodies()[0].kinetic, 0.1);
    const double before = run.energy(), kinetic = run.bodies()[0].kinetic;
    run.run(60, 5e-4);
    QCOMPARE_GT(run.state().q[0], 20 * curve.length());
    COMPARE_NEAR(run.energy(), before, 1e-4 * kinetic, "J");
}

namespace {

/// A car, what hangs on it, and sometimes a track that is a body itself; speeds at random.
struct RandomRide {
    std::vector<RigidBody> bodies;
    std::vector<Joint> joints;

    explicit RandomRide(std::mt19937& random) {
        const auto unit = [&] { return double(random()) / double(std::mt19937::max()); };
        const auto vector = [&](double size) {
            const double x = unit(), y = unit(), z = unit();
            return Vec3(size * (2 * x - 1), size * (2 * y - 1), size * (2 * z - 1));
        };
        JointPath path = knot(0.03 + 0.04 * unit(), 90);
        if (random() % 2 == 0)
            for (std::size_t i = 0; i < path.points.size(); ++i)
                path.ups.push_back(Vec3(0.3 * std::sin(2 * pi * double(i) / 90), 1, 0.2));
        const PathCurve curve = *PathCurve::through(path);
        const auto body = [&](const Pose& at) {
            RigidBody one = bodyAt(BodyId(bodies.size() + 1), at.translation, 0.02 + 0.1 * unit(),
                                   1e-5 * (Vec3::Ones() + 0.3 * vector(1)));
            one.pose.rotation = at.rotation;
            one.centre = vector(0.01);
            one.inertiaFrame = Quat(1, unit(), unit(), unit()).normalized();
            one.velocity = vector(1);
            one.angularVelocity = vector(5);
            bodies.push_back(one);
            return one.id;
        };
        const bool trackMoves = random() % 2 == 0, reversed = random() % 2 == 0;
        const BodyId track = trackMoves ? body({}) : kWorldBody;
        const Pose start = curve.at(curve.length() * unit()).pose;
        const BodyId car = body(start);
        Joint rides = onPath(car, path, track);
        if (trackMoves) {
            const BodyId held = reversed ? car : track; // the car may be nearer to the world than its track
            const Vec3 at = bodies[held - 1].pose.translation;
            joints.push_back(hingeAt(bodies, kWorldBody, held, at + vector(0.02), Vec3::UnitZ()));
        }
        joints.push_back(rides);
        const BodyId hangs = body({Quat::Identity(), start.translation - Vec3(0, 0.03, 0)});
        joints.push_back(ballAt(bodies, car, hangs, start.translation));
    }
};

} // namespace

void PathsTest::randomMechanismsKeepTheirEnergy() {
    std::mt19937 random(11);
    for (int i = 0; i < 40; ++i) {
        const RandomRide ride(random);
        Running run(ride.bodies, ride.joints);
        QVERIFY(run.mechanism().loops.empty());
        const double before = run.energy();
        double most = 1e-3;
        for (int k = 0; k < 10; ++k) {
            run.run(0.03, 2e-5);
            double kinetic = 0;
            for (const BodyState& body : run.bodies())
                kinetic += body.kinetic;
            most = std::max(most, kinetic);
        }
        COMPARE_NEAR(run.energy(), before, 1e-6 * most, "J");
    }
}

// A blow at a point, once as the effective mass and once as a force for a very short time.
void PathsTest::theEffectiveMassIsThatOfABlow() {
    std::mt19937 random(12);
    for (int i = 0; i < 30; ++i) {
        const RandomRide ride(random);
        Running run(ride.bodies, ride.joints);
        run.run(0.01, 1e-4);
        const std::size_t last = ride.bodies.size() - 1 - random() % 2;
        const Place place = run.mechanism().places[last];
        const Place at{place.link, place.pose * Pose{Quat::Identity(), Vec3(0.003, -0.002, 0.004)}};
        const Vec3 along = Vec3(1, 2, double(random() % 5) - 2).normalized();
        run.state().v.setZero();
        const double mass = run.dynamics().effectiveMass(run.state(), at, along);
        Articulation articulation(run.mechanism());
        const double dt = 1e-9;
        AppliedForce force{.at = at, .force_W = along / dt, .into_W = along};
        DynamicState hit = run.state();
        run.dynamics().step(hit, Vec3::Zero(), {&force, 1}, dt);
        articulation.place(run.state().q, hit.v);
        const double speed = articulation.velocityOf(at).linear.dot(along);
        COMPARE_NEAR(1 / speed, mass, 1e-6 * mass, "kg");
    }
}

// Nothing from outside: car and track together keep their momentum, whichever of them hangs on the other.
void PathsTest::aTrackThatIsPushedAwayKeepsMomentum() {
    const JointPath path = knot(0.04);
    const PathCurve curve = *PathCurve::through(path);
    for (const double trackMass : {0.05, 5.0}) { // a light track hangs on its car
        RigidBody track = bodyAt(1, Vec3::Zero(), trackMass, Vec3::Constant(1e-2 * trackMass));
        RigidBody car = bodyAt(2, curve.at(0.1).pose.translation, 0.2, Vec3(1e-5, 2e-5, 3e-5));
        car.velocity = 2 * curve.at(0.1).way;
        car.angularVelocity = 2 * curve.at(0.1).turn;
        Running run({track, car}, {onPath(2, path, 1)});
        QCOMPARE(run.mechanism().vs, 7);
        const auto momentum = [&] {
            const auto& now = run.bodies(Vec3::Zero());
            return Vec3(trackMass * now[0].velocity + 0.2 * now[1].velocity);
        };
        const Vec3 before = momentum();
        const double energy = run.energy(Vec3::Zero());
        run.run(1, 1e-4, Vec3::Zero());
        COMPARE_NEAR(momentum(), before, 1e-8, "N s");
        COMPARE_NEAR(run.energy(Vec3::Zero()), energy, 1e-7 * energy, "J");
    }
}

void PathsTest::anOpenPathEndsInStops() {
    JointPath line;
    line.points = {Vec3(0, 0, 0), Vec3(0.1, 0, 0)};
    RigidBody car = bead(1, Vec3(0.04, 0, 0));
    car.velocity = Vec3(1, 0, 0);
    Running run({car}, {onPath(1, line)});
    COMPARE_NEAR(run.state().q[0], 0.04, 1e-12, "m");
    run.run(0.05, 1e-3);
    COMPARE_NEAR(run.bodies()[0].centre, Vec3(0.09, 0, 0), 1e-9, "m");
    run.run(1, 1e-3);
    COMPARE_NEAR(run.bodies()[0].centre, Vec3(0.1, 0, 0), 1e-6, "m");
    COMPARE_NEAR(run.bodies()[0].velocity, Vec3(Vec3::Zero()), 1e-9, "m/s");
}

// A straight path is a slide: all that acts along one acts along the other.
void PathsTest::whatWorksOnASlideWorksOnAPath() {
    JointPath line;
    line.points = {Vec3(-2, 0, 0), Vec3(-0.7, 0, 0), Vec3(2, 0, 0)};
    RigidBody mass = bead(1, Vec3::Zero(), 0.5);
    mass.velocity = Vec3(0.8, 0, 0);
    const auto act = [](Joint& joint, double zero) {
        JointDrive spring;
        spring.stiffness = 30, spring.damping = 0.2, spring.position = 0.03 + zero;
        JointDrive stiff = spring;
        stiff.stiffness = 0, stiff.damping = 1e5, stiff.velocity = 0.1, stiff.maxForce = 0.05;
        JointDrive detents;
        detents.stiffness = 40, detents.spacing = 0.02, detents.position = zero;
        JointDrive aside = spring;
        aside.axis = 1;
        joint.drives = {spring, stiff, detents, aside};
        joint.frictions = {{false, 0, 0.1}};
        joint.limits.push_back({false, 1, zero - 0.05, zero + 0.1});
        joint.limits.push_back({false, 1, zero - 1, zero + 0.04, 200, 0.1});
    };
    const std::vector<RigidBody> bodies{mass};
    Joint slide = sliderAt(bodies, kWorldBody, 1, Vec3::Zero(), Vec3::UnitX()), path = onPath(1, line);
    act(slide, 0), act(path, 2);
    Running slides(bodies, {slide}), rides(bodies, {path});
    for (int i = 0; i < 50; ++i) {
        slides.run(0.02, 5e-4, Vec3::Zero()), rides.run(0.02, 5e-4, Vec3::Zero());
        COMPARE_NEAR(rides.bodies()[0].centre, slides.bodies()[0].centre, 1e-9, "m");
    }
}

void PathsTest::aBodyBesideItsPathIsPutOntoIt() {
    Running run({bead(1, Vec3(0.3, 0, 0.1))}, {onPath(1, ring(0.1))});
    COMPARE_NEAR(run.bodies()[0].centre, Vec3(0.1, 0, 0), 1e-9, "m");
}

// Of a ring: at equal angles, x along it.
void PathsTest::placesAlongAPathAreEvenlyFarApart() {
    const std::vector<Pose> places = placesAlong(ring(0.1), 12);
    QCOMPARE(places.size(), std::size_t(13)); // the first comes again
    for (std::size_t i = 0; i < places.size(); ++i) {
        const double a = 2 * pi * double(i) / 12;
        COMPARE_NEAR(places[i].translation, 0.1 * Vec3(std::sin(a), -std::cos(a), 0), 1e-7, "m");
        COMPARE_NEAR(Vec3(places[i].rotation * Vec3::UnitX()), Vec3(std::cos(a), std::sin(a), 0), 1e-5, "");
    }
    JointPath line;
    line.points = {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.4, 0, 0)};
    const std::vector<Pose> even = placesAlong(line, 4);
    QCOMPARE(even.size(), std::size_t(5));
    for (std::size_t i = 0; i < even.size(); ++i)
        COMPARE_NEAR(even[i].translation, Vec3(0.1 * double(i), 0, 0), 1e-9, "m");
    QVERIFY(placesAlong(JointPath{}, 4).empty());
}

void PathsTest::theNearestPlaceIsFound() {
    for (const double a : {0.0, 0.4, 3.1, 6.2}) {
        const Vec3 out(std::sin(a), -std::cos(a), 0);
        for (const double far : {0.02, 0.0999, 0.35}) {
            const auto found = nearestOn(ring(0.1), {Quat::Identity(), far * out + Vec3(0, 0, 0.2)});
            QVERIFY(found.has_value());
            COMPARE_NEAR(found->translation, 0.1 * out, 1e-7, "m");
        }
    }
    // Where a curve crosses itself, that of both ways which the body lies along.
    JointPath eight = pathOf([](double a) { return Vec3(0.2 * std::sin(a), 0.1 * std::sin(2 * a), 0); }, 0,
                             2 * pi, 200, true);
    for (const double sign : {1.0, -1.0}) {
        const Vec3 way = Vec3(sign, 1, 0).normalized(); // at a = 0 (0.2, 0.2), at a = pi (-0.2, 0.2)
        const Pose lies{turnOnto(Vec3::UnitX(), way), Vec3::Zero()};
        const auto found = nearestOn(eight, lies);
        QVERIFY(found.has_value());
        COMPARE_NEAR(found->translation, Vec3(0, 0, 0), 1e-6, "m");
        COMPARE_NEAR(Vec3(found->rotation * Vec3::UnitX()), way, 1e-3, "");
    }
    // An open one ends.
    JointPath line;
    line.points = {Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.4, 0, 0)};
    for (const auto& [x, at] : {std::pair(-3.0, 0.0), {0.25, 0.25}, {7.0, 0.4}}) {
        const auto found = nearestOn(line, {Quat::Identity(), Vec3(x, 1, 1)});
        QVERIFY(found.has_value());
        COMPARE_NEAR(found->translation, Vec3(at, 0, 0), 1e-7, "m");
    }
    QVERIFY(!nearestOn(JointPath{}, Pose{}).has_value());
}

void PathsTest::whatIsNoPathIsRefused_data() {
    QTest::addColumn<JointPath>("path");
    QTest::addColumn<QString>("why");
    const auto row = [](const char* why, std::vector<Vec3> points, bool closed, std::vector<Vec3> ups = {}) {
        QTest::newRow(why) << JointPath{std::move(points), std::move(ups), closed} << why;
    };
    const Vec3 o(0, 0, 0), x(1, 0, 0), y(0, 1, 0);
    row("too few points", {o}, false);
    row("3 or more", {o, x}, true);
    row("same place", {o, o, x}, false);
    row("not one up for each", {o, x}, false, {y});
    row("up lies along", {o, x}, false, {x, x});
    row("turns too sharply", {o, x, Vec3(1e-7, 0, 0)}, false);
    row("not a finite number", {o, x, Vec3(kUnbounded, 0, 0)}, false);
}

void PathsTest::whatIsNoPathIsRefused() {
    QFETCH(JointPath, path);
    QFETCH(QString, why);
    const std::vector<RigidBody> bodies{bead(1, Vec3::Zero())};
    const auto made = compileMechanism(bodies, std::vector{onPath(1, path)});
    QVERIFY(!made);
    COMPARE_CONTAINS(made.error().text, why.toStdString());
    // Two paths for one body would be a loop.
    const auto loop = compileMechanism(bodies, std::vector{onPath(1, ring(1)), onPath(1, ring(1))});
    QVERIFY(!loop);
    COMPARE_CONTAINS(loop.error().text, "closes a loop");
}

TACTUM_TEST(PathsTest)

} // namespace test_paths

#include "test_paths.moc"
