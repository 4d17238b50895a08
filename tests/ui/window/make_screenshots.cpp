// Writes the pictures of the guide: drives the real window through a first touch.
#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QDateTime>
#include <QDir>
#include <QDockWidget>
#include <QPainter>
#include <QPushButton>
#include <QTest>

#include "core/base/process_mark.h"
#include "core/files/journal.h"
#include "tests/ui/window/felt_pictures.h"
#include "tests/ui/window/layer_pictures.h"
#include "tests/ui/window/troubled_hand.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/journal.h"
#include "ui/panels/sample_gallery.h"
#include "ui/style.h"
#include "ui/view/scene_view.h"

using namespace tactum;

namespace {

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

void takeLightTheme(TouchedWindow& program, const QDir& folder) {
    for (QAction* action : program.window->findChildren<QAction*>())
        if (action->text() == QLatin1String("&Light")) action->trigger();
    program.frames(30);
    save(program, folder, QStringLiteral("light-theme.png"));
}

void takeGuide(const QDir& folder, const QString& sample, QSize size) {
    const auto trouble = std::make_shared<Trouble>();
    const auto around = [&](auto hand) { return std::make_unique<TroubledHand>(std::move(hand), trouble); };
    TouchedWindow program(size, samplesIn(QStringLiteral(TACTUM_RESOURCES "/scenes")), around);
    program.frames(20);
    save(program, folder, QStringLiteral("start-page.png"));
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
}

} // namespace

// FOLDER [SCENE [WIDTHxHEIGHT [felt|layers]]]: with the last word only the pictures of what is felt, or of
// layers.
int main(int argc, char** argv) {
    prepareProcess();
    QApplication app(argc, argv);
    QTemporaryDir settings;
    useSettingsIn(settings.path()); // what is kept of a fault or a scene as well
    const QDir folder(argc > 1 ? QString::fromLocal8Bit(argv[1]) : QStringLiteral("."));
    const QString sample =
        argc > 2 ? QString::fromLocal8Bit(argv[2]) : QStringLiteral(TACTUM_RESOURCES "/scenes/teapot.obj");
    if (!folder.mkpath(QStringLiteral("."))) qFatal("the folder cannot be made");

    const QSize size = sizeOf(argc > 3 ? QString::fromLocal8Bit(argv[3]) : QString());
    const QByteArray only = argc > 4 ? argv[4] : "";
    if (only.isEmpty()) takeGuide(folder, sample, size);
    applyTheme(ThemeChoice::Dark);
    TouchedWindow program(size);
    const QString scenes = QStringLiteral(TACTUM_RESOURCES "/scenes/");
    if (only != "layers") takeFeltPictures(program, folder, scenes);
    if (only != "felt") takeLayerPictures(program, folder, scenes);
    return 0;
}
