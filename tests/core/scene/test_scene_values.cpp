// Scenes as values: finding and adding, boxes, scaling, descriptions, finger paths.
#include <cmath>
#include <limits>

#include <QTest>

#include "core/scene/describe.h"
#include "core/scene/finger_path.h"
#include "core/scene/object_bounds.h"
#include "core/scene/surface_colours.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_values {

using namespace tactum;

namespace {

SceneObject plate(const char* name, const Vec3& at, double half = 0.5) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}, {99, 99, 99}};
    soup->triangles = {{0, 2, 1}, {0, 3, 2}};
    soup->surfaceOf = {0, 1};
    SceneObject object;
    object.name = name;
    object.geometry = soup;
    object.surfaces.resize(2);
    object.pose.translation = at;
    return object;
}

} // namespace

class TestSceneValues : public QObject {
    Q_OBJECT

private slots:
    void idsAreNeverTwice() {
        Scene scene;
        QCOMPARE(scene.add(plate("a", {0, 0, 0})).id, 1u);
        QCOMPARE(scene.add(plate("b", {0, 0, 0})).id, 2u);
        SceneObject claims = plate("c", {0, 0, 0});
        claims.id = 1;
        QCOMPARE(scene.add(claims).id, 3u);
        scene.objects.erase(scene.objects.begin());
        QCOMPARE(scene.add(plate("d", {0, 0, 0})).id, 4u);
        QCOMPARE(scene.find(3)->name, "c");
        QVERIFY(!scene.find(1));
        QVERIFY(!scene.find(0));
        QCOMPARE(std::as_const(scene).find(4)->name, "d");
        QCOMPARE(triangleCount(scene), 6u);
    }

    void boxesAreOfWhatTrianglesUse() {
        Scene scene;
        QVERIFY(boundsOf(scene).empty());
        scene.add(plate("a", {1, 2, 3}));
        SceneObject turned = plate("b", {0, 0, 0}, 1);
        turned.pose.rotation = Quat(Eigen::AngleAxisd(std::acos(-1.0) / 2, Vec3::UnitX()));
        QCOMPARE(boundsOf(scene.objects[0]).low, Vec3(0.5, 2, 2.5));
        QCOMPARE(boundsOf(scene.objects[0]).high, Vec3(1.5, 2, 3.5));
        scene.add(turned);
        COMPARE_NEAR(boundsOf(scene).low, Vec3(-1, -1, 0), 1e-12, "m");
        COMPARE_NEAR(boundsOf(scene).high, Vec3(1.5, 2, 3.5), 1e-12, "m");
        SceneObject nothing = plate("c", {50, 50, 50});
        nothing.geometry = std::make_shared<TriangleSoup>();
        scene.add(nothing); // has no place
        COMPARE_NEAR(boundsOf(scene).high, Vec3(1.5, 2, 3.5), 1e-12, "m");
    }

    void aSceneIsFittedAboutItsMiddle() {
        Scene scene;
        scene.add(plate("a", {1, 1, 1}));
        scene.add(plate("b", {4, 1, 1}));
        auto motion = std::make_shared<Motion>();
        motion->translation.times = {0, 1};
        motion->translation.values = {Vec3::Zero(), Vec3(2, 0, 0)};
        motion->duration = 1;
        scene.objects[1].motion = motion;
        const double before = boundsOf(scene).diagonal();
        const auto mesh = scene.objects[0].geometry;
        fitDiagonal(scene, 0.2);
        const double scale = 0.2 / before;
        COMPARE_NEAR(boundsOf(scene).diagonal(), 0.2, 1e-12, "m");
        COMPARE_NEAR(boundsOf(scene).centre(), Vec3(0, 0, 0), 1e-12, "m");
        COMPARE_NEAR(scene.objects[0].pose.translation, Vec3(-1.5 * scale, 0, 0), 1e-12, "m");
        COMPARE_NEAR(scene.objects[0].geometry->positions[2], Vec3(0.5 * scale, 0, 0.5 * scale), 1e-12, "m");
        COMPARE_NEAR(scene.objects[1].motion->translation.values[1], Vec3(2 * scale, 0, 0), 1e-12, "m");
        QCOMPARE(mesh->positions[2], Vec3(0.5, 0, 0.5)); // others may share it
        Scene point;
        point.add(plate("p", {1, 1, 1}, 0));
        fitDiagonal(point, 0.2); // nothing to scale
        QCOMPARE(point.objects[0].pose.translation, Vec3(1, 1, 1));
        QCOMPARE(kHandDiagonal, 0.2);
    }

    void everythingIsDescribed() {
        Scene scene;
        scene.proxyRadius = 0.5;
        SceneObject object = plate("a", {1, 2, 3});
        object.visible = false;
        object.surfaces[1].name = "s";
        object.surfaces[1].visible = false;
        object.surfaces[1].locked = true;
        object.surfaces[1].colour = {0.25f, 0.5f, 0.75f};
        TextureLayer image, painted;
        image.pattern.source = TextureSource::Image;
        image.pattern.image =
            std::make_shared<const TextureImage>(1, 1, std::vector<std::uint16_t>{0}, "cloth.png");
        image.pattern.mapping = TextureMapping::Uv;
        image.mask = TexturePattern{};
        image.mask->source = TextureSource::Weave;
        painted.pattern.source = TextureSource::Painted;
        painted.strength = 1e3; // beyond its range
        painted.opacity = -1;
        object.surfaces[1].layers = {image, painted};
        auto motion = std::make_shared<Motion>();
        motion->translation.times = {0, 2};
        motion->translation.values = {Vec3::Zero(), Vec3(1, 0, 0)};
        motion->duration = 2;
        motion->jumpsAtEnd = true;
        object.motion = motion;
        scene.add(object);
        const SceneDescription said = describe(scene);
        QCOMPARE(said.triangles, 2u);
        QCOMPARE(said.bounds_W.low, Vec3(0.5, 2, 2.5));
        QCOMPARE(said.parameters.size(), 1u);
        QCOMPARE_EQ(said.parameters[0].value, 0.5);
        QVERIFY(!said.parameters[0].allowed);
        const ObjectDescription& a = said.objects.at(0);
        QCOMPARE(a.id, 1u);
        QVERIFY(!a.visible);
        QCOMPARE(a.vertices, 5u);
        QCOMPARE(a.triangles, 2u);
        QCOMPARE(a.pose.translation, Vec3(1, 2, 3));
        QCOMPARE(a.bounds_B.high, Vec3(0.5, 0, 0.5));
        QVERIFY(a.motion.has_value());
        QCOMPARE(a.motion->duration, 2.0);
        COMPARE_NEAR(a.motion->topSpeed, 0.5, 1e-9, "m/s");
        QVERIFY(a.motion->jumps);
        QCOMPARE(a.health.boundaryEdges, 4u);
        QCOMPARE(a.surfaces[0].triangles, 1u);
        QVERIFY(a.surfaces[0].visible && !a.surfaces[0].locked);
        const SurfaceDescription& s = a.surfaces[1];
        QCOMPARE(s.name, "s");
        QVERIFY(!s.visible && s.locked);
        QCOMPARE(s.colour.z(), 0.75f);
        QCOMPARE(s.parameters.size(), kMaterialFields.size());
        for (std::size_t i = 0; i < s.parameters.size(); ++i) {
            QCOMPARE_EQ(s.parameters[i].key, kMaterialFields[i].parameter->key);
            QCOMPARE_EQ(s.parameters[i].value, kMaterialFields[i].parameter->initial);
            QVERIFY(s.parameters[i].allowed);
        }
        QCOMPARE_EQ(s.layers[0].source, "image");
        QCOMPARE(s.layers[0].image, "cloth.png");
        QCOMPARE_EQ(s.layers[0].mapping, "uv");
        QCOMPARE_EQ(s.layers[0].mask, "weave");
        QCOMPARE_EQ(s.layers[0].strength.unit, "m");
        QVERIFY(s.layers[0].strength.allowed && s.layers[0].opacity.allowed);
        QCOMPARE_EQ(s.layers[1].mapping, "");
        QCOMPARE_EQ(s.layers[1].mask, "");
        QCOMPARE(s.layers[1].image, "");
        QVERIFY(!s.layers[1].strength.allowed);
        QVERIFY(!s.layers[1].opacity.allowed);
        SceneObject still = plate("still", {0, 0, 0});
        QVERIFY(!describeMotion(still));
    }

    /// The corner that is farthest from the origin of the body is the fastest when it turns.
    void theFastestPointCounts() {
        SceneObject object = plate("a", {0, 0, 0});
        auto motion = std::make_shared<Motion>();
        motion->rotation.times = {0, 1};
        motion->rotation.values = {QuatCoefficients(0, 0, 0, 1),
                                   QuatCoefficients(0, std::sin(0.25), 0, std::cos(0.25))};
        motion->duration = 1;
        object.motion = motion;
        const double reach = Vec3(99, 99, 99).norm(); // of any position
        COMPARE_NEAR(describeMotion(object)->topSpeed / (0.5 * reach), 1, 1e-2, "");
        QVERIFY(!describeMotion(object)->jumps);
        motion->jumps = {0.5};
        QVERIFY(describeMotion(object)->jumps);
    }

    void aPathRisesInTimeAndStaysInReach() {
        const double inf = std::numeric_limits<double>::infinity(),
                     nan = std::numeric_limits<double>::quiet_NaN();
        using Path = std::vector<FingerPoint>;
        const auto is = [](const Path& path) { return isFingerPath(path); };
        QVERIFY(!is({}));
        QVERIFY(is({{0, {1, 2, 3}}}));
        QVERIFY(is({{-5, {0, 0, 0}}, {0, {0, 0, 0}}, {1e-9, {0, 0, 0}}}));
        QVERIFY(!is({{1, {0, 0, 0}}, {1, {0, 0, 0}}}));
        QVERIFY(!is({{1, {0, 0, 0}}, {0.5, {0, 0, 0}}}));
        for (const double t : {inf, -inf, nan})
            QVERIFY(!is({{t, {0, 0, 0}}}));
        for (const double x : {inf, nan, 1e7, -1e7})
            for (int i = 0; i < 3; ++i) {
                Path path{{0, {0, 0, 0}}};
                path[0].position[i] = x;
                QVERIFY(!is(path));
            }
    }

    void surfacesThatNobodyColouredAreToldApart() {
        Scene scene;
        SceneObject many = plate("many", {0, 0, 0});
        many.surfaces.resize(6);
        scene.add(many);
        scene.add(plate("coloured", {0, 0, 0})).surfaces[1].colour = {1, 0, 0};
        scene.add(plate("one", {0, 0, 0})).surfaces.resize(1);
        const Scene before = scene;
        tellSurfacesApart(scene);
        const std::vector<Surface>& told = scene.objects[0].surfaces;
        for (std::size_t i = 0; i < told.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                QCOMPARE_GT(double((told[i].colour - told[j].colour).norm()), 0.1);
        QCOMPARE((told[0].colour - Surface{}.colour).norm(), 0.0F);
        QVERIFY(scene.objects[1] == before.objects[1]); // the file has said a colour
        QVERIFY(scene.objects[2] == before.objects[2]);
        tellSurfacesApart(scene); // they have colours now
        QVERIFY(scene.objects[0].surfaces == told);
        const auto last = colourApartFrom(told);
        for (const Surface& surface : told)
            QCOMPARE_GT(double((surface.colour - last).norm()), 0.1);
    }

    void surfacesOfOneColour() {
        Scene scene;
        const ObjectId first = scene.add(plate("first", {0, 0, 0})).id,
                       second = scene.add(plate("second", {0, 0, 0})).id;
        scene.find(first)->surfaces.resize(2);
        scene.find(second)->surfaces.resize(1);
        scene.find(first)->surfaces[1].colour = scene.find(second)->surfaces[0].colour = {0.5F, 0.25F, 0};
        scene.find(first)->surfaces[0].colour = {0.5F, 0.25F, 0.01F};
        scene.find(second)->surfaces[0].colour.x() += 1e-4F; // nobody sees it
        QVERIFY(surfacesColouredLike(scene, {second, 0}) ==
                (std::vector<SurfaceRef>{{first, 1}, {second, 0}}));
        QVERIFY(surfacesColouredLike(scene, {first, 0}) == (std::vector<SurfaceRef>{{first, 0}}));
        QVERIFY(surfacesColouredLike(scene, {first, 2}).empty());
        QVERIFY(surfacesColouredLike(scene, {99, 0}).empty());
    }

    void aPathIsWrittenToTheLastBit() {
        const std::vector<FingerPoint> path{{0, {0.1, -2, 3}}, {0.001, {1.0 / 3, 0, -1e-9}}};
        QCOMPARE(fingerCsv(path), "t,x,y,z\n0,0.1,-2,3\n0.001,0.3333333333333333,0,-1e-09\n");
        QCOMPARE(fingerCsv({}), "t,x,y,z\n");
    }
};

TACTUM_TEST(TestSceneValues)

} // namespace test_scene_values

#include "test_scene_values.moc"
