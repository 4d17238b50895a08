// Writes the pictures of the guide: drives the real window through a first touch.
#include <filesystem>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>
#include <QUndoStack>

#include <cmath>

#include "core/base/process_mark.h"
#include "core/files/journal.h"
#include "tests/ui/window/connected_picture.h"
#include "tests/ui/window/device_pictures.h"
#include "tests/ui/window/felt_pictures.h"
#include "tests/ui/window/layer_pictures.h"
#include "tests/ui/window/moving_picture.h"
#include "tests/ui/window/self_test_pictures.h"
#include "tests/ui/window/study_pictures.h"
#include "tests/ui/window/troubled_hand.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/preferences.h"
#include "ui/base/style.h"
#include "ui/document/journal.h"
#include "ui/document/preset_store.h"
#include "ui/document/recent_files.h"
#include "ui/document/recent_pictures.h"
#include "ui/panels/outliner.h"
#include "ui/panels/sample_gallery.h"
#include "ui/showing/recording_saver.h"
#include "ui/showing/video_recorder.h"
#include "ui/view/scene_view.h"

using namespace tactum;

namespace {

constexpr int kUntilSharp = 120; // frames: a flight of the camera, what is baked, and the best picture

QSize sizeOf(const QString& text) {
    const QStringList parts = text.split(u'x');
    return parts.size() == 2 ? QSize(parts[0].toInt(), parts[1].toInt()) : QSize(1440, 900);
}

void save(TouchedWindow& program, const QDir& folder, const QString& name) {
    const QString file = folder.filePath(name);
    if (!program.window->grab().save(file)) qFatal("%s cannot be written", qPrintable(file));
    qInfo("%s", qPrintable(file));
}

void strokeTo(TouchedWindow& program, QPoint& at, QPoint to, int steps, int framesEach = 2) {
    const QPointF from = at;
    for (int i = 1; i <= steps; ++i) {
        at = (from + (QPointF(to) - from) * i / steps).toPoint();
        program.moveTo(at);
        program.frames(framesEach);
    }
}

/// Presses into the belly of the teapot, deep enough to see finger and proxy apart, and strokes it until
/// static friction is about to give way, and then beyond.
void takeFirstTouch(TouchedWindow& program, const QDir& folder) {
    program.type(QStringLiteral("stiffness"), QStringLiteral("350"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.6"));
    program.type(QStringLiteral("dynamic-friction"), QStringLiteral("0.4"));
    program.type(QStringLiteral("proxy-radius"), QStringLiteral("2"));
    program.wheel(program.centre() + QPoint(60, -10), 5);
    QPoint at = program.centre() + QPoint(92, -12);
    program.press(at);
    program.frames(60);
    program.wheel(at, 5);
    program.frames(90);
    strokeTo(program, at, at + QPoint(-100, 40), 50);
    program.frames(60);
    strokeTo(program, at, at + QPoint(-30, 12), 15);
    save(program, folder, QStringLiteral("first-touch.png"));
    program.release(at);
}

/// Presses into the body beside its middle and strokes it to the left; where the mouse is then.
QPoint pressAndStroke(TouchedWindow& program) {
    QPoint at = program.centre() + QPoint(70, 20);
    program.press(at);
    program.frames(60);
    program.wheel(at, 5);
    program.frames(60);
    strokeTo(program, at, at + QPoint(-60, 10), 20);
    return at;
}

/// A viscous surface lets go slowly: the picture is taken while the proxy slides.
void takeSlip(TouchedWindow& program, const QDir& folder) {
    program.type(QStringLiteral("viscosity"), QStringLiteral("12"));
    QPoint at = pressAndStroke(program);
    for (int i = 0; i < 80 && !program.touch().contact[0].slipping; ++i)
        strokeTo(program, at, at + QPoint(-2, 0), 1, 1);
    save(program, folder, QStringLiteral("friction-slip.png"));
    program.release(at);
}

/// A stroke with the Health dock in front.
void takeHealth(TouchedWindow& program, const QDir& folder, const QString& name) {
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-health"))->raise();
    const QPoint at = pressAndStroke(program);
    save(program, folder, name);
    program.release(at);
}

/// The device is lost, and the window says so.
void takeFault(TouchedWindow& program, Trouble& trouble, const QDir& folder, const QString& name) {
    trouble.nonsense = true;
    program.frames(30);
    save(program, folder, name);
    trouble.nonsense = false;
    program.frames(10);
    program.window->findChild<QPushButton*>(QStringLiteral("arm-again"))->click();
    program.frames(120); // the recording of the fault has been saved, and the window says where
    program.window->findChild<QWidget*>(QStringLiteral("notice"))->hide();
}

/// A stroke over the body as it was, and half as stiff.
void takeCompare(TouchedWindow& program, const QDir& folder, const QString& name) {
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-compare"))->raise();
    program.type(QStringLiteral("stiffness"), QStringLiteral("400"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.6"));
    program.window->findChild<QPushButton*>(QStringLiteral("compare-record"))->click();
    program.release(pressAndStroke(program));
    program.window->findChild<QPushButton*>(QStringLiteral("compare-record"))->click();
    program.window->findChild<QPushButton*>(QStringLiteral("compare-mark"))->click();
    program.type(QStringLiteral("stiffness"), QStringLiteral("200"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.2"));
    program.frames(60);
    save(program, folder, name);
}

void takePalette(TouchedWindow& program, const QDir& folder, const QString& name) {
    program.window->findChild<QAbstractButton*>(QStringLiteral("palette-button"))->click();
    program.frames(10);
    auto* palette = program.window->findChild<QWidget*>(QStringLiteral("palette"));
    QTest::keyClicks(palette->findChild<QWidget*>(QStringLiteral("palette-line")), QStringLiteral("se"));
    program.frames(10);
    // The list is a window of its own.
    QPixmap picture = program.window->grab();
    QPainter(&picture).drawPixmap(program.window->mapFromGlobal(palette->pos()), palette->grab());
    if (!picture.save(folder.filePath(name))) qFatal("%s cannot be written", qPrintable(name));
    palette->close();
    program.frames(10);
}

/// What a run that died has left is offered above the view.
void leaveJournal(const Scene& scene) {
    ProcessMark dead = ownMark();
    dead.began = 1;
    const auto folder = Journal::home() / (nameOf(dead) + "_0");
    const JournalEntry entry{.file = "/home/someone/models/vase.glb",
                             .title = "vase.glb",
                             .edited = QDateTime(QDate::currentDate(), QTime(14, 32)).toSecsSinceEpoch()};
    if (!writeJournal(folder, entry, scene)) qFatal("the journal cannot be written");
}

/// Friction painted onto the teapot by hand, and the ring of the brush.
void takePainting(const QDir& folder, const QString& sample, QSize size) {
    TouchedWindow program(size);
    if (!program.open(sample)) qFatal("%s cannot be opened", qPrintable(sample));
    program.command("paint-static-friction").trigger();
    const auto paint = [&](QPoint from, std::initializer_list<QPoint> way) {
        QPoint at = program.centre() + from;
        program.press(at);
        for (const QPoint to : way)
            strokeTo(program, at, program.centre() + to, 10, 1);
        program.release(at);
        program.frames(10);
    };
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.4"));
    program.wheel(program.centre() + QPoint(0, 20), 6);
    paint({-140, 40}, {{-90, 90}, {-40, 30}, {10, 90}, {60, 30}, {110, 90}});
    paint({-70, 120}, {{80, 120}});
    program.moveTo(program.centre() + QPoint(60, 0));
    program.frames(20);
    save(program, folder, QStringLiteral("painting.png"));
}

/// The body of the teapot gets a preset, and the library says where its numbers are from.
void takePresets(TouchedWindow& program, const QDir& folder) {
    auto* dock = program.window->findChild<QDockWidget*>(QStringLiteral("dock-presets"));
    auto* store = program.window->findChild<PresetStore*>();
    dock->raise();
    if (!test::waitFor([&] { return !store->loading() && !store->presets().empty(); }))
        qFatal("the presets do not come");
    auto* list = dock->findChild<QListWidget*>(QStringLiteral("preset-list"));
    QListWidgetItem* row = list->findItems(QStringLiteral("Brick"), Qt::MatchExactly).value(0);
    if (!row) qFatal("there is no brick");
    list->setCurrentItem(row);
    list->scrollToItem(row, QAbstractItemView::PositionAtCenter);
    program.document.select(program.window->view().surfaceAt(program.centre()));
    program.command("preset-apply").trigger();
    program.frames(60);
    save(program, folder, QStringLiteral("presets.png"));
    program.document.history().undo();
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-problems"))->raise();
}

/// A ball about the origin, a few patches of which are missing.
QString writeBall(const QTemporaryDir& folder) {
    constexpr int kRows = 24, kColumns = 48;
    QByteArray text;
    const auto add = [&text](double polar, double around) {
        const double r = 0.05 * std::sin(polar);
        for (const double each : {r * std::cos(around), 0.05 * std::cos(polar), r * std::sin(around)})
            text += (text.endsWith('\n') || text.isEmpty() ? "v " : " ") + QByteArray::number(each);
        text += '\n';
    };
    for (int i = 1; i < kRows; ++i)
        for (int j = 0; j < kColumns; ++j)
            add(M_PI * i / kRows, 2 * M_PI * j / kColumns);
    add(0, 0);
    add(M_PI, 0);
    const auto corner = [](int i, int j) {
        constexpr int kTop = (kRows - 1) * kColumns + 1;
        if (i == 0) return QByteArray::number(kTop);
        if (i == kRows) return QByteArray::number(kTop + 1);
        return QByteArray::number((i - 1) * kColumns + j % kColumns + 1);
    };
    const auto face = [&text](const QByteArray& a, const QByteArray& b, const QByteArray& c) {
        text += "f " + a + ' ' + b + ' ' + c + '\n';
    };
    for (int i = 0; i < kRows; ++i)
        for (int j = 0; j < kColumns; ++j) {
            if ((i == 10 || i == 11) && j >= 8 && j < 11) continue;
            if (i > 0) face(corner(i, j), corner(i, j + 1), corner(i + 1, j + 1));
            if (i + 1 < kRows || i == 0) face(corner(i, j), corner(i + 1, j + 1), corner(i + 1, j));
        }
    return writeFile(folder, QStringLiteral("ball.obj"), text);
}

void takeProblems(TouchedWindow& program, const QDir& folder) {
    QTemporaryDir scratch;
    if (!program.open(writeBall(scratch))) qFatal("the ball cannot be opened");
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-problems"))->raise();
    auto* list = program.window->findChild<QTreeWidget*>(QStringLiteral("problems"));
    const auto hole = [list]() -> QTreeWidgetItem* {
        return list->findItems(QStringLiteral("rim"), Qt::MatchContains).value(0);
    };
    if (!test::waitFor([&] { return hole(); })) qFatal("the hole is not found");
    emit list->itemClicked(hole(), 0);
    program.frames(60);
    save(program, folder, QStringLiteral("problems.png"));
}

void takeLightTheme(TouchedWindow& program, const QDir& folder) {
    program.command("theme-light").trigger();
    program.frames(30);
    save(program, folder, QStringLiteral("light-theme.png"));
}

/// As a person finds it who has worked with three scenes before.
void takeStart(const QDir& folder, const QString& scenes, QSize size) {
    QTemporaryDir home; // or the picture would say whose it is
    qputenv("HOME", home.path().toLocal8Bit());
    const QDir models(home.filePath(QStringLiteral("models")));
    {
        TouchedWindow before(size);
        for (const char* name : {"moving/cabinet", "relief-coin", "teapot"}) {
            const QString file = scenes + QString::fromLatin1(name) + QStringLiteral(".glb");
            const QString own = models.filePath(QFileInfo(file).fileName());
            QSignalSpy kept(before.window->findChild<RecentPictures*>(), &RecentPictures::kept);
            if (!models.mkpath(QStringLiteral(".")) || !QFile::copy(file, own) || !before.open(own) ||
                !test::waitFor([&] { return kept.count() > 0; }))
                qFatal("%s has no picture", name);
        }
    }
    TouchedWindow program(size, samplesIn(scenes));
    program.frames(20);
    save(program, folder, QStringLiteral("start-page.png"));
    program.command("keyboard").trigger();
    auto* sheet = program.window->findChild<QDialog*>(QStringLiteral("keyboard-sheet"));
    QTest::qWait(200);
    if (!sheet->grab().save(folder.filePath(QStringLiteral("key-sheet.png"))))
        qFatal("no picture of the keys");
    forgetRecentFiles();
}

void takeGuide(const QDir& folder, const QString& sample, QSize size) {
    const auto trouble = std::make_shared<Trouble>();
    const auto around = [&](auto hand) { return std::make_unique<TroubledHand>(std::move(hand), trouble); };
    TouchedWindow program(size, samplesIn(QStringLiteral(TACTUM_RESOURCES "/scenes")), around);
    if (!program.open(sample)) qFatal("%s cannot be opened", qPrintable(sample));
    save(program, folder, QStringLiteral("opened.png"));
    takeFault(program, *trouble, folder, QStringLiteral("fault.png"));
    takeFirstTouch(program, folder);
    takeSlip(program, folder);
    takeHealth(program, folder, QStringLiteral("health.png"));
    takeCompare(program, folder, QStringLiteral("compare.png"));
    takePalette(program, folder, QStringLiteral("palette.png"));
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-plot"))->raise();
    takeLightTheme(program, folder);
    takeCompare(program, folder, QStringLiteral("compare-light.png"));
    leaveJournal(program.document.scene());
    TouchedWindow again(size, samplesIn(QStringLiteral(TACTUM_RESOURCES "/scenes")));
    again.frames(60);
    save(again, folder, QStringLiteral("recovery.png"));
    std::error_code ignored;
    std::filesystem::remove_all(Journal::home(), ignored); // the pictures after this one need no such line
}

} // namespace

/// The library of presets and the list of problems, in a window of their own.
void takeTasks(const QDir& folder, const QString& sample, QSize size) {
    TouchedWindow program(size);
    if (!program.open(sample)) qFatal("%s cannot be opened", qPrintable(sample));
    takePresets(program, folder);
    takeProblems(program, folder);
}

/// A joint with its handles on the model, and a world that moves.
void takeBodies(const QDir& folder, const QString& scenes, QSize size) {
    TouchedWindow program(size);
    if (!program.open(scenes + QStringLiteral("moving/kettle.glb"))) qFatal("no kettle");
    program.document.select(SurfaceRef{program.document.scene().objects[2].id, 0});
    auto* dock = program.window->findChild<QDockWidget*>(QStringLiteral("dock-body"));
    dock->raise();
    program.command("motion-run").setChecked(false); // and the picture comes to rest, too
    program.frames(kUntilSharp);
    save(program, folder, QStringLiteral("body.png"));
    program.command("arrange").trigger();
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-place"))->raise();
    program.frames(30);
    save(program, folder, QStringLiteral("arranging.png"));
    program.command("touch").trigger();
    if (!program.open(scenes + QStringLiteral("moving/marionette.glb"))) qFatal("no marionette");
    QPoint at = program.centre();
    program.press(at);
    strokeTo(program, at, at + QPoint(40, 10), 20);
    program.frames(20);
    save(program, folder, QStringLiteral("marionette.png"));
    program.release(at);
}

/// A scene of several models, some of them selected.
void takeMany(const QDir& folder, const QString& scenes, QSize size) {
    TouchedWindow program(size);
    program.command("new-ground").trigger();
    for (const char* id : {"add-cylinder", "add-sphere", "add-box"})
        program.command(id).trigger();
    program.document.add({{(scenes + QStringLiteral("teapot.glb")).toStdString(), {}},
                          {(scenes + QStringLiteral("relief-coin.glb")).toStdString(), {}}});
    if (!test::waitFor([&] { return !program.document.opening() && program.caughtUp(); }))
        qFatal("the models do not come");
    program.command("view-isometric").trigger();
    program.frames(kUntilSharp);
    save(program, folder, QStringLiteral("many-models.png"));
    const auto& objects = program.document.scene().objects;
    program.document.selectObjects({objects[1].id, objects[2].id});
    program.command("group").trigger();
    program.window->findChild<Outliner*>()->scrollToTop();
    program.frames(30);
    save(program, folder, QStringLiteral("groups.png"));
}

/// Every scene in which bodies move, after a second and a half, and then with its first joint and as what its
/// bodies meet each other: to look at.
void takeMoving(const QDir& folder, const QString& scenes, QSize size) {
    TouchedWindow program(size);
    const QDir moving(scenes + QStringLiteral("moving"));
    for (const QString& name : moving.entryList({QStringLiteral("*.glb")})) {
        if (!program.open(moving.filePath(name))) qFatal("no %s", qPrintable(name));
        QTest::qWait(1500);
        const QString stem = QFileInfo(name).completeBaseName();
        save(program, folder, stem + QStringLiteral("-runs.png"));
        const Scene& scene = program.document.scene();
        const auto isHeld = [&](const SceneObject& object) {
            return std::ranges::find(scene.mechanics.joints, object.body, &Joint::b) !=
                   scene.mechanics.joints.end();
        };
        auto chosen = std::ranges::find_if(scene.objects, isHeld);
        if (chosen == scene.objects.end()) chosen = scene.objects.begin();
        program.command("motion-run").setChecked(false);
        program.command("motion-reset").trigger();
        program.command("colliders").setChecked(true);
        program.document.select(SurfaceRef{chosen->id, 0});
        program.window->findChild<QDockWidget*>(QStringLiteral("dock-body"))->raise();
        program.frames(10);
        save(program, folder, stem + QStringLiteral("-joint.png"));
        program.command("colliders").setChecked(false);
    }
}

/// Four panes of one touch: pressed in the one from the right.
void takeSplit(const QDir& folder, const QString& sample, QSize size, const QString& name) {
    TouchedWindow program(size);
    if (!program.open(sample)) qFatal("%s cannot be opened", qPrintable(sample));
    program.type(QStringLiteral("stiffness"), QStringLiteral("350"));
    program.command("split-four").trigger();
    program.frames(20);
    const SceneView& view = program.window->view();
    const QPoint at = view.panes()[3].center() + QPoint(-44, 24);
    program.moveTo(at);
    program.press(at);
    program.frames(60);
    program.wheel(at, 5);
    program.frames(60);
    save(program, folder, name);
    program.release(at);
    program.command("split-one").trigger();
}

/// The view of every scene at home, in both themes: whether what is felt can be told apart by looking.
void takeLooks(const QDir& folder, const QString& scenes, QSize size) {
    TouchedWindow program(size);
    const auto save = [&](const QString& name) {
        const QString file = folder.filePath(name);
        if (!program.window->view().grabPicture().save(file))
            qFatal("%s cannot be written", qPrintable(file));
        qInfo("%s", qPrintable(file));
    };
    for (const QString& name : QDir(scenes).entryList({QStringLiteral("*.glb")})) {
        if (!program.open(scenes + name)) qFatal("no %s", qPrintable(name));
        program.document.select(std::nullopt);
        const QString stem = QFileInfo(name).completeBaseName();
        program.frames(20);
        const SceneView& view = program.window->view();
        if (!test::waitFor([&] { return !view.makesFelt() && !view.makesMeshes(); })) qFatal("no light");
        for (const bool dark : {false, true}) {
            program.window->view().setTheme(dark);
            save(stem + QLatin1String(dark ? "-dark.png" : "-light.png"));
        }
    }
}

/// The view alone on the screen while it is touched, and the same stroke as a video and as a recording.
void takeShowing(const QDir& folder, const QString& sample, QSize size) {
    TouchedWindow program(size);
    if (!program.open(sample)) qFatal("%s cannot be opened", qPrintable(sample));
    program.type(QStringLiteral("stiffness"), QStringLiteral("350"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.6"));
    auto* video = program.window->findChild<VideoRecorder*>();
    const auto file = [&](const char* name) { return folder.filePath(QString::fromLatin1(name)); };
    if (!video->begin(file("showing.webm"), {{1280, 720}, true})) qFatal("the video cannot be written");
    program.command("present").setChecked(true);
    program.frames(20);
    const QPoint at = pressAndStroke(program);
    save(program, folder, QStringLiteral("presentation.png"));
    program.release(at);
    program.command("present").setChecked(false);
    video->end();
    QSignalSpy saved(program.window->findChild<RecordingSaver*>(), &RecordingSaver::saved);
    auto* saver = program.window->findChild<RecordingSaver*>();
    saver->save(file("showing.tactum-recording"), saver->take(QStringLiteral("a stroke to show")));
    if (!test::waitFor([&] { return saved.count() > 0; })) qFatal("the recording is not written");
}

// FOLDER [SCENE [WIDTHxHEIGHT
// [start|felt|split|layers|paint|tasks|bodies|many|moving|connected|touch|device|devices|self-test|looks|showing]]]:
// with the last word only the pictures of the start page, of what is felt, of layers, of painting, of presets
// and problems, of what moves, or of a device; `touch`: what join_pictures.py makes a moving picture of;
// `devices`: every page of its dock in both themes, `self-test`: also light and in German; `moving`: every
// scene in which bodies move; `looks`: every scene at home; `split`: the divided view, also light.
int main(int argc, char** argv) {
    prepareProcess();
    QApplication app(argc, argv);
    QTemporaryDir settings;
    useSettingsIn(settings.path()); // what is kept of a fault or a scene as well
    unfoldPlots();
    const QDir folder(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("."));
    const QString sample =
        argc > 2 ? QString::fromLocal8Bit(argv[2]) : QStringLiteral(TACTUM_RESOURCES "/scenes/teapot.obj");
    if (!folder.mkpath(QStringLiteral("."))) qFatal("the folder cannot be made");

    const QSize size = sizeOf(argc > 3 ? QString::fromLocal8Bit(argv[3]) : QString());
    const QByteArray only = argc > 4 ? argv[4] : "";
    if (only == "touch") { // by itself, for join_pictures.py
        takeTouchFrames(folder, sample);
        return 0;
    }
    const QString scenes = QStringLiteral(TACTUM_RESOURCES "/scenes/");
    const auto wanted = [&](const char* what) { return only.isEmpty() || only == what; };
    if (wanted("start")) takeStart(folder, scenes, size);
    if (only == "start") return 0;
    if (only.isEmpty()) takeGuide(folder, sample, size);
    applyTheme(ThemeChoice::Dark);
    if (wanted("tasks")) takeTasks(folder, sample, size);
    if (wanted("device") || only == "devices") takeDevicePictures(folder, sample, size, only == "devices");
    applyTheme(ThemeChoice::Dark);
    if (only == "devices" || only == "device") return 0;
    if (wanted("self-test")) takeSelfTestPictures(folder, only == "self-test");
    applyTheme(ThemeChoice::Dark);
    if (only == "self-test") return 0;
    if (wanted("paint")) takePainting(folder, sample, size);
    if (only == "looks") {
        takeLooks(folder, scenes, size);
        return 0;
    }
    if (wanted("connected")) takeConnectedPicture(folder, scenes, size);
    if (only == "connected") return 0;
    if (wanted("study")) takeStudyPictures(folder, sample, size);
    if (only == "study") return 0;
    if (wanted("showing")) takeShowing(folder, sample, size);
    if (only == "showing") return 0;
    if (wanted("bodies")) takeBodies(folder, scenes, size);
    if (wanted("many")) takeMany(folder, scenes, size);
    if (only == "many") return 0;
    if (only == "moving") takeMoving(folder, scenes, size);
    if (only == "bodies" || only == "moving") return 0;
    if (wanted("split")) takeSplit(folder, sample, size, QStringLiteral("split.png"));
    if (only == "split") {
        Preferences::instance().set(Preferred::Theme, double(ThemeChoice::Light));
        takeSplit(folder, sample, size, QStringLiteral("split-light.png"));
        return 0;
    }
    TouchedWindow program(size);
    if (wanted("felt")) takeFeltPictures(program, folder, scenes);
    if (wanted("layers")) takeLayerPictures(program, folder, scenes);
    return 0;
}
