// What an author makes of objects. Oracles are formulas of boxes and of the physical pendulum; what would
// show that a test is wrong: with another density, length or side the numbers are others.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/dynamics/dynamics.h"
#include "core/dynamics/mechanism_build.h"
#include "core/scene/bodies.h"
#include "core/scene/convex_parts.h"
#include "core/scene/light_bodies.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_bodies {

using namespace tactum;
using namespace tactum::test;

namespace {

TriangleSoup box(const Vec3& size, const Vec3& at = Vec3::Zero()) {
    TriangleSoup soup;
    for (unsigned i = 0; i < 8; ++i)
        soup.positions.push_back(at +
                                 size.cwiseProduct(Vec3(i & 1, i >> 1 & 1, i >> 2) - Vec3::Constant(0.5)));
    for (const auto& side : {std::array<Index, 4>{0, 4, 6, 2},
                             {1, 3, 7, 5},
                             {0, 1, 5, 4},
                             {2, 6, 7, 3},
                             {0, 2, 3, 1},
                             {4, 5, 7, 6}}) {
        soup.triangles.push_back({side[0], side[1], side[2]});
        soup.triangles.push_back({side[0], side[2], side[3]});
    }
    soup.surfaceOf.assign(12, 0);
    return soup;
}

TriangleSoup both(TriangleSoup a, const TriangleSoup& b) {
    const Index first = Index(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    a.surfaceOf.assign(a.triangles.size(), 0);
    return a;
}

ObjectId add(Scene& scene, const std::string& name, TriangleSoup soup, const Pose& pose = {}) {
    SceneObject object;
    object.name = name, object.pose = pose;
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    object.surfaces.resize(1);
    return scene.add(std::move(object)).id;
}

/// A post, and a door of 80 x 130 x 8 mm to its right.
struct Doorway {
    Scene scene;
    ObjectId post, door;
    Doorway() {
        post = add(scene, "post", box({0.01, 0.2, 0.02}), {Quat::Identity(), {-0.046, 0, 0}});
        door = add(scene, "door", box({0.08, 0.13, 0.008}));
    }
};

} // namespace

class TestBodies : public QObject {
    Q_OBJECT

private slots:
    void aBodyWeighsItsVolumeInWater() {
        Scene scene;
        const ObjectId id = add(scene, "plank", box({0.1, 0.02, 0.3}), {Quat::Identity(), {1, 2, 3}});
        const BodyId body = makeBody(scene, id);
        QVERIFY(body != kWorldBody);
        const RigidBody& made = *findBody(scene, body);
        COMPARE_NEAR(made.mass, 0.6, 1e-9, "kg");
        COMPARE_NEAR(made.centre, Vec3::Zero(), 1e-12, "m");
        COMPARE_NEAR(made.pose.translation, Vec3(1, 2, 3), 1e-15, "m");
        std::array<double, 3> moments{made.inertia.x(), made.inertia.y(), made.inertia.z()};
        std::ranges::sort(moments);
        COMPARE_NEAR(moments[2], 0.6 / 12 * (0.1 * 0.1 + 0.3 * 0.3), 1e-9, "kg m^2");
        COMPARE_NEAR(moments[0], 0.6 / 12 * (0.1 * 0.1 + 0.02 * 0.02), 1e-9, "kg m^2");
        setMass(scene.mechanics.bodies[0], 1.2);
        COMPARE_NEAR(scene.mechanics.bodies[0].inertia.maxCoeff(), 2 * moments[2], 1e-12, "kg m^2");
        QCOMPARE(makeBody(scene, id), kWorldBody); // it is one
    }

    void partsThatShareNoCornerAreConvexApart() {
        const TriangleSoup two = both(box({1, 1, 1}), box({1, 1, 1}, {3, 0, 0}));
        const auto shapes = convexParts(two);
        QCOMPARE(shapes.size(), std::size_t(2));
        COMPARE_NEAR(massOf(shapes[1]).centre, Vec3(3, 0, 0), 1e-12, "m");
        TriangleSoup many;
        for (int i = 0; i <= int(kMostParts); ++i)
            many = both(many, box({0.1, 0.1, 0.1}, {double(i), 0, 0}));
        QCOMPARE(convexParts(many).size(), std::size_t(1));
        // Of a fine ball the hull keeps its size within the step of its directions.
        const auto round = convexParts(*ball(0.05, 3));
        QCOMPARE(round.size(), std::size_t(1));
        QCOMPARE_LE(round[0].mesh->points.size(), kMostHullPoints);
        const double volume = 4.0 / 3 * std::numbers::pi * std::pow(0.05, 3);
        COMPARE_NEAR(massOf(round[0]).volume / volume, 1, 0.2, "");
    }

    // What was a thing to lie on is a body now, and not both; taken back, the scene is what it was.
    void nothingIsThereTwice() {
        Doorway doorway;
        const Scene before = doorway.scene;
        const BodyId body = makeBody(doorway.scene, doorway.door);
        const auto& colliders = doorway.scene.mechanics.colliders;
        QCOMPARE(colliders.size(), std::size_t(2));
        QCOMPARE(std::ranges::count(colliders, body, &Collider::body), std::ptrdiff_t(1));
        const BodyId post = makeBody(doorway.scene, doorway.post);
        QCOMPARE(doorway.scene.mechanics.colliders.size(), std::size_t(2));
        setAxisJoint(doorway.scene, body, guessedJoint(doorway.scene, body, AxisKind::Hinge));
        makeStill(doorway.scene, post);
        QCOMPARE(doorway.scene.mechanics.joints.size(), std::size_t(1)); // of the door to the world
        makeStill(doorway.scene, body);
        QVERIFY(doorway.scene == before);
    }

    void aDoorHangsOnTheEdgeAtItsPost() {
        Doorway doorway;
        const BodyId body = makeBody(doorway.scene, doorway.door);
        const AxisJoint guess = guessedJoint(doorway.scene, body, AxisKind::Hinge);
        COMPARE_NEAR(std::abs(guess.axis.y()), 1, 1e-12, "");
        COMPARE_NEAR(guess.at.x(), -0.04, 1e-12, "m");
        setAxisJoint(doorway.scene, body, guess);
        QCOMPARE_EQ(doorway.scene.mechanics.joints[0].part, doorway.scene.mechanics.colliders[0].part);
        const AxisJoint slide = guessedJoint(doorway.scene, body, AxisKind::Slider);
        COMPARE_NEAR(std::abs(slide.axis.y()), 1, 1e-12, ""); // along its longest side
        setLoose(doorway.scene, body);
        QVERIFY(!axisJointOf(doorway.scene, body));
    }

    // Of each number that can be set.
    void aJointIsReadAsItWasSet() {
        for (const AxisKind kind : {AxisKind::Hinge, AxisKind::Slider}) {
            Doorway doorway;
            const BodyId body = makeBody(doorway.scene, doorway.door),
                         post = makeBody(doorway.scene, doorway.post);
            AxisJoint axis;
            axis.kind = kind, axis.to = post;
            axis.at = {0.01, 0.02, 0.03}, axis.axis = Vec3(1, 2, 2) / 3;
            axis.low = -0.25, axis.high = 0.5, axis.damping = 0.01, axis.friction = 0.02;
            axis.stiffness = 3, axis.rest = 0.125, axis.speed = 0.75, axis.strength = 0.5;
            axis.spacing = 0.1, axis.detent = 0.4;
            setAxisJoint(doorway.scene, body, axis);
            const auto read = axisJointOf(doorway.scene, body);
            QVERIFY(read);
            COMPARE_NEAR(read->at, axis.at, 1e-12, "m");
            COMPARE_NEAR(read->axis, axis.axis, 1e-12, "");
            QVERIFY(read->kind == kind && read->to == post);
            for (const AxisField& field : kAxisFields)
                COMPARE_NEAR((*read).*field.value, axis.*field.value, 1e-12, "");
            for (const AxisField& field :
                 kAxisFields) // none is said by two names, none is out of its own range
                QVERIFY(field.hinge->label.substr(0, 5) == field.slider->label.substr(0, 5) &&
                        field.hinge->allows(field.hinge->initial) &&
                        field.slider->allows(field.slider->initial));
        }
    }

    // A loose box yields along each side's middle like its mass; at 2 kHz 800 N/m push k / (16 * 2000)^2 =
    // 0.78 mg.
    void whatIsTooLightIsSaid() {
        Scene scene;
        const ObjectId id = add(scene, "crumb", box({0.01, 0.02, 0.03}));
        RigidBody& body = *findBody(scene, makeBody(scene, id));
        const auto told = [&](double mass, double stiffness, double time) {
            setMass(body, mass);
            scene.objects[0].surfaces[0].material.stiffness = stiffness;
            scene.mechanics.timeScale = time;
            std::vector<Finding> findings;
            appendLightBodies(findings, scene);
            return findings.size();
        };
        QCOMPARE(told(7e-7, 800, 1), std::size_t(1));
        QCOMPARE(told(9e-7, 800, 1), std::size_t(0));
        QCOMPARE(told(7e-7, 600, 1), std::size_t(0));
        QCOMPARE(told(9e-9, 800, 0.1), std::size_t(0));
        const std::vector<Finding> all = [&] {
            told(7e-7, 800, 1);
            return validate(scene);
        }();
        const auto found = std::ranges::find(all, "crumb", &Finding::object);
        QVERIFY(found != all.end());
        qInfo("%s; %s", found->sentence.c_str(), found->remedy.c_str());
        QVERIFY(found->sentence.starts_with("yields to a finger like"));
    }

    // T = 2 pi sqrt(I / (m g d)) of a plate about its edge, I = m L^2 / 3, d = L / 2, at 1 degree.
    void whatIsMadeSwingsAsAPlateDoes() {
        Scene scene;
        const double length = 0.2;
        const ObjectId id = add(scene, "plate", box({0.05, length, 0.004}));
        const BodyId body = makeBody(scene, id);
        AxisJoint axis;
        axis.axis = Vec3::UnitX(), axis.at = {0, length / 2, 0};
        setAxisJoint(scene, body, axis);
        auto mechanism = std::make_shared<const Mechanism>(
            compileMechanism(scene.mechanics.bodies, scene.mechanics.joints, scene.mechanics.colliders)
                .value());
        Dynamics dynamics(mechanism);
        DynamicState state = dynamics.startState();
        QCOMPARE(int(state.q.size()), 1);
        state.q[0] = std::numbers::pi / 180;
        const double inertia = length * length / 3 + 0.004 * 0.004 / 12,
                     expected = 2 * std::numbers::pi * std::sqrt(inertia / (kEarthGravity * length / 2));
        double last = state.q[0], first = -1, crossed = 0;
        int count = 0;
        for (double t = 0; count < 3; t += 1e-4, last = state.q[0]) {
            dynamics.step(state, scene.mechanics.gravity, {}, 1e-4);
            if (last * state.q[0] <= 0 && last != 0) {
                crossed = t + 1e-4 * last / (last - state.q[0]);
                if (first < 0) first = crossed;
                ++count;
            }
            QVERIFY(t < 5);
        }
        COMPARE_NEAR(crossed - first, expected * (1 + 1.9e-5), 2e-5, "s"); // the amplitude's own part
    }
};

TACTUM_TEST(TestBodies)

} // namespace test_bodies

#include "test_bodies.moc"
