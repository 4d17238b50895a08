// Bodies and joints as X3D: the names are those of ISO/IEC 19775-1:2013, 37.4, the numbers are worked out by
// hand.
#include <filesystem>
#include <numbers>

#include <QTest>

#include "core/files/load_scene.h"
#include "core/files/x3d/write_x3d.h"
#include "tests/core/files/bodies.h"
#include "tests/core/files/mesh_files.h"
#include "tests/core/files/parsed_xml.h"
#include "tests/core/files/x3d_scenes.h"
#include "tests/support/compare.h"
#include "tests/support/random_mechanics.h"
#include "tests/support/test_program.h"

namespace test_write_x3d_bodies {

using namespace tactum;
using namespace tactum::test;

namespace {

struct Node {
    QStringList fields, into; ///< and the fields of others that take it, as "Node.field"
};

/// Of the nodes that we write: field by field out of the standard.
const QMap<QString, Node> kStandard{
    {"RigidBodyCollection",
     {{"autoDisable", "constantForceMix", "contactSurfaceThickness", "disableAngularSpeed",
       "disableLinearSpeed", "disableTime", "enabled", "errorCorrection", "gravity", "iterations",
       "maxCorrectionSpeed", "preferAccuracy"},
      {}}},
    {"RigidBody",
     {{"angularDampingFactor",
       "angularVelocity",
       "autoDamp",
       "autoDisable",
       "centerOfMass",
       "disableAngularSpeed",
       "disableLinearSpeed",
       "disableTime",
       "enabled",
       "finiteRotationAxis",
       "fixed",
       "forces",
       "inertia",
       "linearDampingFactor",
       "linearVelocity",
       "mass",
       "orientation",
       "position",
       "torques",
       "useFiniteRotation",
       "useGlobalGravity"},
      {"RigidBodyCollection.bodies", "SingleAxisHingeJoint.body1", "SingleAxisHingeJoint.body2",
       "SliderJoint.body1", "SliderJoint.body2", "BallJoint.body1", "BallJoint.body2", "UniversalJoint.body1",
       "UniversalJoint.body2"}}},
    {"CollisionCollection",
     {{"appliedParameters", "bounce", "enabled", "frictionCoefficients", "minBounceSpeed", "slipFactors",
       "softnessConstantForceMix", "softnessErrorCorrection", "surfaceSpeed"},
      {"RigidBodyCollection.collider"}}},
    {"CollidableOffset",
     {{"enabled", "rotation", "translation", "bboxCenter", "bboxSize"},
      {"RigidBody.geometry", "CollisionCollection.collidables"}}},
    {"CollidableShape",
     {{"enabled", "rotation", "translation", "bboxCenter", "bboxSize"},
      {"CollidableOffset.collidable", "CollisionCollection.collidables", "RigidBody.geometry"}}},
    {"SingleAxisHingeJoint",
     {{"anchorPoint", "axis", "forceOutput", "maxAngle", "minAngle", "stopBounce", "stopErrorCorrection"},
      {"RigidBodyCollection.joints"}}},
    {"SliderJoint",
     {{"axis", "forceOutput", "maxSeparation", "minSeparation", "sliderForce", "stopBounce",
       "stopErrorCorrection"},
      {"RigidBodyCollection.joints"}}},
    {"BallJoint", {{"anchorPoint", "forceOutput"}, {"RigidBodyCollection.joints"}}},
    {"UniversalJoint",
     {{"anchorPoint", "axis1", "axis2", "forceOutput", "stop1Bounce", "stop1ErrorCorrection", "stop2Bounce",
       "stop2ErrorCorrection"},
      {"RigidBodyCollection.joints"}}},
    {"Shape", {{"bboxCenter", "bboxSize"}, {"CollidableShape.shape"}}},
    {"Box", {{"size", "solid"}, {"Shape.geometry"}}},
    {"Sphere", {{"radius", "solid"}, {"Shape.geometry"}}},
    {"Cylinder", {{"bottom", "height", "radius", "side", "solid", "top"}, {"Shape.geometry"}}},
    {"IndexedFaceSet", {{"ccw", "convex", "coordIndex", "creaseAngle", "solid"}, {"Shape.geometry"}}},
};

Vec3 vector(const Element& node, const QString& field) {
    const auto of = node.numbers(field);
    return of.size() == 3 ? Vec3(of[0], of[1], of[2]) : Vec3::Constant(NAN);
}

Pose poseOf(const Element& transform) {
    const auto turn = transform.attributes.contains("rotation") ? transform.numbers("rotation")
                                                                : std::vector<double>{0, 0, 1, 0};
    return {Quat(Eigen::AngleAxisd(turn[3], Vec3(turn[0], turn[1], turn[2]))),
            vector(transform, "translation")};
}

/// A body of 2 kg at (1,0,0) on a hinge about its own z, turned by 0.3 at first, with stops at -0.5 and 1.
Scene door() {
    Scene scene;
    SceneObject object = bodyOf("door", ball(0.05, 0));
    object.body = 1;
    object.pose.translation = {1, 0, 0};
    scene.add(object);
    RigidBody body;
    body.id = 1;
    body.name = "door";
    body.mass = 2;
    body.pose = {Quat(Eigen::AngleAxisd(0.3, Vec3::UnitZ())), {1, 0, 0}};
    body.centre = {0.1, 0, 0};
    body.inertia = {1, 2, 3};
    scene.mechanics.bodies = {body};
    Joint hinge;
    hinge.name = "hinge";
    hinge.b = 1;
    hinge.frameA.translation = {1, 0, 0};
    hinge.limits = {{.min = 0, .max = 0},
                    {.angular = true, .axes = 3, .min = 0, .max = 0},
                    {.angular = true, .axes = 4, .min = -0.5, .max = 1}};
    scene.mechanics.joints = {hinge};
    Collider collider;
    collider.body = 1;
    collider.pose.translation = {0, 0.2, 0};
    collider.shape.size = {0.1, 0.2, 0.3};
    scene.mechanics.colliders = {collider};
    return scene;
}

/// "name: what" of all that is not kept.
QStringList lost(const X3dExport& written) {
    QStringList list;
    for (const Loss& loss : written.losses)
        if (loss.kind != LossKind::Kept)
            list << QString::fromStdString(loss.object + ": " + loss.what + ": " + loss.sentence);
    return list;
}

} // namespace

class TestWriteX3dBodies : public QObject {
    Q_OBJECT
private slots:
    // The net is wide enough: a node or a field that the standard does not know is found.
    void theStandardFindsAMistake() {
        Element wrong = parsed("<RigidBodyCollection gravity='0 0 0'><RigidBody containerField='bodies' "
                               "weight='1'/><Box containerField='joints'/></RigidBodyCollection>");
        QCOMPARE(faultsOf(wrong),
                 QStringList({"RigidBody has no weight", "Box is no RigidBodyCollection.joints"}));
    }

    void everyNodeAndFieldIsOfTheStandard() {
        std::vector<Scene> scenes;
        for (const auto& each : std::filesystem::directory_iterator(TACTUM_SAMPLES "/moving"))
            if (each.path().extension() == ".glb") {
                auto loaded = loadScene(each.path());
                VERIFY_RESULT(loaded);
                scenes.push_back(loaded->scene);
            }
        QCOMPARE_GE(scenes.size(), std::size_t(13));
        std::mt19937 random(1);
        for (int i = 0; i < 200; ++i) {
            Scene scene;
            scene.add(bodyOf("a", ball(0.05, 0)));
            MechanicsDice(random).addTo(scene);
            scenes.push_back(scene);
        }
        scenes.push_back(door()); // no sample has one of these
        scenes.back().mechanics.joints[0].limits = {{.min = 0, .max = 0},
                                                    {.angular = true, .axes = 1, .min = 0, .max = 0}};
        QSet<QString> seen;
        for (const Scene& scene : scenes) {
            const Element root = parsed(x3dOf(scene).scene);
            const Element& collection = root.one("RigidBodyCollection");
            QCOMPARE(faultsOf(collection), QStringList());
            QMap<QString, QString> defs;
            for (const Element* node : root.all())
                if (const QString def = node->attributes.value("DEF"); !def.isEmpty()) {
                    QVERIFY2(!defs.contains(def), qPrintable(def));
                    defs[def] = node->name;
                }
            for (const Element* node : collection.all()) {
                seen << node->name;
                if (const QString use = node->attributes.value("USE"); !use.isEmpty())
                    QCOMPARE(defs.value(use), node->name);
            }
            for (const Element* route : root.all("ROUTE"))
                for (const char* end : {"fromNode", "toNode"})
                    QVERIFY2(defs.contains(route->attributes[end]), qPrintable(route->attributes[end]));
        }
        for (const QString& node : kStandard.keys()) // or the test is about less than it says
            QVERIFY2(seen.contains(node), qPrintable(node));
    }

    void aBodyIsWhatItWeighs() {
        const Element root = parsed(x3dOf(door()).scene);
        const Element& body = *root.all("RigidBody").front();
        const Quat turn(Eigen::AngleAxisd(0.3, Vec3::UnitZ()));
        const Vec3 centre = Vec3(1, 0, 0) + turn * Vec3(0.1, 0, 0);
        QCOMPARE(body.number("mass"), 2.0);
        COMPARE_NEAR(vector(body, "position"), centre, 1e-15, "m");
        QVERIFY(!body.attributes.contains("orientation")); // along the axes of the world at first
        const double c = std::cos(0.3), s = std::sin(0.3);
        const std::vector<double> inertia = body.numbers("inertia"),
                                  wanted{c * c + 2 * s * s, -c * s, 0, -c * s, s * s + 2 * c * c, 0, 0, 0, 3};
        QCOMPARE(inertia.size(), wanted.size());
        for (std::size_t i = 0; i < wanted.size(); ++i)
            COMPARE_NEAR(inertia[i], wanted[i], 1e-12, "kg m^2");
        const Pose collider = poseOf(body.one("CollidableOffset"));
        COMPARE_NEAR(centre + collider.apply({0.05, 0, 0}), Vec3(1, 0, 0) + turn * Vec3(0.05, 0.2, 0), 1e-12,
                     "m");
        COMPARE_NEAR(vector(root.one("Box"), "size"), Vec3(0.1, 0.2, 0.3), 1e-15, "m");
    }

    // What the body does to the object: turned by a quarter about its centre it takes the object along.
    void aBodyLeadsItsObject() {
        const Scene scene = door();
        const Element root = parsed(x3dOf(scene).scene);
        const auto transforms = root.all("Transform");
        QCOMPARE(transforms.size(), std::size_t(3));
        const QString body = root.all("RigidBody").front()->attributes["DEF"];
        QStringList routes;
        for (const Element* route : root.all("ROUTE"))
            routes << route->attributes["fromNode"] + "." + route->attributes["fromField"] + " " +
                          route->attributes["toNode"] + "." + route->attributes["toField"];
        const QString led = transforms[0]->attributes["DEF"];
        QCOMPARE(routes, QStringList({body + ".position " + led + ".translation",
                                      body + ".orientation " + led + ".rotation"}));
        const Pose within = poseOf(*transforms[1]) * poseOf(*transforms[2]);
        COMPARE_NEAR((poseOf(*transforms[0]) * within).apply({0, 0, 0.05}), Vec3(1, 0, 0.05), 1e-12, "m");
        const Vec3 centre = vector(*root.all("RigidBody").front(), "position");
        const Pose quarter{Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ())), centre};
        const Vec3 arm = Vec3(1, 0, 0) - centre;
        COMPARE_NEAR((quarter * within).apply(Vec3::Zero()), centre + Vec3(-arm.y(), arm.x(), 0), 1e-12, "m");
    }

    // Angles count from where it is at first; a joint that is said the other way round is the same one.
    void aHingeHasItsStops() {
        Scene scene = door();
        for (const bool turned : {false, true}) {
            Joint& joint = scene.mechanics.joints[0];
            if (turned) {
                std::swap(joint.a, joint.b), std::swap(joint.frameA, joint.frameB);
                joint.limits[2].min = -1, joint.limits[2].max = 0.5;
            }
            const Element root = parsed(x3dOf(scene).scene);
            const Element& hinge = root.one("SingleAxisHingeJoint");
            COMPARE_NEAR(vector(hinge, "anchorPoint"), Vec3(1, 0, 0), 1e-15, "m");
            COMPARE_NEAR(vector(hinge, "axis"), Vec3(0, 0, 1), 1e-15, "");
            COMPARE_NEAR(hinge.number("minAngle"), -0.8, 1e-12, "rad");
            COMPARE_NEAR(hinge.number("maxAngle"), 0.7, 1e-12, "rad");
            QCOMPARE(hinge.children.size(), std::size_t(1));
            QCOMPARE(hinge.children[0].attributes["containerField"], QString("body1"));
        }
    }

    void jointsAreTheirFreedoms_data() {
        QTest::addColumn<int>("slides");
        QTest::addColumn<int>("turns");
        QTest::addColumn<QString>("node");
        QTest::newRow("fixed") << 0 << 0 << "SliderJoint";
        QTest::newRow("slider") << 2 << 0 << "SliderJoint";
        QTest::newRow("hinge") << 0 << 1 << "SingleAxisHingeJoint";
        QTest::newRow("universal") << 0 << 5 << "UniversalJoint";
        QTest::newRow("ball") << 0 << 7 << "BallJoint";
        QTest::newRow("cylinder") << 1 << 1 << "";
        QTest::newRow("planar") << 3 << 4 << "";
    }
    void jointsAreTheirFreedoms() {
        QFETCH(int, slides);
        QFETCH(int, turns);
        QFETCH(QString, node);
        Scene scene = door();
        Joint& joint = scene.mechanics.joints[0];
        joint.frameA = joint.frameB = {};
        scene.mechanics.bodies[0].pose = {};
        joint.limits = {{.axes = AxisSet(7 - slides), .min = 0, .max = 0},
                        {.angular = true, .axes = AxisSet(7 - turns), .min = 0, .max = 0}};
        const X3dExport written = x3dOf(scene);
        const Element root = parsed(written.scene);
        const QString said = lost(written).filter("hinge: joint").join(' ');
        const Element& body = *root.all("RigidBody").front();
        if (node.isEmpty()) { // it does not fall, and it is said
            QCOMPARE(body.attributes["fixed"], QString("true"));
            COMPARE_CONTAINS(said.toStdString(), "stand still");
            QCOMPARE(root.all("ROUTE").size(), std::size_t(0));
            return;
        }
        QCOMPARE(said, QString());
        const Element& found = root.one(node);
        if (node == "SliderJoint") {
            QCOMPARE(found.number("maxSeparation") - found.number("minSeparation") > 0, slides != 0);
            COMPARE_NEAR(vector(found, "axis"), slides == 2 ? Vec3(0, 1, 0) : Vec3(1, 0, 0), 1e-15, "");
        }
        if (node == "UniversalJoint") { // y is held: z stands on a, x on b, which is the first body
            COMPARE_NEAR(vector(found, "axis1"), Vec3(1, 0, 0), 1e-15, "");
            QVERIFY(!found.attributes.contains("axis"));
            COMPARE_NEAR(vector(found, "axis2"), Vec3(0, 0, 1), 1e-15, "");
        }
    }

    // Each thing in one line.
    void whatX3dLacksIsSaid() {
        Scene scene = door();
        QCOMPARE(lost(x3dOf(scene)).filter("joint").size(), 1); // the hand that does not push
        Mechanics& of = scene.mechanics;
        of.airDensity = 1.2;
        of.timeScale = 2;
        of.joints[0].drives = {{.angular = true, .axis = 2, .stiffness = 1, .spacing = 0.1}};
        of.joints[0].limits.push_back({.angular = true, .axes = 4, .min = -1, .max = 1, .stiffness = 5});
        of.joints[0].frictions = {{.angular = true, .axis = 2, .force = 1}};
        of.bodies[0].gravityFactor = 0.5;
        of.bodies[0].inertia.x() = 0;
        of.colliders.push_back(of.colliders[0]);
        of.colliders[1].material.restitution = 1;
        const QStringList said = lost(x3dOf(scene));
        for (const char* what :
             {"air that", "scaled to the bodies", "springs, motors", "detents", "hinge: limits",
              "door: gravity factor", "door: moments", "friction, bounce and filters"})
            QVERIFY2(said.filter(what).size() == 1, qPrintable(what + (": " + said.join('\n'))));
    }

    // Shapes of bodies are no objects.
    void ourReaderSeesTheObjectsAlone() {
        const auto loaded = loadScene(folder_.write("own.x3d", x3dOf(door()).scene));
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects.size(), std::size_t(1));
        QCOMPARE(loaded->scene.objects[0].name, std::string("door"));
        COMPARE_NEAR(loaded->scene.objects[0].geometry->positions[0] +
                         loaded->scene.objects[0].pose.translation,
                     door().objects[0].geometry->positions[0] + Vec3(1, 0, 0), 1e-6, "m");
    }

private:
    /// What the standard does not know of this node and those below.
    static QStringList faultsOf(const Element& node) {
        QStringList faults;
        for (const QString& field : node.attributes.keys())
            if (field != "DEF" && field != "USE" && field != "containerField" &&
                !kStandard[node.name].fields.contains(field))
                faults << node.name + " has no " + field;
        for (const Element& child : node.children) {
            if (child.name == "Coordinate") continue;
            const QString place = node.name + "." + child.attributes["containerField"];
            if (kStandard[child.name].into.contains(place))
                faults << faultsOf(child);
            else
                faults << child.name + " is no " + place;
        }
        return faults;
    }

    FileFolder folder_;
};

TACTUM_TEST(TestWriteX3dBodies)

} // namespace test_write_x3d_bodies

#include "test_write_x3d_bodies.moc"
