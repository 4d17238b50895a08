// Bodies, joints and colliders as bytes and back, and bytes that lie.
//
// What would show that a test here is wrong: a member that mechanicsBytes() forgets keeps its initial value,
// and every value here is another one than the initial.
#include <QTest>

#include "core/scene/mechanics_bytes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_mechanics_bytes {

using namespace tactum;

namespace {

Mechanics everything() {
    Mechanics mechanics;
    mechanics.gravity = {1, 2, 3};
    mechanics.airDensity = 1.25;
    RigidBody body;
    body.id = 7;
    body.name = "door";
    body.pose = {Quat(0.6, 0.8, 0, 0), Vec3(1, 2, 3)};
    body.mass = 2.5;
    body.centre = {0.1, 0.2, 0.3};
    body.inertia = {3, 4, 5};
    body.inertiaFrame = Quat(0.8, 0, 0.6, 0);
    body.velocity = {4, 5, 6};
    body.angularVelocity = {7, 8, 9};
    body.gravityFactor = 0.5;
    body.kinematic = true;
    mechanics.bodies.push_back(body);
    Joint joint;
    joint.name = "hinge";
    joint.b = 7;
    joint.frameA = joint.frameB = body.pose;
    joint.limits.push_back({true, 3, -kUnbounded, 0.5, 12, 0.25});
    joint.drives.push_back({true, 2, 1, 2, 3, 4, 5, true});
    joint.drives.push_back({});
    joint.frictions.push_back({true, 1, 0.75});
    joint.collide = true;
    joint.path = {{{1, 2, 3}, {4, 5, 6}}, {{0, 1, 0}, {1, 1, 0}}, true};
    mechanics.joints.push_back(joint);
    Collider collider;
    collider.body = 7;
    collider.pose = body.pose;
    collider.shape = {
        ShapeKind::Hull,
        Vec3(2, kUnbounded, 4),
        0.1,
        0.2,
        0.3,
        std::make_shared<const ShapeMesh>(ShapeMesh{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}, {{0, 1, 2}}})};
    collider.material = {0.1, 0.2, 0.3, Combine::Multiply, Combine::Minimum};
    collider.filter = {{"a"}, {"b", "c"}, {"d"}};
    mechanics.colliders.push_back(collider);
    return mechanics;
}

std::string bytesOf(Mechanics mechanics) {
    StringOut out;
    mechanicsBytes(out, mechanics);
    return out.bytes;
}

std::string refusalOf(const std::string& bytes) {
    ByteIn in(bytes, "it", 0, "do not trust it");
    Mechanics read;
    try {
        mechanicsBytes(in, read);
    } catch (const ByteFault& fault) {
        return fault.error.text;
    }
    return "";
}

} // namespace

class TestMechanicsBytes : public QObject {
    Q_OBJECT

private slots:
    void everythingComesBack() {
        const Mechanics before = everything();
        const std::string bytes = bytesOf(before);
        ByteIn in(bytes, "it", 0, "do not trust it");
        Mechanics after;
        mechanicsBytes(in, after);
        QVERIFY(after == before);
        QCOMPARE(in.left(), std::size_t(0));
    }

    void whatIsCutOffIsRefused() {
        const std::string bytes = bytesOf(everything());
        for (std::size_t length = 0; length < bytes.size(); ++length)
            QVERIFY2(!refusalOf(bytes.substr(0, length)).empty(), qPrintable(QString::number(length)));
    }

    void liesAreRefused() {
        Mechanics wrong = everything();
        wrong.joints[0].b = 8;
        COMPARE_CONTAINS(refusalOf(bytesOf(wrong)), "a joint names a body that there is not");
        wrong = everything();
        wrong.colliders[0].body = 8;
        COMPARE_CONTAINS(refusalOf(bytesOf(wrong)), "a collider names a body that there is not");
        wrong = everything();
        wrong.bodies[0].mass = -1;
        COMPARE_CONTAINS(refusalOf(bytesOf(wrong)), "no possible mass");
        wrong = everything();
        wrong.joints[0].drives[0].axis = 3;
        COMPARE_CONTAINS(refusalOf(bytesOf(wrong)), "none of three");
        wrong = everything();
        wrong.colliders[0].shape.mesh =
            std::make_shared<const ShapeMesh>(ShapeMesh{{{0, 0, 0}}, {{0, 0, 1}}});
        COMPARE_CONTAINS(refusalOf(bytesOf(wrong)), "a corner of a shape is not there");
    }

    // As large a scene moves as the small one does: lengths by the factor, times by its root.
    void scaledItKeepsItsMassesAndAngles() {
        const Mechanics before = everything(), after = scaled(before, 2, Vec3(1, 0, 0));
        COMPARE_NEAR(after.bodies[0].pose.translation, Vec3(0, 4, 6), 1e-15, "m");
        COMPARE_NEAR(after.bodies[0].inertia, Vec3(12, 16, 20), 1e-15, "kg m^2");
        QCOMPARE(after.bodies[0].mass, 2.5);
        QCOMPARE(after.joints[0].limits[0].max, 0.5); // an angle
        COMPARE_NEAR(after.joints[0].frameA.translation, Vec3(0, 4, 6), 1e-15, "m");
        COMPARE_NEAR(after.joints[0].frameB.translation, Vec3(2, 4, 6), 1e-15, "m");
        COMPARE_NEAR(after.colliders[0].shape.mesh->points[0], Vec3(2, 4, 6), 1e-15, "m");
    }
};

TACTUM_TEST(TestMechanicsBytes)

} // namespace test_mechanics_bytes

#include "test_mechanics_bytes.moc"
