// The scene between the two processes: nothing lost on the way, nothing let in.
#include <random>

#include <QTest>

#include "core/base/text.h"
#include "core/import/scene_transfer.h"
#include "core/motion/motion_build.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_scene_transfer {

using namespace tactum;

namespace {

/// One of everything, no value at its initial one.
LoadedScene richScene() {
    auto soup = std::make_shared<TriangleSoup>();
    soup->positions = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.25, 0}, {0, 0, -1}};
    soup->triangles = {{0, 1, 2}, {0, 3, 3}};
    soup->surfaceOf = {1, 0};
    soup->cornerNormals.assign(6, Eigen::Vector3f::UnitZ());
    soup->cornerUvs.assign(6, Eigen::Vector2f(0.25f, 3));
    Track<Vec3> slide{Interpolation::Linear, {0, 1}, {Vec3::Zero(), Vec3::UnitX()}, {}, {}};
    Track<QuatCoefficients> turn{Interpolation::Step, {0, 1}, {{0, 0, 0, 1}, {1, 0, 0, 0}}, {}, {}};
    TextureLayer layer;
    layer.name = "bumps";
    layer.enabled = false;
    layer.pattern.source = TextureSource::Image;
    layer.pattern.mapping = TextureMapping::Spherical;
    layer.pattern.image = std::make_shared<TextureImage>(
        3, 2, std::vector<std::uint16_t>{1, 2, 3, 4, 5, 65535}, "picture.png", 8);
    for (const PatternField& field : kPatternFields)
        layer.pattern.*field.value = field.parameter->maximum;
    layer.pattern.frame.translation = {1, 2, 3};
    layer.target = TextureTarget::Viscosity;
    layer.strength = 0.75;
    layer.blend = TextureBlend::Minimum;
    layer.opacity = 0.5;
    layer.mask = layer.pattern;
    layer.mask->source = TextureSource::Dots;
    layer.mask->image = nullptr;
    layer.mask->painted.values = std::make_shared<const PaintedValues>(std::vector{0.25F, 1.0F});
    layer.ownPlane = true;
    Surface surface;
    surface.name = "skin";
    for (const MaterialField& field : kMaterialFields)
        surface.material.*field.value = field.parameter->maximum;
    surface.shading = {true, NormalSource::Computed, 0.1};
    surface.layers = {layer, TextureLayer{}};
    surface.colour = {0.1f, 0.2f, 0.3f};
    surface.sides = Sides::Back;
    surface.kept = {3, std::make_shared<const std::string>("{\"material\":1}")};
    SceneObject object;
    object.name = "body";
    object.pose.translation = {0, 1, 0};
    object.pose.rotation = Quat(0, 1, 0, 0);
    object.motion = std::make_shared<const Motion>(makeMotion(slide, turn, 1.5));
    object.geometry = soup;
    object.surfaces = {surface, Surface{}};
    object.visible = false;
    object.sets = {{"rim", {{0, 1}}}};
    object.kept = {4, std::make_shared<const std::string>("{\"node\":1}")};
    object.keptMesh = {5, nullptr};
    LoadedScene loaded;
    loaded.scene.add(object);
    loaded.scene.add(object).name = "its twin";
    loaded.scene.proxyRadius = 0.003;
    SavedCamera camera;
    camera.name = "front";
    camera.pose = {Quat(0, 0, 1, 0), {0.1, 0.2, -3}};
    camera.ahead = 2.5, camera.near = 0.1, camera.far = 100;
    camera.kept = {6, std::make_shared<const std::string>("{\"eye\":1}")};
    camera.keptCamera = {2, std::make_shared<const std::string>("{\"lens\":1}")};
    loaded.scene.cameras = {camera, camera};
    loaded.scene.cameras[1].name = "plan";
    loaded.scene.cameras[1].parallel = true, loaded.scene.cameras[1].height = 0.7;
    loaded.scene.kept.foreign = std::make_shared<const ForeignGltf>(ForeignGltf{"{}", "binary"});
    loaded.findings = {{Finding::Severity::Warning, "body", "is odd", "look at it"}};
    return loaded;
}

std::string bytesOf(const LoadedScene& loaded) {
    StringOut out;
    writeTransfer(out, loaded);
    return out.bytes;
}

/// Why these bytes are refused; empty when they are not.
std::string refusal(const std::string& bytes) {
    try {
        readTransfer(bytes);
        return {};
    } catch (const ByteFault& fault) {
        return fault.error.text;
    }
}

template <class Change> std::string refusalOf(Change change) {
    LoadedScene loaded = richScene();
    change(loaded);
    return refusal(bytesOf(loaded));
}

void changeSoup(LoadedScene& loaded, const std::function<void(TriangleSoup&)>& change) {
    auto soup = std::make_shared<TriangleSoup>(*loaded.scene.objects[0].geometry);
    change(*soup);
    loaded.scene.objects[0].geometry = soup;
}

/// What the loops rely on.
void checkPromises(const LoadedScene& loaded) {
    for (const SceneObject& object : loaded.scene.objects) {
        QVERIFY(object.geometry);
        QCOMPARE_NE(object.id, 0);
        const TriangleSoup& soup = *object.geometry;
        QCOMPARE(soup.surfaceOf.size(), soup.triangles.size());
        for (const Index surface : soup.surfaceOf)
            QCOMPARE_LT(surface, object.surfaces.size());
        for (const auto& triangle : soup.triangles)
            for (const Index corner : triangle)
                QCOMPARE_LT(corner, soup.positions.size());
        for (const Vec3& p : soup.positions)
            QCOMPARE_LE(p.cwiseAbs().maxCoeff(), 1e6);
        for (const auto& n : soup.cornerNormals)
            QVERIFY(n.allFinite());
        for (const Surface& surface : object.surfaces)
            for (const MaterialField& field : kMaterialFields)
                QVERIFY(std::isfinite(surface.material.*field.value));
        if (object.motion) QVERIFY(object.motion->at(0.3).translation.allFinite());
    }
}

} // namespace

class TestSceneTransfer : public QObject {
    Q_OBJECT

private slots:
    void everythingArrives() {
        const LoadedScene loaded = richScene();
        const std::string bytes = bytesOf(loaded);
        const LoadedScene back = readTransfer(bytes);
        QCOMPARE(bytesOf(back), bytes);
        QCOMPARE(back.scene.objects.size(), std::size_t(2));
        QCOMPARE(back.scene.proxyRadius, 0.003);
        const SceneObject &sent = loaded.scene.objects[0], &got = back.scene.objects[0];
        QVERIFY(*got.geometry == *sent.geometry);
        QVERIFY(*got.motion == *sent.motion);
        QCOMPARE_EQ(got.pose.translation, sent.pose.translation);
        QCOMPARE_EQ(got.visible, sent.visible);
        QCOMPARE(got.sets, sent.sets);
        QVERIFY(back.scene.cameras == loaded.scene.cameras);
        QCOMPARE(*back.scene.cameras[0].kept.json, *loaded.scene.cameras[0].kept.json);
        QCOMPARE(back.scene.cameras[0].keptCamera.index, 2);
        QVERIFY(got.pose.rotation.coeffs() == sent.pose.rotation.coeffs());
        const TextureImage &picture = *sent.surfaces[0].layers[0].pattern.image,
                           &copy = *got.surfaces[0].layers[0].pattern.image;
        QCOMPARE(copy.name(), picture.name());
        QCOMPARE(copy.bits(), picture.bits());
        QCOMPARE(copy.texel(copy.level(1), 0, 0), picture.texel(picture.level(1), 0, 0));
        auto surfaces = got.surfaces; // equal but for where the picture lies
        surfaces[0].layers[0].pattern.image = sent.surfaces[0].layers[0].pattern.image;
        QVERIFY(surfaces == sent.surfaces);
        QCOMPARE(*got.kept.json, *sent.kept.json); // no part of ==
        QCOMPARE(got.keptMesh.index, 5);
        QCOMPARE(*got.surfaces[0].kept.json, *sent.surfaces[0].kept.json);
        QCOMPARE(back.scene.kept.foreign->binary, std::string("binary"));
        QVERIFY(got.geometry == back.scene.objects[1].geometry); // shared as before
        QCOMPARE(back.findings[0].sentence, std::string("is odd"));
    }

    void liesAreRefused() {
        QVERIFY(refusalOf([](LoadedScene&) {}).empty());
        const auto nan = std::numeric_limits<double>::quiet_NaN();
        const std::vector<std::function<void(LoadedScene&)>> lies{
            [](LoadedScene& s) { changeSoup(s, [](auto& t) { t.triangles[0][2] = 4; }); },
            [](LoadedScene& s) { changeSoup(s, [](auto& t) { t.surfaceOf[0] = 2; }); },
            [](LoadedScene& s) { changeSoup(s, [](auto& t) { t.surfaceOf.pop_back(); }); },
            [](LoadedScene& s) { changeSoup(s, [](auto& t) { t.cornerNormals.pop_back(); }); },
            [](LoadedScene& s) { changeSoup(s, [](auto& t) { t.cornerUvs.pop_back(); }); },
            [](LoadedScene& s) { changeSoup(s, [](auto& t) { t.positions[3].x() = 2e6; }); },
            [=](LoadedScene& s) { changeSoup(s, [=](auto& t) { t.positions[3].x() = nan; }); },
            [=](LoadedScene& s) { changeSoup(s, [=](auto& t) { t.cornerUvs[3].x() = float(nan); }); },
            [=](LoadedScene& s) { s.scene.proxyRadius = nan; },
            [=](LoadedScene& s) { s.scene.objects[0].pose.translation.x() = nan; },
            [](LoadedScene& s) { s.scene.objects[0].pose.rotation.coeffs() *= 2; },
            [=](LoadedScene& s) { s.scene.objects[0].surfaces[0].material.stiffness = nan; },
            [](LoadedScene& s) { s.scene.objects[0].surfaces[0].sides = Sides(kSidesNames.size()); },
            [](LoadedScene& s) { s.scene.objects[0].surfaces[0].layers[0].blend = TextureBlend(9); },
            [](LoadedScene& s) { s.scene.objects[0].geometry = nullptr; },
            [](LoadedScene& s) { s.scene.objects[0].id = 0; },
            [](LoadedScene& s) { s.scene.objects[0].sets[0].name.clear(); },
            [](LoadedScene& s) { s.scene.objects[0].sets[0].triangles.clear(); },
            [](LoadedScene& s) { s.scene.objects[0].sets[0].triangles[0].end = ~Index(0); },
            [](LoadedScene& s) { s.scene.objects[0].sets.push_back(s.scene.objects[0].sets[0]); },
            [](LoadedScene& s) { s.scene.objects[0].id = s.scene.objects[1].id; },
            [](LoadedScene& s) { s.scene.objects[0].id = ~ObjectId(0); },
            [](LoadedScene& s) { s.scene.cameras[1].name = s.scene.cameras[0].name; },
            [](LoadedScene& s) { s.scene.cameras[0].name.clear(); },
            [=](LoadedScene& s) { s.scene.cameras[0].angle = nan; },
            [=](LoadedScene& s) { s.scene.cameras[0].pose.translation.y() = nan; },
            [](LoadedScene& s) { s.scene.cameras[1].height = 0; },
            [](LoadedScene& s) { s.scene.cameras[0].ahead = 1e9; },
            [](LoadedScene& s) { s.scene.cameras.resize(kMaxCameras + 1, s.scene.cameras[0]); },
        };
        for (std::size_t i = 0; i < lies.size(); ++i)
            QVERIFY2(!refusalOf(lies[i]).empty(), qPrintable(QString::number(i)));
        QVERIFY(!refusal(bytesOf(richScene()) + '\0').empty());
    }

    void namesAreMadePrintable() {
        LoadedScene loaded = richScene();
        loaded.scene.objects[0].name = "a\x1b[31mb";
        loaded.findings[0].sentence = "two\nlines";
        const LoadedScene back = readTransfer(bytesOf(loaded));
        QCOMPARE(back.scene.objects[0].name, std::string("a?[31mb"));
        QCOMPARE(back.findings[0].sentence, std::string("two?lines"));
    }

    /// As long as loadScene() leaves them.
    void longNamesArriveWhole() {
        LoadedScene loaded = richScene();
        const std::string longest(kLongestName, 'n');
        SceneObject& object = loaded.scene.objects[0];
        object.name = object.surfaces[0].name = longest;
        const LoadedScene back = readTransfer(bytesOf(loaded));
        QCOMPARE(back.scene.objects[0].name, longest);
        QCOMPARE(back.scene.objects[0].surfaces[0].name, longest);
    }

    void everyTruncationIsRefused() {
        const std::string bytes = bytesOf(richScene());
        for (std::size_t size = 0; size < bytes.size(); ++size)
            QVERIFY(!refusal(bytes.substr(0, size)).empty());
    }

    /// Each either refused or a scene that keeps every promise; more with TACTUM_TRANSFERS.
    void changedBytesAreAnswered() {
        const int rounds = std::max(20000, qEnvironmentVariableIntValue("TACTUM_TRANSFERS"));
        const std::string bytes = bytesOf(richScene());
        std::mt19937 random(1);
        int accepted = 0;
        for (int round = 0; round < rounds; ++round) {
            std::string changed = bytes;
            for (unsigned k = 1 + random() % 4; k > 0; --k)
                mutate(changed, random);
            try {
                checkPromises(readTransfer(changed));
                ++accepted;
            } catch (const ByteFault&) {
            }
        }
        QCOMPARE_GT(accepted, rounds / 100);
        QCOMPARE_LT(accepted, rounds);
    }

private:
    static void mutate(std::string& bytes, std::mt19937& random) {
        const std::size_t at = random() % bytes.size();
        const std::uint64_t numbers[] = {0, 1, ~std::uint64_t(0), std::uint64_t(1) << 40, random() % 64};
        switch (random() % 5) {
        case 0:
            bytes[at] = char(random());
            break;
        case 1:
            bytes[at] = char(bytes[at] ^ (1 << random() % 8));
            break;
        case 2:
            bytes.erase(at, random() % 16);
            break;
        case 3:
            bytes.insert(at, std::string(random() % 16, char(random())));
            break;
        default:
            if (at + 8 <= bytes.size()) std::memcpy(bytes.data() + at, &numbers[random() % 5], 8);
        }
        if (bytes.empty()) bytes = "x";
    }
};

TACTUM_TEST(TestSceneTransfer)

} // namespace test_scene_transfer

#include "test_scene_transfer.moc"
