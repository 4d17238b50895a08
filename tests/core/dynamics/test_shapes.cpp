// Shapes by themselves: what they weigh, how far they reach, what contact sees of them, and how a scene is
// scaled with all of its lengths and nothing else.
//
// What would show that a test here is wrong: weights are compared with the textbook's solids, and with what a
// grid of points counts as inside; a shape that lies or leans elsewhere gives other numbers.

#include <cmath>
#include <numbers>

#include <QTest>

#include "core/dynamics/convex.h"
#include "core/dynamics/finger_swing.h"
#include "core/dynamics/mechanics.h"
#include "core/dynamics/weigh.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_shapes {

using namespace tactum;

namespace {

constexpr double pi = std::numbers::pi;

ColliderShape box(const Vec3& size) {
    ColliderShape shape;
    shape.size = size;
    return shape;
}
ColliderShape round(ShapeKind kind, double top, double bottom, double height) {
    ColliderShape shape;
    shape.kind = kind;
    shape.radius = top;
    shape.radiusBottom = bottom;
    shape.height = height;
    return shape;
}
ColliderShape meshShape(ShapeKind kind, const Polytope& body) {
    ShapeMesh mesh{body.points, {}};
    for (const Polytope::Face& face : body.faces)
        for (std::size_t k = 2; k < face.corners.size(); ++k)
            mesh.faces.push_back({std::uint32_t(face.corners[0]), std::uint32_t(face.corners[k - 1]),
                                  std::uint32_t(face.corners[k])});
    ColliderShape shape;
    shape.kind = kind;
    shape.mesh = std::make_shared<const ShapeMesh>(std::move(mesh));
    return shape;
}
ColliderShape tetrahedron(ShapeKind kind) {
    return meshShape(kind, hullOf({Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 2, 0), Vec3(0, 0, 1)}));
}

double apart(const Mat3& a, const Mat3& b) {
    return (a - b).norm();
}

/// What a grid of points says, each of which is inside or not.
ShapeMass counted(const ColliderShape& shape, double half, int across) {
    const double step = 2 * half / across;
    double count = 0;
    Vec3 first = Vec3::Zero();
    Mat3 second = Mat3::Zero();
    for (int i = 0; i < across * across * across; ++i) {
        const Vec3 at =
            Vec3::Constant(-half) +
            step * (Vec3(i % across, i / across % across, i / (across * across)) + Vec3::Constant(0.5));
        if (distanceTo(shape, at) > 0) continue;
        ++count;
        first += at;
        second += at * at.transpose();
    }
    const double cell = step * step * step;
    ShapeMass mass;
    mass.volume = count * cell;
    mass.centre = first / count;
    const Mat3 about = cell * second - mass.volume * mass.centre * mass.centre.transpose();
    mass.moments = about.trace() * Mat3::Identity() - about;
    return mass;
}

/// A joint that has one of everything, with lengths and angles that differ.
Joint joint(BodyId a, BodyId b) {
    Joint made;
    made.name = "joint";
    made.a = a;
    made.b = b;
    made.frameA = {Quat(Eigen::AngleAxisd(0.3, Vec3::UnitX())), Vec3(1, 2, 3)};
    made.frameB = {Quat(Eigen::AngleAxisd(0.4, Vec3::UnitY())), Vec3(4, 5, 6)};
    made.limits = {{false, 1, -0.5, 0.25, 70, 3}, {true, 2, -0.5, 0.25, 70, 3}};
    made.drives = {{false, 0, 5, 6, 0.7, 0.8, 9, true, 0.1}, {true, 1, 5, 6, 0.7, 0.8, 9, false, 0.1}};
    made.frictions = {{false, 0, 2}, {true, 1, 3}};
    made.collide = true;
    made.path.points = {Vec3(0, 1, 0), Vec3(2, 0, 1)};
    made.path.ups = {Vec3(0, 0, 1), Vec3(0, 0, 2)};
    return made;
}

} // namespace

class ShapesTest : public QObject {
    Q_OBJECT

private slots:
    void theyWeighWhatTheTextbookSays();
    void aConeIsWhatACutOneBecomes();
    void whatIsInsideWeighs_data();
    void whatIsInsideWeighs();
    void meshesWeighWhatTheyEnclose();
    void whatEnclosesNothingWeighsNothing();
    void partsAddUp();
    void aBodyGetsTheAxesOfItsShapes();
    void distancesAreThoseOutside_data();
    void distancesAreThoseOutside();
    void whatContactSees();
    void aPlaneHasOneSide();
    void edgesJoinTheirFaces();
    void aScaledSceneHasOtherLengthsAlone();
    void detentsAreSpringsAtEach();
    void howLightAFingerMayPush();
};

void ShapesTest::theyWeighWhatTheTextbookSays() {
    const ShapeMass brick = massOf(box({0.2, 0.3, 0.5}));
    COMPARE_NEAR(brick.volume, 0.03, 1e-15, "m^3");
    COMPARE_NEAR(brick.centre, Vec3(0, 0, 0), 1e-15, "m");
    const Vec3 squares(0.09 + 0.25, 0.04 + 0.25, 0.04 + 0.09);
    QCOMPARE_LT(apart(brick.moments, Mat3((0.03 / 12 * squares).asDiagonal())), 1e-15);
    const ShapeMass ball = massOf(round(ShapeKind::Sphere, 0.3, 7, 7));
    COMPARE_NEAR(ball.volume, 4 * pi / 3 * 0.027, 1e-15, "m^3");
    QCOMPARE_LT(apart(ball.moments, Mat3(0.4 * ball.volume * 0.09 * Mat3::Identity())), 1e-15);
    const double r = 0.2, h = 0.7;
    const ShapeMass can = massOf(round(ShapeKind::Cylinder, r, r, h));
    COMPARE_NEAR(can.volume, pi * r * r * h, 1e-15, "m^3");
    COMPARE_NEAR(can.centre, Vec3(0, 0, 0), 1e-15, "m");
    const double across = can.volume * (r * r / 4 + h * h / 12);
    QCOMPARE_LT(apart(can.moments, Mat3(Vec3(across, can.volume * r * r / 2, across).asDiagonal())), 1e-15);
    // A capsule: its middle part and a ball that is cut in two.
    const ShapeMass pill = massOf(round(ShapeKind::Capsule, r, r, h));
    const double whole = 4 * pi / 3 * r * r * r;
    COMPARE_NEAR(pill.volume, can.volume + whole, 1e-15, "m^3");
    COMPARE_NEAR(pill.centre, Vec3(0, 0, 0), 1e-15, "m");
    const double side = across + whole * (2 * r * r / 5 + h * h / 4 + 3 * h * r / 8);
    const double along = can.volume * r * r / 2 + whole * 2 * r * r / 5;
    QCOMPARE_LT(apart(pill.moments, Mat3(Vec3(side, along, side).asDiagonal())), 1e-15);
}

void ShapesTest::aConeIsWhatACutOneBecomes() {
    // Its wide end below: the centre is a quarter of the height from there.
    const double r = 0.4, h = 0.6;
    const ShapeMass cone = massOf(round(ShapeKind::Cylinder, 0, r, h));
    COMPARE_NEAR(cone.volume, pi * r * r * h / 3, 1e-15, "m^3");
    COMPARE_NEAR(cone.centre, Vec3(0, -h / 4, 0), 1e-15, "m");
    const double across = cone.volume * (3 * r * r / 20 + 3 * h * h / 80);
    const Vec3 moments(across, cone.volume * 3 * r * r / 10, across);
    QCOMPARE_LT(apart(cone.moments, Mat3(moments.asDiagonal())), 1e-15);
    const ShapeMass over = massOf(round(ShapeKind::Cylinder, r, 0, h));
    COMPARE_NEAR(over.centre, Vec3(0, h / 4, 0), 1e-15, "m");
    QCOMPARE_LT(apart(over.moments, cone.moments), 1e-15);
    // A bucket and the cone that it lacks.
    const ShapeMass bucket = massOf(round(ShapeKind::Cylinder, r / 2, r, h / 2));
    const ShapeMass tip = massOf(round(ShapeKind::Cylinder, 0, r / 2, h / 2));
    const ShapeMass sum = together(placed(bucket, {Quat::Identity(), Vec3(0, -h / 4, 0)}),
                                   placed(tip, {Quat::Identity(), Vec3(0, h / 4, 0)}));
    COMPARE_NEAR(sum.volume, cone.volume, 1e-15, "m^3");
    COMPARE_NEAR(sum.centre, cone.centre, 1e-15, "m");
    QCOMPARE_LT(apart(sum.moments, cone.moments), 1e-15);
}

void ShapesTest::whatIsInsideWeighs_data() {
    QTest::addColumn<ColliderShape>("shape");
    QTest::newRow("box") << box({0.6, 1.12, 1.68});
    QTest::newRow("sphere") << round(ShapeKind::Sphere, 0.7, 0, 0);
    QTest::newRow("cylinder") << round(ShapeKind::Cylinder, 0.5, 0.5, 1.4);
    QTest::newRow("cut cone") << round(ShapeKind::Cylinder, 0.3, 0.8, 1.4);
    QTest::newRow("capsule") << round(ShapeKind::Capsule, 0.4, 0.4, 0.9);
}

void ShapesTest::whatIsInsideWeighs() {
    QFETCH(ColliderShape, shape);
    const ShapeMass mass = massOf(shape), grid = counted(shape, 1, 100);
    COMPARE_NEAR(grid.volume, mass.volume, 0.01 * mass.volume, "m^3");
    COMPARE_NEAR(grid.centre, mass.centre, 0.003, "m");
    QCOMPARE_LT(apart(grid.moments, mass.moments), 0.02 * mass.moments.norm());
}

void ShapesTest::meshesWeighWhatTheyEnclose() {
    const Vec3 size(0.2, 0.3, 0.5);
    const ShapeMass brick = massOf(box(size));
    for (const ShapeKind kind : {ShapeKind::Hull, ShapeKind::Mesh}) {
        const ShapeMass mass = massOf(meshShape(kind, boxOf(size)));
        COMPARE_NEAR(mass.volume, brick.volume, 1e-15, "m^3");
        COMPARE_NEAR(mass.centre, Vec3(0, 0, 0), 1e-15, "m");
        QCOMPARE_LT(apart(mass.moments, brick.moments), 1e-15);
        // A corner of a box: a sixth of it, and its centre a quarter along each edge.
        const ShapeMass corner = massOf(tetrahedron(kind));
        COMPARE_NEAR(corner.volume, 1, 1e-12, "m^3");
        COMPARE_NEAR(corner.centre, Vec3(0.75, 0.5, 0.25), 1e-12, "m");
        // The integral of x_i x_j is V (e_i e_j + [i = j] e_i^2) / 20 about the corner.
        const Vec3 e(3, 2, 1);
        const Mat3 second = (e * e.transpose() + Mat3(e.cwiseProduct(e).asDiagonal())) / 20 -
                            corner.centre * corner.centre.transpose();
        QCOMPARE_LT(apart(corner.moments, Mat3(second.trace() * Mat3::Identity() - second)), 1e-12);
    }
}

void ShapesTest::whatEnclosesNothingWeighsNothing() {
    ColliderShape plane = round(ShapeKind::Plane, 1, 1, 1);
    ColliderShape flat = meshShape(ShapeKind::Hull, {});
    ColliderShape inside = tetrahedron(ShapeKind::Mesh);
    ShapeMesh turned = *inside.mesh;
    for (auto& face : turned.faces)
        std::swap(face[0], face[1]);
    inside.mesh = std::make_shared<const ShapeMesh>(turned);
    ColliderShape none;
    none.kind = ShapeKind::Mesh;
    ColliderShape noHull;
    noHull.kind = ShapeKind::Hull;
    for (const ColliderShape& shape : {plane, flat, inside, none, noHull}) {
        const ShapeMass mass = massOf(shape);
        QCOMPARE(mass.volume, 0.0);
        COMPARE_NEAR(mass.centre, Vec3(0, 0, 0), 1e-300, "m");
        QCOMPARE(mass.moments.norm(), 0.0);
    }
    const ShapeMass nothing = together({}, {});
    QCOMPARE(nothing.volume, 0.0);
    QVERIFY(nothing.centre.isZero(0));
}

// Two halves of a brick, turned together, are the brick turned.
void ShapesTest::partsAddUp() {
    const Pose pose{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), Vec3(0.3, -0.2, 0.5)};
    const ShapeMass left = massOf(box({0.1, 0.3, 0.5})), right = massOf(box({0.3, 0.3, 0.5}));
    const ShapeMass sum = together(placed(left, pose * Pose{Quat::Identity(), Vec3(-0.15, 0, 0)}),
                                   placed(right, pose * Pose{Quat::Identity(), Vec3(0.05, 0, 0)}));
    const ShapeMass whole = placed(massOf(box({0.4, 0.3, 0.5})), pose);
    COMPARE_NEAR(sum.volume, 0.06, 1e-15, "m^3");
    COMPARE_NEAR(sum.centre, pose.translation, 1e-15, "m");
    COMPARE_NEAR(whole.centre, pose.translation, 1e-15, "m");
    QCOMPARE_LT(apart(sum.moments, whole.moments), 1e-15);
    const Mat3 turn = pose.rotation.toRotationMatrix();
    QCOMPARE_LT(apart(turn.transpose() * whole.moments * turn, massOf(box({0.4, 0.3, 0.5})).moments), 1e-15);
}

void ShapesTest::aBodyGetsTheAxesOfItsShapes() {
    const Pose pose{Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())), Vec3(0.3, -0.2, 0.5)};
    const ShapeMass brick = massOf(box({0.4, 0.3, 0.5})), leaning = placed(brick, pose);
    RigidBody body;
    body.inertiaFrame = pose.rotation; // of before
    weigh(body, brick, 3);
    QCOMPARE(body.mass, 3.0);
    QCOMPARE(body.inertiaFrame, Quat(Quat::Identity()));
    COMPARE_NEAR(body.inertia, Vec3(3 / 12.0 * Vec3(0.34, 0.41, 0.25)), 1e-12, "kg m^2");
    weigh(body, leaning, 3);
    COMPARE_NEAR(body.centre, pose.translation, 1e-15, "m");
    const Mat3 axes = body.inertiaFrame.toRotationMatrix();
    QCOMPARE_LT(apart(axes * body.inertia.asDiagonal() * axes.transpose(), leaning.moments * (3 / 0.06)),
                1e-12);
    COMPARE_NEAR(body.inertiaFrame.norm(), 1, 1e-12, "");
    COMPARE_NEAR(axes.determinant(), 1, 1e-12, "");
    // Of what nothing moves: as 1 kg.
    weigh(body, leaning, 0);
    QCOMPARE(body.mass, 0.0);
    COMPARE_NEAR(body.inertia.sum(), (0.34 + 0.41 + 0.25) / 12, 1e-12, "kg m^2");
    // Of no shape: a ball of water, r^3 = 3 m / (4 pi rho).
    weigh(body, {}, 2);
    const double r = std::cbrt(3 * 2 / (4 * pi * 1000));
    COMPARE_NEAR(body.inertia, Vec3(Vec3::Constant(0.4 * 2 * r * r)), 1e-15, "kg m^2");
    QCOMPARE(body.inertiaFrame, Quat(Quat::Identity()));
    COMPARE_NEAR(body.centre, Vec3(0, 0, 0), 1e-300, "m");
    QCOMPARE(body.mass, 2.0);
}

void ShapesTest::distancesAreThoseOutside_data() {
    QTest::addColumn<ColliderShape>("shape");
    QTest::addColumn<Vec3>("point");
    QTest::addColumn<double>("distance");
    const ColliderShape brick = box({2, 4, 6});
    QTest::newRow("inside a box") << brick << Vec3(0.9, -1.9, 2.9) << 0.0;
    QTest::newRow("above a box") << brick << Vec3(0.9, 2.5, 2.9) << 0.5;
    QTest::newRow("below a box") << brick << Vec3(0.9, -2.5, 2.9) << 0.5;
    QTest::newRow("beside a corner") << brick << Vec3(-2, 4, -5) << 3.0;
    const ColliderShape ball = round(ShapeKind::Sphere, 2, 9, 9);
    QTest::newRow("inside a ball") << ball << Vec3(1.9, 0, 0) << 0.0;
    QTest::newRow("beside a ball") << ball << Vec3(0, 3, 4) << 3.0;
    const ColliderShape can = round(ShapeKind::Cylinder, 2, 2, 6);
    QTest::newRow("inside a can") << can << Vec3(1.4, 2.9, 1.4) << 0.0;
    QTest::newRow("above a can") << can << Vec3(1, 3.5, 1) << 0.5;
    QTest::newRow("below a can") << can << Vec3(1, -3.5, 1) << 0.5;
    QTest::newRow("beside a can") << can << Vec3(3, -2, 4) << 3.0;
    QTest::newRow("beyond a rim") << can << Vec3(0, 7, 5) << 5.0;
    const ColliderShape cone = round(ShapeKind::Cylinder, 1, 3, 4);
    QTest::newRow("a cone at the top") << cone << Vec3(1.5, 2, 0) << 0.5;
    QTest::newRow("a cone at half its height") << cone << Vec3(2.5, 0, 0) << 0.5;
    QTest::newRow("a cone at the bottom") << cone << Vec3(3.5, -2, 0) << 0.5;
    const ColliderShape pill = round(ShapeKind::Capsule, 2, 2, 6);
    QTest::newRow("inside a capsule") << pill << Vec3(0, 4.9, 0) << 0.0;
    QTest::newRow("beside a capsule") << pill << Vec3(0, 1, 3) << 1.0;
    QTest::newRow("beyond its end") << pill << Vec3(3, 7, 0) << 3.0;
    QTest::newRow("beyond its other end") << pill << Vec3(3, -7, 0) << 3.0;
    const ColliderShape plane = round(ShapeKind::Plane, 1, 1, 1);
    QTest::newRow("above a plane") << plane << Vec3(7, 0.5, 7) << 0.5;
    QTest::newRow("below a plane") << plane << Vec3(7, -0.5, 7) << 0.0;
    for (const ShapeKind kind : {ShapeKind::Hull, ShapeKind::Mesh}) {
        QTest::addRow("inside the box of points %d", int(kind))
            << tetrahedron(kind) << Vec3(2.9, 1.9, 0.9) << 0.0;
        QTest::addRow("beside it %d", int(kind)) << tetrahedron(kind) << Vec3(4, 4, 3) << 3.0;
        QTest::addRow("below it %d", int(kind)) << tetrahedron(kind) << Vec3(1, -0.5, 0.5) << 0.5;
    }
}

void ShapesTest::distancesAreThoseOutside() {
    QFETCH(ColliderShape, shape);
    QFETCH(Vec3, point);
    QFETCH(double, distance);
    COMPARE_NEAR(distanceTo(shape, point), distance, 1e-12, "m");
}

void ShapesTest::whatContactSees() {
    const Convex ball = convexOf(round(ShapeKind::Sphere, 0.3, 7, 7));
    QCOMPARE(ball.core, Convex::Core::Point);
    QCOMPARE(ball.radius, 0.3);
    QCOMPARE(ball.reach, 0.3);
    const Convex pill =
        convexOf(round(ShapeKind::Capsule, 0.3, 0.5, 0.8)); // evenly as wide as it is in the middle
    QCOMPARE(pill.core, Convex::Core::Segment);
    COMPARE_NEAR(pill.radius, 0.4, 1e-15, "m");
    QCOMPARE(pill.half, 0.4);
    COMPARE_NEAR(pill.reach, 0.8, 1e-15, "m");
    const Convex brick = convexOf(box({0.6, 0.8, 2.4}));
    QCOMPARE(brick.core, Convex::Core::Polytope);
    QCOMPARE(brick.radius, 0.0);
    COMPARE_NEAR(brick.reach, 1.3, 1e-15, "m");
    COMPARE_NEAR(brick.low, Vec3(-0.3, -0.4, -1.2), 1e-15, "m");
    COMPARE_NEAR(brick.high, Vec3(0.3, 0.4, 1.2), 1e-15, "m");
    COMPARE_NEAR(brick.polytope.centre, Vec3(0, 0, 0), 1e-15, "m");
    const Convex can = convexOf(round(ShapeKind::Cylinder, 0.3, 0.5, 0.8));
    QCOMPARE(can.polytope.points.size(), std::size_t(2 * kCylinderSides));
    QCOMPARE(can.polytope.faces.size(), std::size_t(kCylinderSides + 2));
    COMPARE_NEAR(can.low, Vec3(-0.5, -0.4, -0.5), 1e-12, "m");
    COMPARE_NEAR(can.high, Vec3(0.5, 0.4, 0.5), 1e-12, "m");
    for (const Vec3& p : can.polytope.points)
        COMPARE_NEAR(std::hypot(p.x(), p.z()), p.y() > 0 ? 0.3 : 0.5, 1e-12, "m");
    const Convex cone = convexOf(round(ShapeKind::Cylinder, 0, 0.5, 0.8));
    COMPARE_NEAR(cone.high.y(), 0.4, 1e-12, "m");
    QCOMPARE_GT(cone.polytope.faces.size(), std::size_t(20));
    const Convex hull = convexOf(tetrahedron(ShapeKind::Mesh));
    QCOMPARE(hull.polytope.faces.size(), std::size_t(4));
    COMPARE_NEAR(hull.high, Vec3(3, 2, 1), 1e-12, "m");
    COMPARE_NEAR(hull.low, Vec3(0, 0, 0), 1e-12, "m");
    COMPARE_NEAR(hull.reach, 3, 1e-12, "m");
    QVERIFY(convexOf(meshShape(ShapeKind::Hull, {})).polytope.faces.empty());
}

void ShapesTest::aPlaneHasOneSide() {
    ColliderShape shape = round(ShapeKind::Plane, 1, 1, 1);
    shape.size = {kUnbounded, 0, kUnbounded};
    const Convex plane = convexOf(shape);
    QCOMPARE(plane.core, Convex::Core::HalfSpace);
    QCOMPARE(plane.reach, kUnbounded);
    // Endless along one side it ends along the other, and below: at a tenth of that.
    for (const int endless : {0, 2}) {
        shape.size[endless] = kUnbounded, shape.size[2 - endless] = 2;
        const Convex strip = convexOf(shape);
        QCOMPARE(strip.core, Convex::Core::Polytope);
        COMPARE_NEAR(strip.high[2 - endless], 1, 1e-12, "m");
        COMPARE_NEAR(strip.low.y(), -0.2, 1e-12, "m");
        QCOMPARE_GE(strip.high[endless], 1e6);
    }
    shape.size = {2, 0, 3};
    const Convex slab = convexOf(shape);
    QCOMPARE(slab.core, Convex::Core::Polytope);
    COMPARE_NEAR(slab.low, Vec3(-1, -0.2, -1.5), 1e-12, "m");
    COMPARE_NEAR(slab.high, Vec3(1, 0, 1.5), 1e-12, "m");
    COMPARE_NEAR(slab.polytope.centre, Vec3(0, -0.1, 0), 1e-12, "m");
    for (const Polytope::Face& face : slab.polytope.faces)
        for (const int corner : face.corners)
            COMPARE_NEAR(face.normal.dot(slab.polytope.points[std::size_t(corner)]), face.offset, 1e-12, "m");
}

void ShapesTest::edgesJoinTheirFaces() {
    for (const Polytope& body : {boxOf({0.2, 0.3, 0.5}), convexOf(tetrahedron(ShapeKind::Hull)).polytope,
                                 convexOf(round(ShapeKind::Cylinder, 0.3, 0.5, 0.8)).polytope}) {
        QCOMPARE(body.points.size() + body.faces.size(), body.edges.size() + 2); // Euler
        for (const Polytope::Face& face : body.faces) {
            COMPARE_NEAR(face.normal.norm(), 1, 1e-12, "");
            QCOMPARE_GT(face.offset, face.normal.dot(body.centre)); // outward
            for (const Vec3& p : body.points)
                QCOMPARE_LE(face.normal.dot(p), face.offset + 1e-12);
            for (const int corner : face.corners)
                COMPARE_NEAR(face.normal.dot(body.points[std::size_t(corner)]), face.offset, 1e-12, "m");
        }
        for (const Polytope::Edge& edge : body.edges) {
            const auto has = [&](int face, int a, int b) {
                const std::vector<int>& rim = body.faces[std::size_t(face)].corners;
                for (std::size_t k = 0; k < rim.size(); ++k)
                    if (rim[k] == a && rim[(k + 1) % rim.size()] == b) return true;
                return false;
            };
            QVERIFY(has(edge.left, edge.a, edge.b));
            QVERIFY(has(edge.right, edge.b, edge.a));
        }
    }
}

void ShapesTest::aScaledSceneHasOtherLengthsAlone() {
    RigidBody body;
    body.id = 1;
    body.name = "body";
    body.pose = {Quat(Eigen::AngleAxisd(0.2, Vec3::UnitZ())), Vec3(3, 4, 5)};
    body.mass = 7;
    body.centre = Vec3(0.1, 0.2, 0.3);
    body.inertia = Vec3(1, 2, 3);
    body.velocity = Vec3(0.4, 0.5, 0.6);
    body.angularVelocity = Vec3(7, 8, 9);
    body.gravityFactor = 0.5;
    Mechanics scene;
    scene.bodies = {body};
    scene.joints = {joint(kWorldBody, 1), joint(1, kWorldBody), joint(1, 1)};
    ColliderShape shape = tetrahedron(ShapeKind::Hull);
    shape.size = {1, 2, 3};
    shape.radius = 4, shape.radiusBottom = 5, shape.height = 6;
    const Pose place{Quat(Eigen::AngleAxisd(0.1, Vec3::UnitX())), Vec3(1, 1, 1)};
    scene.colliders = {
        {kWorldBody, place, shape, {}, {}}, {1, place, shape, {}, {}}, {1, place, box({1, 2, 3}), {}, {}}};
    scene.airDensity = 1.2;
    scene.forceScale = 3;
    scene.timeScale = 4;

    Mechanics wanted = scene;
    wanted.bodies[0].pose.translation = Vec3(4, 4, 4); // twice (3, 4, 5) - (1, 2, 3)
    wanted.bodies[0].centre *= 2;
    wanted.bodies[0].inertia *= 4;
    wanted.bodies[0].velocity *= 2;
    wanted.joints[0].frameA.translation = Vec3(0, 0, 0);
    wanted.joints[0].frameB.translation = Vec3(8, 10, 12);
    wanted.joints[1].frameA.translation = Vec3(2, 4, 6);
    wanted.joints[1].frameB.translation = Vec3(6, 6, 6);
    wanted.joints[2].frameA.translation = Vec3(2, 4, 6);
    wanted.joints[2].frameB.translation = Vec3(8, 10, 12);
    for (Joint& one : wanted.joints) {
        one.path.points = {Vec3(0, 2, 0), Vec3(4, 0, 2)};
        one.limits[0].min = -1, one.limits[0].max = 0.5;
        one.drives[0].position = 1.4, one.drives[0].velocity = 1.6, one.drives[0].spacing = 0.2;
    }
    wanted.colliders[0].pose.translation = Vec3(0, -2, -4);
    wanted.colliders[1].pose.translation = wanted.colliders[2].pose.translation = Vec3(2, 2, 2);
    for (Collider& one : wanted.colliders) {
        one.shape.size *= 2, one.shape.radius *= 2, one.shape.radiusBottom *= 2, one.shape.height *= 2;
        if (!one.shape.mesh) continue;
        ShapeMesh mesh = *one.shape.mesh;
        for (Vec3& point : mesh.points)
            point *= 2;
        one.shape.mesh = std::make_shared<const ShapeMesh>(mesh);
    }
    const Mechanics made = scaled(scene, 2, Vec3(1, 2, 3));
    QVERIFY(made.bodies == wanted.bodies);
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY2(made.joints[i] == wanted.joints[i], qPrintable(QString::number(i)));
        QVERIFY2(made.colliders[i] == wanted.colliders[i], qPrintable(QString::number(i)));
    }
    QVERIFY(made == wanted);
}

// It pulls to the next one as its spring would close by, and not at all half way.
void ShapesTest::detentsAreSpringsAtEach() {
    JointDrive drive;
    drive.position = 0.1;
    QCOMPARE(drive.restAt(0.7), 0.1);
    COMPARE_NEAR(drive.energyAt(0.7), 0.18, 1e-15, "");
    drive.spacing = 0.4;
    const double turn = 0.4 / (2 * pi);
    for (const double detent : {-0.3, 0.1, 0.5}) {
        COMPARE_NEAR(drive.restAt(detent), detent, 1e-12, "m");
        COMPARE_NEAR(drive.restAt(detent + 1e-5), detent, 1e-12, "m"); // as a spring
        COMPARE_NEAR(drive.energyAt(detent + 1e-3), 0.5e-6, 1e-9, "m^2");
        COMPARE_NEAR(drive.restAt(detent + 0.2), detent + 0.2, 1e-12, "m");
        COMPARE_NEAR(drive.energyAt(detent + 0.2), 2 * turn * turn, 1e-12, "m^2");
        COMPARE_NEAR(drive.restAt(detent + 0.1), detent + 0.1 - turn, 1e-12, "m"); // where it pulls most
    }
}

// A mass m on a spring k swings by sqrt(k / m): 2 rad in each of the eight parts of a step at most.
void ShapesTest::howLightAFingerMayPush() {
    const double m = lightestPushed(1000, 5e-4);
    COMPARE_NEAR(std::sqrt(1000 / m) * 5e-4 / 8, 2, 1e-12, "rad");
    COMPARE_NEAR(lightestPushed(2000, 5e-4), 2 * m, 1e-15, "kg");
}

TACTUM_TEST(ShapesTest)

} // namespace test_shapes

#include "test_shapes.moc"
