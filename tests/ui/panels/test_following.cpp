// Panels of the scene beside a document that is edited: what each of them shows otherwise after one edit
// after the other. Wrong itself if a panel showed something that shownIn() does not tell: it would stay
// unseen.
#include <QApplication>
#include <QTest>
#include <QUndoStack>

#include "core/scene/groups.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/english.h"
#include "tests/ui/panels/panels.h"
#include "ui/panels/history_list.h"
#include "ui/panels/inspector.h"
#include "ui/panels/layer_list.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/outliner.h"
#include "ui/panels/world_fields.h"

namespace test_following {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// What a person and other programs do to a scene, one after the other.
class Edits {
public:
    explicit Edits(Document& document) : document_(document) { adopt(document, knownScene()); }

    /// `seen` is done after each.
    template <class Seen> void all(const Seen& seen) {
        const auto then = [&](const char* what, const auto& act) {
            act();
            if (!waitFor([&] { return !document_.editing(); })) qFatal("%s does not end", what);
            QApplication::processEvents();
            seen(QString::fromLatin1(what));
        };
        Document& d = document_;
        then("lid selected", [&] { d.select(kLid); });
        then("lid and floor selected", [&] { d.select({kLid, kFloor}); });
        then("surface renamed", [&] { d.renameSurface(kFloor, QStringLiteral("bottom")); });
        then("object renamed", [&] { d.renameObject(1, QStringLiteral("Chest")); });
        then("surface hidden", [&] { d.setSurfacesVisible({kLid}, false); });
        then("grouped", [&] { d.group({1, 2}); });
        then("group renamed", [&] { d.renameGroup("Group 1", QStringLiteral("Both")); });
        then("group hidden", [&] { d.setGroupVisible("Both", false); });
        then("all shown", [&] { d.showAll(); });
        then("taken apart", [&] { d.ungroup({1}); });
        then("object hidden", [&] { d.setVisible(2, false); });
        then("locked", [&] { d.setLocked({kFloor}, true); });
        then("stiffness of all that is selected", [&] { setStiffness(432); });
        then("unlocked", [&] { d.setLocked({kFloor}, false); });
        then("stiffness of both", [&] { setStiffness(432); });
        then("another object's surface selected", [&] { d.select(kTop); });
        then("a layer", [&] { addLayer(layerOf("Noise", TextureSource::Noise)); });
        then("another layer", [&] { addLayer(layerOf("Dots", TextureSource::Dots)); });
        then("smooth", [&] { shade(true); });
        then("sides", [&] { d.setSides({kTop}, Sides::Back); });
        then("nothing selected", [&] { d.select({}); });
        then("a triangle selected", [&] { d.selectFaces({1, {0}}); });
        then("objects selected", [&] { d.selectObjects({1, 2}); });
        then("undone", [&] { d.history().undo(); });
        then("undone once more", [&] { d.history().undo(); });
        then("redone", [&] { d.history().redo(); });
        then("proxy radius", [&] { d.setProxyRadius(0.002); });
        then("duplicated", [&] { d.duplicate({2}); });
        then("merged", [&] {
            d.select({kLid, kFloor});
            d.mergeSelected();
        });
        then("object removed", [&] { d.removeObject(2); });
        then("removed no more", [&] { d.history().undo(); });
        then("another scene", [&] { adopt(d, Scene()); });
    }

private:
    void setStiffness(double value) {
        document_.setMaterialValue(document_.selected(), kMaterialFields[0], value);
    }
    void addLayer(const TextureLayer& layer) {
        document_.editSurfaces({kTop}, SceneChange::What::Layers, QStringLiteral("Layer on %1"),
                               [&](Surface& surface) { surface.layers.push_back(layer); });
    }
    void shade(bool on) {
        Shading shading = document_.surface(kTop)->shading;
        shading.on = on;
        document_.setShading({kTop}, shading);
    }

    Document& document_;
};

/// A panel of a document that is edited.
template <class Panel> QString statesOf(auto make) {
    Document document;
    Edits edits(document);
    Panel panel = make(document);
    panel.resize(300, 600);
    panel.show();
    if (!QTest::qWaitForWindowExposed(&panel)) qFatal("no window");
    States states(shownIn(panel));
    edits.all([&](const QString& what) { states.note(what, shownIn(panel)); });
    return states.text();
}

} // namespace

class TestFollowing : public QObject {
    Q_OBJECT
public:
    static void initMain() { namePanelTest("TactumFollowing"); }

private slots:
    void initTestCase() {
        speakEnglish();
        applyTheme(ThemeChoice::Dark);
    }

    void theOutliner() {
        COMPARE_SHOWN(statesOf<Outliner>([](Document& d) { return Outliner(d); }), "following-outliner");
    }
    void theInspector() {
        COMPARE_SHOWN(statesOf<Inspector>([](Document& d) { return Inspector(d); }), "following-inspector");
    }
    void theLayers() {
        COMPARE_SHOWN(statesOf<LayerPanel>([](Document& d) { return LayerPanel(d); }), "following-layers");
    }
    void theHistory() {
        COMPARE_SHOWN(statesOf<HistoryList>([](Document& d) { return HistoryList(d.history()); }),
                      "following-history");
    }
    void theWorld() {
        COMPARE_SHOWN(statesOf<WorldFields>([](Document& d) { return WorldFields(d); }), "following-world");
    }
};

TACTUM_GUI_TEST(TestFollowing)

} // namespace test_following

#include "test_following.moc"
