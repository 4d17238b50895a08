// A thousand bodies in the window: the right ones are listed, picked and edited, and what an action costs
// does not grow with how many there are where it concerns one. Counts of work are looked at, not the clock;
// with TACTUM_BODIES set to a number, figures() says how long each action takes with so many.
#include <QAction>
#include <QApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QTest>
#include <QTreeWidget>
#include <QUndoStack>

#include "tests/support/gui_test_program.h"
#include "tests/ui/window/crowd_scene.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"

namespace test_many_bodies {

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr int kBodies = 1000;

QTreeWidget& outlinerOf(TouchedWindow& program) {
    return *program.window->findChild<QTreeWidget*>(QStringLiteral("outliner"));
}

/// Where a body's middle is seen.
QPoint placeOf(TouchedWindow& program, int body) {
    const Vec3 middle = program.document.scene().objects[std::size_t(body)].pose.translation;
    return program.window->view().camera().project(middle)->toPoint();
}

} // namespace

class TestManyBodies : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepareProcess(); }

private:
    QTemporaryDir folder_;
    QString file_;

private slots:
    void initTestCase() {
        useSettingsIn(folder_.path());
        file_ = writeCrowd(folder_, kBodies);
        QVERIFY(!file_.isEmpty());
    }
    void fewActorsShowThem();
    void theOutlinerListsThemInOrder();
    void theBodyUnderThePointerIsPicked();
    void anEditMakesNoRowAnew();
    void undoGivesTheSameScene();
    void figures();
};

/// As many for a thousand as for ten.
void TestManyBodies::fewActorsShowThem() {
    const auto actorsOf = [](const QString& file, std::size_t bodies) {
        TouchedWindow program;
        if (!program.open(file)) qFatal("%s cannot be opened", qPrintable(file));
        const int actors = program.window->view().actorCount();
        program.command("select-all").trigger();
        if (program.document.selected().size() != bodies) qFatal("not all are selected");
        return std::pair(actors, program.window->view().actorCount());
    };
    QTemporaryDir other;
    const auto few = actorsOf(writeCrowd(other, 10), 10);
    QCOMPARE_GT(few.first, 0);
    QCOMPARE(actorsOf(file_, kBodies), few);
}

void TestManyBodies::theOutlinerListsThemInOrder() {
    TouchedWindow program;
    QVERIFY(program.open(file_));
    QTreeWidget& rows = outlinerOf(program);
    QCOMPARE(rows.topLevelItemCount(), kBodies);
    for (int i = 0; i < kBodies; ++i) {
        QCOMPARE(rows.topLevelItem(i)->text(0), QStringLiteral("box %1").arg(i));
        QCOMPARE(rows.topLevelItem(i)->childCount(), 1);
    }
    program.document.select(SurfaceRef{501, 0});
    QCOMPARE(rows.currentItem(), rows.topLevelItem(500)->child(0));
    rows.setCurrentItem(rows.topLevelItem(700)->child(0));
    QCOMPARE(program.document.selection(), (SurfaceRef{701, 0}));
}

void TestManyBodies::theBodyUnderThePointerIsPicked() {
    TouchedWindow program;
    QVERIFY(program.open(file_));
    program.window->view().showStandardView(StandardView::Front);
    program.command("select").trigger();
    program.frames(5);
    const QImage picture = program.window->view().grabPicture();
    const double ratio = double(picture.width()) / program.window->view().width();
    for (const int body : {0, 31, 333, 517, 990, 999}) {
        // Each in its own colour.
        const QColor seen = picture.pixelColor((QPointF(placeOf(program, body)) * ratio).toPoint());
        const auto& colour = program.document.scene().objects[std::size_t(body)].surfaces[0].colour;
        QVERIFY2((seen.red() > seen.green()) == (colour.x() > colour.y()), qPrintable(seen.name()));
        QTest::mouseClick(&program.window->view(), Qt::LeftButton, {}, placeOf(program, body));
        QCOMPARE(program.document.selection(), (SurfaceRef{ObjectId(body + 1), 0}));
    }
}

void TestManyBodies::anEditMakesNoRowAnew() {
    TouchedWindow program;
    QVERIFY(program.open(file_));
    QTreeWidget& rows = outlinerOf(program);
    Document& document = program.document;
    int inserted = 0;
    connect(rows.model(), &QAbstractItemModel::rowsInserted, &rows, [&] { ++inserted; });
    document.setVisible(5, false);
    document.setSurfacesVisible(SurfaceRef{9, 0}, false);
    document.setLocked(SurfaceRef{8, 0}, true);
    document.renameObject(7, QStringLiteral("lid"));
    document.renameSurface(SurfaceRef{7, 0}, QStringLiteral("glaze"));
    document.setMaterialValue(SurfaceRef{7, 0}, kMaterialFields[0], 321);
    QCOMPARE(inserted, 0);
    QCOMPARE(rows.topLevelItem(6)->text(0), QStringLiteral("lid"));
    QCOMPARE(rows.topLevelItem(6)->child(0)->text(0), QStringLiteral("glaze"));
    QCOMPARE(rows.topLevelItem(4)->data(1, Qt::AccessibleTextRole).toString(), QStringLiteral("hidden"));
    QCOMPARE(rows.topLevelItem(8)->child(0)->data(1, Qt::AccessibleTextRole).toString(),
             QStringLiteral("hidden"));
    QCOMPARE(rows.topLevelItem(7)->child(0)->data(2, Qt::AccessibleTextRole).toString(),
             QStringLiteral("locked"));
    document.removeObject(3);
    QCOMPARE(rows.topLevelItemCount(), kBodies - 1);
    QCOMPARE(rows.topLevelItem(2)->text(0), QStringLiteral("box 3"));
}

void TestManyBodies::undoGivesTheSameScene() {
    TouchedWindow program;
    QVERIFY(program.open(file_));
    Document& document = program.document;
    const auto bytes = [this](const Scene& scene) {
        const QString name = folder_.filePath(QStringLiteral("bytes.glb"));
        QFile file(name);
        return saveScene(scene, std::filesystem::path(name.toStdU16String())) &&
                       file.open(QIODevice::ReadOnly)
                   ? file.readAll()
                   : QByteArray();
    };
    const Scene before = document.scene();
    QVERIFY(!bytes(before).isEmpty());
    program.command("select-all").trigger();
    document.setMaterialValue(document.selected(), kMaterialFields[0], 321);
    document.setLocked(SurfaceRef{8, 0}, true);
    const Scene after = document.scene();
    for (const SceneObject& object : after.objects)
        QCOMPARE(object.surfaces[0].material.*kMaterialFields[0].value, 321);
    document.history().undo();
    document.history().undo();
    QVERIFY(document.scene() == before);
    QCOMPARE(bytes(document.scene()), bytes(before));
    document.history().redo();
    document.history().redo();
    QCOMPARE(bytes(document.scene()), bytes(after));
}

void TestManyBodies::figures() {
    const int count = qEnvironmentVariableIntValue("TACTUM_BODIES");
    if (count <= 0) return;
    const QString file = writeCrowd(folder_, count);
    TouchedWindow program;
    Document& document = program.document;
    SceneView& view = program.window->view();
    QElapsedTimer clock;
    const auto say = [&](const char* what, double times = 1) {
        qInfo("| %-34s | %8.1f |", what, 1e-6 * double(clock.nsecsElapsed()) / times);
    };
    const auto take = [&](const char* what, int times, const auto& action) {
        clock.start();
        for (int i = 0; i < times; ++i)
            action(i);
        say(what, times);
    };
    const auto picture = [&] { view.grabPicture(); };
    const auto world = [&] {
        const bool felt = waitFor([&] { return program.caughtUp(); });
        if (!felt) qFatal("the World does not come");
    };
    clock.start();
    program.window->open(file);
    if (!waitFor([&] { return !document.opening() && !document.empty(); })) qFatal("does not open");
    say("open");
    picture();
    say("open to the picture");
    world();
    say("open to the World");
    program.frames(20);
    view.showStandardView(StandardView::Front);
    program.frames(20);
    take("a picture while orbiting", 10, [&](int) {
        view.moveCamera(0.02, 0, 1);
        view.grabPicture();
    });
    view.showStandardView(StandardView::Front);
    ProxyTelemetry proxy = program.engine.proxy();
    take("a picture while bodies move", 10, [&](int i) {
        proxy.time += 0.016 * (i + 1);
        view.setHaptics(proxy, program.engine.servo(), 8, true);
        view.grabPicture();
    });
    program.command("select").trigger();
    take("pick (click)", 6,
         [&](int i) { QTest::mouseClick(&view, Qt::LeftButton, {}, placeOf(program, (i * 157) % count)); });
    take("hover", 10, [&](int i) { view.light(placeOf(program, (i * 97) % count)); });
    take("pick beside everything", 3, [&](int) { view.surfaceAt({2, 2}); });
    QTreeWidget& rows = outlinerOf(program);
    take("select one in the outliner", 5,
         [&](int i) { rows.setCurrentItem(rows.topLevelItem(i * 7)->child(0)); });
    take("scroll the outliner", 5, [&](int i) {
        rows.scrollToItem(rows.topLevelItem(i * (count / 5)));
        rows.repaint();
    });
    take("edit of one surface", 5, [&](int i) {
        document.setMaterialValue(SurfaceRef{7, 0}, kMaterialFields[0], 300 + i);
    });
    world();
    take("undo of it", 5, [&](int) { document.history().undo(); });
    take("lock one", 2, [&](int i) { document.setLocked(SurfaceRef{8, 0}, i == 0); });
    take("hide one", 2, [&](int i) { document.setSurfacesVisible(SurfaceRef{8, 0}, i != 0); });
    world();
    take("select all", 1, [&](int) { program.command("select-all").trigger(); });
    take("a picture with all selected", 5, [&](int) {
        view.moveCamera(0.02, 0, 1);
        view.grabPicture();
    });
    take("edit of all", 1,
         [&](int) { document.setMaterialValue(document.selected(), kMaterialFields[0], 321); });
    world();
    take("undo of all", 1, [&](int) { document.history().undo(); });
    take("redo of all", 1, [&](int) { document.history().redo(); });
    world();
    clock.start();
    document.save(std::filesystem::path(folder_.filePath(QStringLiteral("saved.glb")).toStdU16String()));
    say("save (window)");
    if (!waitFor([&] { return !document.modified(); })) qFatal("does not save");
    say("save (worker)");
}

TACTUM_GUI_TEST(TestManyBodies)

} // namespace test_many_bodies

#include "test_many_bodies.moc"
