// Every edit of the document: which figures of the scene's file it changes, what is told of it, and how the
// history calls it. Wrong itself if the file left a figure out: its edit would say nothing, though undo is
// held against the scene as well.
#include <QSignalSpy>
#include <QTest>

#include "core/presets/preset.h"
#include "core/scene/groups.h"
#include "tests/support/compare.h"
#include "tests/support/shown.h"
#include "tests/support/test_program.h"
#include "tests/ui/document/scene_figures.h"
#include "tests/ui/panels/panels.h"
#include "ui/document/apply_preset.h"

namespace test_document_edits {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

/// The known scene, with a group of two more plates of which one is locked.
Scene fullScene() {
    Scene scene = knownScene();
    for (const char* name : {"Left", "Right"}) {
        SceneObject object;
        object.name = name;
        object.group = "Pair";
        object.geometry = plates(1);
        object.pose.translation = {0, 0, 0.1 * double(scene.objects.size())};
        object.surfaces.resize(1);
        object.surfaces[0].name = std::string(name) + " side";
        scene.add(object);
    }
    scene.objects[3].surfaces[0].locked = true;
    return scene;
}

/// A line for each object and each of its surfaces.
QStringList outlineOf(const Scene& scene) {
    QStringList lines{QStringLiteral("proxy radius %1 m, reach %2 %3 m")
                          .arg(scene.proxyRadius)
                          .arg(int(scene.reach.mode))
                          .arg(scene.reach.shell)};
    for (const SceneObject& object : scene.objects) {
        const Vec3& at = object.pose.translation;
        const QString name = QString::fromStdString(object.name);
        lines << QStringLiteral("%1, id %2, at (%3 %4 %5), %6 across%7%8")
                     .arg(name)
                     .arg(object.id)
                     .arg(at.x(), 0, 'g', 6)
                     .arg(at.y(), 0, 'g', 6)
                     .arg(at.z(), 0, 'g', 6)
                     .arg(boundsOf(*object.geometry).diagonal(), 0, 'g', 6)
                     .arg(object.group.empty()
                              ? QString()
                              : QStringLiteral(", in ") + QString::fromStdString(object.group),
                          object.visible ? QString() : QStringLiteral(", hidden"));
        for (std::size_t i = 0; i < object.surfaces.size(); ++i) {
            const Surface& surface = object.surfaces[i];
            lines << QStringLiteral("%1: %2, %3 triangles, %4 N/m, colour (%5 %6 %7)%8%9")
                         .arg(name, QString::fromStdString(surface.name))
                         .arg(std::ranges::count(object.geometry->surfaceOf, Index(i)))
                         .arg(surface.material.stiffness)
                         .arg(surface.colour.x(), 0, 'g', 3)
                         .arg(surface.colour.y(), 0, 'g', 3)
                         .arg(surface.colour.z(), 0, 'g', 3)
                         .arg(surface.visible ? QString() : QStringLiteral(", hidden"),
                              surface.locked ? QStringLiteral(", locked") : QString());
        }
    }
    return lines;
}

const char* nameOf(SceneChange::What what) {
    constexpr const char* kNames[] = {"everything",   "objects", "surfaces", "names",
                                      "material",     "shading", "sides",    "layers",
                                      "proxy radius", "bodies",  "selection"};
    return kNames[std::size_t(what)];
}

/// A document that writes down what is done with it.
class Noted {
public:
    explicit Noted(QStringList (*figures)(const Scene&)) : figures_(figures) {
        adopt(document, fullScene());
        QObject::connect(&document, &Document::changed, [this](const SceneChange& change) {
            told_ << QLatin1String(nameOf(change.what)) + (change.surface == SurfaceRef{}
                                                               ? QString()
                                                               : QStringLiteral(" of %1.%2")
                                                                     .arg(change.surface.object)
                                                                     .arg(change.surface.surface));
        });
    }

    /// What an edit changed; then it is undone and redone, which has to give both scenes again, and undone.
    template <class Act> void note(const char* what, const Act& act) {
        const Scene before = document.scene();
        const int steps = document.history().index();
        told_.clear();
        act();
        if (!waitFor([&] { return !document.editing(); })) qFatal("%s does not end", what);
        text_ += QLatin1String(what) + QStringLiteral(": ");
        const int more = document.history().index() - steps;
        text_ += more == 0   ? QStringLiteral("no step")
                 : more == 1 ? u'"' + document.history().undoText() + u'"'
                             : QStringLiteral("several steps");
        text_ += QStringLiteral("; told: ") + told_.join(QStringLiteral(", ")) + u'\n' +
                 changedLines(figures_(before), figures_(document.scene()));
        const Scene after = document.scene();
        for (int i = 0; i < more; ++i)
            document.history().undo();
        if (const QString left = difference(document.scene(), before); !left.isEmpty())
            text_ += QStringLiteral("  undo leaves something:\n") + left;
        for (int i = 0; i < more; ++i)
            document.history().redo();
        if (const QString other = difference(document.scene(), after); !other.isEmpty())
            text_ += QStringLiteral("  redo gives another scene:\n") + other;
        for (int i = 0; i < more; ++i)
            document.history().undo();
        document.select({});
    }
    const QString& text() const { return text_; }

    Document document;

private:
    QStringList (*figures_)(const Scene&);
    QStringList told_;
    QString text_;
};

} // namespace

class TestDocumentEdits : public QObject {
    Q_OBJECT
private slots:
    void surfaces() {
        Noted noted(figuresOf);
        Document& document = noted.document;
        for (const MaterialField& field : kMaterialFields)
            noted.note(field.parameter->key.data(), [&] {
                document.setMaterialValue({kLid, kTop}, field, 0.75 * field.parameter->clamped(1));
            });
        noted.note("dynamic friction above the static one",
                   [&] { document.setMaterialValue(kLid, kMaterialFields[3], 0.9); });
        noted.note("static friction below the dynamic one",
                   [&] { document.setMaterialValue(kLid, kMaterialFields[2], 0.1); });
        noted.note("beyond its range", [&] { document.setMaterialValue(kLid, kMaterialFields[0], 1e9); });
        noted.note("of a locked one", [&] {
            document.setMaterialValue(SurfaceRef{4, 0}, kMaterialFields[0], 1);
        });
        noted.note("shading", [&] {
            document.setShading({kLid, kFloor}, {true, NormalSource::Computed, 0.5});
        });
        noted.note("sides", [&] { document.setSides({kLid, kFloor}, Sides::Back); });
        noted.note("hidden", [&] { document.setSurfacesVisible({kLid, kTop}, false); });
        noted.note("locked", [&] { document.setLocked({kLid, kTop}, true); });
        noted.note("unlocked", [&] { document.setLocked(SurfaceRef{4, 0}, false); });
        noted.note("isolated", [&] { document.isolate(kTop); });
        noted.note("surface renamed", [&] { document.renameSurface(kLid, QStringLiteral("cover")); });
        noted.note("surface renamed to what it is",
                   [&] { document.renameSurface(kLid, QStringLiteral("lid")); });
        COMPARE_SHOWN(noted.text(), "edits-surfaces");
    }

    void feelings() {
        Noted noted(figuresOf);
        Document& document = noted.document;
        Feel like{*document.surface(kLid), document.scene().objects[0].geometry};
        like.surface.layers.push_back({});
        like.surface.layers.back().name = "Noise";
        like.surface.layers.back().strength = 1e-4;
        TextureLayer painted;
        painted.name = "Painted";
        painted.pattern.source = TextureSource::Painted;
        painted.pattern.painted.values = std::make_shared<const PaintedValues>(std::vector<float>(8, 0.5F));
        like.surface.layers.push_back(painted);
        noted.note("the lid's feel for its neighbour, of the same mesh",
                   [&] { document.setFeel(kFloor, like, QStringLiteral("Paste feel")); });
        noted.note("and for another mesh, without what is painted",
                   [&] { document.setFeel(kTop, like, QStringLiteral("Paste feel")); });
        Preset preset;
        preset.name = "Wood";
        preset.colour = Vec3(0.5, 0.25, 0.125);
        preset.values[2] = 0.3;
        noted.note("a preset of friction and colour", [&] {
            applyPreset(document, {kLid, kTop, {4, 0}}, preset);
        });
        preset.values = {};
        preset.shading = Shading{true, NormalSource::Computed, 0.25};
        preset.layers = std::vector<TextureLayer>(1);
        preset.layers->front().name = "Grain";
        noted.note("a preset of shading and layers", [&] { applyPreset(document, kFloor, preset); });
        noted.note("a preset for a locked surface", [&] { applyPreset(document, SurfaceRef{4, 0}, preset); });
        noted.note("a preset for what is not there", [&] {
            applyPreset(document, SurfaceRef{9, 0}, preset);
        });
        COMPARE_SHOWN(noted.text(), "edits-feelings");
    }

    void objects() {
        Noted noted(outlineOf);
        Document& document = noted.document;
        noted.note("object renamed", [&] { document.renameObject(1, QStringLiteral("Chest")); });
        noted.note("object hidden", [&] { document.setVisible(2, false); });
        noted.note("all shown that is", [&] { document.showAll(); });
        noted.note("object removed", [&] { document.removeObject(2); });
        noted.note("two removed", [&] { document.removeObjects({1, 3}); });
        noted.note("none removed", [&] { document.removeObjects({9}); });
        noted.note("a group's member duplicated", [&] { document.duplicate({3}); });
        noted.note("grouped", [&] { document.group({1, 2}); });
        noted.note("a member grouped with another", [&] { document.group({2, 4}); });
        noted.note("taken apart", [&] { document.ungroup({3}); });
        noted.note("group renamed", [&] { document.renameGroup("Pair", QStringLiteral("Two")); });
        noted.note("group hidden", [&] { document.setGroupVisible("Pair", false); });
        noted.note("group shown that is", [&] { document.setGroupVisible("Pair", true); });
        noted.note("no such group hidden", [&] { document.setGroupVisible("None", false); });
        noted.note("proxy radius", [&] { document.setProxyRadius(0.002); });
        noted.note("reach", [&] { document.setReach({ReachMode::Rate, 0.01}); });
        noted.note("twice as large", [&] { document.scaleScene(2); });
        noted.note("another scene", [&] { document.replaceScene(QStringLiteral("Another"), knownScene()); });
        noted.note("the same scene of other meshes",
                   [&] { document.replaceScene(QStringLiteral("The same"), fullScene()); });
        COMPARE_SHOWN(noted.text(), "edits-objects");
    }

    void parts() {
        Noted noted(outlineOf);
        Document& document = noted.document;
        noted.note("a triangle split off", [&] {
            document.selectFaces({1, {0}});
            document.splitSelection();
        });
        noted.note("merged", [&] {
            document.select({kLid, kFloor});
            document.mergeSelected();
        });
        noted.note("a scene put beside", [&] { document.add(knownScene()); });
        noted.note("an object in another form", [&] {
            SceneObject other = document.scene().objects[0];
            other.name = "Other";
            document.setObject(other, QStringLiteral("Another form"));
        });
        noted.note("an object that is not there", [&] {
            SceneObject other = document.scene().objects[0];
            other.id = 9;
            document.setObject(other, QStringLiteral("Another form"));
        });
        COMPARE_SHOWN(noted.text(), "edits-parts");
    }

    /// A drag that is given up leaves no trace, one that is kept is a step; both may have many edits.
    void trials() {
        Document document;
        adopt(document, fullScene());
        const Scene before = document.scene();
        const auto drag = [&](Gesture gesture, double to) {
            for (int i = 1; i <= 3; ++i)
                document.setMaterialValue(kLid, kMaterialFields[0], to * i / 3, gesture);
        };
        document.setProxyRadius(0.002);
        document.history().undo();
        QVERIFY(document.history().canRedo());
        Gesture gesture = document.beginTrial();
        drag(gesture, 900);
        QCOMPARE(document.surface(kLid)->material.stiffness, 900.0);
        QCOMPARE(document.history().index(), 0);
        QVERIFY(document.modified());
        document.giveUpTrial(gesture);
        QCOMPARE(difference(document.scene(), before), "");
        QVERIFY(document.history().canRedo()); // as it was when it began
        gesture = document.beginTrial();
        drag(gesture, 600);
        document.endTrial(gesture, false);
        QCOMPARE(document.history().index(), 1);
        document.giveUpTrial(gesture); // it is over
        QCOMPARE(document.surface(kLid)->material.stiffness, 600.0);
        document.history().undo();
        QCOMPARE(difference(document.scene(), before), "");
        gesture = document.beginTrial();
        drag(gesture, 300);
        document.setProxyRadius(0.003); // another edit keeps it
        QCOMPARE(document.history().index(), 2);
        document.history().undo();
        QCOMPARE(document.surface(kLid)->material.stiffness, 300.0);
        document.history().undo();
        QCOMPARE(difference(document.scene(), before), "");
        document.setProxyRadius(0.003);
        gesture = document.beginTrial();
        drag(gesture, 300);
        document.history().undo(); // gives it up, and takes the step before it back
        QCOMPARE(difference(document.scene(), before), "");
        gesture = document.beginTrial();
        document.endTrial(gesture, false); // nothing was dragged
        QCOMPARE(document.history().index(), 0);
    }

    void selections() {
        Document document;
        adopt(document, fullScene());
        QSignalSpy changed(&document, &Document::changed);
        document.selectObjects({1, 3});
        QCOMPARE(document.selected(), (SurfaceRefs{kLid, kFloor, {3, 0}}));
        QCOMPARE(document.selection(), std::optional(SurfaceRef{3, 0}));
        QCOMPARE(changed.size(), 1);
        document.selectObjects({1, 3});
        QCOMPARE(changed.size(), 1); // nothing new
        document.selectObjects({1}, SelectMode::Subtract);
        QCOMPARE(document.selected(), (SurfaceRefs{{3, 0}}));
        document.selectObjects({2}, SelectMode::Add);
        QCOMPARE(document.selectedObjects(), (std::vector<ObjectId>{2, 3})); // as in the scene
        document.select({{9, 0}, {1, 7}, kLid});
        QCOMPARE(document.selected(), SurfaceRefs{kLid}); // what there is
        // Triangles: whole surfaces as such, others of the object that has most.
        QCOMPARE(document.selectTriangles({{1, {0, 1}}, {2, {0, 1}}}), 0u);
        QCOMPARE(document.selected(), (SurfaceRefs{kLid, kTop}));
        QCOMPARE(document.selectedFaces().faces.size(), 0u);
        document.select({});
        QCOMPARE(document.selectTriangles({{1, {0, 2, 3}}, {2, {0}}}), 1u);
        QCOMPARE(document.selectedFaces(), (FaceSelection{1, {0, 2, 3}}));
        document.select(kTop);
        QCOMPARE(document.selectTriangles({{1, {0, 2, 3}}, {2, {0}}}), 1u);
        QCOMPARE(document.selectedFaces(), (FaceSelection{2, {0}})); // the active one's
        QCOMPARE(document.history().count(), 0);
    }
};

TACTUM_TEST(TestDocumentEdits)

} // namespace test_document_edits

#include "test_document_edits.moc"
