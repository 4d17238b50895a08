// Loose bodies against each other and the world.
//
// What would show that a test here is wrong: each expected number is the textbook's for a point or a rigid
// body (sliding, rolling, bouncing, what momentum and restitution leave); with another friction, restitution
// or slope the numbers are others, which the data rows try.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/core/dynamics/loose.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_contacts {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double pi = std::numbers::pi;

/// A plane that falls toward +x, and the pose of what lies `up` above it.
struct Slope {
    double angle;
    Quat turn{Eigen::AngleAxisd(-angle, Vec3::UnitZ())};
    Vec3 down{std::cos(angle), -std::sin(angle), 0};
    Pose above(double up) const { return {turn, turn * Vec3(0, up, 0)}; }
};

} // namespace

class ContactsTest : public QObject {
    Q_OBJECT

private slots:
    void aBlockOnASlope_data();
    void aBlockOnASlope();
    void aBallRollsDownASlope();
    void aCylinderRollsAsFarAsItIs_data();
    void aCylinderRollsAsFarAsItIs();
    void aBallBouncesByItsRestitution_data();
    void aBallBouncesByItsRestitution();
    void materialsAreCombinedAsTheySay_data();
    void materialsAreCombinedAsTheySay();
    void twoBallsExchangeMomentum_data();
    void twoBallsExchangeMomentum();
    void newtonsCradleHandsItOn();
    void aPushedBoxThatSticksDoesNotCreep();
    void tenBoxesStandOnEachOther();
    void elevenHundredBoxesLieOnTheirFloor();
    void aLidLiesOnAPot();
    void dominoesFallInTurn();
    void everyPairOfShapesHolds_data();
    void everyPairOfShapesHolds();
    void aStripIsEndlessOneWay();
    void filtersAndJointsKeepApart();
    void hullsAreTheSmallest();
    void whatHasNoRoomIsCounted();
    void theSameTwice();
};

void ContactsTest::aBlockOnASlope_data() {
    QTest::addColumn<double>("degrees");
    QTest::addColumn<double>("friction");
    QTest::newRow("smooth") << 20. << 0.;
    QTest::newRow("slides") << 30. << 0.3;
    QTest::newRow("hardly slides") << 20. << 0.36;
    QTest::newRow("sticks") << 20. << 0.37;
}

void ContactsTest::aBlockOnASlope() {
    QFETCH(double, degrees);
    QFETCH(double, friction);
    const Slope slope{degrees * pi / 180};
    World world;
    world.material = {friction, friction, 0, Combine::Average, Combine::Average};
    world.addStill(floorShape(), {slope.turn, Vec3::Zero()});
    world.add(box({0.1, 0.04, 0.1}), slope.above(0.02), 0.7);
    Running run(world.mechanics);
    const Vec3 from = run.bodies()[0].centre;
    run.run(1, 1e-3);
    const double pull = 9.81 * (std::sin(slope.angle) - friction * std::cos(slope.angle));
    const double way = (run.bodies()[0].centre - from).dot(slope.down);
    COMPARE_NEAR(way, std::max(0.0, 0.5 * pull), pull > 0 ? 1e-4 * pull : 1e-9, "m");
    COMPARE_NEAR(run.bodies()[0].angularVelocity, Vec3::Zero(), 1e-7, "rad/s");
}

void ContactsTest::aBallRollsDownASlope() {
    const Slope slope{0.3};
    World world;
    world.addStill(floorShape(), {slope.turn, Vec3::Zero()});
    world.add(ball(0.05), slope.above(0.05), 0.4);
    Running run(world.mechanics);
    run.run(1, 1e-3);
    const BodyState now = run.bodies()[0];
    const double pull = 9.81 * std::sin(slope.angle) * 5 / 7;
    COMPARE_NEAR(now.velocity.dot(slope.down), pull, 1e-4, "m/s");
    COMPARE_NEAR(now.angularVelocity.norm() * 0.05, pull, 1e-4, "m/s");
}

void ContactsTest::aCylinderRollsAsFarAsItIs_data() {
    QTest::addColumn<double>("angle");
    QTest::addColumn<bool>("onABox");
    QTest::addColumn<double>("radius");
    for (const double radius : {0.005, 0.05})
        for (const double angle : {0., 0.0175, 0.3}) {
            QTest::addRow("%g m, %g rad, plane", radius, angle) << angle << false << radius;
            QTest::addRow("%g m, %g rad, box", radius, angle) << angle << true << radius;
        }
}

// On the flat it keeps its speed, down a slope it gains 2/3 g sin(angle) each second.
void ContactsTest::aCylinderRollsAsFarAsItIs() {
    QFETCH(double, angle);
    QFETCH(bool, onABox);
    QFETCH(double, radius);
    const Slope slope{angle};
    World world;
    world.material = {0.8, 0.8, 0, Combine::Average, Combine::Average};
    world.addStill(onABox ? box({30, 0.1, 1}) : floorShape(),
                   {slope.turn, slope.turn * Vec3(0, onABox ? -0.05 : 0, 0)});
    ColliderShape wheel;
    wheel.kind = ShapeKind::Cylinder;
    wheel.radius = wheel.radiusBottom = radius;
    wheel.height = 0.1;
    Pose lying = slope.above(radius);
    lying.rotation = lying.rotation * Quat(Eigen::AngleAxisd(pi / 2, Vec3::UnitX()));
    RigidBody& body = world.add(wheel, lying, 0.4);
    body.velocity = 0.5 * slope.down;
    body.angularVelocity = Vec3(0, 0, -0.5 / radius);
    Running run(world.mechanics);
    run.run(2, 0.5e-3);
    const BodyState now = run.bodies()[0];
    const double speed = 0.5 + 2 * 9.81 * std::sin(angle) * 2 / 3;
    COMPARE_NEAR(now.velocity.dot(slope.down), speed, 1e-3 * speed, "m/s");
    COMPARE_NEAR(now.angularVelocity.norm() * radius, speed, 1e-3 * speed, "m/s");
}

void ContactsTest::aBallBouncesByItsRestitution_data() {
    QTest::addColumn<double>("restitution");
    QTest::newRow("none") << 0.;
    QTest::newRow("half") << 0.5;
    QTest::newRow("nearly all") << 0.9;
    QTest::newRow("all") << 1.;
}

void ContactsTest::aBallBouncesByItsRestitution() {
    QFETCH(double, restitution);
    World world;
    world.material.restitution = restitution;
    world.addStill(floorShape());
    world.add(ball(0.05), at(0, 0.55), 0.4);
    Running run(world.mechanics);
    const double fall = std::sqrt(2 * 0.5 / 9.81);
    // The highest place of the first bounce is half its flight after the fall.
    run.run(fall * (1 + restitution), fall / 320);
    COMPARE_NEAR(run.bodies()[0].centre.y() - 0.05, restitution * restitution * 0.5, 5e-5, "m");
}

void ContactsTest::materialsAreCombinedAsTheySay_data() {
    QTest::addColumn<int>("body");
    QTest::addColumn<int>("floor");
    QTest::addColumn<double>("friction"); // of 0.2 and 0.6
    const auto row = [](const char* name, Combine body, Combine floor, double friction) {
        QTest::newRow(name) << int(body) << int(floor) << friction;
    };
    row("average", Combine::Average, Combine::Average, 0.4);
    row("minimum", Combine::Minimum, Combine::Minimum, 0.2);
    row("maximum", Combine::Maximum, Combine::Maximum, 0.6);
    row("multiply", Combine::Multiply, Combine::Multiply, 0.12);
    row("average before others", Combine::Multiply, Combine::Average, 0.4);
    row("minimum before maximum", Combine::Minimum, Combine::Maximum, 0.2);
    row("maximum before multiply", Combine::Multiply, Combine::Maximum, 0.6);
}

// A box is slowed by the friction of both, a ball bounces by the restitution of both.
void ContactsTest::materialsAreCombinedAsTheySay() {
    QFETCH(int, body);
    QFETCH(int, floor);
    QFETCH(double, friction);
    World sliding;
    sliding.material = {0.6, 0.6, 0, Combine(floor), Combine::Average};
    sliding.addStill(floorShape());
    sliding.material = {0.2, 0.2, 0, Combine(body), Combine::Average};
    sliding.add(box({0.1, 0.04, 0.1}), at(0, 0.02), 0.7).velocity = Vec3(2, 0, 0);
    Running slides(sliding.mechanics);
    slides.run(0.2, 1e-3);
    COMPARE_NEAR(slides.bodies()[0].velocity.x(), 2 - friction * 9.81 * 0.2, 1e-6, "m/s");

    World falling;
    falling.material = {0, 0, 0.6, Combine::Average, Combine(floor)};
    falling.addStill(floorShape());
    falling.material = {0, 0, 0.2, Combine::Average, Combine(body)};
    falling.add(ball(0.05), at(0, 0.55), 0.4);
    Running falls(falling.mechanics);
    const double fall = std::sqrt(2 * 0.5 / 9.81);
    falls.run(fall * (1 + friction), fall / 320); // the highest place of the first bounce
    COMPARE_NEAR(falls.bodies()[0].centre.y() - 0.05, friction * friction * 0.5, 5e-5, "m");
}

void ContactsTest::twoBallsExchangeMomentum_data() {
    QTest::addColumn<double>("mass");
    QTest::addColumn<double>("restitution");
    QTest::newRow("equal, elastic") << 1. << 1.;
    QTest::newRow("heavy, elastic") << 5. << 1.;
    QTest::newRow("light, half") << 0.2 << 0.5;
    QTest::newRow("equal, not at all") << 1. << 0.;
}

void ContactsTest::twoBallsExchangeMomentum() {
    QFETCH(double, mass);
    QFETCH(double, restitution);
    World world;
    world.material = {0, 0, restitution, Combine::Average, Combine::Average};
    world.add(ball(0.05), at(-0.3, 0), 1).velocity = Vec3(2, 0, 0);
    world.add(ball(0.05), at(0, 0), mass);
    Running run(world.mechanics);
    run.run(0.3, 1e-3, Vec3::Zero());
    const double first = 2 * (1 - restitution * mass) / (1 + mass),
                 second = 2 * (1 + restitution) / (1 + mass);
    COMPARE_NEAR(run.bodies()[0].velocity, Vec3(first, 0, 0), 1e-12, "m/s");
    COMPARE_NEAR(run.bodies()[1].velocity, Vec3(second, 0, 0), 1e-12, "m/s");
}

void ContactsTest::newtonsCradleHandsItOn() {
    World world;
    world.material = {0, 0, 1, Combine::Average, Combine::Average};
    const double length = 0.2, r = 0.02;
    for (int i = 0; i < 5; ++i)
        world.add(ball(r), at(2 * r * i, -length), 0.1);
    // The first is drawn aside.
    const double angle = -0.5;
    const Quat aside(Eigen::AngleAxisd(angle, Vec3::UnitZ()));
    world.mechanics.bodies[0].pose = {aside, aside * Vec3(0, -length, 0)};
    for (int i = 0; i < 5; ++i)
        world.mechanics.joints.push_back(
            hingeAt(world.mechanics.bodies, kWorldBody, BodyId(i + 1), Vec3(2 * r * i, 0, 0)));
    Running run(world.mechanics);
    const double energy = run.energy();
    double highest = -1;
    for (int i = 0; i < 700; ++i) { // three quarters of a swing
        run.run(1e-3, 1e-3);
        highest = std::max(highest, run.bodies()[4].centre.y());
    }
    COMPARE_NEAR(highest, -length * std::cos(angle), 2e-5, "m");
    for (std::size_t i = 1; i < 4; ++i) // those between have stood still
        COMPARE_NEAR(run.bodies()[i].centre.x(), 2 * r * double(i), 1e-4, "m");
    COMPARE_NEAR(run.energy(), energy, 1e-4 * 0.1 * 9.81 * length, "J");
}

void ContactsTest::aPushedBoxThatSticksDoesNotCreep() {
    World world;
    world.material = {1, 1, 0, Combine::Average, Combine::Average};
    world.addStill(floorShape());
    world.add(box({0.1, 0.1, 0.1}), at(0, 0.05), 1);
    Running run(world.mechanics);
    run.run(0.1, 1e-3);
    const Vec3 from = run.bodies()[0].centre;
    const AppliedForce push{{run.mechanism().places[0].link, {Quat::Identity(), Vec3(-0.05, 0, 0)}},
                            Vec3(0.3 * 9.81, 0, 0)};
    run.run(5, 1e-3, kDown, {&push, 1});
    COMPARE_NEAR(run.bodies()[0].centre, from, 1e-6, "m");
}

void ContactsTest::tenBoxesStandOnEachOther() {
    World world;
    world.addStill(floorShape());
    for (int i = 0; i < 10; ++i)
        world.add(box({0.1, 0.05, 0.1}), at(0.004 * (i % 3 - 1), 0.025 + 0.05 * i), 0.3);
    Running run(world.mechanics);
    run.run(0.2, 1e-3);
    const Vec3 top = run.bodies()[9].centre;
    run.run(4, 1e-3);
    COMPARE_NEAR(run.bodies()[9].centre, top, 2e-5, "m");
    COMPARE_NEAR(top.y(), 0.475, 1e-4, "m");
}

// 4,400 places: whoever had none of them would fall through.
void ContactsTest::elevenHundredBoxesLieOnTheirFloor() {
    World world;
    world.addStill(floorShape());
    for (int i = 0; i < 1100; ++i)
        world.add(box({0.1, 0.1, 0.1}), at(0.2 * (i % 100), 0.05, 0.2 * (i / 100)), 0.3);
    Running run(world.mechanics);
    run.run(0.02, 1e-3);
    double lowest = 1;
    for (const BodyState& body : run.bodies())
        lowest = std::min(lowest, body.centre.y());
    COMPARE_NEAR(lowest, 0.05, 1e-5, "m");
}

void ContactsTest::aLidLiesOnAPot() {
    // A ring of eight posts, and a disc dropped on it a little aside.
    World world;
    for (int i = 0; i < 8; ++i)
        world.addStill(box({0.01, 0.1, 0.01}),
                       at(0.08 * std::cos(i * pi / 4), 0.05, 0.08 * std::sin(i * pi / 4)));
    ColliderShape lid;
    lid.kind = ShapeKind::Cylinder;
    lid.radius = lid.radiusBottom = 0.09;
    lid.height = 0.01;
    world.add(lid, at(0.003, 0.13), 0.2);
    Running run(world.mechanics);
    run.run(2, 1e-3);
    COMPARE_NEAR(run.bodies()[0].centre.y(), 0.105, 2e-5, "m");
    COMPARE_NEAR(run.bodies()[0].velocity, Vec3::Zero(), 1e-6, "m/s");
}

void ContactsTest::dominoesFallInTurn() {
    World world;
    world.addStill(floorShape());
    constexpr int kCount = 8;
    for (int i = 0; i < kCount; ++i)
        world.add(box({0.008, 0.05, 0.025}), at(0.025 * i, 0.025), 0.01);
    Running run(world.mechanics);
    run.run(0.2, 1e-3);
    for (const BodyState& one : run.bodies())
        COMPARE_NEAR(one.pose.rotation.angularDistance(Quat::Identity()), 0, 1e-5, "rad");
    const AppliedForce push{{run.mechanism().places[0].link, {Quat::Identity(), Vec3(0, 0.025, 0)}},
                            Vec3(0.1, 0, 0)};
    run.run(0.1, 1e-3, kDown, {&push, 1});
    run.run(1.5, 1e-3);
    for (const BodyState& one : run.bodies())
        QVERIFY(one.pose.rotation.angularDistance(Quat::Identity()) > 0.5);
}

void ContactsTest::everyPairOfShapesHolds_data() {
    QTest::addColumn<int>("lower");
    QTest::addColumn<int>("upper");
    for (int lower = 0; lower < 6; ++lower)
        for (int upper = 0; upper < 5; ++upper)
            QTest::addRow("%d under %d", lower, upper) << lower << upper;
}

// The lower one stands still at the origin, the upper one is put on its highest place and stays there.
void ContactsTest::everyPairOfShapesHolds() {
    QFETCH(int, lower);
    QFETCH(int, upper);
    const auto shapeOf = [](int which) {
        ColliderShape shape = which == 1 ? ball(0.05) : box({0.1, 0.1, 0.1});
        if (which == 2) {
            shape.kind = ShapeKind::Capsule;
            shape.radius = shape.radiusBottom = 0.03;
            shape.height = 0.04;
        }
        if (which == 3) {
            shape.kind = ShapeKind::Cylinder;
            shape.radius = shape.radiusBottom = 0.05;
            shape.height = 0.1;
        }
        if (which == 4) {
            shape.kind = ShapeKind::Hull;
            ShapeMesh mesh;
            const Polytope cube = boxOf(Vec3::Constant(0.1));
            mesh.points = cube.points;
            for (const Polytope::Face& face : cube.faces)
                for (std::size_t k = 2; k < face.corners.size(); ++k)
                    mesh.faces.push_back({std::uint32_t(face.corners[0]), std::uint32_t(face.corners[k - 1]),
                                          std::uint32_t(face.corners[k])});
            shape.mesh = std::make_shared<const ShapeMesh>(mesh);
        }
        if (which == 5) shape = floorShape();
        return shape;
    };
    const double top = lower == 5 ? 0 : 0.05;
    World world;
    world.addStill(shapeOf(lower));
    world.add(shapeOf(upper), at(0, top + 0.07), 0.5);
    Running run(world.mechanics);
    run.run(0.5, 1e-3);
    COMPARE_NEAR(run.bodies()[0].centre, Vec3(0, top + 0.05, 0), 5e-5, "m");
}

// 1 m wide: what slides along it stays on it, what slides across it falls off at the edge.
void ContactsTest::aStripIsEndlessOneWay() {
    for (const bool along : {true, false}) {
        ColliderShape strip = floorShape();
        strip.size.x() = 1;
        World world;
        world.material = {0, 0, 0, Combine::Average, Combine::Average};
        world.addStill(strip);
        world.add(box({0.1, 0.1, 0.1}), at(0, 0.05), 1).velocity = along ? Vec3(0, 0, 50) : Vec3(2, 0, 0);
        Running run(world.mechanics);
        run.run(1, 1e-3);
        const Vec3& centre = run.bodies()[0].centre;
        if (along)
            COMPARE_NEAR(centre, Vec3(0, 0.05, 50), 2e-5, "m");
        else
            QCOMPARE_LT(centre.y(), -1);
    }
}

void ContactsTest::filtersAndJointsKeepApart() {
    World world;
    world.addStill(floorShape());
    world.add(ball(0.05), at(0, 0.2), 1);
    world.mechanics.colliders[0].filter.systems = {"floor"};
    world.mechanics.colliders[1].filter.notWith = {"floor"};
    Running through(world.mechanics);
    through.run(1, 1e-3);
    COMPARE_NEAR(through.bodies()[0].centre.y(), 0.2 - 0.5 * 9.81, 1e-9, "m");
    world.mechanics.colliders[1].filter = {{}, {}, {"floor"}};
    Running on(world.mechanics);
    on.run(1, 1e-3);
    COMPARE_NEAR(on.bodies()[0].centre.y(), 0.05, 2e-5, "m");
    world.mechanics.colliders[1].filter = {{}, {}, {"wall"}};
    QVERIFY(!Running(world.mechanics).mechanism().mayTouch(0, 1));
}

void ContactsTest::hullsAreTheSmallest() {
    // The corners of a box, points inside it, points on its faces: the box again.
    std::vector<Vec3> points = boxOf({0.2, 0.1, 0.3}).points;
    for (int i = 0; i < 200; ++i)
        points.emplace_back(0.1 * std::sin(i * 1.3), 0.05 * std::sin(i * 2.1), 0.15 * std::sin(i * 0.7));
    points.emplace_back(0.1, 0.01, 0.02);
    points.emplace_back(0, 0.05, 0);
    const Polytope hull = hullOf(points);
    QCOMPARE(hull.faces.size(), std::size_t(6));
    QCOMPARE(hull.edges.size(), std::size_t(12));
    for (const Polytope::Face& face : hull.faces)
        for (const Vec3& p : points)
            QVERIFY(face.normal.dot(p) <= face.offset + 1e-12);
}

// Each of 60 balls within each other touches 59: far more than the 16 for each that there is room for.
void ContactsTest::whatHasNoRoomIsCounted() {
    for (const int balls : {5, 60}) {
        World world;
        for (int i = 0; i < balls; ++i)
            world.add(ball(0.1), at(1e-4 * i, 2e-4 * (i % 3)), 1);
        Running run(world.mechanics);
        run.run(1e-3, 1e-3, Vec3::Zero());
        QCOMPARE(run.dynamics().contactsLeftOut() > 0, balls == 60);
    }
}

void ContactsTest::theSameTwice() {
    World world;
    world.addStill(floorShape());
    for (int i = 0; i < 12; ++i)
        world.add(i % 2 ? ball(0.03) : box({0.05, 0.04, 0.06}),
                  at(0.01 * (i % 3), 0.05 + 0.07 * i, 0.005 * i), 0.1 + 0.05 * i);
    Running one(world.mechanics), two(world.mechanics);
    one.run(1, 1e-3);
    two.run(1, 1e-3);
    QVERIFY(one.state().q == two.state().q && one.state().v == two.state().v);
    for (const BodyState& body : one.bodies())
        QVERIFY(body.centre.y() > 0.01 && body.centre.allFinite());
}

TACTUM_TEST(ContactsTest)

} // namespace test_contacts

#include "test_contacts.moc"
