// What the dock of layers shows and the view moves: thumbnails, flat ground, profile, dropped pictures,
// mapping.
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QImage>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/layered_window.h"
#include "ui/document/layer_picture.h"
#include "ui/panels/flat_swatch.h"
#include "ui/panels/profile_chart.h"

namespace test_layer_views {

using namespace tactum;

namespace {

/// Rises from the left to the right.
QString writeRamp(const QTemporaryDir& folder, const QString& name) {
    QImage image(64, 32, QImage::Format_Grayscale8);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            image.scanLine(y)[x] = uchar(4 * x);
    const QString file = folder.filePath(name);
    return image.save(file) ? file : QString();
}

} // namespace

class TestLayerViews : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void thumbnailsDiffer();
    void flatGroundIsWhatIsFelt();
    void aStrokeGivesTheProfile();
    void aDroppedPictureBecomesALayer();
    void theMappingIsDragged();
    void theHandlesAreThoseOfThePanelInFront();
};

void TestLayerViews::thumbnailsDiffer() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves", "layer-dots", "layer-weave", "layer-painted"});
    std::vector<QImage> pictures;
    for (int i = 0; i < int(window.layers().size()); ++i) {
        const QImage picture = window.list().thumbnail(i).toImage();
        QCOMPARE(picture.deviceIndependentSize(), QSizeF(LayerList::kThumbnail, LayerList::kThumbnail));
        for (const QImage& other : pictures)
            QCOMPARE_NE(picture, other);
        pictures.push_back(picture);
    }
    window.panel().setCurrentLayer(1);
    window.program.type(QStringLiteral("rotation"), QStringLiteral("90"));
    QCOMPARE_NE(window.list().thumbnail(1).toImage(), pictures[1]);
    // Grooves run up and down as they are, and from left to right when they are turned.
    const QImage up = patternPicture(newLayer(TextureSource::Grooves, {}).pattern, 40);
    for (int x = 0; x < 40; ++x)
        QCOMPARE(up.pixel(x, 3), up.pixel(x, 30));
    QCOMPARE_GT(qGray(up.pixel(20, 3)), 240);
    QCOMPARE_LT(qGray(up.pixel(12, 3)), 15); // a ridge and a groove: 16 to a repeat
}

// Height of a repeat's middle and of its edge, which the wave's closed form has as 1 and 0 where the edges
// are narrow enough, half of it covered by a mask.
void TestLayerViews::flatGroundIsWhatIsFelt() {
    TextureLayer layer = newLayer(TextureSource::Grooves, {});
    layer.pattern.size = 0.01;
    layer.strength = 1e-4;
    const FlatGround ground = flatGround({layer}, {90, 0.03, TextureTarget::Height, 0});
    QCOMPARE(ground.values.size(), std::size_t(90 * 90));
    COMPARE_NEAR(ground.at(0.5, 0.2), 1e-4, 2e-6, ""); // the origin is the middle of a ridge
    QCOMPARE_LT(std::abs(ground.at(0.5 + 0.5 / 3, 0.2)), 2e-6);
    QCOMPARE_NE(ground.picture.pixel(33, 45), ground.picture.pixel(57, 45)); // lit from one side
    layer.opacity = 0.5;
    COMPARE_NEAR(flatGround({layer}, {90, 0.03, TextureTarget::Height, 0}).at(0.5, 0.2), 5e-5, 1e-6, "");
    layer = withTarget(layer, TextureTarget::StaticFriction);
    const FlatGround friction = flatGround({layer}, {90, 0.03, TextureTarget::StaticFriction, 0});
    COMPARE_NEAR(friction.high, 1.25, 0.01, "");
    COMPARE_NEAR(friction.low, 1, 0.01, "");
    Layered window(folder_);
    window.add({"layer-grooves"});
    QTRY_VERIFY_WITH_TIMEOUT(window.panel().swatch().ground().high > 1e-4, kPatience);
    COMPARE_CONTAINS(window.panel().swatch().readingAt({50, 50}), QStringLiteral("\u00b5m"));
}

// The finger goes 20 mm to the right over the front side, along the normal x of ridges 5 mm apart.
void TestLayerViews::aStrokeGivesTheProfile() {
    Layered window(folder_);
    window.add({"layer-grooves"});
    window.choose("mapping", int(TextureMapping::Planar));
    window.program.type(QStringLiteral("size"), QStringLiteral("5"));
    window.program.type(QStringLiteral("height"), QStringLiteral("0.1"));
    COMPARE_CONTAINS(window.panel().chart().hint(), QStringLiteral("Stroke the model"));
    QTRY_VERIFY_WITH_TIMEOUT(window.program.caughtUp(), kPatience);
    const double radius = window.program.document.scene().proxyRadius;
    std::vector<TracePoint> stroke;
    for (int i = 0; i <= 400; ++i) {
        TracePoint point;
        point.t = 1000 + 1e-3 * i;
        point.proxy = {-0.01 + 5e-5 * i, 0, 0.05 + radius};
        point.touching = true;
        stroke.push_back(point);
    }
    TracePoint lifted;
    lifted.t = 1002;
    stroke.push_back(lifted);
    window.panel().take(stroke, 0);
    const ProfileChart& chart = window.panel().chart();
    QTRY_VERIFY_WITH_TIMEOUT(chart.profile().any(), kPatience);
    const LayerProfile& profile = chart.profile();
    COMPARE_NEAR(profile.length, 0.02, 1e-9, "");
    const WaveShape wave = waveShape(kTextureFill.initial, kTextureSoftness.initial);
    for (std::size_t i = 0; i < profile.values.size(); i += 50) {
        const double x = -0.01 + profile.wayOf(i);
        double expected = wave.mean;
        for (int n = 1; n <= wave.harmonics; ++n)
            expected += wave.amplitude[std::size_t(n - 1)] * std::cos(2 * EIGEN_PI * n * x / 5e-3);
        COMPARE_NEAR(profile.values[i], 1e-4 * expected, 1e-9, "");
    }
    // An edit is seen at once.
    window.program.type(QStringLiteral("height"), QStringLiteral("0.2"));
    QTRY_VERIFY_WITH_TIMEOUT(std::ranges::max(chart.profile().values) > 1.9e-4, kPatience);
    // Another surface was not stroked.
    window.program.document.select(SurfaceRef{window.id, 0});
    window.add({"layer-grooves"});
    QTRY_VERIFY_WITH_TIMEOUT(chart.hint().contains(QStringLiteral("not on this surface")), kPatience);
}

void TestLayerViews::aDroppedPictureBecomesALayer() {
    Layered window(folder_);
    const Scene before = window.program.document.scene();
    window.program.document.select(SurfaceRef{window.id, 0});
    const QString file = writeRamp(folder_, QStringLiteral("bark.png"));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    MainWindow& main = *window.program.window;
    const QPoint place = main.view().mapTo(&main, window.program.centre());
    QSignalSpy lit(&main.view(), &SceneView::surfaceHovered);
    const auto dropAt = [&](QPoint at) {
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&main, &enter);
        QDragMoveEvent over(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&main, &over);
        QDropEvent drop(at, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&main, &drop);
    };
    dropAt(place);
    QVERIFY(!lit.isEmpty());
    const SurfaceRef front{window.id, Layered::kFront};
    QVERIFY(lit.front()[0].value<std::optional<SurfaceRef>>() == front);
    QTRY_COMPARE_WITH_TIMEOUT(window.layers().size(), std::size_t(1), kPatience);
    const TextureLayer& layer = window.layers().front();
    QCOMPARE(layer.name, std::string("bark"));
    QCOMPARE(layer.pattern.source, TextureSource::Image);
    QCOMPARE(layer.pattern.image->width(), 64);
    QCOMPARE(layer.pattern.image->row(0)[10], 40 * 257);
    QCOMPARE(window.program.document.selection()->surface, Layered::kFront);
    QCOMPARE(window.program.document.path().filename(),
             std::filesystem::path("cube.obj")); // nothing was opened
    window.undoAll();
    QVERIFY(window.program.document.scene() == before);
    // On the panel it becomes one of what is selected.
    window.program.document.select(SurfaceRef{window.id, 1});
    const QPoint onPanel = window.panel().mapTo(&main, window.panel().rect().center());
    dropAt(onPanel);
    QTRY_COMPARE_WITH_TIMEOUT(window.layers(1).size(), std::size_t(1), kPatience);
}

void TestLayerViews::theMappingIsDragged() {
    Layered window(folder_);
    SceneView& view = window.program.window->view();
    window.add({"layer-grooves"});
    window.choose("mapping", int(TextureMapping::Cylindrical));
    QVERIFY(!view.mapping().frame());
    window.program.command("mapping").trigger();
    QVERIFY(view.mapping().frame());
    const int steps = window.program.document.history().count();
    const auto pattern = [&] { return window.layers().front().pattern; };
    const TexturePattern before = pattern();
    const auto drag = [&](MappingHandle handle, QPoint by) {
        const QPoint from = view.mapping().placeOf(handle, view.camera())->toPoint();
        window.program.press(from);
        for (int i = 1; i <= 4; ++i)
            window.program.moveTo(from + by * i / 4);
        window.program.release(from + by);
    };
    // z of the cylinder is up.
    drag(MappingHandle::MoveZ, {0, -40});
    const Vec3 up = pattern().frame.translation - before.frame.translation;
    const double pixel = view.camera().pixelSize(before.frame.translation);
    COMPARE_NEAR(up.y(), 40 * pixel, 3 * pixel, "");
    QCOMPARE_LT(std::abs(up.x()), 1e-9);
    QCOMPARE_LT(std::abs(up.z()), 1e-9);
    QCOMPARE(window.program.document.history().count(), steps + 1);
    drag(MappingHandle::Size, {20, 0});
    QCOMPARE_NE(pattern().size, before.size);
    drag(MappingHandle::Radius, {30, 0});
    QCOMPARE_GT(pattern().radius, before.radius);
    drag(MappingHandle::TurnZ, {20, 0});
    QCOMPARE_GT(pattern().frame.rotation.angularDistance(before.frame.rotation), 0.1);
    QCOMPARE(window.program.document.history().count(), steps + 4);
    for (int i = 0; i < 4; ++i)
        window.program.document.history().undo();
    QVERIFY(pattern() == before);
    // Coordinates of the mesh have no frame.
    window.choose("mapping", int(TextureMapping::Uv));
    QVERIFY(!view.mapping().frame());
    QVERIFY(!window.program.command("mapping").isEnabled());
    // G of who moves things.
    window.program.document.history().undo();
    QVERIFY(view.mapping().frame());
    QTest::keyClick(window.program.window.get(), Qt::Key_Q);
    QTest::keyClick(&view, Qt::Key_G);
    QVERIFY(!view.mapping().frame());
    QTest::keyClick(&view, Qt::Key_G);
    QVERIFY(view.mapping().frame());
}

void TestLayerViews::theHandlesAreThoseOfThePanelInFront() {
    Layered window(folder_);
    SceneView& view = window.program.window->view();
    window.add({"layer-grooves"});
    window.choose("mapping", int(TextureMapping::Planar));
    window.program.command("mapping").trigger();
    QVERIFY(view.mapping().frame());
    window.dock("dock-body")->raise();
    window.program.frames(3);
    QVERIFY(!view.mapping().frame());
    window.dock("dock-layers")->raise();
    window.program.frames(3);
    QVERIFY(view.mapping().frame());
    // Who asks for them behind another panel sees them, and the panel that they are of.
    window.dock("dock-body")->raise();
    window.program.frames(3);
    QTest::keyClick(window.program.window.get(), Qt::Key_Q);
    QTest::keyClick(&view, Qt::Key_G);
    window.program.frames(3);
    QVERIFY(!window.panel().visibleRegion().isEmpty()); // Qt calls what lies behind a tab visible, too
    QVERIFY(view.mapping().frame());
    // Without any panel the view keeps them.
    window.program.command("panels").trigger();
    window.program.frames(3);
    QVERIFY(!window.panel().isVisible());
    QVERIFY(view.mapping().frame());
}

TACTUM_GUI_TEST(TestLayerViews)

} // namespace test_layer_views

#include "test_layer_views.moc"
