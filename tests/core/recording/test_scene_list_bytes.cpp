// The scenes of a recording as bytes: everything comes back, each thing is there once, and what cannot be is
// refused.
#include <QTest>

#include "core/recording/scene_list_bytes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_list_bytes {

using namespace tactum;

namespace {

std::shared_ptr<const TriangleSoup> meshOf(std::size_t triangles) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    soup->triangles.assign(triangles, {0, 1, 2});
    soup->surfaceOf.assign(triangles, 0);
    return soup;
}

SceneObject objectOf(const char* name, std::shared_ptr<const TriangleSoup> soup) {
    SceneObject object;
    object.name = name;
    object.geometry = std::move(soup);
    object.pose = {Quat(0, 1, 0, 0), {1, 2, 3}};
    object.surfaces.resize(1);
    object.surfaces[0].name = std::string(500, 's');
    object.surfaces[0].material.stiffness = 321;
    object.surfaces[0].sides = Sides::Back;
    object.surfaces[0].shading = {true, NormalSource::Computed, 0.25};
    return object;
}

Scene twoObjects() {
    Scene scene;
    scene.proxyRadius = 0.0025;
    scene.add(objectOf("a", meshOf(2)));
    scene.add(objectOf("b", meshOf(3)));
    return scene;
}

RecordedScene recorded(const Scene& scene, std::uint64_t revision) {
    RecordedScene made;
    made.numbers.revision = revision;
    made.numbers.shapeRevision = revision + 100;
    made.scene = std::make_shared<const Scene>(scene);
    return made;
}

std::vector<RecordedScene> again(const std::string& bytes, const KnownParts& known = {},
                                 int* asked = nullptr) {
    ByteIn in(bytes, "recording", 0, "record it again");
    auto read = readScenes(in, [&] {
        if (asked) ++*asked;
        return known;
    });
    if (in.left() != 0) qFatal("something is left");
    return read;
}

} // namespace

class TestSceneListBytes : public QObject {
    Q_OBJECT

private slots:
    void scenesComeBack() {
        Scene second = twoObjects();
        second.objects[1].surfaces[0].material.stiffness = 7;
        second.objects.push_back(objectOf("c", second.objects[0].geometry));
        second.objects.back().id = 9;
        second.objects.back().visible = false;
        const std::vector<RecordedScene> list{recorded(twoObjects(), 1), recorded(second, 2),
                                              recorded(Scene(), 3), recorded(twoObjects(), 4)};
        const auto read = again(sceneBytes(list, {}));
        QCOMPARE(read.size(), 4u);
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(read[i].numbers.revision, i + 1);
            QCOMPARE(read[i].numbers.shapeRevision, i + 101);
            QCOMPARE(read[i].scene->proxyRadius, list[i].scene->proxyRadius);
            QCOMPARE(read[i].scene->objects.size(), list[i].scene->objects.size());
            for (std::size_t k = 0; k < read[i].scene->objects.size(); ++k) {
                const SceneObject &now = read[i].scene->objects[k], &then = list[i].scene->objects[k];
                QVERIFY(*now.geometry == *then.geometry);
                QCOMPARE(now.id, then.id);
                QCOMPARE(now.visible, then.visible);
                QCOMPARE(now.pose.translation, then.pose.translation);
                QVERIFY(now.surfaces[0].material == then.surfaces[0].material);
                QCOMPARE(now.surfaces[0].sides, then.surfaces[0].sides);
                QVERIFY(now.surfaces[0].shading == then.surfaces[0].shading);
            }
        }
        QCOMPARE(again(sceneBytes({}, {})).size(), 0u);
    }

    /// The bodies that forces move are in it, those of each scene, and which object goes with which.
    void bodiesAreThose() {
        std::vector<RecordedScene> list;
        Scene scene = twoObjects();
        RigidBody body;
        body.id = 7;
        body.mass = 0.25;
        scene.objects[1].body = 7;
        scene.mechanics.bodies = {body};
        scene.mechanics.gravity = {0, 0, -3};
        list.push_back(recorded(scene, 1));
        list.push_back(recorded(scene, 2));
        scene.mechanics.bodies[0].mass = 0.5;
        list.push_back(recorded(scene, 3));
        const std::vector<RecordedScene> read = again(sceneBytes(list, {}));
        QCOMPARE(read.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(read[i].scene->mechanics == list[i].scene->mechanics);
            QCOMPARE(read[i].scene->objects[1].body, 7u);
        }
        QCOMPARE(read[2].scene->mechanics.bodies[0].mass, 0.5);
    }

    /// A minute of edits costs the edits: what stays as it was is there once.
    void whatStaysIsThereOnce() {
        const Scene scene = twoObjects();
        const std::size_t one = sceneBytes({recorded(scene, 1)}, {}).size();
        std::vector<RecordedScene> same;
        for (std::uint64_t i = 0; i < 50; ++i)
            same.push_back(recorded(scene, i));
        const std::size_t all = sceneBytes(same, {}).size();
        QCOMPARE_LT(all, one + 50 * 64); // a few numbers for each
        std::vector<RecordedScene> edited;
        for (std::uint64_t i = 0; i < 50; ++i) {
            Scene next = scene;
            next.objects[1].surfaces[0].material.stiffness = double(i + 1);
            edited.push_back(recorded(next, i));
        }
        const std::size_t object = (one - sceneBytes({recorded(Scene(), 1)}, {}).size()) / 2;
        QCOMPARE_LT(sceneBytes(edited, {}).size(), one + 50 * (object + 64)); // one of the two objects each
    }

    void whatIsElsewhereIsLookedForOnce() {
        const Scene scene = twoObjects();
        const KnownParts known(scene);
        const std::string bytes = sceneBytes({recorded(scene, 1)}, known);
        QCOMPARE_LT(bytes.size(), sceneBytes({recorded(scene, 1)}, {}).size());
        int asked = 0;
        const auto read = again(bytes, known, &asked);
        QCOMPARE(asked, 1);
        QCOMPARE(read[0].scene->objects[0].geometry, scene.objects[0].geometry); // the very same
        Scene changed = scene;
        changed.objects[0].geometry = meshOf(4);
        QVERIFY_EXCEPTION_THROWN(again(bytes, KnownParts(changed)), ByteFault);
        asked = 0;
        (void)again(sceneBytes({recorded(scene, 1)}, {}), {}, &asked);
        QCOMPARE(asked, 0); // it is all there
    }

    void everyCutIsRefused() {
        const std::string bytes = sceneBytes({recorded(twoObjects(), 1)}, {});
        for (std::size_t length = 0; length < bytes.size(); length += 7) {
            ByteIn in(std::string_view(bytes).substr(0, length), "recording", 0, "record it again");
            QVERIFY_EXCEPTION_THROWN(readScenes(in, [] { return KnownParts(); }), ByteFault);
        }
    }

    void whatIsLargeIsNotSmall() {
        QVERIFY(areSmall({}));
        QVERIFY(areSmall({recorded(twoObjects(), 1)}));
        Scene most;
        most.add(objectOf("a", meshOf(150'000)));
        most.add(objectOf("b", meshOf(50'000)));
        QVERIFY(areSmall({recorded(most, 1), recorded(most, 2)})); // shared: it counts once
        Scene more = most;
        more.add(objectOf("c", meshOf(1)));
        QVERIFY(!areSmall({recorded(more, 1)}));
        const auto picture = [](int width, int height) {
            const std::size_t texels = std::size_t(width) * std::size_t(height);
            return std::make_shared<const TextureImage>(width, height, std::vector<std::uint16_t>(texels));
        };
        Scene pictures = twoObjects();
        auto& layers = pictures.objects[0].surfaces[0].layers;
        layers.resize(1);
        layers[0].pattern.image = picture(4096, 4095);
        layers[0].mask = TexturePattern{};
        layers[0].mask->painted.values = std::make_shared<const PaintedValues>(std::vector<float>(4096));
        QVERIFY(areSmall({recorded(pictures, 1)}));
        layers[0].mask->image = picture(1, 1);
        QVERIFY(!areSmall({recorded(pictures, 1)}));
    }
};

TACTUM_TEST(TestSceneListBytes)

} // namespace test_scene_list_bytes

#include "test_scene_list_bytes.moc"
