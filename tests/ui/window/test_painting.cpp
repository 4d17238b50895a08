// The brush with real events: what a stroke lays onto a surface, where, and how it is taken back.
#include <cmath>

#include <QAction>
#include <QTest>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/tools/paint_tool.h"
#include "ui/view/scene_view.h"

namespace test_painting {

using namespace tactum;

class TestPainting : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static PaintTool& tool(const TouchedWindow& program) { return *program.window->findChild<PaintTool*>(); }
    /// Waits until it is worked out.
    static void stroke(TouchedWindow& program, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = {}) {
        QWindow* window = program.window->windowHandle();
        const auto at = [&](QPoint place) {
            return program.window->view().mapTo(program.window.get(), place);
        };
        QTest::mousePress(window, Qt::LeftButton, modifiers, at(from));
        for (int i = 1; i <= 4; ++i)
            program.moveTo(from + (to - from) * i / 4);
        QTest::mouseRelease(window, Qt::LeftButton, modifiers, at(to));
        QTRY_VERIFY_WITH_TIMEOUT(!tool(program).working(), kPatience);
    }
    /// A plate of 20 x 20 squares, 0.1 m wide, that fills the middle of the view from above.
    QString writePlate() const;
    static const std::vector<TextureLayer>& layers(const TouchedWindow& program) {
        return program.document.scene().objects[0].surfaces[0].layers;
    }
    static const PaintedValues& values(const TouchedWindow& program) {
        return *layers(program).at(0).pattern.painted.values;
    }
    bool begin(TouchedWindow& program, const char* goal) {
        if (!program.open(writePlate())) return false;
        program.command("view-top").trigger();
        program.command(goal).trigger();
        program.frames(5); // the row of the brush takes some of the view
        return program.command("paint").isChecked();
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void aDabIsAsHighAsTheBrushSays();
    void aStrokeIsOneStep();
    void controlTakesAwayAndEscapeGivesUp();
    void aMaskIsPaintedOnTheTopmostLayer();
    void lockedAndOtherSurfacesStay();
    void besideTheModelNothingHappens();
    void aPictureIsPaintedOnItsTexels();
    void keysChangeTheBrushAndBack();
};

QString TestPainting::writePlate() const {
    const QString path = folder_.filePath(QStringLiteral("plate.obj"));
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return {};
    constexpr int kSquares = 20;
    QByteArray text = "o plate\n";
    for (int y = 0; y <= kSquares; ++y)
        for (int x = 0; x <= kSquares; ++x)
            text += QByteArray("v ") + QByteArray::number(0.005 * x) + " 0 " +
                    QByteArray::number(-0.005 * y) + '\n';
    for (int y = 0; y < kSquares; ++y)
        for (int x = 0; x < kSquares; ++x) {
            const int a = 1 + x + y * (kSquares + 1);
            for (const int corner : {a, a + 1, a + kSquares + 2})
                text += (corner == a ? "f " : " ") + QByteArray::number(corner);
            text += '\n';
            for (const int corner : {a, a + kSquares + 2, a + kSquares + 1})
                text += (corner == a ? "f " : " ") + QByteArray::number(corner);
            text += '\n';
        }
    file.write(text);
    return path;
}

// Closed form: strength times the falloff at the distance from where the pointer met the plate.
void TestPainting::aDabIsAsHighAsTheBrushSays() {
    TouchedWindow program;
    QVERIFY(begin(program, "paint-static-friction"));
    Brush brush;
    brush.radius = 0.02;
    brush.strength = 0.8;
    tool(program).setBrush(brush);
    const SceneObject& object = program.document.scene().objects[0];
    const TriangleSoup& soup = *object.geometry;
    const Ray ray = program.window->view().camera().ray(program.centre());
    const Vec3 at = object.pose.applyInverse(ray.at(-ray.origin.y() / ray.direction.y()));
    stroke(program, program.centre(), program.centre());
    QCOMPARE(layers(program).size(), std::size_t(1));
    QCOMPARE(layers(program)[0].target, TextureTarget::StaticFriction);
    int inside = 0;
    for (std::size_t i = 0; i < soup.positions.size(); ++i) {
        const double x = (soup.positions[i] - at).norm() / brush.radius;
        const double wanted = brush.strength * falloffAt(x, brush.falloff);
        QVERIFY2(
            std::abs(values(program)[i] - wanted) < 1e-3,
            qPrintable(
                QStringLiteral("%1 of the radius: %2, not %3").arg(x).arg(values(program)[i]).arg(wanted)));
        inside += wanted > 0;
    }
    QCOMPARE_GT(inside, 20);
    QCOMPARE_LT(inside, int(soup.positions.size()) / 2);
}

void TestPainting::keysChangeTheBrushAndBack() {
    TouchedWindow program;
    QVERIFY(begin(program, "paint-height"));
    Brush brush = tool(program).brush();
    brush.strength = 0.5;
    tool(program).setBrush(brush);
    const auto after = [&](const char* command) {
        program.command(command).trigger();
        return tool(program).brush();
    };
    QCOMPARE_GT(after("brush-bigger").radius, brush.radius);
    COMPARE_NEAR(after("brush-smaller").radius, brush.radius, 1e-15, "m");
    QCOMPARE_LT(after("brush-weaker").strength, brush.strength);
    COMPARE_NEAR(after("brush-stronger").strength, brush.strength, 1e-12, "");
    QCOMPARE_GT(after("brush-stronger").strength, brush.strength);
}

void TestPainting::aStrokeIsOneStep() {
    TouchedWindow program;
    QVERIFY(begin(program, "paint-height"));
    const Scene before = program.document.scene();
    const int steps = program.document.history().count();
    stroke(program, program.centre() - QPoint(60, 0), program.centre() + QPoint(60, 0));
    QCOMPARE(program.document.history().count(), steps + 1);
    const Scene after = program.document.scene();
    // Along the whole way, and nowhere else.
    Bounds painted;
    for (std::size_t i = 0; i < values(program).size(); ++i)
        if (values(program)[i] > 0) painted.add(after.objects[0].geometry->positions[i]);
    const Vec3 extent = painted.high - painted.low;
    QVERIFY2(extent.x() > 2 * extent.z() && extent.z() > 0, qPrintable(QString::number(extent.x())));
    program.document.history().undo();
    QVERIFY(program.document.scene() == before);
    program.document.history().redo();
    QVERIFY(program.document.scene() == after);
    // A second one goes on in the same layer.
    stroke(program, program.centre() - QPoint(0, 60), program.centre() + QPoint(0, 60));
    QCOMPARE(layers(program).size(), std::size_t(1));
    QCOMPARE(program.document.history().count(), steps + 2);
}

void TestPainting::controlTakesAwayAndEscapeGivesUp() {
    TouchedWindow program;
    QVERIFY(begin(program, "paint-height"));
    Brush brush;
    brush.strength = 1;
    tool(program).setBrush(brush);
    const auto greatest = [&] { return *std::ranges::max_element(values(program).all()); };
    stroke(program, program.centre(), program.centre());
    QCOMPARE_GT(greatest(), 0.5F);
    const Scene painted = program.document.scene();
    stroke(program, program.centre(), program.centre(), Qt::ControlModifier);
    QCOMPARE_LT(greatest(), 0.01F);
    const Scene undone = program.document.scene();
    program.document.history().undo();
    program.press(program.centre());
    program.moveTo(program.centre() + QPoint(50, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!(program.document.scene() == painted), kPatience);
    QTest::keyClick(&program.window->view(), Qt::Key_Escape);
    program.release(program.centre() + QPoint(50, 0));
    QTRY_VERIFY_WITH_TIMEOUT(!tool(program).working(), kPatience);
    QVERIFY(program.document.scene() == painted);
    program.document.history().redo();
    QVERIFY(program.document.scene() == undone);
}

void TestPainting::aMaskIsPaintedOnTheTopmostLayer() {
    TouchedWindow program;
    QVERIFY(begin(program, "paint-mask"));
    stroke(program, program.centre(), program.centre()); // there is no layer yet
    QVERIFY(layers(program).empty());
    TextureLayer noise;
    noise.name = "noise";
    program.document.editSurfaces(SurfaceRef{program.document.scene().objects[0].id, 0},
                                  SceneChange::What::Layers, QStringLiteral("Add"), [&](Surface& each) {
                                      each.layers = {noise, noise};
                                  });
    stroke(program, program.centre(), program.centre());
    QVERIFY(!layers(program)[0].mask);
    QVERIFY(layers(program)[1].mask);
    QCOMPARE(layers(program)[1].mask->source, TextureSource::Painted);
    QCOMPARE(layers(program)[1].pattern.source, TextureSource::Noise);
    // Of a mask that is none yet, taking away begins at full.
    program.document.history().undo();
    stroke(program, program.centre(), program.centre());
    program.document.history().undo();
    program.command("brush-subtract").trigger();
    stroke(program, program.centre(), program.centre());
    const auto& mask = layers(program)[1].mask->painted.values->all();
    QCOMPARE(*std::ranges::max_element(mask), 1.0F);
    QCOMPARE_LT(*std::ranges::min_element(mask), 0.9F);
}

void TestPainting::lockedAndOtherSurfacesStay() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.command("paint-viscosity").trigger();
    const Scene before = program.document.scene();
    stroke(program, program.centre(), program.centre() + QPoint(6, 6));
    int changed = 0;
    for (std::size_t i = 0; i < 6; ++i)
        changed += !(program.document.scene().objects[0].surfaces[i] == before.objects[0].surfaces[i]);
    QCOMPARE(changed, 1);
    program.document.history().undo();
    SurfaceRefs all;
    for (Index i = 0; i < 6; ++i)
        all.push_back({before.objects[0].id, i});
    program.document.setLocked(all, true);
    const Scene locked = program.document.scene();
    stroke(program, program.centre(), program.centre() + QPoint(6, 6));
    QVERIFY(program.document.scene() == locked);
}

void TestPainting::besideTheModelNothingHappens() {
    TouchedWindow program;
    QVERIFY(begin(program, "paint-height"));
    const Scene before = program.document.scene();
    const double yaw = program.window->view().camera().yaw;
    stroke(program, {6, 120}, {40, 120}); // below the row of the brush
    QVERIFY(program.document.scene() == before);
    QVERIFY(program.window->view().camera().yaw != yaw); // it orbits there
}

// A square with texture coordinates, and a grey picture on it: what is painted is where the pointer was.
void TestPainting::aPictureIsPaintedOnItsTexels() {
    TouchedWindow program;
    const QString square =
        writeFile(folder_, QStringLiteral("square.obj"),
                  "v 0 0 0\nv 0.1 0 0\nv 0.1 0 -0.1\nv 0 0 -0.1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
                  "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
    QVERIFY(program.open(square));
    program.command("view-top").trigger();
    constexpr int kSide = 64;
    constexpr std::uint16_t kGrey = 20000;
    TextureLayer layer;
    layer.name = "picture";
    layer.pattern.source = TextureSource::Image;
    layer.pattern.mapping = TextureMapping::UvUnit;
    layer.pattern.size = 1;
    layer.pattern.image = std::make_shared<const TextureImage>(
        kSide, kSide, std::vector<std::uint16_t>(kSide * kSide, kGrey), "grey");
    program.document.editSurfaces(SurfaceRef{program.document.scene().objects[0].id, 0},
                                  SceneChange::What::Layers, QStringLiteral("Add"),
                                  [&](Surface& each) { each.layers = {layer}; });
    program.command("paint-layer").trigger();
    program.frames(5);
    Brush brush;
    brush.radius = 0.02;
    brush.strength = 1;
    brush.falloff = 0;
    tool(program).setBrush(brush);
    const Ray ray = program.window->view().camera().ray(program.centre());
    const Vec3 at =
        program.document.scene().objects[0].pose.applyInverse(ray.at(-ray.origin.y() / ray.direction.y()));
    const Scene before = program.document.scene();
    stroke(program, program.centre(), program.centre());
    const TextureImage& image = *layers(program).at(0).pattern.image;
    QCOMPARE(layers(program)[0].pattern.source, TextureSource::Image);
    int painted = 0;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            // The plate may have been scaled to a hand's reach about its middle.
            const TriangleSoup& soup = *program.document.scene().objects[0].geometry;
            const Vec3 place = soup.positions[0] +
                               (x + 0.5) / kSide * (soup.positions[1] - soup.positions[0]) +
                               (y + 0.5) / kSide * (soup.positions[3] - soup.positions[0]);
            const double far = (place - at).norm();
            const std::uint16_t value = image.row(y)[x];
            if (far < 0.95 * brush.radius) QCOMPARE(value, std::uint16_t(65535));
            if (far > 1.05 * brush.radius) QCOMPARE(value, kGrey);
            painted += value != kGrey;
        }
    QCOMPARE_GT(painted, 100);
    QCOMPARE_LT(painted, kSide * kSide / 2);
    program.document.history().undo();
    QVERIFY(program.document.scene() == before);
}

TACTUM_GUI_TEST(TestPainting)

} // namespace test_painting

#include "test_painting.moc"
