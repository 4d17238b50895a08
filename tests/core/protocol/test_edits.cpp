// Edits as they come over the wire: what they do to a scene, and what is refused.
#include <limits>

#include <QTest>

#include "core/protocol/edits.h"
#include "core/scene/bodies.h"
#include "tests/support/compare.h"
#include "tests/support/soups.h"
#include "tests/support/test_program.h"

namespace test_edits {

using namespace tactum;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN(),
                 kInf = std::numeric_limits<double>::infinity();

/// A ball and a sheet, the ball with two surfaces.
Scene twoObjects() {
    Scene scene;
    SceneObject ball;
    ball.name = "ball";
    ball.geometry = test::ball(0.02, 1);
    ball.surfaces.resize(2);
    scene.add(ball);
    SceneObject sheet;
    sheet.name = "sheet";
    sheet.geometry = test::sheet(0.1);
    sheet.surfaces.resize(1);
    scene.add(sheet);
    return scene;
}

Result<void> make(
    Scene& scene, const v1::Edit& edit, const UploadOf& uploadOf = [](auto) { return nullptr; }) {
    v1::Transaction transaction;
    *transaction.add_edit() = edit;
    SceneParts parts;
    return makeEdits(scene, transaction.edit(), uploadOf, parts);
}

v1::Edit material(std::uint32_t object, std::optional<std::uint32_t> surface, double stiffness) {
    v1::Edit edit;
    edit.mutable_material()->mutable_where()->set_object(object);
    if (surface) edit.mutable_material()->mutable_where()->set_surface(*surface);
    edit.mutable_material()->set_stiffness(stiffness);
    return edit;
}

void set(v1::Vector* to, double x, double y, double z) {
    to->set_x(x), to->set_y(y), to->set_z(z);
}

} // namespace

class TestEdits : public QObject {
    Q_OBJECT

private slots:
    void materialReachesWhatItNames();
    void frictionNeverContradictsItself();
    void posesAreMadeWhole();
    void layersOfNoiseAndOfImages();
    void bodiesAndJoints();
    void uploadsAreAddedAndOpened();
    void removingAndClearing();
    void numbersThatCannotBeAreRefused_data();
    void numbersThatCannotBeAreRefused();
    void theErrorNamesTheEdit();
};

void TestEdits::materialReachesWhatItNames() {
    Scene scene = twoObjects();
    const ObjectId ball = scene.objects[0].id;
    VERIFY_RESULT(make(scene, material(ball, 1, 300)));
    QCOMPARE_EQ(scene.objects[0].surfaces[1].material.stiffness, 300.0);
    QCOMPARE_EQ(scene.objects[0].surfaces[0].material.stiffness, kStiffness.initial);
    VERIFY_RESULT(make(scene, material(ball, {}, 310)));
    QCOMPARE_EQ(scene.objects[0].surfaces[0].material.stiffness, 310.0);
    QCOMPARE_EQ(scene.objects[1].surfaces[0].material.stiffness, kStiffness.initial);
    VERIFY_RESULT(make(scene, material(0, {}, 320)));
    QCOMPARE_EQ(scene.objects[1].surfaces[0].material.stiffness, 320.0);
}

void TestEdits::frictionNeverContradictsItself() {
    Scene scene = twoObjects();
    v1::Edit edit;
    edit.mutable_material()->set_dynamic_friction(0.4);
    VERIFY_RESULT(make(scene, edit));
    QCOMPARE_EQ(scene.objects[0].surfaces[0].material.staticFriction, 0.4); // brought along
    edit.mutable_material()->set_static_friction(0.3);
    QVERIFY(!make(scene, edit));
    edit.mutable_material()->set_static_friction(0.5);
    VERIFY_RESULT(make(scene, edit));
    QCOMPARE_EQ(scene.objects[0].surfaces[0].material.staticFriction, 0.5);
    QCOMPARE_EQ(scene.objects[0].surfaces[0].material.dynamicFriction, 0.4);
}

void TestEdits::posesAreMadeWhole() {
    Scene scene = twoObjects();
    v1::Edit edit;
    edit.mutable_pose()->set_object(scene.objects[0].id);
    set(edit.mutable_pose()->mutable_pose()->mutable_position(), 1, 2, 3);
    v1::Rotation* turn = edit.mutable_pose()->mutable_pose()->mutable_rotation();
    turn->set_w(2), turn->set_z(2);
    VERIFY_RESULT(make(scene, edit));
    COMPARE_NEAR(scene.objects[0].pose.translation, Vec3(1, 2, 3), 1e-15, "m");
    COMPARE_NEAR(scene.objects[0].pose.rotation.norm(), 1.0, 1e-15, "");
    turn->set_w(0), turn->set_z(0);
    COMPARE_CONTAINS(test::refusal(make(scene, edit)), "no length");
}

void TestEdits::layersOfNoiseAndOfImages() {
    Scene scene = twoObjects();
    v1::Edit edit;
    v1::Layer* noise = edit.mutable_layers()->add_layer();
    noise->set_source("noise"), noise->set_strength(1e-4), noise->set_size(0.01);
    v1::Layer* image = edit.mutable_layers()->add_layer();
    image->set_source("image"), image->set_target("static-friction"), image->set_strength(0.5);
    image->mutable_image()->set_width(2), image->mutable_image()->set_height(1);
    const std::uint16_t texels[2] = {0, 65535};
    image->mutable_image()->set_texels(texels, sizeof texels);
    VERIFY_RESULT(make(scene, edit));
    const auto& layers = scene.objects[1].surfaces[0].layers;
    QCOMPARE_EQ(layers.size(), std::size_t(2));
    QCOMPARE_EQ(layers[0].pattern.size, 0.01);
    QCOMPARE_EQ(int(layers[1].target), int(TextureTarget::StaticFriction));
    QCOMPARE_EQ(layers[1].pattern.image->row(0)[1], std::uint16_t(65535));
    image->mutable_image()->set_height(2);
    COMPARE_CONTAINS(test::refusal(make(scene, edit)), "texels");
    image->set_source("magic");
    COMPARE_CONTAINS(test::refusal(make(scene, edit)), "magic");
}

void TestEdits::bodiesAndJoints() {
    Scene scene = twoObjects();
    const ObjectId ball = scene.objects[0].id;
    v1::Edit body, joint;
    joint.mutable_joint()->set_object(ball);
    joint.mutable_joint()->set_kind("hinge");
    set(joint.mutable_joint()->mutable_axis(), 0, 3, 0);
    QVERIFY(!make(scene, joint)); // no body yet
    body.mutable_body()->set_object(ball);
    body.mutable_body()->set_mass(0.25);
    VERIFY_RESULT(make(scene, body));
    QCOMPARE_EQ(scene.mechanics.bodies.size(), std::size_t(1));
    QCOMPARE_EQ(scene.mechanics.bodies[0].mass, 0.25);
    joint.mutable_joint()->set_damping(0.01);
    VERIFY_RESULT(make(scene, joint));
    const auto made = axisJointOf(scene, scene.objects[0].body);
    QVERIFY(made.has_value());
    COMPARE_NEAR(made->axis, Vec3::UnitY(), 1e-12, "");
    QCOMPARE_EQ(made->damping, 0.01);
    v1::Edit pose;
    pose.mutable_pose()->set_object(ball);
    QVERIFY(!make(scene, pose)); // forces move it
    body.mutable_body()->set_mass(0);
    VERIFY_RESULT(make(scene, body));
    QCOMPARE_EQ(scene.mechanics.bodies.size(), std::size_t(0));
}

void TestEdits::uploadsAreAddedAndOpened() {
    auto loaded = std::make_shared<LoadedScene>();
    SceneObject object;
    object.geometry = test::sheet(1);
    object.surfaces.resize(1);
    loaded->scene.add(object);
    const auto uploadOf = [&](std::uint64_t number) {
        return number == 7 ? std::shared_ptr<const LoadedScene>(loaded) : nullptr;
    };
    Scene scene = twoObjects();
    v1::Edit edit;
    edit.mutable_add()->set_upload(7);
    edit.mutable_add()->set_name("new\x1b[31m");
    set(edit.mutable_add()->mutable_pose()->mutable_position(), 0, 1, 0);
    VERIFY_RESULT(make(scene, edit, uploadOf));
    QCOMPARE_EQ(scene.objects.size(), std::size_t(3));
    COMPARE_LACKS(scene.objects[2].name, "\x1b");
    COMPARE_NEAR(scene.objects[2].pose.translation, Vec3(0, 1, 0), 1e-15, "m");
    QVERIFY(scene.objects[2].id != scene.objects[0].id);
    edit.mutable_add()->set_upload(8);
    COMPARE_CONTAINS(test::refusal(make(scene, edit, uploadOf)), "no upload 8");
    edit.mutable_open()->set_upload(7);
    edit.mutable_open()->set_fit_diagonal(0.2);
    VERIFY_RESULT(make(scene, edit, uploadOf));
    QCOMPARE_EQ(scene.objects.size(), std::size_t(1));
    COMPARE_NEAR(boundsOf(scene).diagonal(), 0.2, 1e-12, "m");
    for (const double never : {1e-7, 1e7, -0.2}) {
        edit.mutable_open()->set_fit_diagonal(never);
        COMPARE_CONTAINS(test::refusal(make(scene, edit, uploadOf)), "from 1e-6 to 1e6 m");
    }
}

void TestEdits::removingAndClearing() {
    Scene scene = twoObjects();
    v1::Edit edit;
    edit.set_remove(scene.objects[0].id);
    VERIFY_RESULT(make(scene, edit));
    QCOMPARE_EQ(scene.objects.size(), std::size_t(1));
    QVERIFY(!make(scene, edit)); // it is gone
    edit.mutable_clear();
    VERIFY_RESULT(make(scene, edit));
    QVERIFY(scene.objects.empty());
}

void TestEdits::numbersThatCannotBeAreRefused_data() {
    QTest::addColumn<double>("value");
    for (const auto& [name, value] : {std::pair{"nan", kNaN}, {"inf", kInf}, {"-inf", -kInf}, {"far", 1e300}})
        QTest::newRow(name) << value;
}

void TestEdits::numbersThatCannotBeAreRefused() {
    QFETCH(double, value);
    const Scene before = twoObjects();
    std::vector<v1::Edit> edits(8);
    edits[0] = material(0, {}, value);
    edits[1].mutable_material()->set_viscosity(value);
    edits[2].set_proxy_radius(value);
    set(edits[3].mutable_gravity(), 0, value, 0);
    edits[4].mutable_pose()->set_object(before.objects[0].id);
    set(edits[4].mutable_pose()->mutable_pose()->mutable_position(), value, 0, 0);
    edits[5].mutable_pose()->set_object(before.objects[0].id);
    edits[5].mutable_pose()->mutable_pose()->mutable_rotation()->set_w(value);
    edits[6].mutable_layers()->add_layer()->set_strength(value);
    edits[7].mutable_body()->set_object(before.objects[0].id);
    edits[7].mutable_body()->set_mass(value);
    for (std::size_t i = 0; i < edits.size(); ++i) {
        Scene scene = before;
        QVERIFY2(!make(scene, edits[i]), qPrintable(QString::number(i)));
    }
}

void TestEdits::theErrorNamesTheEdit() {
    Scene scene = twoObjects();
    v1::Transaction transaction;
    *transaction.add_edit() = material(0, {}, 300);
    *transaction.add_edit() = material(99, {}, 300);
    SceneParts parts;
    const auto made = makeEdits(
        scene, transaction.edit(), [](auto) { return nullptr; }, parts);
    COMPARE_BEGINS(test::refusal(made), "edit 2: there is no object 99");
    *transaction.mutable_edit(1) = v1::Edit{}; // of a newer client, say
    COMPARE_CONTAINS(test::refusal(makeEdits(
                         scene, transaction.edit(), [](auto) { return nullptr; }, parts)),
                     "newer");
}

TACTUM_TEST(TestEdits)

} // namespace test_edits

#include "test_edits.moc"
