// Scene to World: what is shared, what is left out, what is made safe.

#include <limits>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/test_program.h"

namespace test_compile {

using namespace tactum;
using namespace tactum::test;

class CompileTest : public QObject {
    Q_OBJECT

private slots:
    void materialEditRebuildsNothing();
    void poseAndRadiusChangeTheShape();
    void objectsThatShareASoupShareTheMesh();
    void invisibleObjectsAreNotTouched();
    void materialsAreMadeSafe();
    void sidesAreAShape();
    void hiddenSurfacesAreNotFelt();
    void otherSurfacesKeepTheHierarchy();
    void cancelledCompileSaysSo();
    void emptySceneIsAWorld();
    void plainSurfacesHaveNoFeels();
    void normalsAreComputedOnceAndShared();
    void texturesAreShared();
};

void CompileTest::materialEditRebuildsNothing() {
    Scene scene = sceneOf(ball(0.01, 2), frictionless());
    const auto first = compile(scene).value();
    scene.objects[0].surfaces[0].material = rough(0.5, 0.4);
    const auto second = compile(scene, first.get()).value();
    QCOMPARE(second->bodies[0].mesh.get(), first->bodies[0].mesh.get());
    QCOMPARE(second->obstacles[0].mesh, first->obstacles[0].mesh);
    QCOMPARE(second->obstacles[0].materials[0].staticFriction, 0.5);
    QCOMPARE_GT(second->revision, first->revision);
    QCOMPARE(second->shapeRevision, first->shapeRevision);
}

void CompileTest::poseAndRadiusChangeTheShape() {
    Scene scene = sceneOf(ball(0.01, 1), frictionless());
    const auto first = compile(scene).value();
    scene.objects[0].pose.translation.z() = 0.001;
    const auto moved = compile(scene, first.get()).value();
    QCOMPARE_GT(moved->shapeRevision, first->shapeRevision);
    QCOMPARE(moved->bodies[0].mesh.get(), first->bodies[0].mesh.get());
    scene.proxyRadius *= 2;
    const auto wider = compile(scene, moved.get()).value();
    QCOMPARE_GT(wider->shapeRevision, moved->shapeRevision);
    scene.objects[0].geometry = ball(0.01, 2);
    const auto other = compile(scene, wider.get()).value();
    QCOMPARE_GT(other->shapeRevision, wider->shapeRevision);
    QVERIFY(other->bodies[0].mesh != first->bodies[0].mesh);
    QCOMPARE(compile(scene, other.get()).value()->shapeRevision, other->shapeRevision);
}

void CompileTest::objectsThatShareASoupShareTheMesh() {
    Scene scene = sceneOf(ball(0.01, 1), frictionless());
    SceneObject twin = scene.objects[0];
    twin.pose.translation.x() = 0.1;
    scene.add(twin);
    const auto world = compile(scene).value();
    QCOMPARE(world->bodies.size(), std::size_t(2));
    QCOMPARE(world->bodies[0].mesh.get(), world->bodies[1].mesh.get());
    QCOMPARE_NE(world->bodies[0].object, world->bodies[1].object);
    // Both are touched where they are.
    for (double x : {0.0, 0.1}) {
        Hand hand(world);
        hand.to({x, 0, 0.02});
        hand.go({x, 0, 0.008}, 0.05);
        QCOMPARE_GT(hand.output().force.z(), 0.1);
    }
}

void CompileTest::invisibleObjectsAreNotTouched() {
    Scene scene = sceneOf(sheet(0.05), frictionless());
    scene.objects[0].visible = false;
    const auto world = compile(scene).value();
    QVERIFY(world->bodies.empty());
    Hand hand(world);
    hand.to({0, 0, 0.003});
    hand.go({0, 0, -0.003}, 0.05);
    QCOMPARE(hand.output().force, Vec3(Vec3::Zero()));
    QCOMPARE(hand.output().proxy, hand.finger());
}

void CompileTest::materialsAreMadeSafe() {
    Material wild;
    wild.stiffness = -5;
    wild.damping = 1e9;
    wild.staticFriction = 0.3;
    wild.dynamicFriction = 0.9;
    wild.viscosity = std::numeric_limits<double>::quiet_NaN();
    const auto world = worldOf(sheet(0.05), wild, 1e9);
    const Material& safe = world->obstacles[0].materials[0];
    QCOMPARE(safe.stiffness, kStiffness.minimum);
    QCOMPARE(safe.damping, kDamping.maximum);
    QCOMPARE(safe.staticFriction, 0.3);
    QCOMPARE(safe.dynamicFriction, 0.3);
    QCOMPARE(safe.viscosity, kViscosity.initial);
    QCOMPARE(world->proxyRadius, kProxyRadius.maximum);
}

// Another side: a contact from the side that is felt no more is void. Nothing is rebuilt.
void CompileTest::sidesAreAShape() {
    Scene scene = sceneOf(sheet(0.05), frictionless());
    const auto both = compile(scene).value();
    QVERIFY(both->obstacles[0].sides.empty());
    scene.objects[0].surfaces[0].sides = Sides::Front;
    const auto front = compile(scene, both.get()).value();
    QCOMPARE_NE(front->shapeRevision, both->shapeRevision);
    QCOMPARE(front->bodies[0].mesh.get(), both->bodies[0].mesh.get());
    for (double side : {1.0, -1.0}) {
        Hand hand(front);
        hand.to({0, 0, side * 0.003});
        hand.go({0, 0, -side * 0.003}, 0.05);
        QCOMPARE(hand.output().contacts, side > 0 ? 1 : 0);
    }
}

void CompileTest::hiddenSurfacesAreNotFelt() {
    Scene scene = sceneOf(sheet(0.05), frictionless());
    scene.objects[0].surfaces[0].visible = false;
    const auto world = compile(scene).value();
    Hand hand(world);
    hand.to({0, 0, 0.003});
    hand.go({0, 0, -0.003}, 0.05);
    QCOMPARE(hand.output().contacts, 0);
    QCOMPARE(hand.output().proxy.z(), -0.003);
}

void CompileTest::otherSurfacesKeepTheHierarchy() {
    Scene scene = sceneOf(sheet(0.05, 8), frictionless());
    scene.objects[0].surfaces[0].shading = {.on = true};
    const auto one = compile(scene).value();
    auto regrouped = std::make_shared<TriangleSoup>(*scene.objects[0].geometry);
    regrouped->surfaceOf.back() = 1;
    scene.objects[0].geometry = regrouped;
    scene.objects[0].surfaces.push_back(scene.objects[0].surfaces[0]);
    const auto two = compile(scene, one.get()).value();
    QCOMPARE(two->bodies[0].normals[0].get(), one->bodies[0].normals[0].get());
    QCOMPARE(two->bodies[0].mesh->soup.get(), regrouped.get());
    QCOMPARE(two->bodies[0].mesh->tree.nodes().size(), one->bodies[0].mesh->tree.nodes().size());
}

void CompileTest::cancelledCompileSaysSo() {
    const std::atomic<bool> cancelled{true};
    const auto result = compile(sceneOf(sheet(0.05), frictionless()), nullptr, Progress{{}, &cancelled});
    QVERIFY(!result);
    QVERIFY(!result.error().text.empty());
}

void CompileTest::emptySceneIsAWorld() {
    const auto world = compile(Scene{}).value();
    Hand hand(world);
    QCOMPARE(hand.to({0.01, 0.02, 0.03}).force, Vec3(Vec3::Zero()));
}

void CompileTest::plainSurfacesHaveNoFeels() {
    Scene scene = sceneOf(ball(0.01, 1), frictionless());
    QVERIFY(compile(scene).value()->obstacles[0].feels.empty());
    scene.objects[0].surfaces.resize(3);
    scene.objects[0].surfaces[2].shading.on = true;
    const auto world = compile(scene).value();
    QCOMPARE(world->obstacles[0].feels.size(), std::size_t(3));
    QVERIFY(!world->obstacles[0].feels[0].normals);
    QVERIFY(world->obstacles[0].feels[2].normals);
}

// A slider of friction must not wait for normals, and an edit of them not for a hierarchy.
void CompileTest::normalsAreComputedOnceAndShared() {
    Scene scene = sceneOf(ball(0.01, 2), frictionless());
    const auto flat = compile(scene).value();
    scene.objects[0].surfaces[0].shading.on = true;
    const auto first = compile(scene, flat.get()).value();
    QCOMPARE(first->shapeRevision, flat->shapeRevision);
    QCOMPARE(first->bodies[0].mesh.get(), flat->bodies[0].mesh.get());
    scene.objects[0].surfaces[0].material = rough(0.5, 0.4);
    SceneObject twin = scene.objects[0];
    scene.add(twin);
    const auto second = compile(scene, first.get()).value();
    for (int i = 0; i < 2; ++i)
        QCOMPARE(second->obstacles[i].feels[0].normals, first->obstacles[0].feels[0].normals);
    scene.objects[0].surfaces[0].shading.creaseAngle = 0.1;
    const auto sharp = compile(scene, second.get()).value();
    QCOMPARE_NE(sharp->obstacles[0].feels[0].normals, first->obstacles[0].feels[0].normals);
    QCOMPARE(sharp->obstacles[1].feels[0].normals, first->obstacles[0].feels[0].normals);
}

void CompileTest::texturesAreShared() {
    Scene scene = sceneOf(ball(0.01, 2), frictionless());
    scene.objects[0].surfaces[0].layers.resize(2);
    const auto first = compile(scene).value();
    QVERIFY(first->obstacles[0].feels[0].texture);
    scene.objects[0].surfaces[0].material = rough(0.5, 0.4);
    const auto second = compile(scene, first.get()).value();
    QCOMPARE(second->obstacles[0].feels[0].texture, first->obstacles[0].feels[0].texture);
    scene.objects[0].surfaces[0].layers[1].strength *= 2;
    const auto third = compile(scene, second.get()).value();
    QCOMPARE_NE(third->obstacles[0].feels[0].texture, first->obstacles[0].feels[0].texture);
}

TACTUM_TEST(CompileTest)

} // namespace test_compile

#include "test_compile.moc"
