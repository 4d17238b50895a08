// Scenes of several: what comes in keeps its feel and its joints under names and numbers of its own, copies
// hang together as what they are copies of, and what is taken out leaves nothing behind.
#include <QTest>

#include "core/scene/bodies.h"
#include "core/scene/compose.h"
#include "core/scene/findings.h"
#include "tests/core/scene/things.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_compose {

using namespace tactum;
using namespace tactum::test;

namespace {

/// The door of a doorway as a body on a hinge at the world, where the post stands.
struct HungDoor : Doorway {
    BodyId body;
    HungDoor() {
        body = makeBody(scene, door);
        setAxisJoint(scene, body, guessedJoint(scene, body, AxisKind::Hinge));
    }
};

const SceneObject& named(const Scene& scene, const char* name) {
    const auto found = std::ranges::find(scene.objects, name, &SceneObject::name);
    if (found == scene.objects.end()) qFatal("no object %s", name);
    return *found;
}

} // namespace

class TestCompose : public QObject {
    Q_OBJECT

private slots:
    void namesAreGivenOnce() {
        Scene scene;
        add(scene, "Cup", box({1, 1, 1}));
        add(scene, "cup 2", box({1, 1, 1}));
        add(scene, "7", box({1, 1, 1}));
        QCOMPARE(freeName(scene, "saucer"), "saucer");
        QCOMPARE(freeName(scene, "cup"), "cup 3");
        QCOMPARE(freeName(scene, "cup 2"), "cup 3");
        QCOMPARE(freeName(scene, "7"), "7 2");
        QCOMPARE(freeName(scene, ""), "");
    }

    // The second of the same file: all of it is there twice, nothing of one holds anything of the other.
    void aSceneComesInWhole() {
        const HungDoor one;
        Scene scene = one.scene;
        scene.objects[1].surfaces[0].material.stiffness = 321;
        Scene other = one.scene;
        other.objects[1].surfaces[0].material.stiffness = 123;
        arrange(other, allOf(other), {.move = {0.3, 0, 0}});
        const std::vector<ObjectId> added = addScene(scene, other, 40);
        QCOMPARE(added, (std::vector<ObjectId>{41, 42}));
        QCOMPARE(scene.objects.size(), std::size_t(4));
        QCOMPARE_EQ(named(scene, "door").surfaces[0].material.stiffness, 321.0);
        QCOMPARE_EQ(named(scene, "door 2").surfaces[0].material.stiffness, 123.0);
        QCOMPARE(named(scene, "door 2").geometry, one.scene.find(one.door)->geometry);
        QCOMPARE(scene.mechanics.bodies.size(), std::size_t(2));
        QCOMPARE(scene.mechanics.joints.size(), std::size_t(2));
        const Joint& joint = scene.mechanics.joints[1];
        QCOMPARE_EQ(joint.b, named(scene, "door 2").body);
        QVERIFY(joint.b != one.body);
        QVERIFY(joint.part != scene.mechanics.joints[0].part);
        // What moves along with the second post is the second door alone.
        const ObjectId post = named(scene, "post 2").id;
        QCOMPARE(goingAlong(scene, std::array{post}).objects,
                 (std::vector<ObjectId>{post, named(scene, "door 2").id}));
        QCOMPARE(validate(scene).size(), 2 * validate(one.scene).size());
    }

    void anEmptySceneBecomesTheOther() {
        const HungDoor one;
        Scene scene, other = one.scene;
        other.proxyRadius = 0.002, other.mechanics.gravity = {0, -1.6, 0};
        other.finger = std::make_shared<const std::vector<FingerPoint>>(3);
        addScene(scene, other);
        QVERIFY(scene == other);
        addScene(scene, Scene(one.scene));
        QCOMPARE_EQ(scene.proxyRadius, 0.002);
        COMPARE_NEAR(scene.mechanics.gravity, (Vec3(0, -1.6, 0)), 1e-12, "m/s^2");
        QCOMPARE(scene.finger, other.finger);
    }

    // Whichever comes first: a body lies on a plate of the other scene.
    void bodiesLieOnWhatComesToThem() {
        const auto lies = [](const Scene& scene, const char* name) {
            return !collidersOf(scene, named(scene, name)).empty();
        };
        Scene plate, ball;
        add(plate, "plate", box({0.1, 0.01, 0.1}));
        makeBody(ball, add(ball, "ball", box({0.02, 0.02, 0.02}), {Quat::Identity(), {0, 0.1, 0}}));
        Scene first = plate, second = ball;
        addScene(first, ball);
        addScene(second, plate);
        QVERIFY(lies(first, "plate"));
        QVERIFY(lies(second, "plate"));
        Scene still = plate;
        addScene(still, plate);
        QVERIFY(still.mechanics.colliders.empty());
    }

    void otherProgramsPartsStayWithTheirFile() {
        Scene scene, other;
        add(scene, "a", box({1, 1, 1}));
        add(other, "b", box({1, 1, 1}));
        other.objects[0].kept.index = other.objects[0].surfaces[0].kept.index = 3;
        other.kept.foreign = std::make_shared<const ForeignGltf>();
        addScene(scene, other);
        QVERIFY(!scene.kept.foreign);
        QCOMPARE(scene.objects[1].kept.index, -1);
        QCOMPARE(scene.objects[1].surfaces[0].kept.index, -1);
        Scene empty;
        addScene(empty, other);
        QCOMPARE(empty.kept.foreign, other.kept.foreign);
        QCOMPARE(empty.objects[0].kept.index, 3);
    }

    // A door alone: its copy hangs where it hangs. With the post: on the copy of that.
    void aCopyHangsAsItsOriginalDoes() {
        const HungDoor one;
        Scene scene = one.scene;
        const auto copy = [&](ObjectId id) {
            return addCopies(scene, one.scene, goingAlong(one.scene, std::array{id}));
        };
        QCOMPARE(copy(one.door).size(), std::size_t(1));
        QCOMPARE_EQ(scene.mechanics.joints.back().part, one.scene.mechanics.joints[0].part);
        QCOMPARE(scene.mechanics.joints.back().frameA, one.scene.mechanics.joints[0].frameA);
        QCOMPARE(copy(one.post).size(), std::size_t(2));
        QVERIFY(scene.mechanics.joints.back().part != one.scene.mechanics.joints[0].part);
        QCOMPARE(named(scene, "door 3").body, scene.mechanics.joints.back().b);
    }

    void whatIsTakenOutLeavesNothing() {
        HungDoor one;
        const Scene before = one.scene;
        ObjectId knob = add(one.scene, "knob", box({0.01, 0.01, 0.01}), {Quat::Identity(), {0.03, 0, 0.01}});
        const BodyId body = makeBody(one.scene, knob);
        AxisJoint on = guessedJoint(one.scene, body, AxisKind::Hinge);
        on.to = one.body;
        setAxisJoint(one.scene, body, on);
        const Removed removed = removeObjects(one.scene, std::array{one.door, ObjectId(99)});
        QCOMPARE(removed.objects, std::size_t(1));
        QCOMPARE(removed.joints, std::size_t(2));
        QCOMPARE(removed.loose, std::vector<std::string>{"knob"});
        QCOMPARE(one.scene.mechanics.bodies.size(), std::size_t(1));
        QVERIFY(one.scene.mechanics.joints.empty());
        QCOMPARE(removeObjects(one.scene, std::array{knob, one.post}).objects, std::size_t(2));
        QVERIFY(one.scene.mechanics.colliders.empty());
    }
};

TACTUM_TEST(TestCompose)

} // namespace test_compose

#include "test_compose.moc"
