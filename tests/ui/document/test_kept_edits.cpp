// What is edited and not saved is kept, and found again after a run that died. Wrong itself if the run that
// is said to have died were this one: its journals are given the name of a process that has ended.
#include <fstream>
#include <sys/wait.h>

#include <QDateTime>
#include <QSignalSpy>
#include <QTest>

#include "core/base/child_program.h"
#include "core/base/process_mark.h"
#include "core/files/journal.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/cube_file.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/panels/panels.h"
#include "ui/document/journal.h"
#include "ui/document/recovery.h"

namespace test_kept_edits {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace fs = std::filesystem;

namespace {

std::vector<fs::path> journals() {
    std::vector<fs::path> folders;
    std::error_code none;
    for (const auto& each : fs::directory_iterator(Journal::home(), none))
        folders.push_back(each.path());
    return folders;
}

/// A document whose edits are kept at once.
struct Run {
    Run() { journal.setPace({.milliseconds = 0, .edits = 20, .first = 0}); }
    bool edits(double radius) {
        QSignalSpy written(&journal, &Journal::written);
        document.setProxyRadius(radius);
        return waitFor([&] { return written.size() > 0; });
    }
    Document document;
    Journal journal{document};
};

} // namespace

class TestKeptEdits : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> data_;
    int dead_ = 0;

    /// The journal of a run that edited `radius` metres of a scene and then died.
    fs::path leftBehind(double radius, const std::string& file = {}) {
        ChildProgram program;
        program.program = "/bin/true";
        pid_t child = -1;
        if (startChild(program, child) != 0) qFatal("no child");
        int status = 0;
        waitpid(child, &status, 0);
        ProcessMark mark = ownMark();
        mark.pid = child;
        const fs::path folder = Journal::home() / (nameOf(mark) + '_' + std::to_string(dead_++));
        Run run;
        adopt(run.document, knownScene());
        if (!file.empty()) {
            run.document.save(file);
            if (!waitFor([&] { return !run.document.saving() && !run.document.path().empty(); }))
                qFatal("not saved");
        }
        if (!run.edits(radius)) qFatal("not written");
        for (const fs::path& each : journals())
            if (markNamed(each.filename().string().substr(0, each.filename().string().rfind('_'))) ==
                    ownMark() &&
                holdsJournal(each))
                fs::rename(each, folder);
        return folder;
    }

private slots:
    void init() {
        data_ = std::make_unique<QTemporaryDir>();
        useFoldersIn(data_->path());
        fs::create_directories(Journal::home());
    }

    void editsAreKeptUntilTheyAreSaved() {
        Run run;
        run.document.begin(knownScene());
        QCOMPARE(journals().size(), 0u);
        QVERIFY(run.edits(0.002));
        QCOMPARE(journals().size(), 1u);
        const fs::path folder = journals()[0];
        QVERIFY(holdsJournal(folder));
        const auto entry = readJournalEntry(folder);
        QVERIFY(entry.has_value());
        QCOMPARE(entry->title, run.document.title().toStdString());
        QVERIFY(!entry->own);
        QCOMPARE_LE(std::abs(entry->edited - QDateTime::currentSecsSinceEpoch()), 60);
        QVERIFY(run.edits(0.003));
        QCOMPARE(journals().size(), 1u); // the same one
        run.document.history().undo();
        run.document.history().undo(); // nothing is unsaved any more
        QVERIFY(waitFor([&] { return journals().empty(); }));
        QVERIFY(run.edits(0.002));
        run.document.save(data_->filePath(QStringLiteral("a.glb")).toStdString());
        QVERIFY(waitFor([&] { return journals().empty(); }));
        run.document.setProxyRadius(0.004);
        run.journal.discard(); // the person wants none of it
        QTest::qWait(50);
        QCOMPARE(journals().size(), 0u);
    }

    /// Written after so many edits, or after some time, and not before.
    void thePaceIsKept() {
        Run run;
        run.document.begin(knownScene());
        run.journal.setPace({.milliseconds = 3'600'000, .edits = 3, .first = 3'600'000});
        QSignalSpy written(&run.journal, &Journal::written);
        run.document.setProxyRadius(0.002);
        run.document.setProxyRadius(0.003);
        QTest::qWait(100);
        QCOMPARE(written.size(), 0);
        run.document.setProxyRadius(0.004);
        QVERIFY(waitFor([&] { return written.size() == 1; }));
        run.document.setProxyRadius(0.005);
        run.journal.writeNow();
        QVERIFY(waitFor([&] { return written.size() == 2; }));
        run.document.history().setClean();
        run.journal.writeNow(); // nothing is unsaved
        QTest::qWait(50);
        QCOMPARE(written.size(), 2);
    }

    void whatCannotBeWrittenIsSaidOnce() {
        fs::remove_all(Journal::home());
        std::ofstream(Journal::home()) << "no folder";
        Run run;
        run.document.begin(knownScene());
        QSignalSpy failed(&run.journal, &Journal::failed);
        run.document.setProxyRadius(0.002);
        QVERIFY(waitFor([&] { return failed.size() == 1; }));
        COMPARE_CONTAINS(failed[0][0].toString(), "What you edit is not kept for the case of a crash: ");
        QTest::qWait(100); // it is tried again
        QCOMPARE(failed.size(), 1);
        QSignalSpy written(&run.journal, &Journal::written);
        fs::remove(Journal::home());
        QVERIFY(waitFor([&] { return written.size() > 0; })); // without another edit
    }

    void aRunThatDiedIsFoundAgain() {
        const std::string file = data_->filePath(QStringLiteral("pot.glb")).toStdString();
        leftBehind(0.003, file);
        const fs::path own = leftBehind(0.002);
        Run living; // whose journal is nobody else's
        living.document.begin(knownScene());
        QVERIFY(living.edits(0.009));
        Run run;
        Recovery recovery(run.document, run.journal);
        QSignalSpy changed(&recovery, &Recovery::changed), recovered(&recovery, &Recovery::recovered),
            failed(&recovery, &Recovery::failed);
        recovery.look();
        QVERIFY(waitFor([&] { return changed.size() == 1; }));
        QCOMPARE(recovery.scenes().size(), 2u);
        const std::size_t pot = recovery.scenes()[0].entry.title == "pot.glb" ? 0 : 1;
        QCOMPARE(recovery.scenes()[pot].entry.title, "pot.glb");
        COMPARE_BEGINS(sentenceOf(recovery.scenes()[pot]),
                       QStringLiteral("pot.glb was not saved: edited until "));
        QSignalSpy progressed(&recovery, &Recovery::progressed);
        recovery.recover(pot);
        QCOMPARE(progressed.front(), (QVariantList{0.0, -1.0})); // at once, with nothing to judge from yet
        QVERIFY(waitFor([&] { return recovered.size() == 1; }));
        QCOMPARE(recovered[0][0].toString(), "pot.glb");
        QVERIFY(recovered[0][1].toBool()); // with its history
        QCOMPARE(run.document.scene().proxyRadius, 0.003);
        QVERIFY(run.document.modified() && run.document.hasOwnFile());
        QCOMPARE(run.document.path(), fs::path(file));
        run.document.history().undo();
        QCOMPARE(run.document.scene().proxyRadius, knownScene().proxyRadius);
        run.document.history().redo();
        QCOMPARE(recovery.scenes().size(), 1u);
        // The other one is thrown away, brought back, and thrown away for good.
        recovery.throwAway(0);
        QVERIFY(recovery.scenes()[0].thrownAway);
        recovery.bringBack(0);
        QVERIFY(!recovery.scenes()[0].thrownAway);
        QVERIFY(fs::exists(recovery.scenes()[0].folder));
        QVERIFY(!fs::exists(own)); // it is under our name since
        QCOMPARE(failed.size(), 0);
    }

    void whatIsThrownAwayGoesWithTheProgram() {
        leftBehind(0.002), leftBehind(0.003);
        {
            Run run;
            Recovery recovery(run.document, run.journal);
            QSignalSpy changed(&recovery, &Recovery::changed);
            recovery.look();
            QVERIFY(waitFor([&] { return changed.size() == 1; }));
            recovery.throwAway(1);
            QCOMPARE(journals().size(), 2u);
        }
        QCOMPARE(journals().size(), 1u);
    }

    void whatIsDamagedIsPutAside() {
        const fs::path folder = leftBehind(0.002);
        for (const auto& each : fs::directory_iterator(folder))
            std::ofstream(each.path(), std::ios::trunc) << "{";
        Run run;
        Recovery recovery(run.document, run.journal);
        QSignalSpy failed(&recovery, &Recovery::failed);
        recovery.look();
        QVERIFY(waitFor([&] { return failed.size() == 1; }));
        COMPARE_CONTAINS(failed[0][0].toString(), "its journal is damaged. It was kept in ");
        QCOMPARE(recovery.scenes().size(), 0u);
        QVERIFY(!fs::exists(folder));
        QVERIFY(fs::exists(Journal::home() / ("damaged-" + folder.filename().string())));
        recovery.look(); // it is nobody's journal any more
        QTest::qWait(100);
        QCOMPARE(failed.size(), 1);
    }

    void anotherWindowWasQuicker() {
        leftBehind(0.002);
        Run run;
        Recovery recovery(run.document, run.journal);
        QSignalSpy changed(&recovery, &Recovery::changed), failed(&recovery, &Recovery::failed);
        recovery.look();
        QVERIFY(waitFor([&] { return changed.size() == 1; }));
        fs::rename(recovery.scenes()[0].folder, Journal::newFolder());
        recovery.recover(0);
        QCOMPARE(failed.size(), 1);
        QCOMPARE(failed[0][0].toString(), "Another window has taken that scene.");
        QCOMPARE(recovery.scenes().size(), 0u);
        QVERIFY(run.document.empty());
    }

    void theSentenceSaysTheDay() {
        LostScene scene;
        scene.entry.title = "cube.obj";
        const QDateTime day(QDate(2026, 2, 3), QTime(14, 32, 10));
        scene.entry.edited = day.toSecsSinceEpoch();
        QCOMPARE(sentenceOf(scene), "cube.obj was not saved: edited until 14:32 on 2026-02-03.");
        const QDateTime today(QDate::currentDate(), QTime(12, 5));
        scene.entry.edited = today.toSecsSinceEpoch();
        if (QDate::currentDate() == today.date()) // midnight has not come since
            QCOMPARE(sentenceOf(scene), "cube.obj was not saved: edited until 12:05.");
    }
};

TACTUM_TEST(TestKeptEdits)

} // namespace test_kept_edits

#include "test_kept_edits.moc"
