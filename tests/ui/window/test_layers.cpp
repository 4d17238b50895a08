// The layers of a surface in the window: added, edited, ordered, tried alone, dropped, moved about the model.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

#include "tests/ui/window/window_fixture.h"
#include "ui/layer_picture.h"
#include "ui/panels/flat_swatch.h"
#include "ui/panels/layer_list.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/profile_chart.h"
#include "ui/view/scene_view.h"

using namespace tactum;

namespace {

/// The window with the cube, its front side selected and the dock of layers in front.
struct Layered {
    explicit Layered(const QTemporaryDir& folder) {
        if (!program.open(writeCube(folder))) qFatal("the cube cannot be opened");
        program.window->view().showStandardView(StandardView::Front);
        id = program.document.scene().objects.front().id;
        program.document.select(SurfaceRef{id, kFront});
        dock("dock-layers")->raise();
        program.frames(10);
    }

    QWidget* dock(const char* name) const { return program.window->findChild<QWidget*>(QLatin1String(name)); }
    LayerPanel& panel() const { return *program.window->findChild<LayerPanel*>(); }
    LayerList& list() const { return *program.window->findChild<LayerList*>(); }
    void choose(const char* box, int choice) const {
        auto* list = program.window->findChild<QComboBox*>(QLatin1String(box));
        list->setCurrentIndex(choice);
        emit list->activated(choice);
    }
    const TextureLayers& layers(Index surface = kFront) const {
        return program.document.scene().objects.front().surfaces[surface].layers;
    }
    std::string names() const {
        std::string all;
        for (const TextureLayer& layer : layers())
            all += (all.empty() ? "" : " ") + layer.name;
        return all;
    }
    void add(std::initializer_list<const char*> ids) {
        for (const char* each : ids)
            program.command(each).trigger();
    }
    QPoint middleOf(int row, int column = 0) const {
        return list().visualRect(list().model()->index(row, column)).center();
    }
    void click(int row, int column) const {
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, middleOf(row, column));
    }
    /// What the loops have of the front side.
    const TextureStack* felt() const {
        return program.window->publisher().world()->bodies.at(0).textures.at(kFront).get();
    }
    void undoAll() {
        while (program.document.history().canUndo())
            program.document.history().undo();
    }

    static constexpr Index kFront = 4;
    TouchedWindow program;
    ObjectId id = 0;
};

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

class TestLayers : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void layersAreAddedToAllSelectedSurfaces();
    void eachEditIsOneStep();
    void noMoreThanAreFelt();
    void anotherTargetBeginsAnew();
    void onlyWhatMattersIsShown();
    void rowsAreDraggedIntoAnotherOrder();
    void keysDoItAll();
    void theEyeSwitchesOff();
    void soloIsFeltAndForgotten();
    void aLockedSurfaceStays();
    void thumbnailsDiffer();
    void flatGroundIsWhatIsFelt();
    void aStrokeGivesTheProfile();
    void aDroppedPictureBecomesALayer();
    void theMappingIsDragged();
    void whatIsPaintedIsKnown();
};

void TestLayers::layersAreAddedToAllSelectedSurfaces() {
    Layered window(folder_);
    const Scene before = window.program.document.scene();
    window.program.document.select({SurfaceRef{window.id, 0}, SurfaceRef{window.id, Layered::kFront}});
    window.add({"layer-grooves", "layer-grooves"});
    QCOMPARE(window.names(), std::string("Grooves Grooves 2"));
    QCOMPARE(window.layers(0), window.layers());
    QVERIFY(window.layers(1).empty());
    QCOMPARE(window.program.document.history().count(), 2);
    QCOMPARE(window.panel().currentLayer(), std::optional(1));
    QCOMPARE(window.list().topLevelItem(0)->text(0), QStringLiteral("Grooves 2")); // topmost first
    QTRY_VERIFY_WITH_TIMEOUT(window.program.caughtUp(), kPatience);
    QCOMPARE(window.felt()->layers.size(), std::size_t(2));
    window.undoAll();
    QVERIFY(window.program.document.scene() == before);
    QVERIFY(!window.panel().currentLayer());
}

void TestLayers::noMoreThanAreFelt() {
    Layered window(folder_);
    window.add({"layer-noise"});
    for (int i = 1; i < kMostTextureLayers + 3; ++i)
        window.program.command("layer-duplicate").trigger();
    QCOMPARE(int(window.layers().size()), kMostTextureLayers);
    QCOMPARE(window.layers().back().name, "Noise " + std::to_string(kMostTextureLayers));
    auto* notice = window.program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    QVERIFY(notice->isVisible() && notice->text().contains(QStringLiteral("16 layers")));
}

void TestLayers::eachEditIsOneStep() {
    Layered window(folder_);
    const Scene before = window.program.document.scene();
    window.add({"layer-noise"});
    const auto layer = [&]() -> const TextureLayer& { return window.layers().front(); };
    window.program.type(QStringLiteral("height"), QStringLiteral("0.35"));
    QCOMPARE(layer().strength, 3.5e-4); // mm on the screen
    window.program.type(QStringLiteral("opacity"), QStringLiteral("0.5"));
    QCOMPARE(layer().opacity, 0.5);
    window.choose("layer-blend", int(TextureBlend::Maximum));
    QCOMPARE(layer().blend, TextureBlend::Maximum);
    window.choose("layer-source", int(TextureSource::Dots));
    QCOMPARE(layer().pattern.source, TextureSource::Dots);
    window.program.type(QStringLiteral("size"), QStringLiteral("4"));
    QCOMPARE(layer().pattern.size, 4e-3);
    window.choose("mapping", int(TextureMapping::Planar));
    QVERIFY((layer().pattern.frame.translation - Vec3(0, 0, 0.05)).norm() <
            1e-12); // in the middle of the side
    window.choose("mask-source", 1 + int(TextureSource::Grooves));
    QVERIFY(layer().mask && layer().mask->source == TextureSource::Grooves);
    window.program.type(QStringLiteral("mask-fill"), QStringLiteral("0.25"));
    QCOMPARE(layer().mask->fill, 0.25);
    QCOMPARE(layer().pattern.fill, kTextureFill.initial);
    QCOMPARE(window.program.document.history().count(), 9);
    window.undoAll();
    QVERIFY(window.program.document.scene() == before);
}

void TestLayers::anotherTargetBeginsAnew() {
    Layered window(folder_);
    window.add({"layer-grooves"});
    window.program.type(QStringLiteral("height"), QStringLiteral("-0.1"));
    window.choose("layer-target", int(TextureTarget::StaticFriction));
    const auto layer = [&]() -> const TextureLayer& { return window.layers().front(); };
    QCOMPARE(layer().strength, -kTextureRatio.initial);
    QVERIFY(window.program.box(QStringLiteral("ratio")).isVisible());
    QVERIFY(!window.program.box(QStringLiteral("height")).isVisible());
    window.program.type(QStringLiteral("ratio"), QStringLiteral("0.8"));
    window.choose("layer-target", int(TextureTarget::Viscosity)); // the same unit: it stays
    QCOMPARE(layer().strength, 0.8);
    window.choose("layer-target", int(TextureTarget::Height));
    QCOMPARE(layer().strength, kTextureHeight.initial);
    QCOMPARE(targetText(layer()), QStringLiteral("Height 0.20 mm"));
    // A plane of its own is of a height alone.
    TextureLayer own = layer();
    own.ownPlane = true;
    QVERIFY(!withTarget(own, TextureTarget::Stiffness).ownPlane);
}

void TestLayers::onlyWhatMattersIsShown() {
    Layered window(folder_);
    window.add({"layer-noise"});
    const auto shown = [&](const char* key) {
        return window.program.box(QLatin1String(key)).isVisibleTo(&window.panel());
    };
    QVERIFY(shown("octaves") && shown("seed") && !shown("fill") && !shown("mapping-radius"));
    window.choose("layer-source", int(TextureSource::Grooves));
    QVERIFY(shown("fill") && shown("softness") && !shown("octaves"));
    window.choose("mapping", int(TextureMapping::Spherical));
    QVERIFY(shown("mapping-radius"));
    // A height that is multiplied takes the bare pattern.
    window.choose("layer-blend", int(TextureBlend::Multiply));
    QVERIFY(!shown("height"));
    window.choose("layer-source", int(TextureSource::Painted));
    QVERIFY(!shown("size") && !shown("rotation") && !shown("mapping-radius"));
}

void TestLayers::rowsAreDraggedIntoAnotherOrder() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves", "layer-dots"});
    QCOMPARE(window.names(), std::string("Noise Grooves Dots"));
    QWidget* rows = window.list().viewport();
    const auto drag = [&](int from, QPoint to) {
        QTest::mousePress(rows, Qt::LeftButton, {}, window.middleOf(from));
        for (const QPoint at : {0.5 * (window.middleOf(from) + to), to}) {
            QMouseEvent move(QEvent::MouseMove, at, rows->mapToGlobal(QPointF(at)), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(rows, &move);
        }
        QTest::mouseRelease(rows, Qt::LeftButton, {}, to);
    };
    drag(0, window.middleOf(2) + QPoint(0, 12)); // the topmost beneath the lowest
    QCOMPARE(window.names(), std::string("Dots Noise Grooves"));
    QCOMPARE(window.panel().currentLayer(), std::optional(0)); // the same layer is selected
    drag(2, window.middleOf(1) - QPoint(0, 12));
    QCOMPARE(window.names(), std::string("Noise Dots Grooves"));
    drag(0, window.middleOf(1) + QPoint(0, 12)); // down by one
    QCOMPARE(window.names(), std::string("Noise Grooves Dots"));
    QCOMPARE(window.program.document.history().count(), 6);
    window.program.document.history().undo();
    window.program.document.history().undo();
    QCOMPARE(window.panel().currentLayer(), std::optional(2));
}

void TestLayers::keysDoItAll() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves"});
    LayerList& list = window.list();
    list.setFocus();
    QTest::keyClick(&list, Qt::Key_Down);
    QCOMPARE(window.panel().currentLayer(), std::optional(0));
    QTest::keyClick(&list, Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(window.names(), std::string("Noise Noise 2 Grooves"));
    QCOMPARE(window.panel().currentLayer(), std::optional(1));
    QTest::keyClick(&list, Qt::Key_Up, Qt::AltModifier);
    QCOMPARE(window.names(), std::string("Noise Grooves Noise 2"));
    QTest::keyClick(&list, Qt::Key_Up, Qt::AltModifier); // it is the topmost
    QTest::keyClick(&list, Qt::Key_Down, Qt::AltModifier);
    QTest::keyClick(&list, Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(window.names(), std::string("Noise 2 Noise Grooves"));
    QTest::keyClick(&list, Qt::Key_Delete);
    QCOMPARE(window.names(), std::string("Noise Grooves"));
    QTest::keyClick(&list, Qt::Key_F2);
    auto* editor = list.findChild<QLineEdit*>();
    QVERIFY(editor);
    editor->setText(QStringLiteral("clay"));
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(window.names(), std::string("clay Grooves"), kPatience);
}

void TestLayers::theEyeSwitchesOff() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves"});
    window.click(0, 1);
    QVERIFY(!window.layers()[1].enabled && window.layers()[0].enabled);
    QCOMPARE(window.felt()->layers.size(), std::size_t(1));
    window.list().setFocus();
    QTest::keyClick(&window.list(), Qt::Key_Space);
    QVERIFY(window.layers()[1].enabled);
    QCOMPARE(window.program.document.history().count(), 4);
}

// Solo is felt, but no part of the scene: nothing of it is saved, and all comes back.
void TestLayers::soloIsFeltAndForgotten() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves", "layer-dots"});
    window.click(1, 1); // the grooves are off
    const Scene before = window.program.document.scene();
    const int steps = window.program.document.history().count();
    window.click(2, 2); // the noise alone
    QCOMPARE(window.felt()->layers.size(), std::size_t(1));
    QCOMPARE(window.felt()->layers[0].pattern.source, TextureSource::Noise);
    QVERIFY(window.program.document.scene() == before);
    QCOMPARE(window.program.document.history().count(), steps);
    // One that is off can be tried too, and follows its layer.
    window.click(1, 2);
    QCOMPARE(window.felt()->layers[0].pattern.source, TextureSource::Grooves);
    window.panel().moveLayer(1, 2);
    QCOMPARE(window.panel().solo()->layer, 2);
    QCOMPARE(window.felt()->layers[0].pattern.source, TextureSource::Grooves);
    window.program.document.history().undo();
    QCOMPARE(window.panel().solo()->layer, 1);
    window.click(1, 2);
    QVERIFY(!window.panel().solo());
    QCOMPARE(window.felt()->layers.size(), std::size_t(2));
    QVERIFY(window.program.document.scene() == before);
    // It ends with the selection of another surface, and with the layer.
    window.click(1, 2);
    window.program.document.select(SurfaceRef{window.id, 0});
    QCOMPARE(window.felt()->layers.size(), std::size_t(2));
    window.program.document.select(SurfaceRef{window.id, Layered::kFront});
    window.click(0, 2);
    window.panel().setCurrentLayer(2);
    window.panel().remove();
    QVERIFY(!window.panel().solo());
    QCOMPARE(window.felt()->layers.size(), std::size_t(1));
}

void TestLayers::aLockedSurfaceStays() {
    Layered window(folder_);
    window.add({"layer-noise"});
    QVERIFY(window.program.command("layer-remove").isEnabled());
    window.program.document.setLocked(SurfaceRef{window.id, Layered::kFront}, true);
    const Scene before = window.program.document.scene();
    QVERIFY(!window.list().isEnabled());
    QVERIFY(!window.program.box(QStringLiteral("height")).isEnabled());
    for (const char* id : {"layer-noise", "layer-image", "layer-remove", "layer-duplicate", "mapping"})
        QVERIFY2(!window.program.command(id).isEnabled(), id);
    window.panel().add(TextureSource::Dots);
    window.panel().remove();
    window.panel().toggleShown(0);
    QVERIFY(window.program.document.scene() == before);
    auto* hint = window.program.window->findChild<QLabel*>(QStringLiteral("layer-hint"));
    QVERIFY(hint->isVisible() && hint->text().contains(QStringLiteral("locked")));
}

void TestLayers::thumbnailsDiffer() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves", "layer-dots", "layer-weave", "layer-painted"});
    std::vector<QImage> pictures;
    for (int i = 0; i < int(window.layers().size()); ++i) {
        const QImage picture = window.list().thumbnail(i).toImage();
        QCOMPARE(picture.deviceIndependentSize(), QSizeF(LayerList::kThumbnail, LayerList::kThumbnail));
        for (const QImage& other : pictures)
            QVERIFY(picture != other);
        pictures.push_back(picture);
    }
    window.panel().setCurrentLayer(1);
    window.program.type(QStringLiteral("rotation"), QStringLiteral("90"));
    QVERIFY(window.list().thumbnail(1).toImage() != pictures[1]);
    // Grooves run up and down as they are, and from left to right when they are turned.
    const QImage up = patternPicture(newLayer(TextureSource::Grooves, {}).pattern, 40);
    for (int x = 0; x < 40; ++x)
        QCOMPARE(up.pixel(x, 3), up.pixel(x, 30));
    QVERIFY(qGray(up.pixel(20, 3)) > 240 &&
            qGray(up.pixel(12, 3)) < 15); // a ridge and a groove: 16 to a repeat
}

// Height of a repeat's middle and of its edge, which the wave's closed form has as 1 and 0 where the edges
// are narrow enough, half of it covered by a mask.
void TestLayers::flatGroundIsWhatIsFelt() {
    TextureLayer layer = newLayer(TextureSource::Grooves, {});
    layer.pattern.size = 0.01;
    layer.strength = 1e-4;
    const FlatGround ground = flatGround({layer}, {90, 0.03, TextureTarget::Height, 0});
    QCOMPARE(ground.values.size(), std::size_t(90 * 90));
    QVERIFY(std::abs(ground.at(0.5, 0.2) - 1e-4) < 2e-6); // the origin is the middle of a ridge
    QVERIFY(std::abs(ground.at(0.5 + 0.5 / 3, 0.2)) < 2e-6);
    QVERIFY(ground.picture.pixel(33, 45) != ground.picture.pixel(57, 45)); // lit from one side
    layer.opacity = 0.5;
    QVERIFY(std::abs(flatGround({layer}, {90, 0.03, TextureTarget::Height, 0}).at(0.5, 0.2) - 5e-5) < 1e-6);
    layer = withTarget(layer, TextureTarget::StaticFriction);
    const FlatGround friction = flatGround({layer}, {90, 0.03, TextureTarget::StaticFriction, 0});
    QVERIFY(std::abs(friction.high - 1.25) < 0.01 && std::abs(friction.low - 1) < 0.01);
    Layered window(folder_);
    window.add({"layer-grooves"});
    QTRY_VERIFY_WITH_TIMEOUT(window.panel().swatch().ground().high > 1e-4, kPatience);
    QVERIFY(window.panel().swatch().readingAt({50, 50}).contains(QStringLiteral("\u00b5m")));
}

// The finger goes 20 mm to the right over the front side, along the normal x of ridges 5 mm apart.
void TestLayers::aStrokeGivesTheProfile() {
    Layered window(folder_);
    window.add({"layer-grooves"});
    window.choose("mapping", int(TextureMapping::Planar));
    window.program.type(QStringLiteral("size"), QStringLiteral("5"));
    window.program.type(QStringLiteral("height"), QStringLiteral("0.1"));
    QVERIFY(window.panel().chart().hint().contains(QStringLiteral("Stroke the model")));
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
    QVERIFY(std::abs(profile.length - 0.02) < 1e-9);
    const WaveShape wave = waveShape(kTextureFill.initial, kTextureSoftness.initial);
    for (std::size_t i = 0; i < profile.values.size(); i += 50) {
        const double x = -0.01 + profile.wayOf(i);
        double expected = wave.mean;
        for (int n = 1; n <= wave.harmonics; ++n)
            expected += wave.amplitude[std::size_t(n - 1)] * std::cos(2 * EIGEN_PI * n * x / 5e-3);
        QVERIFY2(std::abs(profile.values[i] - 1e-4 * expected) < 1e-9, qPrintable(QString::number(x)));
    }
    // An edit is seen at once.
    window.program.type(QStringLiteral("height"), QStringLiteral("0.2"));
    QTRY_VERIFY_WITH_TIMEOUT(std::ranges::max(chart.profile().values) > 1.9e-4, kPatience);
    // Another surface was not stroked.
    window.program.document.select(SurfaceRef{window.id, 0});
    window.add({"layer-grooves"});
    QTRY_VERIFY_WITH_TIMEOUT(chart.hint().contains(QStringLiteral("not on this surface")), kPatience);
}

void TestLayers::aDroppedPictureBecomesALayer() {
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
    QCOMPARE(layer.pattern.image->row(layer.pattern.image->level(0), 0)[10], 40 * 257);
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

void TestLayers::theMappingIsDragged() {
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
    QVERIFY(std::abs(up.y() - 40 * pixel) < 3 * pixel);
    QVERIFY(std::abs(up.x()) < 1e-9 && std::abs(up.z()) < 1e-9);
    QCOMPARE(window.program.document.history().count(), steps + 1);
    drag(MappingHandle::Size, {20, 0});
    QVERIFY(pattern().size != before.size);
    drag(MappingHandle::Radius, {30, 0});
    QVERIFY(pattern().radius > before.radius);
    drag(MappingHandle::TurnZ, {20, 0});
    QVERIFY(pattern().frame.rotation.angularDistance(before.frame.rotation) > 0.1);
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

void TestLayers::whatIsPaintedIsKnown() {
    Layered window(folder_);
    QSignalSpy told(&window.panel(), &LayerPanel::currentLayerChanged);
    window.add({"layer-painted"});
    QCOMPARE(told.count(), 1);
    QCOMPARE(window.panel().currentLayer(), std::optional(0));
    QVERIFY(!window.panel().maskIsEdited());
    window.choose("mask-source", 1 + int(TextureSource::Painted));
    QVERIFY(!window.panel().maskIsEdited()); // both can be painted: the layer first
    QTest::mouseClick(window.dock("mask-paint"), Qt::LeftButton);
    QVERIFY(window.panel().maskIsEdited());
    QTest::mouseClick(window.dock("mask-paint"), Qt::LeftButton);
    window.choose("layer-source", int(TextureSource::Noise));
    QVERIFY(window.panel().maskIsEdited()); // nothing else can be
    window.choose("mask-source", 0);
    QVERIFY(!window.panel().maskIsEdited());
}

QTEST_MAIN(TestLayers)
#include "test_layers.moc"
