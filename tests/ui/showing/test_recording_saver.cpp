// When the last minute is saved, under which name, with which words, and how many are kept.
//
// What would show that a test here is wrong: files are read by the reader of recordings, and what must not
// save anything stands beside what must.
#include <QDir>
#include <QSignalSpy>
#include <QTest>

#include "core/safety/inhibit_words.h"
#include "core/scene/primitives.h"
#include "tests/core/recording/hand_made_run.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/own_folders.h"
#include "tests/ui/told_engine.h"
#include "ui/showing/recording_saver.h"

namespace test_recording_saver {

using namespace tactum;
using namespace tactum::test;

namespace {

struct Desk {
    explicit Desk(std::size_t hands = 1) : engine(hands), saver(std::in_place, engine, document) {
        engine.run = handMadeRun(40);
        QObject::connect(&*saver, &RecordingSaver::saved, [this](const QString& file, bool afterFault) {
            saved << (afterFault ? QStringLiteral("fault ") + file : file);
        });
        QObject::connect(&*saver, &RecordingSaver::failed, [this](const QString& what) { failures << what; });
    }
    QStringList kept() const { return QDir(RecordingSaver::folder()).entryList(QDir::Files, QDir::Name); }
    bool keeps(int count) {
        return waitFor([&] { return kept().size() == count && !saver->saving(); });
    }
    ToldEngine engine;
    Document document;
    std::optional<RecordingSaver> saver;
    QStringList saved, failures;
};

std::string reasonIn(const QString& file) {
    const auto read = readRecording(file.toStdString());
    return read ? read->reason : read.error().text;
}

} // namespace

class TestRecordingSaver : public QObject {
    Q_OBJECT

    FoldersOfEach folders_;
    QString own_;

private slots:
    void init() { own_ = folders_.next(); }

    void aRecordingIsKnownByItsEnding() {
        QVERIFY(isRecording(QStringLiteral("/tmp/a.tactum-recording")));
        QVERIFY(isRecording(QStringLiteral("A.Tactum-Recording")));
        QVERIFY(!isRecording(QStringLiteral("a.tactum-recording.glb")));
        QVERIFY(!isRecording(QStringLiteral("tactum-recording")));
    }

    void whatIsAskedForIsSaved() {
        Desk desk;
        const auto taken = desk.saver->take(QStringLiteral("I liked it"));
        QVERIFY(taken);
        QCOMPARE(taken->reason, "I liked it");
        QVERIFY(taken->sources.empty()); // the scene is of no file
        const QString file = own_ + QStringLiteral("/one.tactum-recording");
        desk.saver->save(file, taken);
        QVERIFY(waitFor([&] { return !desk.saved.isEmpty(); }));
        QCOMPARE(desk.saved, QStringList(file));
        QCOMPARE(reasonIn(file), "I liked it");
        const auto read = readRecording(file.toStdString());
        VERIFY_RESULT(read);
        QCOMPARE(read->run.servo.rows.size(), desk.engine.run.servo.rows.size());
        QCOMPARE(desk.kept(), QStringList());
    }

    void nothingIsNoRecording() {
        Desk desk;
        desk.engine.run = {};
        QVERIFY(!desk.saver->take(QStringLiteral("why")));
        QCOMPARE(desk.failures.size(), 1);
        COMPARE_CONTAINS(desk.failures[0], QStringLiteral("Nothing was recorded yet"));
        // A servo or a proxy alone is one.
        desk.engine.run = handMadeRun(40);
        desk.engine.run.servo.rows.clear();
        QVERIFY(desk.saver->take(QStringLiteral("why")));
        desk.engine.run = handMadeRun(40);
        desk.engine.run.proxy.rows.clear();
        QVERIFY(desk.saver->take(QStringLiteral("why")));
        QCOMPARE(desk.failures.size(), 1);
    }

    void whatCannotBeWrittenIsSaid() {
        Desk desk;
        desk.saver->save(own_ + QStringLiteral("/no folder/one.tactum-recording"), desk.saver->take({}));
        QVERIFY(waitFor([&] { return !desk.failures.isEmpty(); }));
        COMPARE_CONTAINS(desk.failures[0], QStringLiteral("cannot be written"));
        QCOMPARE(desk.saved, QStringList());
    }

    // Several are written one after the other; what is left when the window goes is written all the same.
    void noneIsForgotten() {
        Desk desk;
        for (int i = 0; i < 4; ++i)
            desk.saver->save(own_ + QStringLiteral("/%1.tactum-recording").arg(i),
                             desk.saver->take(QString::number(i)));
        QVERIFY(desk.saver->saving());
        QVERIFY(waitFor([&] { return desk.saved.size() == 4; }));
        for (int i = 0; i < 4; ++i)
            QCOMPARE(reasonIn(desk.saved[i]), std::to_string(i));
        for (int i = 4; i < 7; ++i)
            desk.saver->save(own_ + QStringLiteral("/%1.tactum-recording").arg(i),
                             desk.saver->take(QString::number(i)));
        desk.saver.reset();
        const auto there = [&] {
            return QDir(own_).entryList({QStringLiteral("*.tactum-recording")}, QDir::Files).size();
        };
        QVERIFY(waitFor([&] { return there() == 7; }));
    }

    void aFaultIsSavedASecondLater() {
        Desk desk;
        ServoTelemetry& servo = desk.engine.of[0].servo;
        desk.saver->watch();
        QTest::qWait(1200);
        QCOMPARE(desk.kept(), QStringList()); // nothing happened
        servo.faults = 1;
        servo.inhibit = InhibitReason::TooFast;
        QElapsedTimer clock;
        clock.start();
        desk.saver->watch();
        servo.inhibit = InhibitReason::NotArmed; // the window has disarmed it
        desk.saver->watch();
        QVERIFY(desk.keeps(1));
        QCOMPARE_GE(clock.elapsed(), 950);
        QVERIFY(waitFor([&] { return !desk.saved.isEmpty(); }));
        const QString file = RecordingSaver::folder() + u'/' + desk.kept()[0];
        QCOMPARE(desk.saved, QStringList(QStringLiteral("fault ") + file));
        QCOMPARE(reasonIn(file), std::string("Fault: ") + inhibitWords(InhibitReason::TooFast).brief);
        desk.saver->watch();
        QTest::qWait(1200);
        QCOMPARE(desk.kept().size(), 1); // once
    }

    // Of any hand; those that there were before are not counted.
    void theFaultOfAnotherHandIsOneToo() {
        Desk desk(2);
        desk.engine.of[1].servo.faults = 3;
        desk.engine.of[1].servo.inhibit = InhibitReason::ForceJump;
        desk.saver->watch();
        desk.saver->flush();
        QVERIFY(desk.keeps(1));
        QVERIFY(waitFor([&] { return !desk.saved.isEmpty(); }));
        QCOMPARE(reasonIn(desk.saved[0].mid(6)),
                 std::string("Fault: ") + inhibitWords(InhibitReason::ForceJump).brief);
    }

    void whatIsDueIsFlushed() {
        Desk desk;
        desk.saver->flush(); // nothing is due
        QTest::qWait(50);
        QCOMPARE(desk.kept(), QStringList());
        desk.engine.of[0].servo.faults = 1;
        desk.engine.of[0].servo.inhibit = InhibitReason::DeviceLost;
        desk.saver->watch();
        desk.saver->flush();
        QVERIFY(desk.keeps(1));
        QTest::qWait(1200);
        QCOMPARE(desk.kept().size(), 1); // and not again when it would have been due
    }

    void aDeviceThatHangsIsRecordedWhenItIsLetGo_data() {
        QTest::addColumn<bool>("standsStill");
        QTest::addColumn<bool>("runs");
        QTest::addColumn<bool>("saved");
        QTest::newRow("stands still") << true << true << true;
        QTest::newRow("stands still, stopped") << true << false << true;
        QTest::newRow("stalls") << false << true << true;
        QTest::newRow("stalled before it was stopped") << false << false << false;
    }

    void aDeviceThatHangsIsRecordedWhenItIsLetGo() {
        QFETCH(bool, standsStill);
        QFETCH(bool, runs);
        QFETCH(bool, saved);
        Desk desk;
        desk.engine.runs = runs;
        desk.engine.of[0].standsStill = standsStill;
        if (!standsStill) desk.engine.of[0].servo.inhibit = InhibitReason::Stall;
        desk.saver->flush();
        QVERIFY(desk.keeps(saved));
        if (!saved) return;
        QVERIFY(waitFor([&] { return !desk.saved.isEmpty(); }));
        QCOMPARE(reasonIn(desk.saved[0].mid(6)),
                 std::string("Fault: ") + inhibitWords(InhibitReason::Stall).brief);
    }

    void theLastTwentyFaultsAreKept() {
        Desk desk;
        QDir().mkpath(RecordingSaver::folder());
        const QDir folder(RecordingSaver::folder());
        for (int i = 0; i < 25; ++i) {
            QFile old(folder.filePath(
                QStringLiteral("1999-01-%1 00-00-00.tactum-recording").arg(i + 1, 2, 10, QChar(u'0'))));
            QVERIFY(old.open(QIODevice::ReadWrite));
            QVERIFY(old.setFileTime(QDateTime(QDate(1999, 1, i + 1), QTime(0, 0)),
                                    QFileDevice::FileModificationTime));
        }
        QFile notes(folder.filePath(QStringLiteral("notes.txt")));
        QVERIFY(notes.open(QIODevice::WriteOnly));
        desk.engine.of[0].servo.faults = 1;
        desk.saver->watch();
        desk.saver->flush();
        QVERIFY(waitFor([&] { return !desk.saved.isEmpty(); }));
        const QStringList left =
            folder.entryList({QStringLiteral("*.tactum-recording")}, QDir::Files, QDir::Name);
        QCOMPARE(left.size(), 20);
        COMPARE_BEGINS(left[0], QStringLiteral("1999-01-07")); // six of the oldest have gone
        QVERIFY(notes.exists());
    }
};

TACTUM_TEST(TestRecordingSaver)

} // namespace test_recording_saver

#include "test_recording_saver.moc"
