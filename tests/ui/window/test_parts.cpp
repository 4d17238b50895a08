// A scene of many models, built with real events: begun, added to, doubled, renamed, searched, taken apart.
#include <algorithm>
#include <filesystem>

#include <QContextMenuEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>
#include <QUndoStack>

#include "core/files/gltf/write_gltf.h"
#include "core/files/journal.h"
#include "core/scene/bodies.h"
#include "core/scene/object_bounds.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/obj_box.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/journal.h"
#include "ui/panels/import_bar.h"
#include "ui/panels/outliner.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace test_parts {

using namespace tactum;

namespace {

/// A model of one object with two surfaces: a box of so many metres, its upper half another one.
QString writeModel(const QTemporaryDir& folder, const char* name, double size) {
    int next = 1;
    QByteArray text = QByteArray("o ") + name + "\nusemtl " + name + "-low\n";
    text += objBox(nullptr, {0, 0, 0}, {size, 0.5 * size, size}, next);
    text += QByteArray("usemtl ") + name + "-high\n";
    text += objBox(nullptr, {0, 0.5 * size, 0}, {size, size, size}, next);
    return writeFile(folder, QString::fromLatin1(name) + QStringLiteral(".obj"), text);
}

struct Desk {
    TouchedWindow program{{1400, 1000}};
    SceneView& view = program.window->view();
    Document& document = program.document;
    Outliner& outliner = *program.window->findChild<Outliner*>();
    NoticeBar& notice = *program.window->findChild<NoticeBar*>();

    const Scene& scene() const { return program.document.scene(); }
    std::size_t count() const { return scene().objects.size(); }
    const SceneObject& named(const char* name) const {
        const auto found = std::ranges::find(scene().objects, name, &SceneObject::name);
        if (found == scene().objects.end()) qFatal("no object %s", name);
        return *found;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const SceneObject& object : scene().objects)
            all.push_back(object.name);
        return all;
    }
    bool added(std::size_t wanted) {
        return test::waitFor([&] { return count() == wanted && !document.opening() && program.caughtUp(); });
    }
    void drop(const QStringList& files) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& file : files)
            urls << QUrl::fromLocalFile(file);
        data.setUrls(urls);
        QDragEnterEvent enter({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(program.window.get(), &enter);
        QDropEvent let({200, 200}, Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(program.window.get(), &let);
    }
    void key(Qt::Key which, Qt::KeyboardModifiers modifiers = {}) {
        view.setFocus();
        QTest::keyClick(program.window->windowHandle(), which, modifiers);
    }
    QPoint seen(const SceneObject& object) const {
        return view.camera().project(boundsOf(object).centre()).value().toPoint();
    }
    void click(QPoint at, Qt::MouseButton button = Qt::LeftButton) {
        program.moveTo(at);
        QTest::mouseClick(program.window->windowHandle(), button, {}, view.mapTo(program.window.get(), at));
    }
    QPushButton& button(const char* name) {
        return *program.window->findChild<QPushButton*>(QLatin1String(name));
    }
    void keep(const char* name) {
        if (const QString folder = qEnvironmentVariable("TACTUM_KEEP_PICTURES"); !folder.isEmpty()) {
            program.frames(20);
            program.window->grab().save(folder + u'/' + QLatin1String(name) + QStringLiteral(".png"));
        }
    }
};

bool overlap(const Bounds& a, const Bounds& b) {
    return ((a.low.array() + 1e-7 < b.high.array()) && (b.low.array() + 1e-7 < a.high.array())).all();
}

} // namespace

class TestParts : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

public:
    static void initMain() { prepareProcess(); }

private slots:
    void init() {
        useSettingsIn(folder_.path());
        QSettings().clear(); // as what files were taken before
    }

    // From the start page on: one step for each choice of files, none inside of another, saved and opened
    // again. What other programs make of such a scene: test_other_programs.
    void fiveModelsComeOntoAGround() {
        Desk desk;
        QTest::mouseClick(&desk.button("start-new"), Qt::LeftButton);
        QVERIFY(desk.added(1));
        QVERIFY(desk.view.isVisible());
        QVERIFY(!desk.document.modified());
        COMPARE_BEGINS(desk.program.window->windowTitle(), QStringLiteral("New scene"));
        const double sizes[] = {0.05, 0.06, 0.04, 0.07, 0.05};
        const char* names[] = {"cup", "jug", "bowl", "pot", "jar"};
        QStringList files;
        for (int i = 0; i < 5; ++i)
            files << writeModel(folder_, names[i], sizes[i]);
        answerFileDialog(u'"' + files.mid(0, 3).join(QStringLiteral("\" \"")) + u'"');
        desk.program.command("add").trigger();
        QVERIFY(desk.added(4));
        QCOMPARE(desk.document.history().count(), 1);
        QCOMPARE(desk.document.selectedObjects().size(), std::size_t(3));
        answerFileDialog(files[3]);
        desk.program.command("add").trigger();
        QVERIFY(desk.added(5));
        desk.drop({files[4]});
        QVERIFY(desk.added(6));
        QCOMPARE(desk.names(), (std::vector<std::string>{"Ground", "cup", "jug", "bowl", "pot", "jar"}));
        for (std::size_t i = 1; i < 6; ++i) {
            const Bounds box = boundsOf(desk.scene().objects[i]);
            COMPARE_NEAR(box.low.y(), 0, 1e-9, "m");
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!overlap(box, boundsOf(desk.scene().objects[j])));
        }
        desk.keep("five-models");

        const QString saved = folder_.filePath(QStringLiteral("five.glb"));
        answerFileDialog(saved);
        desk.program.command("save").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(!desk.document.modified(), kPatience);
        COMPARE_BEGINS(desk.program.window->windowTitle(), QStringLiteral("five.glb"));
        const Scene before = desk.scene();
        QVERIFY(desk.program.open(saved));
        QCOMPARE(desk.names().size(), std::size_t(6));
        QVERIFY(glbOf(desk.scene()).value() == glbOf(before).value());
    }

    // What an author begins with: added by the menu, felt, doubled, renamed, deleted, and all of it undone.
    void simpleBodiesAreAddedDoubledAndDeleted() {
        Desk desk;
        desk.program.command("new").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(desk.view.isVisible(), kPatience);
        QVERIFY(!desk.program.command("save").isEnabled());
        for (const char* id : {"add-box", "add-sphere", "add-cylinder", "add-plate", "add-box"})
            desk.program.command(id).trigger();
        QVERIFY(desk.added(5));
        QCOMPARE(desk.names(), (std::vector<std::string>{"Box", "Sphere", "Cylinder", "Plate", "Box 2"}));
        desk.program.command("view-isometric").trigger();
        desk.keep("simple-bodies");
        desk.document.select(SurfaceRef{desk.named("Sphere").id, 0});
        desk.document.setMaterialValue(desk.document.selected(), kMaterialFields[0], 222);
        const Scene before = desk.scene();
        desk.key(Qt::Key_D, Qt::ControlModifier);
        QVERIFY(desk.added(6));
        const SceneObject copy = desk.named("Sphere 2");
        QCOMPARE_EQ(copy.surfaces[0].material.*kMaterialFields[0].value, 222.0);
        QCOMPARE(copy.geometry, desk.named("Sphere").geometry);
        for (const SceneObject& object : desk.scene().objects)
            QVERIFY(object.id == copy.id || !overlap(boundsOf(copy), boundsOf(object)));

        desk.key(Qt::Key_F2);
        auto* editor = desk.outliner.findChild<QLineEdit*>();
        QVERIFY(editor);
        QTest::keyClicks(editor, "ball");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE_WITH_TIMEOUT(desk.scene().find(copy.id)->name, std::string("ball"), kPatience);

        desk.document.selectObjects({copy.id, desk.named("Box").id});
        desk.key(Qt::Key_Delete);
        QVERIFY(desk.added(4));
        QVERIFY(!desk.document.selection());
        desk.program.command("undo").trigger();
        QCOMPARE(desk.count(), std::size_t(6));
        QCOMPARE(desk.document.selectedObjects().size(), std::size_t(2));
        desk.program.command("undo").trigger();
        desk.program.command("undo").trigger();
        QVERIFY(desk.scene() == before);

        // An object that comes after one has gone is another one.
        desk.document.removeObject(desk.scene().objects.back().id);
        desk.program.command("add-box").trigger();
        QVERIFY(desk.scene().objects.back().id != before.objects.back().id);
        for (std::vector<ObjectId> all; desk.count() > 0;)
            desk.document.removeObjects({desk.scene().objects.front().id});
        desk.program.frames(5);
        QVERIFY(desk.view.isVisible());
    }

    // Dropped on a scene a model comes into it; Undo and another choice are beside what is told.
    void whatIsDroppedOnASceneComesIntoIt() {
        Desk desk;
        const QString cup = writeModel(folder_, "cup", 0.05), jug = writeModel(folder_, "jug", 0.06);
        desk.drop({cup});
        QVERIFY(desk.added(1));
        COMPARE_BEGINS(desk.program.window->windowTitle(), QStringLiteral("cup.obj"));
        const Scene before = desk.scene();
        desk.drop({jug, cup});
        QVERIFY(desk.added(3));
        QCOMPARE(desk.names(), (std::vector<std::string>{"cup", "jug", "cup 2"}));
        QCOMPARE(desk.notice.text(), QStringLiteral("2 files are in the scene now."));
        desk.program.command("undo").trigger();
        QVERIFY(desk.scene() == before);
        desk.drop({jug});
        QVERIFY(desk.added(2));
        QTRY_VERIFY_WITH_TIMEOUT(desk.button("notice-also").isVisible(), kPatience);
        QTest::mouseClick(&desk.button("notice-also"), Qt::LeftButton);
        QVERIFY(desk.scene() == before);
        desk.drop({jug});
        QVERIFY(desk.added(2));
        QTest::mouseClick(&desk.button("notice-act"), Qt::LeftButton);
        QVERIFY(test::waitFor([&] { return desk.names() == std::vector<std::string>{"jug"}; }));
        COMPARE_BEGINS(desk.program.window->windowTitle(), QStringLiteral("jug.obj"));
    }

    // One that is torn does not keep the others away, and alone it changes nothing.
    void aTornFileIsLeftOut() {
        Desk desk;
        QVERIFY(desk.program.open(writeModel(folder_, "cup", 0.05)));
        const QString torn = writeFile(folder_, QStringLiteral("torn.ply"), "ply\nformat");
        desk.drop({torn, writeModel(folder_, "jug", 0.06)});
        QVERIFY(desk.added(2));
        COMPARE_CONTAINS(desk.notice.text(), QStringLiteral("torn.ply"));
        const int steps = desk.document.history().count();
        desk.drop({torn});
        QVERIFY(test::waitFor([&] { return !desk.document.opening(); }));
        QCOMPARE(desk.document.history().count(), steps);
        QCOMPARE(desk.count(), std::size_t(2));
        COMPARE_CONTAINS(desk.notice.text(), QStringLiteral("torn.ply"));
    }

    // A mesh without unit: guessed, told, and taken otherwise by the bar, in place of the first guess.
    void theBarTakesAnAddedModelOtherwise() {
        Desk desk;
        QVERIFY(desk.program.open(writeModel(folder_, "cup", 0.05)));
        desk.drop({writeModel(folder_, "bolt", 80)}); // millimetres, surely
        QVERIFY(desk.added(2));
        auto* bar = desk.program.window->findChild<ImportBar*>();
        QTRY_VERIFY_WITH_TIMEOUT(bar->isVisible(), kPatience);
        COMPARE_NEAR(boundsOf(desk.named("bolt")).diagonal(), 0.08 * std::sqrt(3), 1e-9, "m");
        const int steps = desk.document.history().count();
        desk.program.command("taken-cm").trigger();
        QVERIFY(test::waitFor([&] {
            return !desk.document.opening() && std::abs(desk.document.takenAs()->axes.unit - 0.01) < 1e-12;
        }));
        QCOMPARE(desk.count(), std::size_t(2));
        QCOMPARE(desk.document.history().count(), steps);
        COMPARE_NEAR(boundsOf(desk.named("bolt")).diagonal(), kHandDiagonal, 1e-9, "m"); // 0.8 m fit no hand
        COMPARE_NEAR(boundsOf(desk.named("cup")).diagonal(), 0.05 * std::sqrt(3), 1e-9, "m");
    }

    // New shapes for what the scene began with; what was added since keeps its place, number and feel.
    void whatWasAddedOutlivesNewShapes() {
        Desk desk;
        const QString cup = writeModel(folder_, "cup", 0.05);
        QVERIFY(desk.program.open(cup));
        desk.drop({writeModel(folder_, "jug", 0.06)});
        desk.program.command("add-box").trigger();
        QVERIFY(desk.added(3));
        const SceneObject jug = desk.named("jug"), box = desk.named("Box");
        const Scene before = desk.scene();
        writeModel(folder_, "cup", 0.055);
        QSignalSpy ended(&desk.document, &Document::editEnded);
        desk.document.updateGeometry(cup.toStdString());
        QTRY_COMPARE_WITH_TIMEOUT(ended.size(), 1, kPatience);
        QCOMPARE(ended[0][0].toString(), QString());
        COMPARE_NEAR(boundsOf(desk.named("cup")).diagonal(), 0.055 * std::sqrt(3), 1e-9, "m");
        QVERIFY(desk.named("jug") == jug);
        QVERIFY(desk.named("Box") == box);
        COMPARE_LACKS(desk.notice.text(), QStringLiteral("not there any more"));
        desk.program.command("undo").trigger();
        QVERIFY(desk.scene() == before);
    }

    // What hangs on what is deleted is told, in one line; what is locked stays.
    void whatGoesWithADeletedObjectIsTold() {
        Desk desk;
        desk.program.command("new").trigger();
        desk.program.command("add-box").trigger();
        desk.program.command("add-plate").trigger();
        QVERIFY(desk.added(2));
        desk.program.command("motion-run").setChecked(false);
        desk.document.editBodies(QStringLiteral("Join"), [&](Scene& scene) {
            const BodyId box = makeBody(scene, scene.objects[0].id),
                         plate = makeBody(scene, scene.objects[1].id);
            AxisJoint joint = guessedJoint(scene, plate, AxisKind::Hinge);
            joint.to = box;
            setAxisJoint(scene, plate, joint);
        });
        const Scene before = desk.scene();
        desk.document.selectObjects({desk.named("Box").id});
        desk.program.command("lock").trigger();
        desk.key(Qt::Key_Delete);
        QCOMPARE(desk.count(), std::size_t(2));
        COMPARE_CONTAINS(desk.notice.text(), QStringLiteral("locked"));
        desk.program.command("lock").trigger();
        desk.key(Qt::Key_Delete);
        QVERIFY(desk.added(1));
        QCOMPARE(
            desk.notice.text(),
            QStringLiteral("A joint went with it. Hangs on nothing now: Plate. Undo brings all of it back."));
        desk.program.command("undo").trigger();
        QVERIFY(desk.scene() == before);
        // Doubled with what hangs on it.
        desk.key(Qt::Key_D, Qt::ControlModifier);
        QVERIFY(desk.added(4));
        QCOMPARE(desk.scene().mechanics.joints.size(), std::size_t(2));
        QCOMPARE(desk.scene().mechanics.joints[1].a, desk.named("Box 2").body);
    }

    void theUndoOfACopySelectsWhatWasSelected() {
        Desk desk;
        desk.document.begin({});
        for (const char* id : {"add-box", "add-sphere", "add-cylinder"})
            desk.program.command(id).trigger();
        QVERIFY(desk.added(3));
        const std::vector copied{desk.named("Box").id, desk.named("Sphere").id};
        desk.document.selectObjects(copied);
        desk.key(Qt::Key_D, Qt::ControlModifier);
        QVERIFY(desk.added(5));
        const std::vector<ObjectId> copies = desk.document.selectedObjects();
        QCOMPARE(copies.size(), std::size_t(2));
        QCOMPARE_NE(copies.front(), copied.front());
        for (int i = 0; i < 2; ++i) {
            desk.program.command("undo").trigger();
            QCOMPARE(desk.document.selectedObjects(), copied);
            desk.program.command("redo").trigger();
            QCOMPARE(desk.document.selectedObjects(), copies);
        }
        // What else is selected meanwhile stays so.
        desk.document.selectObjects({desk.named("Cylinder").id});
        desk.program.command("undo").trigger();
        QCOMPARE(desk.document.selectedObjects(), std::vector{desk.named("Cylinder").id});
        desk.program.command("redo").trigger();
        QCOMPARE(desk.document.selectedObjects(), std::vector{desk.named("Cylinder").id});
    }

    void thingsComeDownToTheGround() {
        Desk desk;
        desk.program.command("new-ground").trigger();
        desk.program.command("add-box").trigger();
        desk.program.command("add-sphere").trigger();
        QVERIFY(desk.added(3));
        desk.document.editScene(QStringLiteral("Lift"), SceneChange::What::Objects, [](Scene& scene) {
            scene.objects[1].pose.translation += Vec3(0.01, 0.2, 0);
            scene.objects[2].pose.translation = scene.objects[1].pose.translation + Vec3(0, 0.2, 0);
        });
        desk.document.selectObjects({desk.named("Box").id, desk.named("Sphere").id});
        const int steps = desk.document.history().count();
        desk.key(Qt::Key_End, Qt::ControlModifier);
        QCOMPARE(desk.document.history().count(), steps + 1);
        COMPARE_NEAR(boundsOf(desk.named("Box")).low.y(), 0, 1e-9, "m");
        COMPARE_NEAR(boundsOf(desk.named("Sphere")).low.y(), 0.06, 1e-9, "m"); // onto the box
        desk.key(Qt::Key_End, Qt::ControlModifier);
        QCOMPARE(desk.document.history().count(), steps + 1);
        COMPARE_CONTAINS(desk.notice.text(), QStringLiteral("already"));
    }

    void theListFindsAndTheRightButtonOffers() {
        Desk desk;
        desk.program.command("new").trigger();
        for (const char* id : {"add-box", "add-sphere", "add-box"})
            desk.program.command(id).trigger();
        QVERIFY(desk.added(3));
        auto* field = desk.program.window->findChild<QLineEdit*>(QStringLiteral("outliner-search"));
        QTest::mouseClick(field, Qt::LeftButton);
        QTest::keyClicks(field, "box");
        QVERIFY(desk.outliner.topLevelItem(1)->isHidden());
        QVERIFY(!desk.outliner.topLevelItem(2)->isHidden());
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(desk.document.selectedObjects(),
                 (std::vector<ObjectId>{desk.scene().objects[0].id, desk.scene().objects[2].id}));
        desk.keep("searched");
        desk.document.renameObject(desk.scene().objects[2].id, QStringLiteral("lid"));
        desk.document.renameSurface(SurfaceRef{desk.scene().objects[2].id, 0}, QStringLiteral("rim"));
        QTRY_VERIFY_WITH_TIMEOUT(desk.outliner.topLevelItem(2)->isHidden(), kPatience);
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(!desk.outliner.topLevelItem(1)->isHidden());
        QTest::keyClicks(field, "zzz");
        COMPARE_CONTAINS(test::drawnBy(*desk.outliner.viewport()), QStringLiteral("zzz"));
        QTest::keyClick(field, Qt::Key_Escape);
        COMPARE_LACKS(test::drawnBy(*desk.outliner.viewport()), QStringLiteral("zzz"));

        desk.program.frames(2);
        const ObjectId sphere = desk.named("Sphere").id;
        desk.click(desk.seen(desk.named("Sphere")), Qt::RightButton);
        QCOMPARE(desk.document.selectedObjects(), std::vector<ObjectId>{sphere});
        auto* menu = desk.program.window->findChild<QMenu*>(QStringLiteral("object-menu"));
        QVERIFY(menu && menu->isVisible());
        desk.keep("object-menu");
        QVERIFY(menu->actions().contains(&desk.program.command("duplicate")));
        menu->close();
        // A drag with the right button asks for nothing.
        desk.program.frames(2);
        QWindow* window = desk.program.window->windowHandle();
        const QPoint from = desk.view.mapTo(desk.program.window.get(), desk.program.centre());
        QTest::mousePress(window, Qt::RightButton, {}, from);
        QTest::mouseMove(window, from + QPoint(40, 0));
        QTest::mouseRelease(window, Qt::RightButton, {}, from + QPoint(40, 0));
        QVERIFY(!desk.program.window->findChild<QMenu*>(QStringLiteral("object-menu")));
        QContextMenuEvent asked(QContextMenuEvent::Keyboard, {5, 5}, desk.outliner.mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(&desk.outliner, &asked);
        menu = desk.program.window->findChild<QMenu*>(QStringLiteral("object-menu"));
        QVERIFY(menu && menu->isVisible());
        menu->close();
    }

    // A scene without a file is kept for a crash as any other; with nothing in it, what was there last is.
    void aNewSceneIsKeptForACrash() {
        Desk desk;
        Journal& journal = desk.program.window->journal();
        desk.program.command("new-ground").trigger();
        desk.program.command("add-box").trigger();
        QVERIFY(desk.added(2));
        QSignalSpy written(&journal, &Journal::written);
        journal.writeNow();
        QTRY_VERIFY_WITH_TIMEOUT(!written.isEmpty(), kPatience);
        // As the next run finds it.
        std::vector<std::filesystem::path> folders;
        for (const auto& each : std::filesystem::directory_iterator(Journal::home()))
            if (holdsJournal(each.path())) folders.push_back(each.path());
        QCOMPARE(folders.size(), std::size_t(1));
        const auto entry = readJournalEntry(folders[0]);
        VERIFY_RESULT(entry);
        QCOMPARE(entry->title, std::string("New scene"));
        QVERIFY(entry->file.empty());
        const auto file = unpackJournal(folders[0]);
        VERIFY_RESULT(file);
        const auto kept = loadScene(*file);
        VERIFY_RESULT(kept);
        QVERIFY(glbOf(kept->scene).value() == glbOf(desk.scene()).value());
    }

    void aDeletedSurfaceTakesItsObjectAlongAndSaysSo() {
        Desk desk;
        QVERIFY(desk.program.open(writeCube(folder_)));
        desk.document.select(SurfaceRef{desk.scene().objects[0].id, 2});
        const QString name = QString::fromStdString(desk.scene().objects[0].name);
        desk.key(Qt::Key_Delete);
        QVERIFY(desk.added(0));
        QCOMPARE(
            desk.notice.text(),
            QStringLiteral("All of %1 went, not its selected surfaces alone. Undo brings all of it back.")
                .arg(name));
        desk.program.command("undo").trigger();
        desk.program.command("select-all").trigger();
        desk.key(Qt::Key_Delete);
        QVERIFY(desk.added(0));
        COMPARE_LACKS(desk.notice.text(), QStringLiteral("All of"));
    }

    // A file of nothing could not be opened again.
    void anEmptiedSceneIsNotOfferedToBeSaved() {
        Desk desk;
        const QString file = writeModel(folder_, "emptied", 0.04);
        QVERIFY(desk.program.open(file));
        desk.program.command("select-all").trigger();
        desk.key(Qt::Key_Delete);
        QCOMPARE(desk.count(), std::size_t(0));
        desk.program.window->close();
        auto* question = desk.program.window->findChild<QMessageBox*>(QStringLiteral("unsaved"));
        QVERIFY(question && question->isVisible());
        QCOMPARE(question->button(QMessageBox::Save), nullptr);
        question->button(QMessageBox::Cancel)->click();
        QVERIFY(desk.program.window->isVisible());
        desk.document.history().undo();
        QCOMPARE(desk.count(), std::size_t(1));
    }

    // From wherever one looks: the finger rests to the right of the picture, where the next thing may come.
    void whatIsAddedDoesNotComeOntoTheFinger() {
        Desk desk;
        desk.program.command("new").trigger();
        QTRY_VERIFY_WITH_TIMEOUT(desk.view.isVisible(), kPatience);
        QVERIFY(desk.program.fullForce());
        for (const double yaw : {-0.16, 0.5, -1.4}) {
            desk.view.moveCamera(yaw - desk.view.camera().yaw, 0, 1);
            for (const char* id : {"add-box", "add-sphere"}) {
                const std::size_t before = desk.count();
                desk.program.command(id).trigger();
                QVERIFY(desk.added(before + 1));
                QVERIFY(desk.program.atRest());
                QCOMPARE(desk.program.touch().contacts, 0);
                QCOMPARE_EQ(desk.program.engine.servo().force.norm(), 0.0);
            }
            desk.program.command("new").trigger();
            if (auto* question = desk.program.window->findChild<QMessageBox*>(QStringLiteral("unsaved")))
                question->button(QMessageBox::Discard)->click();
            QTRY_COMPARE_WITH_TIMEOUT(desk.count(), std::size_t(0), kPatience);
        }
    }

    /// By the mouse in the list, one step; kept in the file.
    void rowsAreDraggedToAnotherPlace() {
        Desk desk;
        addThree(desk);
        const Scene before = desk.scene();
        const auto dragTo = [&](int row, QPoint to) {
            const QPoint from = desk.outliner.visualItemRect(desk.outliner.topLevelItem(row)).center();
            QWidget& list = *desk.outliner.viewport();
            QTest::mousePress(&list, Qt::LeftButton, {}, from);
            QTest::mouseMove(&list, (from + to) / 2);
            QTest::mouseMove(&list, to);
            QTest::mouseRelease(&list, Qt::LeftButton, {}, to);
        };
        const auto top = [&](int row) {
            return desk.outliner.visualItemRect(desk.outliner.topLevelItem(row)).topLeft() + QPoint(20, 2);
        };
        dragTo(2, top(0));
        QCOMPARE(desk.names(), (std::vector<std::string>{"c", "a", "b"}));
        QCOMPARE(desk.outliner.topLevelItem(0)->text(0), QStringLiteral("c"));
        QCOMPARE(desk.document.selectedObjects(), std::vector{desk.named("c").id});
        // Two that are selected go together.
        desk.document.selectObjects({desk.named("c").id, desk.named("a").id});
        dragTo(0, desk.outliner.visualItemRect(desk.outliner.topLevelItem(2)->child(1)).center());
        QCOMPARE(desk.names(), (std::vector<std::string>{"b", "c", "a"}));
        const QString file = folder_.filePath(QStringLiteral("order.glb"));
        desk.document.save(std::filesystem::path(file.toStdU16String()));
        QTRY_VERIFY_WITH_TIMEOUT(!desk.document.saving(), kPatience);
        desk.document.history().undo();
        desk.document.history().undo();
        QVERIFY2(desk.scene() == before, "two steps");
        desk.document.history().redo();
        desk.document.history().redo(); // or it would ask whether to save
        desk.document.open(std::filesystem::path(writeCube(folder_).toStdU16String()));
        QVERIFY(desk.added(1));
        QVERIFY(desk.program.open(file));
        QCOMPARE(desk.names(), (std::vector<std::string>{"b", "c", "a"}));
    }

    void keysMoveObjectsInTheList() {
        Desk desk;
        addThree(desk);
        desk.document.selectObjects({desk.named("b").id});
        desk.key(Qt::Key_Up, Qt::AltModifier);
        QCOMPARE(desk.names(), (std::vector<std::string>{"b", "a", "c"}));
        desk.key(Qt::Key_Up, Qt::AltModifier); // it is the first already
        desk.key(Qt::Key_Down, Qt::AltModifier);
        desk.key(Qt::Key_Down, Qt::AltModifier);
        QCOMPARE(desk.names(), (std::vector<std::string>{"a", "c", "b"}));
        QCOMPARE(desk.document.selectedObjects(), std::vector{desk.named("b").id});
    }

    void objectsComeIntoLine() {
        Desk desk;
        addThree(desk);
        const auto box = [&](const char* name) { return boundsOf(desk.named(name)); };
        const Bounds last = box("c");
        desk.document.selectObjects({desk.named("a").id, desk.named("b").id, desk.named("c").id});
        const int steps = desk.document.history().count();
        desk.program.command("align-z-high").trigger();
        COMPARE_NEAR(box("a").high.z(), last.high.z(), 1e-9, "m");
        COMPARE_NEAR(box("b").high.z(), last.high.z(), 1e-9, "m");
        QCOMPARE(desk.document.history().count(), steps + 1);
        desk.program.command("align-z-high").trigger();
        COMPARE_CONTAINS(desk.notice.text(), QStringLiteral("They are aligned already."));
        desk.program.command("distribute-x").trigger();
        std::vector<double> middles{box("a").centre().x(), box("b").centre().x(), box("c").centre().x()};
        std::ranges::sort(middles);
        COMPARE_NEAR(middles[2] - middles[1], middles[1] - middles[0], 1e-9, "m");
        desk.document.selectObjects({desk.named("c").id});
        desk.program.command("align-x-low").trigger();
        COMPARE_CONTAINS(desk.notice.text(), QStringLiteral("Select two or more objects"));
    }

private:
    /// a, b and c, of several sizes.
    void addThree(Desk& desk) {
        desk.document.begin({});
        std::size_t count = 0;
        for (const auto& [name, size] : {std::pair{"a", 0.03}, {"b", 0.05}, {"c", 0.08}}) {
            desk.document.add(
                {{std::filesystem::path(writeModel(folder_, name, size).toStdU16String()), {}}});
            QVERIFY(desk.added(++count));
        }
        desk.document.selectObjects({});
    }
};

TACTUM_GUI_TEST(TestParts)

} // namespace test_parts

#include "test_parts.moc"
