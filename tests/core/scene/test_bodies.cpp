// What an author makes of objects. Oracles are formulas of boxes and of the physical pendulum; what would
// show that a test is wrong: with another density, length or side the numbers are others.
#include <cmath>
#include <numbers>

#include <QTest>

#include "core/dynamics/dynamics.h"
#include "core/dynamics/mechanism_build.h"
#include "core/dynamics/path_places.h"
#include "core/scene/bodies.h"
#include "core/scene/convex_parts.h"
#include "core/scene/light_bodies.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_bodies {

using namespace tactum;
using namespace tactum::test;

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

    // A motor's speed is nothing without its strength, a detent's torque nothing without how far it is to the
    // next: whichever is set first brings the other.
    void aNumberThatIsSetAloneStays() {
        for (const AxisKind kind : {AxisKind::Hinge, AxisKind::Slider, AxisKind::Path})
            for (const AxisField& field : kAxisFields) {
                Doorway doorway;
                const BodyId body = makeBody(doorway.scene, doorway.door);
                AxisJoint axis = guessedJoint(doorway.scene, body, kind);
                const Parameter& parameter = field.of(kind);
                const double value = 0.25 * parameter.minimum + 0.75 * parameter.maximum;
                setFigure(axis, field, value);
                setAxisJoint(doorway.scene, body, axis);
                const auto read = axisJointOf(doorway.scene, body);
                QVERIFY(read);
                COMPARE_NEAR((*read).*field.value, value, 1e-9, parameter.key.data());
                setFigure(axis, field, 2 * parameter.maximum + 1); // beyond its range
                QCOMPARE_EQ(axis.*field.value, field.isStop() && parameter.maximum == parameter.initial
                                                   ? field.endless()
                                                   : parameter.maximum);
                setFigure(axis, field, parameter.minimum);
                QCOMPARE_EQ(axis.*field.value, parameter.minimum == parameter.initial && field.isStop()
                                                   ? field.endless()
                                                   : parameter.minimum);
            }
    }

    // A change of a number takes the bodies nowhere: their places are kept by where joints are, to the bit.
    void aNumberOfAJointLeavesItsPlace() {
        for (const AxisKind kind : {AxisKind::Hinge, AxisKind::Slider, AxisKind::Path}) {
            Doorway doorway;
            Scene& scene = doorway.scene;
            const BodyId body = makeBody(scene, doorway.door), post = makeBody(scene, doorway.post);
            AxisJoint axis = guessedJoint(scene, body, kind);
            axis.to = post, axis.axis = Vec3(1, 2, 2) / 3;
            setAxisJoint(scene, body, axis);
            scene.mechanics.joints[0].frameB.translation += Vec3(0.01, 0, 0); // begins pulled out
            const Joint before = scene.mechanics.joints[0];
            AxisJoint read = axisJointOf(scene, body).value();
            read.damping += 0.01;
            setAxisJoint(scene, body, read);
            const Joint& now = scene.mechanics.joints[0];
            QVERIFY(now.frameA == before.frameA && now.frameB == before.frameB && now.path == before.path);
            COMPARE_NEAR(axisJointOf(scene, body)->damping, read.damping, 1e-15, "");
            read.at += Vec3(0.01, 0, 0);
            setAxisJoint(scene, body, read);
            QVERIFY(kind == AxisKind::Path || !(scene.mechanics.joints[0].frameA == before.frameA));
        }
    }

    // It stays where it is, rides along the points, keeps its numbers, and refuses what is no curve.
    void aBodyRidesOnAPath() {
        Scene scene;
        const Pose at{Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized())), {0.1, 0.2, 0.3}};
        const ObjectId id = add(scene, "car", box({0.04, 0.02, 0.02}, {0.01, 0, 0}), at);
        const BodyId body = makeBody(scene, id);
        AxisJoint axis = guessedJoint(scene, body, AxisKind::Path);
        QCOMPARE(axis.path.points.size(), std::size_t(3));
        COMPARE_NEAR(axis.path.points[1], at.apply({0.01, 0, 0}), 1e-12, "m");
        axis.path.points[2] += Vec3(0.01, 0.03, -0.02);
        axis.friction = 0.25, axis.high = 0.1, axis.stiffness = 3, axis.rest = 0.02;
        setAxisJoint(scene, body, axis);
        const auto startOf = [&] {
            const auto mechanism = std::make_shared<const Mechanism>(
                compileMechanism(scene.mechanics.bodies, scene.mechanics.joints).value());
            Dynamics dynamics(mechanism);
            Pose pose;
            dynamics.posesOf(dynamics.startState(), {&pose, 1});
            return pose;
        };
        COMPARE_NEAR(startOf().translation, at.translation, 1e-9, "m");
        COMPARE_NEAR(std::abs(startOf().rotation.dot(at.rotation)), 1, 1e-9, "");
        const AxisJoint read = axisJointOf(scene, body).value();
        QVERIFY(read.kind == AxisKind::Path);
        for (std::size_t i = 0; i < 3; ++i)
            COMPARE_NEAR(read.path.points[i], axis.path.points[i], 1e-12, "m");
        for (const AxisField& field : kAxisFields)
            QVERIFY(read.*field.value == axis.*field.value ||
                    std::abs(read.*field.value - axis.*field.value) < 1e-12);
        AxisJoint higher = read; // the whole curve goes up, and what rides on it with it
        for (Vec3& point : higher.path.points)
            point.y() += 0.05;
        setAxisJoint(scene, body, higher);
        const Vec3 rides = startOf().apply(scene.mechanics.joints[0].frameB.translation);
        double away = 1;
        for (const Pose& place : placesAlong(higher.path, 2000))
            away = std::min(away, (place.translation - rides).norm());
        COMPARE_NEAR(away, 0, 1e-4, "m");
        QCOMPARE_GT(rides.y(), at.apply({0.01, 0, 0}).y() + 0.02);
        const Scene before = scene;
        AxisJoint none = read;
        none.path.points.resize(1);
        setAxisJoint(scene, body, none);
        none.path.points = {{0, 0, 0}, {0, 0, 0}, {0.1, 0, 0}};
        setAxisJoint(scene, body, none);
        QVERIFY(scene == before);
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
