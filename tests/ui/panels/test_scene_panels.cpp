// Panels of the scene: outliner, inspector, problems, presets, comparing; what they show, and the edits they
// make.
#include <QAction>
#include <QApplication>
#include <QButtonGroup>
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeWidgetItemIterator>

#include "core/port/hand_target.h"
#include "core/presets/preset_file.h"
#include "core/runtime/local_engine.h"
#include "device/simulated_hand.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/document/preset_store.h"
#include "ui/engine/comparison.h"
#include "ui/engine/world_publisher.h"
#include "ui/panels/compare_panel.h"
#include "ui/panels/inspector.h"
#include "ui/panels/outliner.h"
#include "ui/panels/preset_form.h"
#include "ui/panels/preset_library.h"
#include "ui/panels/problems.h"
#include "ui/widgets/number_box.h"
#include "ui/widgets/picture_grid.h"

namespace test_scene_panels {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// The known scene in an outliner that can be clicked.
struct ListedScene {
    ListedScene() {
        adopt(document, knownScene());
        outliner.resize(300, 300);
        outliner.show();
        if (!QTest::qWaitForWindowExposed(&outliner)) qFatal("no window");
    }
    Document document;
    Outliner outliner{document};
};

/// The row with a name, also deeper down.
QTreeWidgetItem* row(QTreeWidget& tree, const char* name) {
    for (QTreeWidgetItemIterator it(&tree); *it; ++it)
        if ((*it)->text(0) == QLatin1String(name)) return *it;
    qFatal("no row %s", name);
    return nullptr;
}

void click(QTreeWidget& tree, const char* name, int column, Qt::KeyboardModifiers keys = {}) {
    const QRect cell = tree.visualRect(tree.indexFromItem(row(tree, name), column));
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, keys, cell.center());
    QApplication::processEvents(); // edits come later, for they fill the tree anew
}

const Surface& surface(const Document& document, SurfaceRef ref) {
    const Surface* found = document.surface(ref);
    if (!found) qFatal("no surface");
    return *found;
}

} // namespace

class TestScenePanels : public QObject {
    Q_OBJECT

    QTemporaryDir data_;

public:
    static void initMain() { namePanelTest("TactumScenePanels"); }

private slots:
    void initTestCase() {
        qputenv("XDG_DATA_HOME", data_.path().toLocal8Bit()); // presets of one's own
        applyTheme(ThemeChoice::Dark);
    }

    void theOutlinerShowsTheScene() {
        Document document;
        Outliner outliner(document);
        outliner.resize(300, 300);
        COMPARE_SHOWN(shownIn(outliner), "outliner-empty");
        COMPARE_CONTAINS(drawnBy(*outliner.viewport()), "\"The objects of the scene and their surfaces.\"");
        Scene scene = knownScene();
        scene.objects[0].surfaces[1].locked = true;
        scene.objects[0].surfaces[0].visible = false;
        scene.objects[1].visible = false;
        adopt(document, scene);
        document.select({kFloor, kTop});
        COMPARE_SHOWN(shownIn(outliner), "outliner");
        document.select({});
        COMPARE_SHOWN(shownIn(outliner), "outliner-none");
    }

    void eyesAndLocksAreClicked() {
        ListedScene listed;
        Document& document = listed.document;
        Outliner& outliner = listed.outliner;
        const auto visible = [&] {
            return std::tuple(document.scene().objects[0].visible, surface(document, kLid).visible,
                              surface(document, kFloor).visible, document.scene().objects[1].visible);
        };
        click(outliner, "lid", 1);
        QCOMPARE(visible(), std::tuple(true, false, true, true));
        click(outliner, "lid", 1);
        QCOMPARE(visible(), std::tuple(true, true, true, true));
        click(outliner, "Box", 1);
        QCOMPARE(visible(), std::tuple(false, true, true, true));
        click(outliner, "Plate", 1);
        QCOMPARE(visible(), std::tuple(false, true, true, false));
        const int steps = document.history().count();
        click(outliner, "Box", 2); // an object has no lock
        click(outliner, "lid", 0); // nor is a name a switch
        QCOMPARE(document.history().count(), steps);
        click(outliner, "floor", 2);
        QVERIFY(surface(document, kFloor).locked);
        QVERIFY(!surface(document, kLid).locked);
        click(outliner, "floor", 2);
        QVERIFY(!surface(document, kFloor).locked);
        QCOMPARE(document.history().count(), steps + 2);
    }

    void rowsAndSelectionFollowEachOther() {
        ListedScene listed;
        Document& document = listed.document;
        Outliner& outliner = listed.outliner;
        click(outliner, "lid", 0);
        QCOMPARE(document.selected(), SurfaceRefs{kLid});
        click(outliner, "top", 0, Qt::ControlModifier);
        QCOMPARE(document.selected(), (SurfaceRefs{kLid, kTop}));
        QCOMPARE(*document.selection(), kTop);
        click(outliner, "lid", 0, Qt::ControlModifier);
        QCOMPARE(document.selected(), SurfaceRefs{kTop});
        click(outliner, "Box", 0); // an object stands for its surfaces, the first of them active
        QCOMPARE(document.selected(), (SurfaceRefs{kFloor, kLid}));
        document.select({kFloor});
        QVERIFY(row(outliner, "floor")->isSelected());
        QVERIFY(!row(outliner, "Box")->isSelected());
        QVERIFY(!row(outliner, "lid")->isSelected());
        QCOMPARE(outliner.currentItem(), row(outliner, "floor"));
        document.select({});
        QVERIFY(outliner.selectedItems().isEmpty());
        QVERIFY(!outliner.currentItem());
    }

    // Whoever chose an object and changes it still has the object, not a list of its surfaces.
    void aChosenObjectStaysChosenWhenItIsEdited() {
        ListedScene listed;
        Document& document = listed.document;
        Outliner& outliner = listed.outliner;
        click(outliner, "Box", 0);
        const auto showsTheObject = [&] {
            return row(outliner, "Box")->isSelected() && !row(outliner, "lid")->isSelected() &&
                   !row(outliner, "floor")->isSelected() && outliner.currentItem() == row(outliner, "Box");
        };
        document.renameSurface(kTop, QStringLiteral("cover")); // rows are brought to what they say
        QVERIFY(showsTheObject());
        document.setVisible(document.scene().objects[1].id, false);
        QVERIFY(showsTheObject());
        document.removeObject(document.scene().objects[1].id); // rows are made anew
        QVERIFY(showsTheObject());
        QCOMPARE(document.selected(), (SurfaceRefs{kFloor, kLid}));
        document.select({kLid}); // elsewhere
        QVERIFY(!row(outliner, "Box")->isSelected());
        QVERIFY(row(outliner, "lid")->isSelected());
        document.select({kFloor, kLid});
        QVERIFY(showsTheObject());
        click(outliner, "lid", 0);
        document.select({kFloor, kLid}); // by its surfaces this time
        QVERIFY(row(outliner, "lid")->isSelected() && row(outliner, "floor")->isSelected());
        QVERIFY(!row(outliner, "Box")->isSelected());
    }

    void rowsAreRenamed() {
        Document document;
        adopt(document, knownScene());
        Outliner outliner(document);
        row(outliner, "Box")->setText(0, QStringLiteral("  Chest "));
        QApplication::processEvents();
        QCOMPARE(document.scene().objects[0].name, "Chest");
        row(outliner, "top")->setText(0, QStringLiteral("cover"));
        QApplication::processEvents();
        QCOMPARE(surface(document, kTop).name, "cover");
        const int steps = document.history().count();
        row(outliner, "lid")->setText(0, QStringLiteral("   ")); // no name at all
        QApplication::processEvents();
        QCOMPARE(surface(document, kLid).name, "lid");
        QVERIFY(row(outliner, "lid"));
        QCOMPARE(document.history().count(), steps);
    }

    void theInspectorShowsTheSelection() {
        Document document;
        Inspector inspector(document);
        COMPARE_SHOWN(shownIn(inspector), "inspector-none");
        Scene scene = knownScene();
        scene.objects[1].surfaces[0].shading.on = true;
        scene.objects[1].surfaces[0].shading.normals = NormalSource::File;
        scene.proxyRadius = 0.002;
        adopt(document, scene);
        document.select({kLid});
        COMPARE_SHOWN(shownIn(inspector), "inspector-one");
        document.select({kFloor, kLid});
        COMPARE_SHOWN(shownIn(inspector), "inspector-two");
        document.select({kTop});
        COMPARE_SHOWN(shownIn(inspector), "inspector-normals");
        document.setShading({kTop}, [&] {
            Shading shading = surface(document, kTop).shading;
            shading.normals = NormalSource::Computed;
            return shading;
        }());
        QVERIFY(!part<QWidget>(inspector, "crease-angle").parentWidget()->isHidden());
        document.setLocked({kTop}, true);
        COMPARE_SHOWN(shownIn(inspector), "inspector-locked");
        document.select({kLid, kTop});
        QCOMPARE(part<QLabel>(inspector, "locked-hint").text(), "1 of 2 are locked and stay as they are.");
        QVERIFY(!part<QLabel>(inspector, "locked-hint").isHidden());
        inspector.setCeiling({1234.4, QStringLiteral("limited by the hand")}, false);
        COMPARE_CONTAINS(part<QWidget>(inspector, "stiffness").parentWidget()->toolTip(),
                         "Ceiling, the red tick: 1234 N/m, limited by the hand");
        COMPARE_LACKS(part<QWidget>(inspector, "damping").parentWidget()->toolTip(), "Ceiling, the red tick");
        inspector.setCeiling({1234.4, QStringLiteral("limited by the hand")}, true);
        COMPARE_CONTAINS(part<QWidget>(inspector, "stiffness").parentWidget()->toolTip(),
                         "1234 N/m, overridden at your own risk");
    }

    /// Each field sets its value on all that is selected, and nothing else.
    void theInspectorEditsWhatIsSelected() {
        Document document;
        adopt(document, knownScene());
        Inspector inspector(document);
        document.select({kLid, kFloor});
        const Surface lid = surface(document, kLid), floor = surface(document, kFloor),
                      top = surface(document, kTop);
        const auto unlike = [&](SurfaceRef ref, Surface before, auto change) {
            change(before);
            return surface(document, ref) == before;
        };
        for (const auto& [name, value, member] : {std::tuple("stiffness", 333.0, &Material::stiffness),
                                                  {"damping", 3.0, &Material::damping},
                                                  {"viscosity", 4.0, &Material::viscosity}}) {
            part<NumberBox>(inspector, name).setValue(value);
            const auto change = [&](Surface& each) { each.material.*member = value; };
            QVERIFY(unlike(kLid, lid, change));
            QVERIFY(unlike(kFloor, floor, change));
            QVERIFY(surface(document, kTop) == top);
            document.history().undo();
        }
        part<NumberBox>(inspector, "static-friction").setValue(0.2); // dynamic friction follows
        QVERIFY(unlike(kLid, lid,
                       [](Surface& s) { s.material.staticFriction = s.material.dynamicFriction = 0.2; }));
        document.history().undo();
        for (const auto& [name, sides] : {std::pair("sides-both", Sides::Both),
                                          {"sides-front", Sides::Front},
                                          {"sides-back", Sides::Back},
                                          {"sides-none", Sides::None}}) {
            part<QToolButton>(inspector, name).click();
            QVERIFY(unlike(kLid, lid, [&](Surface& each) { each.sides = sides; }));
            QVERIFY(unlike(kFloor, floor, [&](Surface& each) { each.sides = sides; }));
        }
        while (document.history().canUndo())
            document.history().undo();
        document.select({kTop});
        auto& shading = part<QCheckBox>(inspector, "force-shading");
        const bool was = top.shading.on;
        shading.click();
        QVERIFY(unlike(kTop, top, [&](Surface& each) { each.shading.on = !was; }));
        auto& normals = part<QCheckBox>(inspector, "file-normals");
        QCOMPARE(normals.isHidden(), was);
        const auto source = surface(document, kTop).shading.normals;
        normals.click();
        QVERIFY(surface(document, kTop).shading.normals != source);
        normals.click();
        QVERIFY(surface(document, kTop).shading.normals == source);
        part<NumberBox>(inspector, "crease-angle").setValue(50);
        COMPARE_NEAR(surface(document, kTop).shading.creaseAngle, 50 * std::acos(-1.0) / 180, 1e-6, "rad");
        QVERIFY(surface(document, kLid) == lid);
        part<NumberBox>(inspector, "proxy-radius").setValue(2.5);
        COMPARE_NEAR(document.scene().proxyRadius, 0.0025, 1e-12, "m");
    }

    void problemsAreListedWithTheirRemedies() {
        Document document;
        Problems problems(document);
        QSignalSpy counted(&problems, &Problems::counted), gone(&problems, &Problems::placeGone);
        Scene scene = knownScene();
        scene.objects[0].surfaces[0].material.stiffness = 1e6;
        scene.objects[1].geometry = [&] {
            TriangleSoup soup = *scene.objects[1].geometry;
            soup.triangles.push_back(soup.triangles[0]); // twice the same
            soup.surfaceOf.push_back(0);
            for (int i = 0; i < 3; ++i) {
                soup.cornerUvs.push_back(soup.cornerUvs[std::size_t(i)]);
                soup.cornerNormals.push_back(soup.cornerNormals[std::size_t(i)]);
            }
            return std::make_shared<const TriangleSoup>(soup);
        }();
        adopt(document, scene,
              {{Finding::Severity::Error, "", "The file ends early.", "Export <it> again."},
               {Finding::Severity::Note, "Box", "2 faces were left out.", "Nothing."}});
        QVERIFY(waitFor([&] { return counted.size() > 0 && problems.topLevelItemCount() > 0; }));
        COMPARE_SHOWN(shownIn(problems), "problems");
        QCOMPARE(counted.back()[0].toInt(), problems.topLevelItemCount());
        // A click selects what it is about, and shows the place where there is one.
        std::vector<ObjectId> asked;
        connect(&problems, &Problems::placeAsked, &problems,
                [&](ObjectId object, const Problem&) { asked.push_back(object); });
        gone.clear();
        emit problems.itemClicked(problems.topLevelItem(1), 0);
        QCOMPARE(document.selected(), SurfaceRefs{kLid});
        QVERIFY(asked.empty());
        QCOMPARE(gone.size(), 1);
        auto* fix = problems.findChild<QPushButton*>(QStringLiteral("fix"));
        QVERIFY(fix);
        for (int i = 0; i < problems.topLevelItemCount(); ++i)
            if (auto* button = problems.itemWidget(problems.topLevelItem(i), 1);
                button && button->toolTip().startsWith(QStringLiteral("Remove"))) {
                emit problems.itemActivated(problems.topLevelItem(i), 0);
                fix = static_cast<QPushButton*>(button);
            }
        QCOMPARE(asked, std::vector<ObjectId>{2});
        QCOMPARE(document.selected(), SurfaceRefs{kTop});
        gone.clear();
        document.select({kLid}); // by somebody else
        QCOMPARE(gone.size(), 1);
        // Repairing is one step of the history.
        QSignalSpy repaired(&problems, &Problems::repaired);
        const int steps = document.history().index();
        document.setLocked({kTop}, true);
        fix->click();
        QCOMPARE(repaired.size(), 1);
        QCOMPARE(repaired[0][0].toString(), "Plate has a locked surface. Unlock it first.");
        document.setLocked({kTop}, false);
        fix->click();
        QVERIFY(waitFor([&] { return repaired.size() == 2; }));
        COMPARE_CONTAINS(repaired[1][0].toString(), "Undo takes it back.");
        COMPARE_BEGINS(repaired[1][0].toString(), QStringLiteral("Plate: "));
        QCOMPARE(document.scene().objects[1].geometry->triangles.size(), 2u);
        QCOMPARE(document.history().index(), steps + 3);
        QCOMPARE(document.history().undoText(), "Repair Plate");
    }

    void nothingIsWrongWithNothing() {
        Document document;
        Problems problems(document);
        COMPARE_SHOWN(shownIn(problems), "problems-none");
        problems.resize(300, 100);
        COMPARE_CONTAINS(drawnBy(*problems.viewport()), "\"No problems found.");
    }

    void aPresetIsMadeOfASurface() {
        Surface lid = knownScene().objects[0].surfaces[0];
        lid.layers.push_back({});
        lid.layers.back().name = "Noise";
        lid.shading.on = true;
        PresetForm form(lid);
        COMPARE_SHOWN(shownIn(form), "preset-form");
        auto& name = part<QLineEdit>(form, "preset-name");
        auto* save = form.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save);
        const auto boxes = form.findChildren<QCheckBox*>();
        QCOMPARE(boxes.size(), 3);
        QVERIFY(save->isEnabled());
        name.setText(QStringLiteral("  "));
        QVERIFY(!save->isEnabled());
        name.setText(QStringLiteral(" Felt "));
        QVERIFY(save->isEnabled());
        Preset made = form.made().preset;
        QCOMPARE(made.name, "Felt");
        QCOMPARE(made.category, "");
        QCOMPARE(sourceOf(made, "stiffness").words, "Set by hand: no source");
        QCOMPARE(sourceOf(made, "stiffness").typical, false);
        QCOMPARE(*made.values[0], 500.0);
        QVERIFY(made.layers && made.shading);
        part<QLineEdit>(form, "preset-category").setText(QStringLiteral(" Cloth "));
        part<QLineEdit>(form, "preset-link").setText(QStringLiteral(" https://a.b "));
        made = form.made().preset;
        QCOMPARE(made.category, "Cloth");
        QCOMPARE(sourceOf(made, "stiffness").words, "");
        QCOMPARE(sourceOf(made, "stiffness").link, "https://a.b");
        part<QLineEdit>(form, "preset-source").setText(QStringLiteral(" me "));
        QCOMPARE(sourceOf(form.made().preset, kLayersPart).words, "me");
        // Each box leaves out its part and that part's source.
        boxes[0]->setChecked(false);
        made = form.made().preset;
        QVERIFY(std::ranges::none_of(made.values, [](const auto& value) { return value.has_value(); }));
        QVERIFY(made.layers && made.shading);
        QCOMPARE(made.sources.size(), 2u);
        boxes[1]->setChecked(false);
        made = form.made().preset;
        QVERIFY(!made.layers);
        QVERIFY(made.shading);
        QCOMPARE(made.sources.size(), 1u);
        QVERIFY(save->isEnabled());
        boxes[2]->setChecked(false);
        QVERIFY(!save->isEnabled()); // of nothing
        boxes[0]->setChecked(true);
        QVERIFY(save->isEnabled());
        made = form.made().preset;
        QVERIFY(!made.layers && !made.shading);
        QCOMPARE(*made.values[4], 2.0);
        QCOMPARE(made.sources.size(), 5u);
        QSignalSpy accepted(&form, &QDialog::accepted);
        save->click();
        QCOMPARE(accepted.size(), 1);
        Surface bare;
        PresetForm second(bare);
        QVERIFY(!second.findChildren<QCheckBox*>()[1]->isChecked()); // there are no layers
        QCOMPARE(second.findChildren<QCheckBox*>()[2]->isChecked(), bare.shading.on);
    }

    void presetsAreFoundAndChosen() {
        QDir(PresetStore::folder()).removeRecursively();
        PresetStore store;
        PresetLibrary library(store);
        library.resize(300, 600);
        QVERIFY(waitFor([&] { return !store.loading() && !store.presets().empty(); }));
        Preset cork;
        cork.name = "Corky";
        cork.category = "Wood";
        cork.tags = {"soft"};
        cork.values = {400.0, std::nullopt, 0.5, 0.25, std::nullopt};
        cork.shading = Shading{};
        cork.layers = std::vector<TextureLayer>(1);
        cork.layers->front().name = "Grain";
        cork.sources["stiffness"] = {"a <table>", "https://a.b/c?d&e", true};
        cork.sources["staticFriction"] = {"", "doi:10/x", false};
        const QString file = store.add(cork);
        QVERIFY(!file.isEmpty());
        QVERIFY(waitFor([&] { return store.find(file) != nullptr; }));
        auto& list = part<PictureGrid>(library, "preset-list");
        auto& search = part<QLineEdit>(library, "preset-search");
        auto& details = part<QLabel>(library, "preset-details");
        const auto picture = [&](int i) { return list.pictures().at(i); };
        QCOMPARE(list.pictures().size(), qsizetype(store.presets().size()));
        QCOMPARE(picture(0)->text(), "Corky"); // own ones first
        QVERIFY(picture(0)->flags() & Qt::ItemIsEditable);
        QVERIFY(!(picture(1)->flags() & Qt::ItemIsEditable));
        QSignalSpy chosen(&library, &PresetLibrary::chosenChanged),
            applied(&library, &PresetLibrary::applyAsked), removed(&library, &PresetLibrary::removed);
        QVERIFY(!library.chosen());
        COMPARE_CONTAINS(list.toolTip(), "Drag a preset onto the model");
        COMPARE_CONTAINS(details.text(), "No preset is chosen");
        library.choose(file);
        QVERIFY(library.chosen());
        QCOMPARE(library.chosen()->preset.name, "Corky");
        QVERIFY(chosen.size() > 0);
        while (list.count() > 2) // what comes with the program is for its own tests
            delete list.takeItem(2);
        COMPARE_SHOWN(shownIn(library).replace(QFileInfo(file).absolutePath(), QStringLiteral("FOLDER")),
                      "presets");
        // A search keeps what fits; what was chosen stays as long as it does.
        search.setText(QStringLiteral("soft corky"));
        QCOMPARE(list.pictures().size(), 1);
        QCOMPARE(library.chosen()->preset.name, "Corky");
        search.setText(QStringLiteral("no such thing"));
        QCOMPARE(list.count(), 0);
        QVERIFY(!library.chosen());
        search.setText(QStringLiteral("cork"));
        QVERIFY(library.chosen()); // the first, by itself
        QTest::keyClick(&search, Qt::Key_Return);
        QCOMPARE(applied.size(), 1);
        emit list.itemActivated(list.currentItem());
        QCOMPARE(applied.size(), 2);
        search.clear();
        QVERIFY(library.chosen()); // stays
        // What is dragged is the file's text.
        const std::unique_ptr<QMimeData> carried(list.model()->mimeData({list.indexFromItem(picture(0))}));
        QVERIFY(carried);
        COMPARE_CONTAINS(QString::fromUtf8(carried->data(list.model()->mimeTypes().front())), "Corky");
        QCOMPARE(list.model()->mimeTypes().size(), 1);
        QCOMPARE(list.model()->supportedDragActions(), Qt::CopyAction);
        // Renamed in the list, then in the store.
        picture(0)->setText(QStringLiteral("Cork oak"));
        QVERIFY(waitFor([&] { return store.find(file) && store.find(file)->preset.name == "Cork oak"; }));
        const auto actions = list.actions();
        QAction *rename = nullptr, *remove = nullptr;
        for (QAction* action : actions) {
            if (action->text() == QStringLiteral("&Rename")) rename = action;
            if (action->text() == QStringLiteral("Re&move")) remove = action;
        }
        QVERIFY(rename && remove);
        QVERIFY(rename->isEnabled());
        list.setCurrentItem(picture(1)); // of the program
        QVERIFY(!rename->isEnabled());
        QVERIFY(!remove->isEnabled());
        library.choose(file);
        QVERIFY(remove->isEnabled());
        remove->trigger();
        QCOMPARE(removed.size(), 1);
        QCOMPARE(removed[0][0].toString(), "Cork oak");
        QVERIFY(waitFor([&] { return !store.find(file); }));
        store.takeBack();
        QVERIFY(waitFor([&] { return store.find(file) != nullptr; }));
    }

    void arrowsLeadFromTheSearchIntoTheList() {
        PresetStore store;
        PresetLibrary library(store);
        QVERIFY(waitFor([&] { return !store.loading() && !store.presets().empty(); }));
        library.show();
        QVERIFY(QTest::qWaitForWindowExposed(&library));
        auto& list = part<PictureGrid>(library, "preset-list");
        auto& search = part<QLineEdit>(library, "preset-search");
        search.setFocus();
        QVERIFY(!list.currentItem());
        QTest::keyClick(&search, Qt::Key_A);
        QCOMPARE(search.text(), "a");
        search.clear();
        list.setCurrentItem(nullptr);
        QTest::keyClick(&search, Qt::Key_Down);
        QCOMPARE(list.currentItem(), list.pictures()[0]);
        list.setCurrentItem(list.pictures()[1]);
        QTest::keyClick(&search, Qt::Key_Up); // what is chosen stays
        QCOMPARE(list.currentItem(), list.pictures()[1]);
    }

    void buttonsOfTheLibrary() {
        PresetStore store;
        PresetLibrary library(store);
        QAction apply(QStringLiteral("&Apply it")), save(QStringLiteral("&Save it")),
            other(QStringLiteral("Other"));
        apply.setIconText(QStringLiteral("Apply"));
        save.setIconText(QStringLiteral("Save"));
        library.addActions(&apply, &save, {&other});
        const auto buttons = library.findChildren<QToolButton*>();
        QStringList texts;
        for (auto* button : buttons)
            if (button->property("choice").toBool()) texts << button->text();
        QCOMPARE(texts.join(u'|'), "Apply|Save");
        QSignalSpy applied(&apply, &QAction::triggered);
        for (auto* button : buttons)
            if (button->defaultAction() == &apply) {
                QCOMPARE(button->focusPolicy(), Qt::TabFocus);
                QCOMPARE(button->toolButtonStyle(), Qt::ToolButtonTextOnly);
                button->click();
            }
        QCOMPARE(applied.size(), 1);
        QStringList menu;
        auto& list = part<PictureGrid>(library, "preset-list");
        for (QAction* action : list.actions())
            menu << (action->isSeparator() ? QStringLiteral("-") : action->text());
        QCOMPARE(menu.join(u'|'), "&Rename|Re&move|-|&Apply it|&Save it|Other");
        QCOMPARE(list.contextMenuPolicy(), Qt::ActionsContextMenu);
    }

    void twoStatesAreCompared() {
        Document document;
        LocalEngine engine(std::make_unique<SimulatedHand>(std::make_shared<HandTarget>()));
        WorldPublisher publisher(document, engine);
        tactum::Comparison comparison(document, engine, publisher);
        ComparePanel panel(comparison);
        COMPARE_SHOWN(shownIn(panel), "compare-panel-none");
        adopt(document, knownScene());
        std::vector<FingerPoint> stroke; // down onto the upper plate, and along it
        for (int i = 0; i <= 400; ++i)
            stroke.push_back({1e-3 * i, {1e-4 * std::max(0, i - 200), 0.0151 - 4e-5 * std::min(i, 200), 0}});
        comparison.setStroke(stroke);
        auto& mark = part<QPushButton>(panel, "compare-mark");
        mark.click();
        QVERIFY(comparison.hasA());
        document.setMaterialValue({kLid, kFloor}, kMaterialFields[2], 0.3);
        QVERIFY(waitFor([&] { return comparison.result().has_value() && !comparison.working(); }));
        COMPARE_SHOWN(shownIn(panel).replace(QRegularExpression(QStringLiteral("-?\\d+\\.\\d{3,4}")),
                                             QStringLiteral("#")),
                      "compare-panel");
        const TouchDifference& d = comparison.result()->difference;
        QVERIFY(d.largest > 0);
        const QString figures = figuresOf(comparison);
        COMPARE_CONTAINS(figures, QStringLiteral("rms  %1 N").arg(d.rms, 0, 'f', 4));
        COMPARE_CONTAINS(figures, QStringLiteral("largest  %1 N").arg(d.largest, 0, 'f', 4));
        COMPARE_CONTAINS(figures, QStringLiteral("  at %1 s").arg(d.largestAt, 0, 'f', 3));
        COMPARE_CONTAINS(figures, QStringLiteral("Work, mJ\n  A %1, B %2")
                                      .arg(1e3 * d.workA, 0, 'f', 3)
                                      .arg(1e3 * d.workB, 0, 'f', 3));
        COMPARE_CONTAINS(figures, QStringLiteral("Mean friction ratio\n  A %1, B %2")
                                      .arg(d.ratioA, 0, 'f', 3)
                                      .arg(d.ratioB, 0, 'f', 3));
        auto& automatic = part<QCheckBox>(panel, "compare-automatic");
        automatic.click();
        QVERIFY(!comparison.automatic());
        automatic.click();
        QVERIFY(comparison.automatic());
        part<QPushButton>(panel, "compare-swap").click();
        QCOMPARE(document.surface(kLid)->material.staticFriction, 0.6);
        QSignalSpy exported(&panel, &ComparePanel::exportAsked);
        QVERIFY(waitFor([&] { return comparison.result().has_value() && !comparison.working(); }));
        part<QPushButton>(panel, "compare-export").click();
        QCOMPARE(exported.size(), 1);
        mark.click(); // as it is now: no difference
        comparison.compare();
        QVERIFY(waitFor([&] { return comparison.result() && comparison.result()->difference.largest == 0; }));
        COMPARE_BEGINS(figuresOf(comparison), QStringLiteral("No difference\nWork, mJ\n"));
        auto& record = part<QPushButton>(panel, "compare-record");
        record.click();
        QVERIFY(comparison.recording());
        QCOMPARE(record.text(), "End the stroke");
    }
};

TACTUM_GUI_TEST(TestScenePanels)

} // namespace test_scene_panels

#include "test_scene_panels.moc"
