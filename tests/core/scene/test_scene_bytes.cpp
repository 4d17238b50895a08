// A scene as bytes: what comes back is equal, and what the reader has already is named instead of sent.
// The test itself would be wrong if Scene's == left a member out: the import's test fills every member and
// compares each by hand.
#include <QTest>

#include "core/motion/motion_build.h"
#include "core/scene/scene_bytes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_bytes {

using namespace tactum;

namespace {

std::shared_ptr<const TriangleSoup> meshOf(double size) {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    soup->triangles.assign(100, {0, 1, 2});
    soup->surfaceOf.assign(100, 0);
    return soup;
}

std::shared_ptr<const Motion> motionOf(double way) {
    const Track<Vec3> slide{Interpolation::Linear, {0, 1}, {Vec3::Zero(), way * Vec3::UnitX()}, {}, {}};
    return std::make_shared<const Motion>(makeMotion(slide, {}, 1));
}

/// One part of each kind.
Scene partsOf(double size) {
    SceneObject object;
    object.name = "a";
    object.geometry = meshOf(size);
    object.motion = motionOf(size);
    object.surfaces.resize(1);
    TextureLayer layer;
    layer.pattern.source = TextureSource::Image;
    layer.pattern.image = std::make_shared<const TextureImage>(
        2, 2, std::vector<std::uint16_t>{1, 2, 3, std::uint16_t(1000 * size)});
    layer.mask = TexturePattern{};
    layer.mask->source = TextureSource::Painted;
    layer.mask->painted.values = std::make_shared<const PaintedValues>(std::vector<float>{float(size / 100)});
    object.surfaces[0].layers = {layer};
    object.kept = {3, std::make_shared<const std::string>("{}")};
    Scene scene;
    scene.add(std::move(object));
    return scene;
}

Scene again(const std::string& bytes, const KnownParts& known = {}) {
    ByteIn in(bytes, "the scene", 0, "send it again");
    Scene scene = readScene(in, {[&] { return known; }});
    if (in.left() != 0) qFatal("something is left");
    return scene;
}

} // namespace

class TestSceneBytes : public QObject {
    Q_OBJECT

private slots:
    void itComesBack() {
        const Scene scene = partsOf(1);
        const Scene read = again(bytesOf(scene));
        QCOMPARE(read.objects.size(), 1u);
        QVERIFY(*read.objects[0].geometry == *scene.objects[0].geometry);
        QCOMPARE(*read.objects[0].kept.json, "{}");
        QCOMPARE(again(bytesOf(withoutKept(scene))).objects[0].kept.json, nullptr);
        QVERIFY(again(bytesOf(Scene())) == Scene());
    }

    /// The very same parts, so that nothing that was made of them is made anew.
    void whatIsKnownIsNamed() {
        const Scene scene = partsOf(1);
        const KnownParts known(scene);
        const std::string named = bytesOf(scene, known);
        QCOMPARE_LT(named.size(), bytesOf(scene).size() - 100 * sizeof(std::array<Index, 3>));
        QVERIFY(again(named, known) == scene); // Scene compares parts by where they are
    }

    void whatIsEqualIsKnownToo() {
        const Scene mine = partsOf(1), theirs = partsOf(1);
        QVERIFY(!(mine == theirs));
        QVERIFY(again(bytesOf(mine, KnownParts(theirs)), KnownParts(theirs)) == theirs);
    }

    void whatIsNotThereIsAFault_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("mesh") << 0;
        QTest::newRow("motion") << 1;
        QTest::newRow("image") << 2;
        QTest::newRow("painted") << 3;
    }
    void whatIsNotThereIsAFault() {
        QFETCH(int, kind);
        const Scene scene = partsOf(1), other = partsOf(2);
        Scene lacking = scene;
        SceneObject& object = lacking.objects[0];
        TextureLayer& layer = object.surfaces[0].layers[0];
        const TextureLayer& elsewhere = other.objects[0].surfaces[0].layers[0];
        if (kind == 0) object.geometry = other.objects[0].geometry;
        if (kind == 1) object.motion = other.objects[0].motion;
        if (kind == 2) layer.pattern.image = elsewhere.pattern.image;
        if (kind == 3) layer.mask->painted = elsewhere.mask->painted;
        const std::string named = bytesOf(scene, KnownParts(scene));
        QVERIFY_EXCEPTION_THROWN(again(named, KnownParts(lacking)), ByteFault);
        QVERIFY(again(bytesOf(scene, KnownParts(lacking)), KnownParts(lacking)).objects.size() == 1);
    }

    void aFingerprintIsOfEveryValue() {
        const Scene a = partsOf(1), b = partsOf(2);
        const SceneObject &x = a.objects[0], &y = b.objects[0];
        QCOMPARE_NE(fingerprintOf(*x.geometry), fingerprintOf(*y.geometry));
        QCOMPARE_NE(fingerprintOf(*x.motion), fingerprintOf(*y.motion));
        const TextureLayer &p = x.surfaces[0].layers[0], &q = y.surfaces[0].layers[0];
        QCOMPARE_NE(fingerprintOf(*p.pattern.image), fingerprintOf(*q.pattern.image));
        QCOMPARE_NE(fingerprintOf(*p.mask->painted.values), fingerprintOf(*q.mask->painted.values));
        QCOMPARE(fingerprintOf(*x.geometry), fingerprintOf(*meshOf(1)));
    }

    void everyCutIsRefused() {
        const std::string bytes = bytesOf(partsOf(1));
        for (std::size_t length = 0; length < bytes.size(); length += 5)
            QVERIFY_EXCEPTION_THROWN(again(bytes.substr(0, length)), ByteFault);
    }
};

TACTUM_TEST(TestSceneBytes)

} // namespace test_scene_bytes

#include "test_scene_bytes.moc"
