// Recordings in the window: saved on demand and after a fault, opened, scrubbed, played, left again.
#include <QAction>
#include <QActionGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>
#include <QToolButton>
#include <QTreeWidget>

#include "core/recording/recording_file.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/troubled_hand.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/base/shortcuts.h"
#include "ui/showing/playback.h"
#include "ui/showing/playback_bar.h"
#include "ui/showing/recording_saver.h"
#include "ui/view/scene_view.h"

namespace test_playback {

using namespace tactum;

class TestPlayback : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    QString recording_;

    static Playback& playbackOf(TouchedWindow& program) { return *program.window->findChild<Playback*>(); }
    static PlaybackBar& barOf(TouchedWindow& program) { return *program.window->findChild<PlaybackBar*>(); }
    static QString textOf(TouchedWindow& program, const char* name) {
        return program.window->findChild<QLabel*>(QString::fromLatin1(name))->text();
    }
    /// The window's own saver, without the dialog.
    static bool save(TouchedWindow& program, const QString& file) {
        auto* saver = program.window->findChild<RecordingSaver*>();
        QSignalSpy saved(saver, &RecordingSaver::saved);
        saver->save(file, saver->take(QStringLiteral("a test wanted it")));
        return test::waitFor([&] { return saved.count() > 0; }) && QFile::exists(file);
    }
    /// What a late machine did on the way has been saved.
    static void noFaultWaits(TouchedWindow& program) {
        program.window->findChild<RecordingSaver*>()->flush();
        QThreadPool::globalInstance()->waitForDone();
        program.frames(2);
    }
    static bool opened(TouchedWindow& program, const QString& file) {
        program.window->open(file);
        return test::waitFor([&] { return playbackOf(program).active(); });
    }

private slots:
    static void initMain() { prepareProcess(); }
    void init() {
        useSettingsIn(folder_.path());
        unfoldPlots();
    }
    void initTestCase();

    void itIsShownInsteadOfTheLiveScene();
    void itsBarMovesNothing();
    void scrubbingGoesThere();
    void playingGoesOnAtItsSpeed();
    void healthIsTheRecordings();
    void historyAndHandAreLeftAlone();
    void aFaultIsSavedByItself();
    void aDeviceThatHangsIsSavedBeforeItGoes();
    void whatWaitsWhenTheWindowClosesIsWritten();
    void aDamagedFileIsOneLine();
    void everyMomentLooksLikeIt();
};

/// A stroke over the cube with an edit in it.
void TestPlayback::initTestCase() {
    useSettingsIn(folder_.path());
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    QVERIFY(program.fullForce());
    program.stroke();
    program.type(QStringLiteral("stiffness"), QStringLiteral("400"));
    program.frames(20);
    program.stroke();
    recording_ = folder_.filePath(QStringLiteral("stroke.tactum-recording"));
    QVERIFY(save(program, recording_));
}

void TestPlayback::itIsShownInsteadOfTheLiveScene() {
    TouchedWindow program;
    QVERIFY(!barOf(program).isVisible());
    QVERIFY(opened(program, recording_)); // without any model
    program.frames(10);
    QVERIFY(barOf(program).isVisible());
    QVERIFY(program.window->view().isVisible());
    QVERIFY(!program.engine.armed());
    COMPARE_BEGINS(program.window->windowTitle(), QStringLiteral("stroke.tactum-recording"));
    COMPARE_CONTAINS(textOf(program, "status-device"), QStringLiteral("recorded"));
    QTest::mouseClick(program.window->findChild<QPushButton*>(QStringLiteral("playback-back")),
                      Qt::LeftButton);
    program.frames(10);
    QVERIFY(!barOf(program).isVisible());
    QVERIFY(!program.window->view().isVisible()); // the start page again
    COMPARE_LACKS(textOf(program, "status-device"), QStringLiteral("recorded"));
}

void TestPlayback::itsBarMovesNothing() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const QRect before = program.placeOf(program.window->view());
    QVERIFY(opened(program, recording_));
    program.frames(10);
    QCOMPARE(program.placeOf(program.window->view()), before);
    const QRect bar = program.placeOf(barOf(program));
    QVERIFY(before.contains(bar));
    QVERIFY2(bar.height() < before.height() / 4, "it is a bar, not a curtain");
    const QWidget* seen = program.window->childAt(bar.center());
    QVERIFY2(barOf(program).isAncestorOf(seen), "the view hides it");
    QTest::mouseClick(program.window->findChild<QPushButton*>(QStringLiteral("playback-back")),
                      Qt::LeftButton);
    program.frames(10);
    QVERIFY(!barOf(program).isVisible());
    QCOMPARE(program.placeOf(program.window->view()), before);
}

void TestPlayback::scrubbingGoesThere() {
    TouchedWindow program;
    QVERIFY(opened(program, recording_));
    auto* scrubber = program.window->findChild<Scrubber*>();
    const double length =
        playbackOf(program).player().run().end() - playbackOf(program).player().run().begin();
    for (const double part : {0.8, 0.3, 0.6}) {
        const QPoint at(int(part * scrubber->width()), scrubber->height() / 2);
        QTest::mousePress(scrubber, Qt::LeftButton, {}, at - QPoint(9, 0));
        QTest::mouseMove(scrubber, at);
        QTest::mouseRelease(scrubber, Qt::LeftButton, {}, at);
        QTRY_VERIFY(std::abs(playbackOf(program).time() - part * length) < 0.03 * length);
        QCOMPARE(playbackOf(program).player().check().differ, 0u);
        QTRY_VERIFY(textOf(program, "playback-verdict").contains(QStringLiteral("same bits")));
    }
    const double before = playbackOf(program).time();
    program.window->view().setFocus();
    QTest::keyClick(&program.window->view(), Qt::Key_Right);
    COMPARE_NEAR(playbackOf(program).time() - before, 0.01, 1e-9, "");
}

void TestPlayback::playingGoesOnAtItsSpeed() {
    TouchedWindow program;
    QVERIFY(opened(program, recording_));
    auto* speed = program.window->findChild<QComboBox*>(QStringLiteral("playback-speed"));
    speed->setCurrentIndex(speed->count() - 1);
    QTest::keyClick(&program.window->view(), Qt::Key_Down);
    QCOMPARE(speed->currentIndex(), speed->count() - 2);
    QTest::keyClick(&program.window->view(), Qt::Key_Up);
    QCOMPARE(speed->currentIndex(), speed->count() - 1);
    QTest::keyClick(&program.window->view(), Qt::Key_Space);
    QVERIFY(playbackOf(program).playing());
    QVERIFY(test::waitFor([&] { return !playbackOf(program).playing(); })); // to the end
    Player& player = playbackOf(program).player();
    QVERIFY(player.atEnd());
    QCOMPARE(player.check().proxySteps, player.run().proxy.rows.size());
    QCOMPARE(player.check().servoSteps, player.run().servo.rows.size());
    QVERIFY2(player.check().differ == 0, player.check().first.c_str());
    QTest::mouseClick(program.window->findChild<QToolButton*>(QStringLiteral("playback-play")),
                      Qt::LeftButton);
    QVERIFY(playbackOf(program).playing()); // from the beginning
    QCOMPARE_LT(playbackOf(program).time(), 1);
}

/// Nothing of the live loops: here they have not felt any scene.
void TestPlayback::healthIsTheRecordings() {
    TouchedWindow program;
    auto* override = program.window->findChild<QCheckBox*>(QStringLiteral("health-override"));
    const auto* events = program.window->findChild<QTreeWidget*>(QStringLiteral("health-events"));
    program.command("panels").trigger(); // the start page hides them
    auto* dock = program.window->findChild<QDockWidget*>(QStringLiteral("dock-health"));
    QTRY_VERIFY(dock->isVisible());
    dock->raise();
    QTRY_COMPARE(textOf(program, "health-stiffest"), QStringLiteral("nothing yet"));
    QVERIFY(opened(program, recording_));
    Player& player = playbackOf(program).player();
    const double length = player.run().end() - player.run().begin();
    for (const double part : {0.3, 0.95}) {
        playbackOf(program).seek(part * length, true);
        // The panel is drawn anew a few times a second: on a busy machine it may show the moment before.
        QTRY_VERIFY(
            textOf(program, "health-servo").startsWith(QString::number(std::lround(player.servo().rate))));
        QTRY_COMPARE(textOf(program, "health-stiffest"), QStringLiteral("800 N/m"));
        QTRY_VERIFY(textOf(program, "health-late").endsWith(QStringLiteral("so far")));
        QTRY_COMPARE(events->topLevelItemCount(), int(playbackOf(program).eventsSoFar().size()));
    }
    const QString edited = QStringLiteral("the scene was edited");
    QVERIFY(!events->findItems(edited, Qt::MatchContains).isEmpty());
    QVERIFY(!override->isEnabled());
    std::uint64_t ticks = 0, recent = 0, misses = 0;
    for (const std::uint32_t count : player.servo().periods.count)
        ticks += count;
    for (const ServoRow& row : player.run().servo.rows) {
        if (row.time > player.time()) break;
        recent += row.time > player.time() - RecentPeriods::kPeriodWindow;
        misses += (row.flags & ServoRow::Late) != 0;
    }
    QCOMPARE_GE(ticks, recent); // also those that seeking left out
    QCOMPARE(player.servo().misses, misses);
    QTest::mouseClick(program.window->findChild<QPushButton*>(QStringLiteral("playback-back")),
                      Qt::LeftButton);
    QTRY_COMPARE(textOf(program, "health-stiffest"), QStringLiteral("nothing yet"));
    QTRY_VERIFY(textOf(program, "health-late").contains(QStringLiteral("machine")));
    QVERIFY(events->findItems(edited, Qt::MatchContains).isEmpty() && override->isEnabled());
}

void TestPlayback::historyAndHandAreLeftAlone() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    program.type(QStringLiteral("stiffness"), QStringLiteral("500"));
    program.document.select(SurfaceRef{program.document.scene().objects.front().id, 2});
    program.command("copy-feel").trigger();
    const int steps = program.document.history().count();
    const Scene scene = program.document.scene();
    QVERIFY(opened(program, recording_));
    // The choices among several, as what a click selects, stay on: they change nothing by themselves.
    for (const Command& command : commands()) {
        const QAction& action = program.command(command.id);
        const bool choice = action.actionGroup() && action.actionGroup()->isExclusive();
        QVERIFY2(!isLive(command) || choice || !action.isEnabled(), command.id);
    }
    QTest::keyClick(program.window.get(), Qt::Key_L);
    QTest::keyClick(program.window.get(), Qt::Key_V, Qt::ControlModifier);
    QTest::keyClick(program.window.get(), Qt::Key_G, Qt::ControlModifier);
    const Vec3 hand = program.finger();
    program.stroke();
    QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
    program.frames(10);
    COMPARE_NEAR(program.finger(), hand, 1e-3, "m");
    QCOMPARE(program.document.history().count(), steps);
    QVERIFY(program.document.scene() == scene);
    QTest::mouseClick(program.window->findChild<QPushButton*>(QStringLiteral("playback-back")),
                      Qt::LeftButton);
    QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(!(program.document.scene() == scene)); // live again
    COMPARE_BEGINS(program.window->windowTitle(),
                   QStringLiteral("cube.obj[*]")); // where what is unsaved is marked
    QCOMPARE(program.window->isWindowModified(), program.document.modified());
}

void TestPlayback::aFaultIsSavedByItself() {
    QDir(RecordingSaver::folder()).removeRecursively();
    const auto trouble = std::make_shared<Trouble>();
    TouchedWindow program(
        {1200, 800}, {}, [&](auto hand) { return std::make_unique<TroubledHand>(std::move(hand), trouble); });
    QVERIFY(program.open(writeCube(folder_)));
    auto* saver = program.window->findChild<RecordingSaver*>();
    QVERIFY(program.fullForce()); // no fault without force
    noFaultWaits(program);
    QSignalSpy saved(saver, &RecordingSaver::saved);
    const std::uint64_t faults = program.engine.servo().faults;
    trouble->nonsense = true;
    QTRY_VERIFY_WITH_TIMEOUT(program.engine.servo().faults > faults, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(saved.count() > 0, kPatience);
    QVERIFY(saved.front().at(1).toBool());
    QVERIFY(opened(program, saved.front().at(0).toString()));
    const auto events = eventsOf(playbackOf(program).player().run());
    QVERIFY(std::ranges::any_of(events, &RecordedEvent::fault));
}

void TestPlayback::aDeviceThatHangsIsSavedBeforeItGoes() {
    QDir(RecordingSaver::folder()).removeRecursively();
    const auto trouble = std::make_shared<Trouble>();
    TouchedWindow program(
        {1200, 800}, {}, [&](auto hand) { return std::make_unique<TroubledHand>(std::move(hand), trouble); });
    QVERIFY(program.open(writeCube(folder_)));
    auto* saver = program.window->findChild<RecordingSaver*>();
    QVERIFY(program.fullForce());
    noFaultWaits(program);
    QSignalSpy saved(saver, &RecordingSaver::saved);
    saver->flush(); // all is well
    trouble->hangs = true;
    QTRY_VERIFY_WITH_TIMEOUT(program.engine.servoStandsStill(), kPatience);
    QCOMPARE(saved.count(), 0);
    saver->flush();
    QTRY_VERIFY_WITH_TIMEOUT(saved.count() > 0, kPatience);
    trouble->hangs = false;
    QVERIFY(saved.front().at(1).toBool() && QFileInfo::exists(saved.front().at(0).toString()));
}

void TestPlayback::whatWaitsWhenTheWindowClosesIsWritten() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(folder_)));
    const QStringList files{folder_.filePath(QStringLiteral("first.tactum-recording")),
                            folder_.filePath(QStringLiteral("second.tactum-recording"))};
    {
        RecordingSaver saver(program.engine, program.document);
        const RecordingSaver::Taken recording = saver.take(QStringLiteral("wanted"));
        QVERIFY(recording);
        for (const QString& file : files)
            saver.save(file, recording);
    }
    QThreadPool::globalInstance()->waitForDone();
    for (const QString& file : files)
        QVERIFY2(QFileInfo::exists(file), qPrintable(file));
    QVERIFY(opened(program, files.back()));
}

void TestPlayback::aDamagedFileIsOneLine() {
    TouchedWindow program;
    program.window->open(writeFile(folder_, QStringLiteral("torn.tactum-recording"), "TACTUMRC torn"));
    const auto* notice = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    QTRY_VERIFY_WITH_TIMEOUT(notice->text().contains(QStringLiteral("torn.tactum-recording")), kPatience);
    QVERIFY(!notice->text().contains(u'\n'));
    QVERIFY(!playbackOf(program).active());
}

/// Where the file is looked at by a person: TACTUM_PICTURES=folder.
void TestPlayback::everyMomentLooksLikeIt() {
    const QString folder = qEnvironmentVariable("TACTUM_PICTURES");
    TouchedWindow program({1440, 900});
    QVERIFY(opened(program, recording_));
    const Player& player = playbackOf(program).player();
    const auto deepest = std::ranges::max_element(
        player.run().servo.rows, {}, [](const ServoRow& row) { return vectorOf(row.force).norm(); });
    const double time = deepest->time - player.run().begin();
    playbackOf(program).seek(time, true);
    program.frames(20);
    COMPARE_NEAR(player.servo().force.norm(), vectorOf(deepest->force).norm(), 0.2, "N");
    QCOMPARE_GT(player.proxy().output.contacts, 0);
    if (!folder.isEmpty()) program.window->grab().save(folder + QStringLiteral("/playback.png"));
}

TACTUM_GUI_TEST(TestPlayback)

} // namespace test_playback

#include "test_playback.moc"
