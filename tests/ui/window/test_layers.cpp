// The layers of a surface in the window: added, edited, ordered, tried alone.
#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/layered_window.h"
#include "ui/widgets/picture_grid.h"

namespace test_layers {

using namespace tactum;

class TestLayers : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

private slots:
    static void initMain() { prepareProcess(); }
    void init() { useSettingsIn(folder_.path()); }

    void layersAreAddedToAllSelectedSurfaces();
    void aLayerIsChosenFromPictures();
    void eachEditIsOneStep();
    void noMoreThanAreFelt();
    void anotherTargetBeginsAnew();
    void onlyWhatMattersIsShown();
    void rowsAreDraggedIntoAnotherOrder();
    void keysDoItAll();
    void onlyWhatHasRoomMovesUpOrDown();
    void theEyeSwitchesOff();
    void soloIsFeltAndForgotten();
    void aLockedSurfaceStays();
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

void TestLayers::aLayerIsChosenFromPictures() {
    Layered window(folder_);
    auto* add = window.panel().findChild<QToolButton*>(QStringLiteral("layer-add"));
    auto* kinds = window.panel().findChild<PictureGrid*>(QStringLiteral("layer-kinds"));
    QVERIFY(!kinds->isVisible());
    QTest::mouseClick(add, Qt::LeftButton);
    QVERIFY(kinds->isVisible());
    QCOMPARE(kinds->headings().size(), 3); // patterns, pictures, of presets
    std::vector<QImage> pictures;
    for (QListWidgetItem* each : kinds->pictures()) {
        const QImage picture = each->data(Qt::DecorationRole).value<QPixmap>().toImage();
        QVERIFY(!picture.isNull());
        QVERIFY(std::ranges::find(pictures, picture) == pictures.end());
        pictures.push_back(picture);
    }
    const auto place = [&](const char* name) {
        QListWidgetItem* item = kinds->findItems(QString::fromLatin1(name), Qt::MatchExactly).value(0);
        if (!item) qFatal("no %s", name);
        kinds->scrollToItem(item);
        return kinds->visualItemRect(item).center();
    };
    QTest::mouseClick(kinds->viewport(), Qt::LeftButton, {}, place("Dots"));
    QTRY_COMPARE_WITH_TIMEOUT(window.names(), std::string("Dots"), kPatience);
    QVERIFY(!kinds->isVisible());
    // By keys: the first is there, letters lead to another, Enter takes it.
    QTest::mouseClick(add, Qt::LeftButton);
    QTest::keyClicks(kinds, QStringLiteral("we"));
    QTest::keyClick(kinds, Qt::Key_Return);
    QTRY_COMPARE_WITH_TIMEOUT(window.names(), std::string("Dots Weave"), kPatience);
    // A preset's layer comes as it is there, in one step, and takes nothing else along.
    const Material before = window.program.document.scene().objects[0].surfaces[Layered::kFront].material;
    QTest::mouseClick(add, Qt::LeftButton);
    QTest::mouseClick(kinds->viewport(), Qt::LeftButton, {}, place("Brick"));
    QTRY_COMPARE_WITH_TIMEOUT(window.names(), std::string("Dots Weave grain"), kPatience);
    QCOMPARE(window.layers().back().strength, 4e-4);
    QVERIFY(window.program.document.scene().objects[0].surfaces[Layered::kFront].material == before);
    QCOMPARE(window.program.document.history().count(), 3);
    // A heading folds and takes nothing; Esc closes.
    QTest::mouseClick(add, Qt::LeftButton);
    kinds->scrollToTop();
    QTest::mouseClick(kinds->viewport(), Qt::LeftButton, {},
                      kinds->visualItemRect(kinds->headings().front()).center());
    QVERIFY(kinds->isVisible());
    QVERIFY(kinds->pictures().front()->isHidden());
    QTest::keyClick(kinds, Qt::Key_Escape);
    QVERIFY(!kinds->isVisible());
    QCOMPARE(window.program.document.history().count(), 3);
}

void TestLayers::noMoreThanAreFelt() {
    Layered window(folder_);
    window.add({"layer-noise"});
    for (int i = 1; i < kMaxTextureLayers + 3; ++i)
        window.program.command("layer-duplicate").trigger();
    QCOMPARE(int(window.layers().size()), kMaxTextureLayers);
    QCOMPARE(window.layers().back().name, "Noise " + std::to_string(kMaxTextureLayers));
    auto* notice = window.program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    QVERIFY(notice->isVisible());
    COMPARE_CONTAINS(notice->text(), QStringLiteral("16 layers"));
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
    COMPARE_NEAR(layer().pattern.frame.translation, Vec3(0, 0, 0.05), 1e-12,
                 "m"); // in the middle of the side
    window.choose("mask-source", 1 + int(TextureSource::Grooves));
    QVERIFY(layer().mask);
    QCOMPARE_EQ(layer().mask->source, TextureSource::Grooves);
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
    QVERIFY(shown("octaves"));
    QVERIFY(shown("seed"));
    QVERIFY(!shown("fill"));
    QVERIFY(!shown("mapping-radius"));
    window.choose("layer-source", int(TextureSource::Grooves));
    QVERIFY(shown("fill"));
    QVERIFY(shown("softness"));
    QVERIFY(!shown("octaves"));
    window.choose("mapping", int(TextureMapping::Spherical));
    QVERIFY(shown("mapping-radius"));
    // A height that is multiplied takes the bare pattern.
    window.choose("layer-blend", int(TextureBlend::Multiply));
    QVERIFY(!shown("height"));
    window.choose("layer-source", int(TextureSource::Painted));
    QVERIFY(!shown("size"));
    QVERIFY(!shown("rotation"));
    QVERIFY(!shown("mapping-radius"));
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

void TestLayers::onlyWhatHasRoomMovesUpOrDown() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves"});
    const auto may = [&](const char* id) { return window.program.command(id).isEnabled(); };
    QVERIFY(!may("layer-up")); // the topmost is chosen
    QVERIFY(may("layer-down"));
    window.program.command("layer-down").trigger();
    QCOMPARE(window.names(), std::string("Grooves Noise"));
    QVERIFY(may("layer-up"));
    QVERIFY(!may("layer-down"));
}

void TestLayers::theEyeSwitchesOff() {
    Layered window(folder_);
    window.add({"layer-noise", "layer-grooves"});
    window.click(0, 1);
    QVERIFY(!window.layers()[1].enabled);
    QVERIFY(window.layers()[0].enabled);
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
    QVERIFY(hint->isVisible());
    COMPARE_CONTAINS(hint->text(), QStringLiteral("locked"));
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

TACTUM_GUI_TEST(TestLayers)

} // namespace test_layers

#include "test_layers.moc"
