// A scene shown to others: a video of the view, the view alone on the screen, and a recording as a video.
#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenuBar>
#include <QProcess>
#include <QSignalSpy>
#include <QStatusBar>
#include <QTest>

#include "core/recording/recording_file.h"
#include "tests/core/video/seen_video.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/file_dialogs.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/showing/recording_saver.h"
#include "ui/showing/recording_video.h"
#include "ui/showing/video_recorder.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace test_showing {

using namespace tactum;
using namespace tactum::test;

class TestShowing : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    static VideoRecorder& videoOf(TouchedWindow& program) {
        return *program.window->findChild<VideoRecorder*>();
    }
    QString file(const char* name) const { return folder_.filePath(QString::fromLatin1(name)); }
    void begin(TouchedWindow& program, const QString& name) {
        answerFileDialog(name);
        program.command("record-video").trigger();
    }
    /// Chosen again, and the file is complete.
    static bool end(TouchedWindow& program) {
        QSignalSpy ended(&videoOf(program), &VideoRecorder::ended);
        program.command("record-video").trigger();
        return waitFor([&] { return ended.count() > 0; });
    }

    /// Where the docks are, and which of them are seen.
    static QStringList layoutOf(const MainWindow& window) {
        QStringList places;
        for (const auto* dock : window.findChildren<QDockWidget*>()) {
            const QRect at = dock->visibleRegion().isEmpty() ? QRect() : dock->geometry();
            places << QStringLiteral("%1 %2,%3 %4x%5")
                          .arg(dock->objectName())
                          .arg(at.x())
                          .arg(at.y())
                          .arg(at.width())
                          .arg(at.height());
        }
        places.sort();
        return places;
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        unfoldPlots();
    }

    void theViewBecomesAVideo();
    void theBadgeIsNotInIt();
    void thePlotIsBeneathInAFixedSize();
    void aVideoThatCannotBeWrittenIsOneLine();
    void whoClosesTheWindowKeepsTheVideo();
    void aRecordingBecomesAVideo();
    void aCancelledVideoIsComplete();
    void thePresentationLeavesTheViewAlone();
    void oneTapLeavesThePresentationWithTheFingerPressed();
    void thePresentationComesBackToHiddenPanels();
    void aReportIsWritten();
};

void TestShowing::theViewBecomesAVideo() {
    if (!otherPlayerIsHere()) QSKIP(kNoOtherPlayer);
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.fullForce());
    const QString name = file("view.webm");
    begin(program, name);
    QVERIFY(videoOf(program).recording());
    QVERIFY(program.command("record-video").isChecked());
    program.stroke();
    QVERIFY(program.atRest());
    program.frames(30);
    const QImage last = program.window->view().grabPicture();
    QVERIFY(end(program));
    QVERIFY(!program.command("record-video").isChecked());

    const SeenVideo found = seen(name);
    QCOMPARE(found.codec, QByteArray("vp8"));
    const QSize view = program.window->view().size();
    QCOMPARE(found.width, view.width() / 2 * 2);
    QCOMPARE(found.height, view.height() / 2 * 2);
    QCOMPARE_GT(found.times.size(), std::size_t(10));
    for (std::size_t i = 1; i < found.times.size(); ++i)
        QCOMPARE_GT(found.times[i], found.times[i - 1]);
    QCOMPARE_LE(found.times.back(), found.duration);
    // What is seen at the end: at rest the edges are smoother than in what moves.
    const auto pictures = decoded(name, found.width, found.height);
    QCOMPARE(pictures.size(), found.times.size());
    const QImage shown = last.copy(0, 0, found.width, found.height).convertToFormat(QImage::Format_RGB32);
    const auto* pixels = reinterpret_cast<const std::uint32_t*>(shown.constBits());
    const std::vector<std::uint32_t> expected(pixels, pixels + found.width * found.height);
    QCOMPARE_LT(difference(pictures.back(), expected, found.width), 2.0);
}

void TestShowing::theBadgeIsNotInIt() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* badge = program.window->findChild<QLabel*>(QStringLiteral("video-badge"));
    QVERIFY(!badge->isVisible());
    const QImage before = program.window->view().grabPicture();
    begin(program, file("badge.webm"));
    QVERIFY(waitFor([&] { return badge->isVisible(); }));
    COMPARE_CONTAINS(badge->text(), QStringLiteral("0:0"));
    QVERIFY(program.window->view().rect().contains(badge->geometry()));
    QImage taken;
    QVERIFY(end(program));
    QVERIFY(!badge->isVisible());
    program.window->view().takeNextPicture([&](const QImage& picture) { taken = picture; });
    badge->show();
    program.window->view().update();
    QVERIFY(waitFor([&] { return !taken.isNull(); }));
    const QRect place = badge->geometry();
    QCOMPARE(taken.copy(place).pixel(4, 4), before.copy(place).pixel(4, 4));
}

void TestShowing::thePlotIsBeneathInAFixedSize() {
    if (!otherPlayerIsHere()) QSKIP(kNoOtherPlayer);
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.command("video-720").trigger();
    program.command("video-plot").setChecked(true);
    const QString name = file("plot.webm");
    begin(program, name);
    program.stroke();
    QVERIFY(end(program));
    const SeenVideo found = seen(name);
    QCOMPARE(QSize(found.width, found.height), QSize(1280, 720));
    const auto pictures = decoded(name, 1280, 720);
    QVERIFY(!pictures.empty());
    // The plot's ground is flat, and the curve on it is in the colour of the force.
    const QColor ground = QColor::fromRgb(pictures.back()[std::size_t(719 * 1280 + 640)]);
    COMPARE_NEAR(ground.lightness(), kDarkTheme.panel.lightness(), 6, "");
    int orange = 0;
    for (std::size_t i = std::size_t(1280 * 540); i < pictures.back().size(); ++i) {
        const QColor pixel = QColor::fromRgb(pictures.back()[i]);
        orange += pixel.red() > 150 && pixel.blue() < 110;
    }
    QCOMPARE_GT(orange, 50);
}

void TestShowing::aVideoThatCannotBeWrittenIsOneLine() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    begin(program, file("no-folder/a.webm"));
    QVERIFY(!videoOf(program).recording());
    QVERIFY(!program.command("record-video").isChecked());
    auto* notice = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    COMPARE_CONTAINS(notice->text(), QStringLiteral("a.webm: cannot be written"));
}

void TestShowing::whoClosesTheWindowKeepsTheVideo() {
    if (!otherPlayerIsHere()) QSKIP(kNoOtherPlayer);
    const QString name = file("closed.webm");
    {
        TouchedWindow program;
        QVERIFY(program.open(writeCube(folder_)));
        begin(program, name);
        program.stroke();
    }
    QCOMPARE_GT(seen(name).duration, 0.1);
}

/// Frame by frame at its own times: as many pictures as it has thirtieths of a second.
void TestShowing::aRecordingBecomesAVideo() {
    if (!otherPlayerIsHere()) QSKIP(kNoOtherPlayer);
    const auto recording = readRecording(TACTUM_REPLAYS "/few-bumps.tactum-recording");
    VERIFY_RESULT(recording);
    auto player = Player::open(std::make_shared<const RecordedRun>(recording->run));
    VERIFY_RESULT(player);
    const double length = recording->run.end() - recording->run.begin();
    const QString name = file("played.webm");
    const auto written = writeRecordingVideo(std::move(*player), {name.toStdString(), 360, true});
    VERIFY_RESULT(written);
    COMPARE_NEAR(*written, length, 1e-9, "s");
    const SeenVideo found = seen(name);
    QCOMPARE(QSize(found.width, found.height), QSize(640, 360));
    COMPARE_NEAR(found.duration, length, 1e-3, "s");
    QCOMPARE(found.times.size(), std::size_t(length * kVideoRate) + 1);
    for (std::size_t i = 0; i < found.times.size(); ++i)
        COMPARE_NEAR(found.times[i], double(i) * kVideoPeriod, 6e-4, "s");
}

void TestShowing::aCancelledVideoIsComplete() {
    if (!otherPlayerIsHere()) QSKIP(kNoOtherPlayer);
    const auto recording = readRecording(TACTUM_REPLAYS "/few-bumps.tactum-recording");
    auto player = Player::open(std::make_shared<const RecordedRun>(recording->run));
    VERIFY_RESULT(player);
    std::atomic<bool> cancelled = false;
    int reports = 0;
    const Progress progress{[&](double) { cancelled = ++reports == 3; }, &cancelled};
    const QString name = file("cancelled.gif");
    const auto written = writeRecordingVideo(std::move(*player), {name.toStdString(), 180, false}, progress);
    VERIFY_RESULT(written);
    COMPARE_NEAR(seen(name).duration, *written, 0.02, "s");
    QCOMPARE_LT(*written, 0.2);
}

void TestShowing::thePresentationLeavesTheViewAlone() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    MainWindow& window = *program.window;
    SceneView& view = window.view();
    const QSize before = view.size();
    const double words = view.font().pointSizeF();
    const QStringList layout = layoutOf(window);
    QTest::keyClick(&view, Qt::Key_F11);
    QVERIFY(waitFor([&] { return window.isFullScreen() && view.size() == window.size(); }));
    QCOMPARE_GT(view.font().pointSizeF(), 1.4 * words);
    QVERIFY(!window.statusBar()->isVisible());
    // Touching works, and so do the keys of commands that are in the menus alone.
    QVERIFY(program.fullForce());
    program.press(program.centre());
    QVERIFY(waitFor([&] { return program.touch().contacts > 0; }));
    program.release(program.centre());
    QTest::keyClick(&view, Qt::Key_A);
    QVERIFY(waitFor([&] { return program.document.selected().size() == 6; }));
    // A pointer that rests is not seen, and comes again when it moves.
    QVERIFY(waitFor([&] { return QApplication::overrideCursor() != nullptr; }));
    program.moveTo(program.centre() + QPoint(7, 7));
    QVERIFY(!QApplication::overrideCursor());
    QTest::keyClick(&view, Qt::Key_Escape);
    QVERIFY(waitFor([&] { return !window.isFullScreen() && view.size() == before; }));
    QVERIFY(!program.command("present").isChecked());
    QCOMPARE(layoutOf(window), layout);
    QCOMPARE(view.font().pointSizeF(), words);
    QVERIFY(window.statusBar()->isVisible());
    QCOMPARE_GT(window.menuBar()->height(), 10);
}

void TestShowing::oneTapLeavesThePresentationWithTheFingerPressed() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QTest::keyClick(&program.window->view(), Qt::Key_F11);
    QVERIFY(waitFor([&] { return program.window->isFullScreen(); }));
    QVERIFY(program.fullForce());
    program.press(program.centre());
    QVERIFY(waitFor([&] { return program.touch().contacts > 0; }));
    QTest::keyClick(&program.window->view(), Qt::Key_Escape);
    QVERIFY(waitFor([&] { return !program.window->isFullScreen(); }));
    QVERIFY(program.atRest());
    QCOMPARE(program.touch().contacts, 0); // it lets go as well
    program.release(program.centre());
}

void TestShowing::thePresentationComesBackToHiddenPanels() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.command("panels").setChecked(true);
    program.command("present").setChecked(true);
    program.command("present").setChecked(false);
    QVERIFY(program.command("panels").isChecked());
    program.command("panels").setChecked(false);
    QVERIFY(program.window->findChild<ForcePlot*>()->isVisible());
}

void TestShowing::aReportIsWritten() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    auto* notice = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    const QString name = file("report.html");
    answerFileDialog(name);
    program.command("export-report").trigger();
    QVERIFY(waitFor([&] { return notice->text().contains(QStringLiteral("report.html")); }));
    QFile report(name);
    QVERIFY2(report.open(QIODevice::ReadOnly), qPrintable(notice->text()));
    const QByteArray page = report.readAll();
    COMPARE_CONTAINS(page, QByteArray::fromStdString(program.engine.device().name));
    COMPARE_CONTAINS(page, "Stiffness ceiling");
    QCOMPARE(page.count("by default"), 6);
    COMPARE_LACKS(page, "not saved as it is here");
    // Its picture is the view's: as wide for its height, and with the model's colour in the middle.
    const QByteArray begin = "data:image/png;base64,";
    const qsizetype at = page.indexOf(begin) + begin.size();
    const QImage inReport =
        QImage::fromData(QByteArray::fromBase64(page.mid(at, page.indexOf('"', at) - at)), "PNG");
    SceneView& view = program.window->view();
    QVERIFY(!inReport.isNull());
    COMPARE_NEAR(double(inReport.width()) / inReport.height(), double(view.width()) / view.height(), 0.01,
                 "width to height");
    QCOMPARE(inReport.pixelColor(inReport.rect().center()),
             view.grabWithoutHandles().scaled(inReport.size()).pixelColor(inReport.rect().center()));

    // That the file is another scene now is told.
    const SurfaceRef surface{program.document.scene().objects[0].id, 0};
    program.document.setMaterialValue(surface, kMaterialFields[0], 123);
    answerFileDialog(file("changed.html"));
    program.command("export-report").trigger();
    QVERIFY(waitFor([&] { return notice->text().contains(QStringLiteral("changed.html")); }));
    QFile changed(file("changed.html"));
    QVERIFY2(changed.open(QIODevice::ReadOnly), qPrintable(notice->text()));
    COMPARE_CONTAINS(changed.readAll(), "not saved as it is here");

    // On paper nothing is stretched, as another reader finds it: as many dots to an inch across as along.
    answerFileDialog(file("report.pdf"));
    program.command("export-report").trigger();
    QVERIFY(waitFor([&] { return notice->text().contains(QStringLiteral("report.pdf")); }));
    QProcess reader;
    reader.start(QStringLiteral("pdfimages"), {QStringLiteral("-list"), file("report.pdf")});
    if (!reader.waitForStarted())
        QSKIP("pdfimages is not installed: nobody else reads the PDF; apt install poppler-utils");
    QVERIFY(reader.waitForFinished());
    const QList<QByteArray> lines = reader.readAllStandardOutput().split('\n');
    const QList<QByteArray> names = lines[0].simplified().split(' ');
    int drawings = 0;
    for (const QByteArray& line : lines) {
        const QList<QByteArray> words = line.simplified().split(' ');
        if (words.size() != names.size() || !words.contains("image")) continue;
        const auto figure = [&](const char* column) { return words[names.indexOf(column)].toDouble(); };
        drawings += figure("width") > 1000;
        COMPARE_NEAR(figure("x-ppi"), figure("y-ppi"), 2, "dots per inch"); // they are whole numbers
    }
    QCOMPARE_GE(drawings, 1); // the forces of a stroke
}

TACTUM_GUI_TEST(TestShowing)

} // namespace test_showing

#include "test_showing.moc"
