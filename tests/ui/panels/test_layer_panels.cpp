// Layers of texture: their list, what can be set on one, and the panel that edits them.
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>

#include "core/surface/texture_image.h"
#include "core/surface/texture_matters.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/base/shortcuts.h"
#include "ui/panels/flat_swatch.h"
#include "ui/panels/layer_fields.h"
#include "ui/panels/layer_list.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/profile_chart.h"
#include "ui/widgets/number_box.h"

namespace test_layer_panels {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// Three, from the bottom: noise, grooves that are off, dots for the friction.
TextureLayers three() {
    TextureLayers layers{layerOf("Noise", TextureSource::Noise), layerOf("Grooves", TextureSource::Grooves),
                         layerOf("Dots", TextureSource::Dots)};
    layers[1].enabled = false;
    layers[2].target = TextureTarget::StaticFriction;
    layers[2].strength = 0.5;
    return layers;
}

std::shared_ptr<const TextureImage> image() {
    return std::make_shared<const TextureImage>(2, 4, std::vector<std::uint16_t>{0, 1, 2, 3, 4, 5, 6, 65535},
                                                "cloth.png", 8);
}

/// The list on the screen, and what it asks for.
struct Listed {
    Listed() {
        list.resize(240, 200);
        list.setRows(4);
        list.display(three(), 1, std::nullopt);
        list.show();
        if (!QTest::qWaitForWindowExposed(&list)) qFatal("no window");
        const auto note = [this](const QString& what) { told << what; };
        QObject::connect(&list, &LayerList::chosen, &list,
                         [=](int l) { note(QStringLiteral("chosen %1").arg(l)); });
        QObject::connect(&list, &LayerList::renameAsked, &list, [=](int l, const QString& name) {
            note(QStringLiteral("rename %1 %2").arg(l).arg(name));
        });
        QObject::connect(&list, &LayerList::showAsked, &list,
                         [=](int l) { note(QStringLiteral("show %1").arg(l)); });
        QObject::connect(&list, &LayerList::soloAsked, &list,
                         [=](int l) { note(QStringLiteral("solo %1").arg(l)); });
        QObject::connect(&list, &LayerList::moveAsked, &list,
                         [=](int l, int to) { note(QStringLiteral("move %1 %2").arg(l).arg(to)); });
        QObject::connect(&list, &LayerList::removeAsked, &list, [=] { note(QStringLiteral("remove")); });
        QObject::connect(&list, &LayerList::duplicateAsked, &list,
                         [=] { note(QStringLiteral("duplicate")); });
    }
    QStringList taken() { return std::exchange(told, {}); }
    QPoint at(int row, int column = 0, int dy = 0) {
        return list.visualRect(list.model()->index(row, column)).center() + QPoint(0, dy);
    }
    /// From a row to a height.
    QStringList dragged(int row, QPoint to) {
        mouse(*list.viewport(), QEvent::MouseButtonPress, at(row));
        mouse(*list.viewport(), QEvent::MouseMove, to);
        mouse(*list.viewport(), QEvent::MouseButtonRelease, to);
        QStringList moves;
        for (const QString& each : taken())
            if (each.startsWith(QStringLiteral("move"))) moves << each;
        return moves;
    }
    LayerList list;
    QStringList told;
};

} // namespace

class TestLayerPanels : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumLayerPanels"); }

private slots:
    void initTestCase() { applyTheme(ThemeChoice::Dark); }

    void theListShowsTheTopmostFirst() {
        LayerList list;
        list.setRows(1);
        COMPARE_SHOWN(shownIn(list), "layers-none");
        list.display(three(), 1, std::nullopt);
        COMPARE_SHOWN(shownIn(list), "layers");
        list.display(three(), 2, 0);
        COMPARE_SHOWN(shownIn(list), "layers-solo");
        list.setRows(3);
        QCOMPARE(list.height(), 3 * 40 + 2 * list.frameWidth());
        list.setRows(0);
        QCOMPARE(list.height(), 40 + 2 * list.frameWidth());
        const QPixmap noise = list.thumbnail(0), dots = list.thumbnail(2);
        QCOMPARE(noise.deviceIndependentSize().toSize(), QSize(32, 32));
        QVERIFY(noise.toImage() != dots.toImage());
        TextureLayers fewer = three();
        fewer.erase(fewer.begin());
        fewer.push_back(layerOf("Painted", TextureSource::Painted)); // no plane shows it: an icon
        list.display(fewer, std::nullopt, std::nullopt);
        QCOMPARE(list.topLevelItemCount(), 3);
        QCOMPARE(list.thumbnail(1).toImage(), dots.toImage());
        QCOMPARE(list.thumbnail(2).deviceIndependentSize().toSize(), QSize(32, 32));
        QVERIFY(!list.currentItem());
    }

    void rowsAreDrawn() {
        Listed listed;
        COMPARE_SHOWN(drawnBy(*listed.list.viewport())
                          .remove(QRegularExpression(QStringLiteral("^(?!\").*$\n?"),
                                                     QRegularExpression::MultilineOption)),
                      "layers-words");
    }

    void clicksAndKeysAsk() {
        Listed listed;
        LayerList& list = listed.list;
        QWidget& view = *list.viewport();
        QTest::mouseClick(&view, Qt::LeftButton, {}, listed.at(0, 1));
        QCOMPARE(listed.taken().filter(QStringLiteral("show")), QStringList{QStringLiteral("show 2")});
        QTest::mouseClick(&view, Qt::LeftButton, {}, listed.at(2, 2));
        QCOMPARE(listed.taken().filter(QStringLiteral("solo")), QStringList{QStringLiteral("solo 0")});
        QTest::mouseClick(&view, Qt::LeftButton, {}, listed.at(1, 0));
        QCOMPARE(listed.taken(), QStringList{QStringLiteral("chosen 1")});
        const auto key = [&](int of, Qt::KeyboardModifiers with = {}) {
            QTest::keyClick(&list, Qt::Key(of), with);
            return listed.taken().join(u',');
        };
        QCOMPARE(key(Qt::Key_Up, Qt::AltModifier), "move 1 2");
        QCOMPARE(key(Qt::Key_Down, Qt::AltModifier), "move 1 0");
        QCOMPARE(key(Qt::Key_Delete), "remove");
        QCOMPARE(key(Qt::Key_Delete, Qt::ShiftModifier), "");
        QCOMPARE(key(Qt::Key_D, Qt::ControlModifier), "duplicate");
        COMPARE_LACKS(key(Qt::Key_D), "duplicate"); // but letters look for a row
        list.setCurrentItem(list.topLevelItem(1));
        listed.taken();
        QCOMPARE(key(Qt::Key_Space), "show 1");
        QCOMPARE(key(Qt::Key_S), "solo 1");
        QCOMPARE(key(Qt::Key_S, Qt::ControlModifier), "");
        QCOMPARE(key(Qt::Key_Up), "chosen 2");
        QCOMPARE(key(Qt::Key_Down), "chosen 1");
        list.topLevelItem(2)->setText(0, QStringLiteral(" Hair "));
        QCOMPARE(listed.taken().join(u','), "rename 0 Hair");
        list.display(three(), 0, std::nullopt); // shown without telling anybody
        QCOMPARE(listed.taken().join(u','), "");
        list.setCurrentItem(nullptr);
        listed.taken();
        QCOMPARE(key(Qt::Key_Delete), ""); // of none
        list.editName(2);
        auto* editor = list.viewport()->findChild<QLineEdit*>();
        QVERIFY(editor);
        QCOMPARE(editor->accessibleName(), "Name of the layer");
        QCOMPARE(editor->text(), "Dots");
        QCOMPARE(editor->height(), 24);
    }

    void rowsAreDragged() {
        Listed listed;
        // Row 0 is layer 2. Below the middle of a row lies the gap under it.
        QCOMPARE(listed.dragged(0, listed.at(1, 0, 6)), QStringList{QStringLiteral("move 2 1")});
        QCOMPARE(listed.dragged(0, listed.at(2, 0, 6)), QStringList{QStringLiteral("move 2 0")});
        QCOMPARE(listed.dragged(0, listed.at(1, 0, -6)), QStringList()); // the gap that it comes from
        QCOMPARE(listed.dragged(2, listed.at(0, 0, -6)), QStringList{QStringLiteral("move 0 2")});
        QCOMPARE(listed.dragged(2, listed.at(1, 0, -6)), QStringList{QStringLiteral("move 0 1")});
        QCOMPARE(listed.dragged(1, listed.at(2, 0, 60)),
                 QStringList{QStringLiteral("move 1 0")});              // below all
        QCOMPARE(listed.dragged(1, listed.at(1, 0, 3)), QStringList()); // hardly moved
        // By the eye, or with another button, nothing is dragged.
        mouse(*listed.list.viewport(), QEvent::MouseButtonPress, listed.at(0, 1));
        mouse(*listed.list.viewport(), QEvent::MouseMove, listed.at(2, 0, 6));
        mouse(*listed.list.viewport(), QEvent::MouseButtonRelease, listed.at(2, 0, 6));
        QVERIFY(listed.taken().filter(QStringLiteral("move")).isEmpty());
        mouse(*listed.list.viewport(), QEvent::MouseButtonPress, listed.at(0), Qt::RightButton);
        mouse(*listed.list.viewport(), QEvent::MouseMove, listed.at(2, 0, 6), Qt::RightButton);
        mouse(*listed.list.viewport(), QEvent::MouseButtonRelease, listed.at(2, 0, 6), Qt::RightButton);
        QVERIFY(listed.taken().filter(QStringLiteral("move")).isEmpty());
        // The gap is a line in the colour of what is chosen.
        mouse(*listed.list.viewport(), QEvent::MouseButtonPress, listed.at(0));
        mouse(*listed.list.viewport(), QEvent::MouseMove, listed.at(2, 0, 6));
        QCOMPARE(listed.list.cursor().shape(), Qt::ClosedHandCursor);
        const QRect last = listed.list.visualItemRect(listed.list.topLevelItem(2));
        COMPARE_CONTAINS(drawnBy(*listed.list.viewport()),
                         QStringLiteral("rect filled accent (0.0 %1.0) (%2.0 %3.0)")
                             .arg(last.bottom() - 1)
                             .arg(listed.list.viewport()->width())
                             .arg(last.bottom() + 1));
        mouse(*listed.list.viewport(), QEvent::MouseMove, listed.at(0, 0, -6));
        COMPARE_CONTAINS(drawnBy(*listed.list.viewport()), "rect filled accent (0.0 -1.0)");
        mouse(*listed.list.viewport(), QEvent::MouseButtonRelease, listed.at(0, 0, -6));
        COMPARE_LACKS(drawnBy(*listed.list.viewport()), "rect filled accent (0.0 -1.0)");
        QVERIFY(listed.list.cursor().shape() != Qt::ClosedHandCursor);
    }

    void fieldsOfEachKindOfLayer_data() {
        QTest::addColumn<int>("source");
        QTest::addColumn<int>("mapping");
        for (int source = 0; source < 6; ++source)
            for (const int mapping : {0, 2, 3, 4, 5})
                QTest::addRow("%s %s", kTextureSources[std::size_t(source)].key.data(),
                              kTextureMappings[std::size_t(mapping)].key.data())
                    << source << mapping;
    }

    /// Only the numbers that make a difference are there.
    void fieldsOfEachKindOfLayer() {
        QFETCH(int, source);
        QFETCH(int, mapping);
        LayerFields fields([](const QString&, const LayerFields::Change&, Gesture) {});
        TextureLayer layer = layerOf("L", TextureSource(source));
        layer.pattern.mapping = TextureMapping(mapping);
        fields.display(layer, false);
        for (const PatternField& each : kPatternFields) {
            const auto* box = fields.findChild<NumberBox*>(QString::fromUtf8(each.parameter->key.data()));
            QVERIFY(box);
            QCOMPARE(box->parentWidget()->isHidden(), !matters(each, layer.pattern));
        }
        const bool painted = layer.pattern.source == TextureSource::Painted;
        QCOMPARE(part<QComboBox>(fields, "mapping").parentWidget()->isHidden(), painted);
        QCOMPARE(part<QPushButton>(fields, "image-choose").parentWidget()->isHidden(),
                 layer.pattern.source != TextureSource::Image);
    }

    void fieldsAreShown() {
        LayerFields fields([](const QString&, const LayerFields::Change&, Gesture) {});
        TextureLayer layer = layerOf("L", TextureSource::Noise);
        fields.display(layer, false);
        COMPARE_SHOWN(shownIn(fields), "layer-fields");
        layer.pattern.source = TextureSource::Image;
        layer.pattern.image = image();
        layer.pattern.mapping = TextureMapping::Uv;
        layer.target = TextureTarget::Viscosity;
        layer.strength = -0.25;
        layer.blend = TextureBlend::Maximum;
        layer.opacity = 0.5;
        layer.mask = TexturePattern{};
        layer.mask->source = TextureSource::Grooves;
        fields.display(layer, true);
        COMPARE_SHOWN(shownIn(fields), "layer-fields-image");
        COMPARE_CONTAINS(part<QLabel>(fields, "image-name").toolTip(), "2 x 4, 8 bits");
        fields.display(layer, false);
        QCOMPARE(part<QLabel>(fields, "pattern-hint").text(),
                 "The mesh has no texture coordinates, so it is not felt. Triplanar needs none.");
        layer.pattern.image.reset();
        fields.display(layer, true);
        QCOMPARE(part<QLabel>(fields, "image-name").text(), "No picture");
        QCOMPARE(part<QLabel>(fields, "image-name").toolTip(), "");
        layer.target = TextureTarget::Height;
        layer.ownPlane = true;
        layer.pattern.source = TextureSource::Painted;
        layer.mask->source = TextureSource::Painted;
        fields.display(layer, true);
        COMPARE_SHOWN(shownIn(fields), "layer-fields-painted");
        layer.mask.reset();
        layer.ownPlane = false;
        layer.blend = TextureBlend::Multiply; // takes the bare pattern
        fields.display(layer, true);
        QVERIFY(part<NumberBox>(fields, "height").parentWidget()->isHidden());
        QVERIFY(part<QToolButton>(fields, "mask-paint").isHidden());
        layer.blend = TextureBlend::Add;
        fields.display(layer, true);
        QVERIFY(!part<NumberBox>(fields, "height").parentWidget()->isHidden());
    }

    /// Each field changes one thing of the layer, under a name of its own.
    void fieldsEditOneThing() {
        TextureLayer layer = layerOf("L", TextureSource::Image), before;
        layer.pattern.mapping = TextureMapping::Cylindrical;
        layer.mask = TexturePattern{};
        QStringList names;
        LayerFields* shown = nullptr;
        LayerFields fields([&](const QString& what, const LayerFields::Change& change, Gesture) {
            names << what;
            before = layer;
            change(layer);
            shown->display(layer, true);
        });
        shown = &fields;
        fields.display(layer, true);
        const auto only = [&](const char* name, auto change) {
            TextureLayer expected = before;
            change(expected);
            const QString last = names.isEmpty() ? QString() : names.back();
            names.clear();
            return last == QLatin1String(name) && layer == expected && !(layer == before);
        };
        emit part<QComboBox>(fields, "layer-target").activated(4);
        QVERIFY(only("Target", [](TextureLayer& l) { l = withTarget(l, TextureTarget::Stiffness); }));
        part<NumberBox>(fields, "ratio").setValue(0.75);
        QVERIFY(only("Ratio", [](TextureLayer& l) { l.strength = 0.75; }));
        names.clear();
        emit part<QComboBox>(fields, "layer-target").activated(0);
        names.clear();
        part<NumberBox>(fields, "height").setValue(0.3);
        COMPARE_NEAR(layer.strength, 3e-4, 1e-12, "m");
        names.clear();
        part<QCheckBox>(fields, "layer-own-plane").click();
        QVERIFY(only("Own plane", [](TextureLayer& l) { l.ownPlane = true; }));
        QVERIFY(part<QComboBox>(fields, "layer-blend").parentWidget()->isHidden());
        part<QCheckBox>(fields, "layer-own-plane").click();
        names.clear();
        emit part<QComboBox>(fields, "layer-blend").activated(2);
        QVERIFY(only("Blend", [](TextureLayer& l) { l.blend = TextureBlend::Multiply; }));
        part<NumberBox>(fields, "opacity").setValue(0.25);
        QVERIFY(only("Opacity", [](TextureLayer& l) { l.opacity = 0.25; }));
        emit part<QComboBox>(fields, "mapping").activated(5);
        QVERIFY(only("Mapping", [](TextureLayer& l) { l.pattern.mapping = TextureMapping::Spherical; }));
        emit part<QComboBox>(fields, "mask-mapping").activated(3);
        QVERIFY(
            only("Mapping of the mask", [](TextureLayer& l) { l.mask->mapping = TextureMapping::Planar; }));
        QSignalSpy asked(&fields, &LayerFields::imageAsked);
        emit part<QComboBox>(fields, "layer-source").activated(int(TextureSource::Grooves));
        QVERIFY(only("Source", [](TextureLayer& l) { l.pattern.source = TextureSource::Grooves; }));
        QCOMPARE(asked.size(), 0);
        emit part<QComboBox>(fields, "layer-source").activated(int(TextureSource::Image)); // it has none yet
        QCOMPARE(asked.size(), 1);
        QCOMPARE(asked[0][0].toBool(), false);
        names.clear();
        emit part<QComboBox>(fields, "mask-source").activated(1 + int(TextureSource::Image));
        QVERIFY(only("Mask", [](TextureLayer& l) { l.mask->source = TextureSource::Image; }));
        QCOMPARE(asked.size(), 2);
        QCOMPARE(asked[1][0].toBool(), true);
        part<QPushButton>(fields, "image-choose").click();
        part<QPushButton>(fields, "mask-image-choose").click();
        QCOMPARE(asked.size(), 4);
        QCOMPARE(asked[2][0].toBool(), false);
        QCOMPARE(asked[3][0].toBool(), true);
        emit part<QComboBox>(fields, "mask-source").activated(0);
        QVERIFY(only("Mask", [](TextureLayer& l) { l.mask.reset(); }));
        emit part<QComboBox>(fields, "mask-source").activated(1 + int(TextureSource::Painted));
        QVERIFY(layer.mask && layer.mask->source == TextureSource::Painted);
        names.clear();
        // The numbers of the pattern and of its mask, each with its own key.
        layer.mask->source = layer.pattern.source = TextureSource::Grooves;
        fields.display(layer, true);
        for (const PatternField& each : kPatternFields) {
            const QString key = QString::fromUtf8(each.parameter->key.data());
            for (const bool mask : {false, true}) {
                const TextureLayer was = layer;
                const QString name = mask ? QStringLiteral("mask-") + key : key;
                auto* box = fields.findChild<NumberBox*>(name);
                QVERIFY2(box, qPrintable(name));
                box->setValue(box->value() + box->singleStep());
                TextureLayer expected = was;
                (mask ? *expected.mask : expected.pattern).*each.value =
                    (mask ? *layer.mask : layer.pattern).*each.value;
                QVERIFY2(layer == expected, qPrintable(name));
                QVERIFY2(!(layer == was), qPrintable(name));
                QCOMPARE(names.back(), QString::fromUtf8(each.parameter->label.data()) +
                                           (mask ? QStringLiteral(" of the mask") : QString()));
            }
        }
        QSignalSpy paints(&fields, &LayerFields::paintsMaskChanged);
        QVERIFY(!fields.paintsMask());
        part<QToolButton>(fields, "mask-paint").click();
        QVERIFY(fields.paintsMask());
        QCOMPARE(paints.size(), 1);
    }

    void thePanelEditsTheLayersOfASurface() {
        Document document;
        LayerPanel panel(document);
        COMPARE_SHOWN(shownIn(panel), "layer-panel-none");
        adopt(document, knownScene());
        document.select({kLid});
        COMPARE_SHOWN(shownIn(panel), "layer-panel-no-layer");
        QVERIFY(!panel.currentLayer());
        QVERIFY(panel.canEdit());
        const auto names = [&](SurfaceRef of) {
            QStringList all;
            for (const TextureLayer& layer : document.surface(of)->layers)
                all << QString::fromStdString(layer.name);
            return all.join(u',');
        };
        QSignalSpy current(&panel, &LayerPanel::currentLayerChanged);
        panel.add(TextureSource::Noise);
        panel.add(TextureSource::Grooves);
        panel.add(TextureSource::Noise);
        QCOMPARE(names(kLid), "Noise,Grooves,Noise 2");
        QCOMPARE(names(kFloor), "");
        QCOMPARE(*panel.currentLayer(), 2);
        QVERIFY(current.size() >= 3);
        QCOMPARE(document.history().undoText(), "Layer Noise 2 on lid");
        panel.setCurrentLayer(1);
        panel.duplicate();
        QCOMPARE(names(kLid), "Noise,Grooves,Grooves 2,Noise 2");
        QCOMPARE(*panel.currentLayer(), 2);
        QCOMPARE(document.history().undoText(), "Duplicate layer Grooves");
        panel.moveLayer(2, 0);
        QCOMPARE(names(kLid), "Grooves 2,Noise,Grooves,Noise 2");
        QCOMPARE(*panel.currentLayer(), 0); // it goes along
        const int steps = document.history().index();
        for (const auto& [from, to] : {std::pair(1, 1), {-1, 0}, {0, -1}, {4, 0}, {0, 4}})
            panel.moveLayer(from, to);
        QCOMPARE(document.history().index(), steps);
        panel.toggleShown(1);
        QVERIFY(!document.surface(kLid)->layers[1].enabled);
        QCOMPARE(document.history().undoText(), "Switch layer Noise off");
        panel.toggleShown(1);
        QVERIFY(document.surface(kLid)->layers[1].enabled);
        QCOMPARE(document.history().undoText(), "Switch layer Noise on");
        panel.toggleShown(4); // there is none
        QCOMPARE(document.history().index(), steps + 2);
        panel.setCurrentLayer(2);
        panel.remove();
        QCOMPARE(names(kLid), "Grooves 2,Noise,Noise 2");
        QCOMPARE(document.history().undoText(), "Remove layer Grooves");
        document.history().undo();
        QCOMPARE(names(kLid), "Grooves 2,Noise,Grooves,Noise 2");
        COMPARE_SHOWN(shownIn(panel).section(QStringLiteral("LayerFields"), 0, 0), "layer-panel");
        emit part<LayerList>(panel, "layer-list").renameAsked(1, QStringLiteral("Sand"));
        emit part<LayerList>(panel, "layer-list").renameAsked(2, QString());
        emit part<LayerList>(panel, "layer-list").renameAsked(4, QStringLiteral("none"));
        QApplication::processEvents();
        QCOMPARE(names(kLid), "Grooves 2,Sand,Grooves,Noise 2");
        QCOMPARE(document.history().undoText(), "Rename layer Noise to Sand");
        // Onto all that is selected, but for what is locked.
        document.setLocked({kFloor}, true);
        document.select({kTop, kFloor, kLid});
        panel.add(TextureSource::Dots);
        QCOMPARE(names(kTop), "Dots");
        QCOMPARE(names(kFloor), "");
        QCOMPARE(names(kLid), "Grooves 2,Sand,Grooves,Noise 2,Dots");
        document.select({kFloor});
        QVERIFY(!panel.canEdit());
        QCOMPARE(part<QLabel>(panel, "layer-hint").text(), "The surface is locked: press L to unlock it.");
        // Sixteen are felt, and no more are made.
        document.select({kTop});
        QSignalSpy failed(&panel, &LayerPanel::failed);
        for (int i = 0; i < 15; ++i)
            panel.add(TextureSource::Dots);
        QCOMPARE(document.surface(kTop)->layers.size(), 16u);
        QCOMPARE(failed.size(), 0);
        panel.add(TextureSource::Dots);
        panel.duplicate();
        QCOMPARE(document.surface(kTop)->layers.size(), 16u);
        QCOMPARE(failed.size(), 2);
        QCOMPARE(failed[0][0].toString(), "top has 16 layers, and more are not felt. Remove one first.");
        QCOMPARE(part<LayerList>(panel, "layer-list").height(),
                 4 * 40 + 2 * part<LayerList>(panel, "layer-list").frameWidth());
        panel.addImage({kFloor}, QStringLiteral("/none.png"));
        QCOMPARE(failed.size(), 3);
        COMPARE_CONTAINS(failed[2][0].toString(), "The surface is locked");
        document.setSurfacesVisible({kTop}, true);
        panel.remove();
        panel.addImage({kTop}, QStringLiteral("/none.png"));
        QVERIFY(waitFor([&] { return failed.size() == 4; }));
        COMPARE_CONTAINS(failed[3][0].toString(), "/none.png");
    }

    void aLayerIsFeltAlone() {
        Document document;
        Scene scene = knownScene();
        scene.objects[0].surfaces[0].layers = three();
        adopt(document, scene);
        LayerPanel panel(document);
        std::vector<std::optional<SoloLayer>> told;
        connect(&panel, &LayerPanel::soloChanged, &panel,
                [&](const std::optional<SoloLayer>& solo) { told.push_back(solo); });
        panel.toggleSolo(0); // nothing is selected
        QVERIFY(told.empty());
        document.select({kLid});
        QCOMPARE(*panel.currentLayer(), 2);
        panel.toggleSolo(3);
        QVERIFY(told.empty());
        panel.toggleSolo(1);
        QCOMPARE(told.size(), 1u);
        QVERIFY(told.back() == std::optional(SoloLayer{kLid, 1}));
        panel.moveLayer(1, 0);
        QVERIFY(told.back() == std::optional(SoloLayer{kLid, 0})); // it goes along
        panel.toggleSolo(2);
        QVERIFY(panel.solo() == std::optional(SoloLayer{kLid, 2}));
        panel.toggleSolo(2);
        QVERIFY(!panel.solo());
        panel.toggleSolo(2);
        panel.setCurrentLayer(2);
        panel.remove();
        QVERIFY(!panel.solo());
        panel.toggleSolo(0);
        document.select({kFloor}); // another surface ends it
        QVERIFY(!panel.solo());
        QVERIFY(!told.back());
        QCOMPARE(document.surface(kLid)->layers.size(), 2u);
    }

    void theMappingHasAFrame() {
        Document document;
        Scene scene = knownScene();
        scene.objects[1].surfaces[0].layers = three();
        TextureLayer& top = scene.objects[1].surfaces[0].layers[2];
        top.pattern.source = TextureSource::Image;
        top.pattern.image = image();
        top.pattern.mapping = TextureMapping::Planar;
        top.pattern.size = 0.02;
        top.pattern.offsetU = 0.001;
        top.pattern.offsetV = 0.002;
        top.pattern.rotation = 0.3;
        top.pattern.radius = 0.04;
        top.pattern.frame.translation = {0, 0.01, 0};
        adopt(document, scene);
        LayerPanel panel(document);
        QVERIFY(!panel.mappingFrame());
        document.select({kTop});
        const auto frame = panel.mappingFrame();
        QVERIFY(frame.has_value());
        QCOMPARE(frame->mapping, TextureMapping::Planar);
        COMPARE_NEAR(frame->pose.translation, Vec3(0.2, 0.01, 0), 1e-12, "m");
        QCOMPARE(frame->size, 0.02);
        QCOMPARE(frame->proportion, 2.0);
        QCOMPARE(frame->offset.x(), 0.001);
        QCOMPARE(frame->offset.y(), 0.002);
        QCOMPARE(frame->rotation, 0.3);
        QCOMPARE(frame->radius, 0.04);
        MappingFrame moved = *frame;
        moved.pose.translation = {0.25, 0.02, 0.03};
        moved.pose.rotation = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY()));
        moved.size = 1e9; // brought into range
        moved.radius = 0.05;
        panel.setMappingFrame(moved, 0);
        const TexturePattern& after = document.surface(kTop)->layers[2].pattern;
        COMPARE_NEAR(after.frame.translation, Vec3(0.05, 0.02, 0.03), 1e-12, "m");
        COMPARE_NEAR(after.frame.rotation.angularDistance(moved.pose.rotation), 0, 1e-9, "rad");
        QCOMPARE(after.size, kTextureSize.maximum);
        QCOMPARE(after.radius, 0.05);
        QCOMPARE(after.offsetU, 0.001);
        QCOMPARE(document.history().undoText(), "Mapping of layer Dots");
        panel.setCurrentLayer(1); // triplanar
        QCOMPARE(panel.mappingFrame()->proportion, 1.0);
        document.setLocked({kTop}, true);
        QVERIFY(!panel.mappingFrame());
        const int steps = document.history().index();
        panel.setMappingFrame(moved, 0);
        QCOMPARE(document.history().index(), steps);
    }

    void theMaskIsPaintedWhereItCanBe() {
        Document document;
        Scene scene = knownScene();
        auto& layers = scene.objects[0].surfaces[0].layers;
        layers = {layerOf("a", TextureSource::Noise), layerOf("b", TextureSource::Painted),
                  layerOf("c", TextureSource::Noise)};
        layers[0].mask = layers[1].mask = TexturePattern{};
        layers[0].mask->source = layers[1].mask->source = TextureSource::Painted;
        layers[2].mask = TexturePattern{};
        adopt(document, scene);
        LayerPanel panel(document);
        QVERIFY(!panel.maskIsEdited());
        document.select({kLid});
        QVERIFY(!panel.maskIsEdited()); // a mask of noise
        panel.setCurrentLayer(0);
        QVERIFY(panel.maskIsEdited()); // nothing else can be painted
        panel.setCurrentLayer(1);
        QVERIFY(!panel.maskIsEdited());
        QSignalSpy current(&panel, &LayerPanel::currentLayerChanged);
        part<QToolButton>(panel, "mask-paint").click();
        QVERIFY(panel.maskIsEdited());
        QCOMPARE(current.size(), 1);
    }

    void theCurrentLayerIsFollowed() {
        Document document;
        Scene scene = knownScene();
        scene.objects[0].surfaces[0].layers = three();
        adopt(document, scene);
        LayerPanel panel(document);
        document.select({kLid});
        panel.setCurrentLayer(0);
        panel.moveLayer(2, 0);
        QCOMPARE(*panel.currentLayer(), 1);
        document.history().undo();
        QCOMPARE(*panel.currentLayer(), 0);
        panel.setCurrentLayer(2);
        panel.remove();
        QCOMPARE(*panel.currentLayer(), 1);
        document.history().undo();
        QCOMPARE(document.surface(kLid)->layers.size(), 3u);
        panel.setCurrentLayer(7);
        QVERIFY(!panel.currentLayer());
        document.select({kFloor});
        QVERIFY(!panel.currentLayer());
        document.select({kLid});
        QCOMPARE(*panel.currentLayer(), 2); // the topmost
    }

    void buttonsOfThePanel() {
        Document document;
        LayerPanel panel(document);
        Actions actions;
        panel.addButtons(actions);
        COMPARE_SHOWN(shownIn(panel).section(QStringLiteral("QLabel layer-hint"), 0, 0), "layer-buttons");
    }
};

TACTUM_GUI_TEST(TestLayerPanels)

} // namespace test_layer_panels

#include "test_layer_panels.moc"
