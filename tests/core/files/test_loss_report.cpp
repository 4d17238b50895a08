// What is said to be kept or lost, for scenes of which the answer is known.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "core/base/text.h"
#include "core/files/loss_report.h"
#include "core/scene/world_fields.h"
#include "tests/core/files/bodies.h"
#include "tests/core/files/x3d_scenes.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_loss_report {

using namespace tactum;
using namespace tactum::test;

namespace {

Scene plainScene() {
    Scene scene;
    scene.add(bodyOf("ball", ball(0.05, 1)));
    scene.objects[0].surfaces[0].name = "skin";
    return scene;
}

const Loss* said(const std::vector<Loss>& losses, ExportTarget target, const std::string& what) {
    for (const Loss& loss : losses)
        if (loss.target == target && loss.what == what) return &loss;
    return nullptr;
}

} // namespace

class TestLossReport : public QObject {
    Q_OBJECT
private slots:
    void aPlainSceneLosesOnlyWhatFormatsCannotSay();
    void whatASceneHasNotIsNotSpokenOf();
    void everyFeatureIsNoticed();
    void ourOwnFormatLosesNothing();
    void everyLossHasAReason();
    void likeThingsStandOnOneLine();
    void hostileNamesBreakNeitherText();
    void sentencesAreWhole();
    void everyParameterHasItsRow();
    void partsOfOtherProgramsAreSpokenOf();
};

void TestLossReport::aPlainSceneLosesOnlyWhatFormatsCannotSay() {
    const auto losses = lossesOf(plainScene());
    QCOMPARE(said(losses, ExportTarget::X3d, "stiffness")->kind, LossKind::Kept);
    QCOMPARE(said(losses, ExportTarget::Mpeg, "stiffness")->kind, LossKind::Degraded);
    QCOMPARE(said(losses, ExportTarget::KhrPhysics, "stiffness")->kind, LossKind::Lost);
    QCOMPARE(said(losses, ExportTarget::Stl, "shape")->kind, LossKind::Degraded);
    QCOMPARE(said(losses, ExportTarget::Obj, "colour")->object, std::string("ball / skin"));
}

void TestLossReport::whatASceneHasNotIsNotSpokenOf() {
    const auto losses = lossesOf(plainScene());
    for (const char* what : {"viscosity", "damping", "motion", "hidden", "layers of height", "lines", "pose"})
        QVERIFY2(!said(losses, ExportTarget::X3d, what), what);
}

void TestLossReport::everyFeatureIsNoticed() {
    Scene scene = plainScene();
    SceneObject& object = scene.objects[0];
    Surface& surface = object.surfaces[0];
    surface.material = {500, 1, 0.5, 0.4, 2};
    surface.sides = Sides::Front;
    surface.shading.on = true;
    surface.layers.push_back(heightLayer(TextureSource::Dots, TextureMapping::Planar, 0.01, 1e-4));
    surface.layers.push_back(surface.layers[0]);
    surface.layers[1].target = TextureTarget::Viscosity;
    surface.layers[1].mask.emplace().source = TextureSource::Painted;
    Rng rng(1);
    object.motion = randomMotion(rng);
    object.visible = false;
    object.pose.translation = {1, 0, 0};
    const auto losses = lossesOf(scene);
    for (const char* what :
         {"viscosity", "damping", "static friction", "dynamic friction", "motion", "hidden",
          "layers of height", "painted values", "layers of viscosity", "felt side", "force shading", "pose"})
        QVERIFY2(said(losses, ExportTarget::X3d, what), what);
    QVERIFY(!said(losses, ExportTarget::X3d, "layers of friction or stiffness"));
    QCOMPARE(said(losses, ExportTarget::X3d, "viscosity")->kind, LossKind::Lost);
    QCOMPARE(said(losses, ExportTarget::KhrPhysics, "static friction")->kind, LossKind::Kept);
    QCOMPARE(said(losses, ExportTarget::Mpeg, "static friction")->kind, LossKind::Lost);
    QCOMPARE(said(losses, ExportTarget::Mpeg, "layers of height")->kind, LossKind::Degraded);
    COMPARE_LACKS(reportMarkdown(losses), "..."); // whole sentences
    surface.layers[0].enabled = false;
    QVERIFY(!said(lossesOf(scene), ExportTarget::X3d, "layers of height"));
}

void TestLossReport::ourOwnFormatLosesNothing() {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Rng rng(seed);
        for (const Loss& loss : lossesOf(randomHapticScene(rng), ExportTarget::Glb))
            QCOMPARE(loss.kind, LossKind::Kept);
    }
}

void TestLossReport::everyLossHasAReason() {
    for (std::uint64_t seed = 0; seed < 30; ++seed) {
        Rng rng(seed);
        for (const Loss& loss : lossesOf(randomHapticScene(rng)))
            QVERIFY(loss.kind == LossKind::Kept || !loss.sentence.empty());
    }
}

void TestLossReport::likeThingsStandOnOneLine() {
    Scene scene;
    for (int i = 0; i < 9; ++i)
        scene.add(plainScene().objects[0]).name = "ball" + std::to_string(i);
    const std::string report = reportMarkdown(lossesOf(scene, ExportTarget::Stl));
    QCOMPARE(QString::fromStdString(report).count("| stiffness |"), 1);
    COMPARE_CONTAINS(report, "and 4 more");
    QCOMPARE_LT(report.find("lost"), report.find("degraded"));
}

void TestLossReport::hostileNamesBreakNeitherText() {
    for (const std::string& name : kHostileNames) {
        Scene scene = plainScene();
        scene.objects[0].name = name;
        const auto losses = lossesOf(scene);
        for (const QString& line : QString::fromStdString(reportMarkdown(losses)).split('\n'))
            if (line.startsWith('|')) QCOMPARE(QString(line).remove("\\|").count('|'), 5);
        const QJsonDocument json = QJsonDocument::fromJson(QByteArray::fromStdString(reportJson(losses)));
        QCOMPARE(std::size_t(json.array().size()), losses.size());
        QCOMPARE(json.array()[0].toObject()["target"].toString(), QString("glb"));
    }
}

void TestLossReport::sentencesAreWhole() {
    Scene scene = plainScene();
    scene.objects[0].name = std::string(90, 'x');
    const std::string report = reportMarkdown(lossesOf(scene));
    COMPARE_CONTAINS(report, "the standard says no unit, ours beside it does |");
    COMPARE_CONTAINS(report, scene.objects[0].name + " / skin |");
}

/// A number that an author can set and that the table forgets would be lost without a word.
void TestLossReport::everyParameterHasItsRow() {
    const auto demand = [](const Scene& scene, const std::string& what) {
        for (std::size_t target = 0; target < kExportTargets.size(); ++target) {
            const auto losses = lossesOf(scene, ExportTarget(target));
            QVERIFY2(said(losses, ExportTarget(target), what), (what + " has no row").c_str());
        }
    };
    demand(plainScene(), lowerCase(kProxyRadius.label));
    for (const MaterialField& field : kMaterialFields) {
        Scene scene = plainScene();
        scene.objects[0].surfaces[0].material.*field.value = 0.5;
        demand(scene, lowerCase(field.parameter->label));
    }
    for (std::size_t target = 0; target < kTextureTargets.size(); ++target) {
        Scene scene = plainScene();
        TextureLayer layer;
        layer.target = TextureTarget(target);
        scene.objects[0].surfaces[0].layers = {layer};
        const bool found = std::ranges::any_of(lossesOf(scene, ExportTarget::Obj), [](const Loss& loss) {
            return loss.what.starts_with("layers of ") && loss.kind == LossKind::Lost;
        });
        QVERIFY2(found, std::string(kTextureTargets[target].key).c_str());
    }
    for (const WorldField& field : kWorldFields) {
        Scene scene = plainScene();
        scene.mechanics.bodies.emplace_back().id = 1;
        const auto before = lossesOf(scene, ExportTarget::X3d);
        scene.mechanics.*field.value = 2 + 2 * field.parameter->initial;
        QVERIFY2(lossesOf(scene, ExportTarget::X3d).size() > before.size(),
                 std::string(field.parameter->label).c_str());
    }
    const auto changed = [&](const std::string& what, auto&& change) {
        Scene scene = plainScene();
        change(scene.objects[0].surfaces[0]);
        demand(scene, what);
    };
    changed("force shading", [](Surface& surface) { surface.shading.on = true; });
    changed("felt side", [](Surface& surface) { surface.sides = Sides::Front; });
    changed("hidden surface", [](Surface& surface) { surface.visible = false; });
}

void TestLossReport::partsOfOtherProgramsAreSpokenOf() {
    const std::vector<std::pair<std::string, std::string>> parts{
        {R"("cameras":[{"type":"perspective"}])", "cameras"},
        {R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}})", "lights"},
        {R"("images":[{"bufferView":0}])", "pictures for the eye"},
        {R"("animations":[{}])", "other parts of other programs"},
        {R"("extensions":{"ABC_other":{}})", "other parts of other programs"}};
    for (const auto& [json, what] : parts) {
        Scene scene = plainScene();
        scene.kept.foreign = std::make_shared<const ForeignGltf>(
            ForeignGltf{R"({"asset":{"version":"2.0"},"nodes":[{}],)" + json + "}", ""});
        for (const ExportTarget target : {ExportTarget::X3d, ExportTarget::Obj, ExportTarget::Stl})
            for (const auto& [other, spoken] : parts) {
                const Loss* loss = said(lossesOf(scene, target), target, spoken);
                QVERIFY2(bool(loss) == (spoken == what), (json + ": " + spoken).c_str());
            }
        const auto losses = lossesOf(scene);
        QCOMPARE(said(losses, ExportTarget::X3d, what)->kind, LossKind::Lost);
        QCOMPARE(said(losses, ExportTarget::Glb, what)->kind, LossKind::Kept);
    }
}

TACTUM_TEST(TestLossReport)

} // namespace test_loss_report

#include "test_loss_report.moc"
