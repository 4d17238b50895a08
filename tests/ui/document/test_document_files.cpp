// The document and files: whose a file is, saving in turn, models that come in besides, new shapes with the
// old feel, and a file that another program writes. Wrong itself if a scene that was saved were held against
// itself: it is read by the reader of files.
#include <fstream>

#include <QSignalSpy>
#include <QTest>

#include "core/files/load_scene.h"
#include "core/scene/object_bounds.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/cube_file.h"
#include "tests/ui/document/scene_figures.h"
#include "tests/ui/panels/panels.h"
#include "ui/document/source_watch.h"

namespace test_document_files {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

class TestDocumentFiles : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;

    QString place(const char* name) const { return folder_->filePath(QString::fromUtf8(name)); }
    static bool open(Document& document, const QString& file) {
        document.open(file.toStdString());
        return waitFor([&] { return !document.opening(); });
    }
    /// As another program writes it again: this instead of that.
    static bool inFile(const QString& file, const char* from, const char* to) {
        QFile changing(file);
        if (!changing.open(QIODevice::ReadWrite)) return false;
        const QByteArray text = changing.readAll(), other = QByteArray(text).replace(from, to);
        return other != text && changing.resize(0) && changing.seek(0) &&
               changing.write(other) == other.size();
    }
    static bool save(Document& document, const QString& file) {
        document.save(file.toStdString());
        return waitFor([&] { return !document.saving(); });
    }

private slots:
    void init() { folder_ = std::make_unique<QTemporaryDir>(); }

    void aFileIsOnesOwnOnceItWasSaved() {
        Document document;
        QSignalSpy opening(&document, &Document::openProgressed);
        QVERIFY(!document.isOpen() && document.empty());
        QVERIFY(open(document, writeCube(*folder_)));
        QVERIFY(document.isOpen());
        QCOMPARE(opening.front(), (QVariantList{0.0, -1.0})); // at once, with nothing to judge from yet
        QVERIFY(!document.hasOwnFile() && !document.modified());
        QCOMPARE(document.title(), "cube.obj");
        QCOMPARE(document.source().path, document.path());
        document.setProxyRadius(0.002);
        QVERIFY(document.modified());
        QSignalSpy saved(&document, &Document::saved), failed(&document, &Document::saveFailed);
        QVERIFY(save(document, place("scene.glb")));
        QCOMPARE(saved.size(), 1);
        QVERIFY(document.hasOwnFile() && !document.modified() && !document.changedOutside());
        QCOMPARE(document.title(), "scene.glb");
        QCOMPARE(document.source().path.filename(), std::filesystem::path("cube.obj")); // the shapes' stays
        QCOMPARE(loadScene(place("scene.glb").toStdString())->scene.proxyRadius, 0.002);
        document.history().undo();
        QVERIFY(document.modified());
        document.history().redo();
        QVERIFY(!document.modified());
        // Where it cannot be written it stays as it was.
        QVERIFY(save(document, place("none/scene.glb")));
        QCOMPARE(failed.size(), 1);
        QCOMPARE(document.title(), "scene.glb");
        std::ofstream(place("scene.glb").toStdString(), std::ios::app) << "more";
        QVERIFY(document.changedOutside());
    }

    void aSampleIsABeginning() {
        Document document;
        adopt(document, knownScene());
        QVERIFY(save(document, place("sample.glb")));
        Document other;
        other.open(place("sample.glb").toStdString(), true);
        QVERIFY(waitFor([&] { return !other.opening(); }));
        QVERIFY(!other.hasOwnFile());
        QVERIFY(open(other, place("sample.glb")));
        QVERIFY(other.hasOwnFile());
        other.begin(knownScene());
        QVERIFY(!other.hasOwnFile() && !other.modified());
        QCOMPARE(other.path(), std::filesystem::path());
        QCOMPARE(other.source().path, std::filesystem::path());
        other.adoptShared(knownScene(), place("shared.glb").toStdString());
        QVERIFY(!other.hasOwnFile() && !other.modified());
        QCOMPARE(other.title(), "shared.glb");
        QCOMPARE(other.source().path, std::filesystem::path());
    }

    /// One at a time; each has the scene as it is when its turn comes, and an edit meanwhile stays unsaved.
    void savesWaitForTheirTurn() {
        Document document;
        adopt(document, knownScene());
        QSignalSpy saved(&document, &Document::saved), exported(&document, &Document::exported);
        document.setProxyRadius(0.002);
        document.save(place("a.glb").toStdString());
        document.setProxyRadius(0.003);
        document.save(place("b.glb").toStdString());
        document.exportBundle(place("c.tactum").toStdString());
        QVERIFY(waitFor([&] { return saved.size() == 1; }));
        QVERIFY(document.modified()); // 3 mm are not in that file
        QVERIFY(waitFor([&] { return saved.size() == 2 && exported.size() == 1; }));
        QVERIFY(!document.modified());
        QCOMPARE(document.title(), "b.glb"); // a bundle is for others
        const auto radius = [&](const char* name) {
            return loadScene(place(name).toStdString())->scene.proxyRadius;
        };
        QCOMPARE(radius("a.glb"), 0.002);
        QCOMPARE(radius("b.glb"), 0.003);
        QCOMPARE(radius("c.tactum"), 0.003);
        // Another scene meanwhile: the file is not its.
        document.save(place("d.glb").toStdString());
        document.begin(knownScene());
        QVERIFY(waitFor([&] { return saved.size() == 3; }));
        QCOMPARE(document.path(), std::filesystem::path());
    }

    void modelsComeInBesides() {
        Document document;
        adopt(document, knownScene());
        const Scene before = document.scene();
        QSignalSpy added(&document, &Document::added), failed(&document, &Document::openFailed),
            opening(&document, &Document::openProgressed);
        const std::filesystem::path cube = writeCube(*folder_).toStdString(),
                                    large = writeCube(*folder_, 100).toStdString(),
                                    bad = writeFile(*folder_, QStringLiteral("bad.ply"), "no").toStdString();
        document.add(std::vector<FileToAdd>{{cube, {}}, {bad, {}}, {large, {}}});
        QVERIFY(document.adding());
        QCOMPARE(opening.front(), (QVariantList{0.0, -1.0}));
        QVERIFY(waitFor([&] { return added.size() == 1; }));
        const auto told = added[0][0].value<SceneAddition>();
        QCOMPARE(told.files, (std::vector<std::filesystem::path>{cube, large}));
        QCOMPARE(told.objects.size(), 2u);
        QCOMPARE(told.refused.size(), 1u);
        QCOMPARE(told.scaled.size(), 1u);
        COMPARE_NEAR(told.scaled[0].second, 10 * std::sqrt(3.0), 1e-6, "m");
        QCOMPARE(document.history().undoText(), "Add 2 files");
        QCOMPARE(document.scene().objects.size(), 4u);
        QCOMPARE(document.selectedObjects(), told.objects);
        for (const ObjectId id : told.objects) // beside or upon whatever is there
            for (const SceneObject& other : document.scene().objects) {
                if (other.id == id) continue;
                const Bounds box = boundsOf(*document.scene().find(id)), its = boundsOf(other);
                QVERIFY((box.low.array() >= its.high.array() - 1e-9).any() ||
                        (box.high.array() <= its.low.array() + 1e-9).any());
            }
        document.history().undo();
        QCOMPARE(difference(document.scene(), before), "");
        document.add(std::vector<FileToAdd>{{bad, {}}});
        QVERIFY(waitFor([&] { return failed.size() == 1; }));
        QCOMPARE(difference(document.scene(), before), "");
        document.add(std::vector<FileToAdd>{{cube, {}}});
        QVERIFY(waitFor([&] { return added.size() == 2; }));
        QCOMPARE(document.history().undoText(), "Add cube.obj");
        // Another scene meanwhile: it stays alone.
        document.add(std::vector<FileToAdd>{{cube, {}}});
        document.begin(knownScene());
        const int before2 = int(added.size());
        QTest::qWait(100);
        QCOMPARE(added.size(), before2);
        QCOMPARE(document.scene().objects.size(), 2u);
        document.add(std::vector<FileToAdd>()); // nothing
        document.add(Scene());
        QVERIFY(!document.opening());
        QCOMPARE(document.history().count(), 0);
    }

    void aModelIsTakenOtherwise() {
        Document document;
        QVERIFY(open(document, writeCube(*folder_)));
        QVERIFY(document.takenAs());
        QCOMPARE(document.takenFile().filename(), std::filesystem::path("cube.obj"));
        COMPARE_NEAR(document.takenAcross(), 0.1 * std::sqrt(3.0), 1e-9, "m");
        document.takeOtherwise({0.01, true});
        QVERIFY(waitFor([&] { return !document.opening(); }));
        QCOMPARE(document.takenAs()->axes.unit, 0.01);
        QVERIFY(document.takenAs()->axes.zUp);
        COMPARE_NEAR(document.takenAs()->across, 0.001 * std::sqrt(3.0), 1e-9, "m");
        COMPARE_NEAR(document.takenAcross(), 0.2, 1e-9, "m"); // made to fit a hand
        QVERIFY(!document.modified());
        // Not while there is an edit that it would lose: of a drag, or one that could be done again.
        const Gesture drag = document.beginTrial();
        document.setProxyRadius(0.002, drag);
        QVERIFY(!document.takenAs());
        document.giveUpTrial(drag);
        QVERIFY(document.takenAs());
        document.setProxyRadius(0.002);
        QVERIFY(!document.takenAs());
        document.history().undo();
        QVERIFY(!document.takenAs());
        document.setProxyRadius(0.002);
        QCOMPARE_GT(document.history().count(), 0);
        QSignalSpy failed(&document, &Document::openFailed);
        document.reopen({});
        QVERIFY(waitFor([&] { return failed.size() == 1; }));
        COMPARE_CONTAINS(failed[0][0].toString(), "was not opened anew: the scene was edited meanwhile.");
        QCOMPARE(document.scene().proxyRadius, 0.002);
    }

    /// New shapes take the feel of the surfaces of their names.
    void shapesAreUpdated() {
        Document document;
        const QString file = writeCube(*folder_);
        QVERIFY(open(document, file));
        const ObjectId cube = document.scene().objects[0].id;
        document.setMaterialValue(SurfaceRef{cube, 4}, kMaterialFields[0], 123);
        document.setMaterialValue(SurfaceRef{cube, 5}, kMaterialFields[0], 456);
        const Scene before = document.scene();
        QSignalSpy updated(&document, &Document::geometryUpdated), ended(&document, &Document::editEnded),
            editing(&document, &Document::editProgressed);
        document.updateGeometry(file.toStdString());
        QCOMPARE(editing.front(), (QVariantList{0.0, -1.0}));
        QVERIFY(waitFor([&] { return updated.size() == 1; }));
        QVERIFY(!updated[0][0].value<GeometryUpdate>().changed); // the shapes that are here
        const auto findings = [&](int i) {
            QString text;
            for (const Finding& finding : updated[i][0].value<GeometryUpdate>().findings)
                text +=
                    QString::fromStdString(finding.object + ": " + finding.sentence + "; " + finding.remedy) +
                    u'\n';
            return text;
        };
        QCOMPARE(findings(0), ""); // all is as it was
        QCOMPARE(difference(document.scene(), before), "");
        const int steps = document.history().count();
        QVERIFY(inFile(file, "v 0.05", "v 0.07") && inFile(file, "g back", "g rear"));
        document.updateGeometry(file.toStdString());
        QVERIFY(waitFor([&] { return updated.size() == 2; }));
        const auto told = updated[1][0].value<GeometryUpdate>();
        QVERIFY(told.changed);
        QCOMPARE(document.history().count(), steps + 1);
        QCOMPARE(findings(1), "cube: surface rear has no partner; it feels as it did; give it the name that "
                              "it had, or set its feel by hand\n"
                              "cube: surface back of the scene with the feel has no partner; its feel is "
                              "kept for when the file has it again\n");
        QCOMPARE(told.surfaces, 6u);
        QCOMPARE(told.withFeel, 5u);
        QCOMPARE(told.surfacesBefore, 6u);
        QCOMPARE(told.surfacesLost, 1u);
        const SceneObject& now = document.scene().objects[0];
        COMPARE_NEAR(boundsOf(document.scene()).high.x() - boundsOf(document.scene()).low.x(), 0.12, 1e-9,
                     "m");
        const auto stiffness = [&](const char* name) {
            return std::ranges::find(now.surfaces, name, &Surface::name)->material.stiffness;
        };
        QCOMPARE(stiffness("front"), 123.0);
        for (std::size_t i = 0; i < 5; ++i) // the file says no colours: the surfaces look as they did
            QCOMPARE(now.surfaces[i].colour, before.objects[0].surfaces[i].colour);
        QCOMPARE(stiffness("rear"), kStiffness.initial);
        document.history().undo();
        QCOMPARE(difference(document.scene(), before), "");
        document.history().redo();
        // What found no surface waits for the next update.
        QVERIFY(inFile(file, "g rear", "g back"));
        document.updateGeometry(file.toStdString());
        QVERIFY(waitFor([&] { return updated.size() == 3; }));
        QCOMPARE(updated[2][0].value<GeometryUpdate>().back, 1u);
        QCOMPARE(findings(2), "cube: surface rear of the scene with the feel has no partner; its feel is "
                              "kept for when the file has it again\n");
        const SceneObject& again = document.scene().objects[0];
        QCOMPARE(std::ranges::find(again.surfaces, "back", &Surface::name)->material.stiffness, 456.0);
        document.updateGeometry(place("none.obj").toStdString());
        QVERIFY(waitFor([&] { return !ended.isEmpty() && !ended.back()[0].toString().isEmpty(); }));
    }

    /// The same shapes by another unit are news, and a step of the history: what the unit was can be taken
    /// back.
    void anotherUnitIsAChange() {
        Document document;
        const QString file = writeCube(*folder_, 1000); // 100 units: millimetres
        QVERIFY(open(document, file));
        const Scene before = document.scene();
        QSignalSpy updated(&document, &Document::geometryUpdated);
        QVERIFY(inFile(file, "50", "0.05")); // metres
        document.updateGeometry(file.toStdString());
        QVERIFY(waitFor([&] { return updated.size() == 1; }));
        const auto told = updated[0][0].value<GeometryUpdate>();
        QVERIFY(told.changed);
        QCOMPARE(told.axesBefore->unit, 1e-3);
        QCOMPARE(told.axes->unit, 1.0);
        COMPARE_NEAR(told.grown, 1e-3, 1e-12, "");
        COMPARE_NEAR(boundsOf(document.scene()).diagonal(), boundsOf(before).diagonal(), 1e-12, "m");
        QCOMPARE(document.history().count(), 1);
        QCOMPARE(document.takenAs()->by, TakenAs::By::Size);
        document.history().undo();
        QCOMPARE(difference(document.scene(), before), "");
    }

    /// Each version of the file is told once, when nobody has written on it for a moment; not what is saved
    /// here.
    void aFileIsWatched() {
        Document document;
        SourceWatch watch(document);
        QSignalSpy told(&watch, &SourceWatch::changed);
        adopt(document, knownScene());
        QVERIFY(save(document, place("scene.glb")));
        QVERIFY(open(document, place("scene.glb")));
        document.setProxyRadius(0.002);
        QVERIFY(save(document, place("scene.glb")));
        Document other;
        adopt(other, knownScene());
        QVERIFY(save(other, place("scene.glb"))); // another program's hand
        QVERIFY(waitFor([&] { return told.size() == 1; }));
        QTest::qWait(1300); // longer than it takes to settle
        QCOMPARE(told.size(), 1);
        QVERIFY(QFile::remove(place("scene.glb")));
        QTest::qWait(1300);
        QCOMPARE(told.size(), 1); // nothing to read
        other.setProxyRadius(0.004);
        QVERIFY(save(other, place("scene.glb"))); // it comes back
        QVERIFY(waitFor([&] { return told.size() == 2; }));
    }
};

TACTUM_TEST(TestDocumentFiles)

} // namespace test_document_files

#include "test_document_files.moc"
