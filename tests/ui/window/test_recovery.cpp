// What was edited outlives the program: killed, started again, recovered.
#include <csignal>
#include <filesystem>

#include <QApplication>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

#include "core/base/process_mark.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/journal.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/window/left_journal.h"
#include "tests/ui/window/other_run.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/document/journal.h"
#include "ui/panels/recovery_bar.h"
#include "ui/view/scene_view.h"

namespace test_recovery {

using namespace tactum;
namespace fs = std::filesystem;

namespace {

QPushButton* choice(const TouchedWindow& program, const char* name, int line = 0) {
    return program.window->findChild<QPushButton*>(
        QStringLiteral("%1-%2").arg(QLatin1String(name)).arg(line));
}

const QWidget& bar(const TouchedWindow& program) {
    return *program.window->findChild<RecoveryBar*>();
}

QString noticeOf(const TouchedWindow& program) {
    const auto* label = program.window->findChild<QLabel*>(QStringLiteral("notice-text"));
    return label->isVisible() ? label->text() : QString();
}

} // namespace

class TestRecovery : public QObject {
    Q_OBJECT

public:
    static void initMain() { prepareProcess(); }
    static std::optional<int> instead() { return asOtherRun(); }

private:
    std::unique_ptr<QTemporaryDir> folder_;

    Scene someScene() {
        TouchedWindow program;
        if (!program.open(writeCube(*folder_))) qFatal("the cube cannot be opened");
        return program.document.scene();
    }

private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        useSettingsIn(folder_->path());
    }

    void aKilledProgramLosesNothing();
    void aRunThatGoesOnKeepsItsJournal();
    void theBarMovesNothing();
    void throwingAwayCanBeTakenBackUntilTheEnd();
    void severalAreOfferedAtOnce();
    void itsSentenceIsWholeInASmallWindow();
    void aDamagedJournalIsSaidAndKept();
    void savingAndLeavingEndTheJournal();
    void anEditIsInItAfterTheTimeOrTheCount();
    void theFirstEditIsInItAtOnce();
    void aDragIsInItToo();
    void whatCannotBeWrittenIsSaidOnce();
    void theHistoryOutlivesASave();
    void aStepOfSeveralIsOneStep();
};

void TestRecovery::aKilledProgramLosesNothing() {
    const QString cube = writeCube(*folder_);
    const QByteArray original = read(cube);
    {
        OtherRun run(folder_->path(), cube, 20);
        QVERIFY(run.waitForJournals(1));
        run.kill();
    }
    const QByteArray edited = read(folder_->filePath(QStringLiteral("edited.glb")));
    QVERIFY(!edited.isEmpty());
    TouchedWindow program;
    QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
    const QString text = program.window->findChild<QLabel*>(QStringLiteral("recovery-text-0"))->text();
    COMPARE_BEGINS(text, QStringLiteral("cube.obj was not saved: edited until "));
    QSignalSpy opened(&program.document, &Document::opened);
    choice(program, "recovery-recover")->click();
    QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience);
    const std::string recovered = *glbOf(program.document.scene());
    QVERIFY(QByteArray::fromStdString(recovered) == edited);
    QCOMPARE(program.document.scene().objects[0].surfaces[0].material.stiffness, 118.0);
    // Under the old name, modified, and its file as it was.
    QVERIFY(program.document.modified());
    QVERIFY(program.window->isWindowModified());
    QCOMPARE(QString::fromStdString(program.document.path().string()), cube);
    COMPARE_BEGINS(program.window->windowTitle(), QStringLiteral("cube.obj"));
    QVERIFY(!program.document.hasOwnFile());
    QCOMPARE(read(cube), original);
    QVERIFY(!bar(program).isVisible());
    // With its history: the same steps, and the last undone one can be done again.
    QUndoStack& history = program.document.history();
    QCOMPARE(history.count(), 19);
    QCOMPARE(history.index(), 18);
    QCOMPARE(history.text(17), QStringLiteral("Stiffness of right"));
    QTest::keyClick(program.window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(program.document.scene().objects[0].surfaces[0].material.stiffness, 117.0);
    QTest::keyClick(program.window.get(), Qt::Key_Y, Qt::ControlModifier);
    QTest::keyClick(program.window.get(), Qt::Key_Y, Qt::ControlModifier);
    QCOMPARE(program.document.scene().objects[0].surfaces[0].material.stiffness, 119.0);
    while (history.canUndo())
        history.undo();
    QCOMPARE(program.document.scene().objects[0].surfaces[0].material.stiffness, kStiffness.initial);
    QVERIFY(program.document.modified()); // the file may be another one by now
    // Still in a journal, now this run's, until it is saved.
    QCOMPARE(journals().size(), std::size_t(1));
    QVERIFY(holdsJournal(journals().front()));
    QSignalSpy saved(&program.document, &Document::saved);
    program.document.save(folder_->filePath(QStringLiteral("kept.glb")).toStdString());
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(journals().empty(), kPatience);
}

void TestRecovery::aRunThatGoesOnKeepsItsJournal() {
    OtherRun run(folder_->path(), writeCube(*folder_), 20);
    QVERIFY(run.waitForJournals(1));
    const auto theirs = journals();
    TouchedWindow program;
    program.frames(60);
    QVERIFY(!bar(program).isVisible());
    QVERIFY(program.open(writeCube(*folder_)));
    for (int i = 0; i < 20; ++i)
        setStiffness(program.document, 300 + i);
    QVERIFY(run.waitForJournals(2));
    program.window->journal().discard();
    QTRY_VERIFY_WITH_TIMEOUT(journals() == theirs, kPatience);
}

void TestRecovery::theBarMovesNothing() {
    leaveJournal(someScene(), "lost.obj", 1);
    TouchedWindow program;
    QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
    QVERIFY(program.open(writeCube(*folder_)));
    const SceneView& view = program.window->view();
    const QRect before = program.placeOf(view), covered = program.placeOf(bar(program));
    QCOMPARE(before, program.placeOf(*program.window->centralWidget()));
    QVERIFY(before.contains(covered));
    QVERIFY2(covered.height() < before.height() / 4, "it is one line, not a curtain");
    QVERIFY2(bar(program).isAncestorOf(program.window->childAt(covered.center())), "the view hides it");
    QTest::mouseClick(program.window->findChild<QToolButton*>(QStringLiteral("recovery-later")),
                      Qt::LeftButton);
    program.frames(5);
    QVERIFY(!bar(program).isVisible());
    QCOMPARE(program.placeOf(view), before);
}

void TestRecovery::throwingAwayCanBeTakenBackUntilTheEnd() {
    leaveJournal(someScene(), "cube.obj", 1000);
    {
        TouchedWindow program;
        QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
        choice(program, "recovery-throw")->click();
        QVERIFY(!choice(program, "recovery-recover"));
        choice(program, "recovery-back")->click();
        QVERIFY(choice(program, "recovery-recover"));
    }
    // That run ended with it: its name is this process's, which goes on. As if it had ended as well:
    QCOMPARE(journals().size(), std::size_t(1));
    ProcessMark dead = ownMark();
    dead.began = 7;
    fs::rename(journals().front(), Journal::home() / (nameOf(dead) + "_3"));
    {
        TouchedWindow program;
        QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
        choice(program, "recovery-throw")->click();
        QCOMPARE(journals().size(), std::size_t(1));
    }
    QVERIFY(journals().empty());
}

void TestRecovery::severalAreOfferedAtOnce() {
    const Scene scene = someScene();
    leaveJournal(scene, "older.glb", 1000);
    leaveJournal(scene, "newer.glb", 2000);
    TouchedWindow program;
    QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
    const auto textOf = [&](int line) {
        return program.window->findChild<QLabel*>(QStringLiteral("recovery-text-%1").arg(line))->text();
    };
    COMPARE_BEGINS(textOf(0), QStringLiteral("newer.glb"));
    COMPARE_BEGINS(textOf(1), QStringLiteral("older.glb"));
    QSignalSpy opened(&program.document, &Document::opened);
    choice(program, "recovery-recover", 1)->click();
    QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, kPatience);
    COMPARE_BEGINS(program.window->windowTitle(), QStringLiteral("older.glb"));
    QVERIFY(bar(program).isVisible());
    COMPARE_BEGINS(textOf(0), QStringLiteral("newer.glb"));
    // What was recovered is unsaved: the other one does not take its place without a question.
    choice(program, "recovery-recover")->click();
    auto* question = program.window->findChild<QMessageBox*>(QStringLiteral("unsaved"));
    QVERIFY(question);
    question->button(QMessageBox::Discard)->click();
    QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 2, kPatience);
    QVERIFY(!bar(program).isVisible());
    QTRY_COMPARE_WITH_TIMEOUT(journals().size(), std::size_t(1), kPatience);
    QCOMPARE_EQ(readJournalEntry(journals().front())->title, "newer.glb");
}

void TestRecovery::itsSentenceIsWholeInASmallWindow() {
    leaveJournal(someScene(), "a scene with a name of several words.glb", 1000);
    TouchedWindow program({640, 480});
    QTRY_VERIFY_WITH_TIMEOUT(bar(program).isVisible(), kPatience);
    const auto* text = program.window->findChild<QLabel*>(QStringLiteral("recovery-text-0"));
    QCOMPARE_GT(text->fontMetrics().horizontalAdvance(text->text()), text->width()); // more than a line
    const auto needed = [&] {
        const QRect room(0, 0, text->width(), 1000);
        return text->fontMetrics().boundingRect(room, Qt::TextWordWrap, text->text()).height();
    };
    QVERIFY2(text->wordWrap(), "it goes on in a second line");
    QTRY_VERIFY_WITH_TIMEOUT(text->height() >= needed(), kPatience);
    QVERIFY(program.window->rect().contains(program.placeOf(bar(program))));
    if (qEnvironmentVariableIsSet("TACTUM_PICTURE"))
        program.window->grab().save(qEnvironmentVariable("TACTUM_PICTURE"));
}

void TestRecovery::aDamagedJournalIsSaidAndKept() {
    const fs::path folder = leaveJournal(someScene(), "cube.obj", 1000);
    std::string bytes = read(QString::fromStdString((folder / "journal").string())).toStdString();
    bytes[bytes.size() / 2] ^= 1;
    write(QString::fromStdString((folder / "journal").string()), bytes);
    {
        TouchedWindow program;
        QTRY_VERIFY_WITH_TIMEOUT(noticeOf(program).contains(QStringLiteral("damaged")), kPatience);
        QVERIFY(!bar(program).isVisible());
    }
    QCOMPARE(journals().size(), std::size_t(1));
    COMPARE_BEGINS(journals().front().filename().string(), "damaged-");
    TouchedWindow again;
    again.frames(60);
    QVERIFY(noticeOf(again).isEmpty());
    QCOMPARE(journals().size(), std::size_t(1));
}

void TestRecovery::savingAndLeavingEndTheJournal() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    const auto edit = [&](double stiffness) {
        setStiffness(program.document, stiffness);
        QSignalSpy written(&program.window->journal(), &Journal::written);
        program.window->journal().writeNow();
        return test::waitFor([&] { return written.size() == 1; }) && journals().size() == 1;
    };
    QVERIFY(edit(201));
    program.document.history().undo(); // nothing is left to lose
    QTRY_VERIFY_WITH_TIMEOUT(journals().empty(), kPatience);
    QVERIFY(edit(202));
    program.document.save(folder_->filePath(QStringLiteral("kept.glb")).toStdString());
    QTRY_VERIFY_WITH_TIMEOUT(journals().empty(), kPatience);
    QVERIFY(edit(203));
    program.window->close();
    program.window->findChild<QMessageBox*>(QStringLiteral("unsaved"))->button(QMessageBox::Discard)->click();
    QTRY_VERIFY_WITH_TIMEOUT(journals().empty(), kPatience);
}

void TestRecovery::anEditIsInItAfterTheTimeOrTheCount() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    Journal& journal = program.window->journal();
    QSignalSpy written(&journal, &Journal::written);
    const Journal::Pace pace;
    QCOMPARE_LT(pace.milliseconds, 30'000);
    QCOMPARE_LE(pace.edits, 20);
    journal.setPace({pace.milliseconds, pace.edits, pace.milliseconds});
    for (int i = 1; i < pace.edits; ++i)
        setStiffness(program.document, 100 + i);
    program.frames(30);
    QCOMPARE(written.size(), 0);
    setStiffness(program.document, 150);
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 1, kPatience);
    // The clock counts from the first edit that is not in it: who goes on editing does not put it off.
    journal.setPace({200, 1000});
    for (int i = 0; i < 1000 && written.size() < 2; ++i) {
        setStiffness(program.document, 160 + i % 7);
        QTest::qWait(20);
    }
    QCOMPARE(written.size(), 2);
}

/// Most who lose something have edited once or twice since they opened it.
void TestRecovery::theFirstEditIsInItAtOnce() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    Journal& journal = program.window->journal();
    const Journal::Pace pace;
    QCOMPARE_LE(pace.first, 1000);
    journal.setPace({3'600'000, 1000, pace.first});
    QSignalSpy written(&journal, &Journal::written);
    setStiffness(program.document, 100);
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 1, kPatience);
    setStiffness(program.document, 101); // what comes then can wait
    program.frames(pace.first / 8);
    QCOMPARE(written.size(), 1);
    program.document.history().undo();
    program.document.history().undo(); // nothing is unsaved: the next edit is a first one again
    QTRY_VERIFY_WITH_TIMEOUT(journals().empty(), kPatience);
    setStiffness(program.document, 102);
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 2, kPatience);
}

void TestRecovery::aDragIsInItToo() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    Journal& journal = program.window->journal();
    QSignalSpy written(&journal, &Journal::written);
    journal.setPace({100, 1000});
    const Gesture drag = newGesture();
    setStiffness(program.document, 100, drag);
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 1, kPatience);
    setStiffness(program.document, 101, drag); // the same step of the history
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 2, kPatience);
}

void TestRecovery::whatCannotBeWrittenIsSaidOnce() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    fs::remove_all(Journal::home());
    fs::create_directories(Journal::home().parent_path());
    write(QString::fromStdString(Journal::home().string()), "no folder");
    Journal& journal = program.window->journal();
    journal.setPace({20, 1000});
    QSignalSpy failed(&journal, &Journal::failed), written(&journal, &Journal::written);
    setStiffness(program.document, 101);
    QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, kPatience);
    COMPARE_BEGINS(noticeOf(program), QStringLiteral("What you edit is not kept"));
    QVERIFY(!noticeOf(program).contains(u'\n'));
    for (int i = 0; i < 5; ++i) {
        setStiffness(program.document, 102 + i);
        QTest::qWait(60);
    }
    QCOMPARE(failed.size(), 1);
    // It tries again by itself.
    fs::remove(Journal::home());
    QTRY_COMPARE_WITH_TIMEOUT(written.size(), 1, kPatience);
}

void TestRecovery::theHistoryOutlivesASave() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    const double before = program.document.scene().objects[0].surfaces[0].material.stiffness;
    setStiffness(program.document, 333);
    QSignalSpy saved(&program.document, &Document::saved);
    program.document.save(folder_->filePath(QStringLiteral("kept.glb")).toStdString());
    QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, kPatience);
    QCOMPARE(program.document.history().text(0), QStringLiteral("Stiffness of right"));
    program.document.history().undo();
    QCOMPARE(program.document.scene().objects[0].surfaces[0].material.stiffness, before);
    QVERIFY(program.document.modified());
}

// A preset is several edits and one step. The last of them is taken back first, or another value than that of
// before would come back.
void TestRecovery::aStepOfSeveralIsOneStep() {
    TouchedWindow program;
    QVERIFY(program.open(writeCube(*folder_)));
    Document& document = program.document;
    const std::string before = *glbOf(document.scene());
    document.history().beginMacro(QStringLiteral("Several"));
    setStiffness(document, 333);
    setStiffness(document, 444);
    document.setProxyRadius(0.0071);
    document.history().endMacro();
    const std::string after = *glbOf(document.scene());
    const SceneHistory done = document.stepsAround(10);
    QCOMPARE(done.done.size(), std::size_t(1));
    QCOMPARE(QString::fromStdString(done.done[0].text), QStringLiteral("Several"));
    QCOMPARE(*glbOf(done.done[0].scene), before);
    document.history().undo();
    const SceneHistory undone = document.stepsAround(10);
    QCOMPARE(undone.done.size(), std::size_t(0));
    QCOMPARE(undone.undone.size(), std::size_t(1));
    QCOMPARE(*glbOf(undone.undone[0].scene), after);
    QCOMPARE(*glbOf(document.scene()), before); // looking changes nothing
}

TACTUM_GUI_TEST(TestRecovery)

} // namespace test_recovery

#include "test_recovery.moc"
