// Every recording in this folder gives the same bits as when it was made.
#include <filesystem>

#include <QTest>

#include "core/recording/player.h"
#include "core/recording/recording_file.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_replay {

using namespace tactum;

class TestReplay : public QObject {
    Q_OBJECT

private slots:
    void everyRecording_data() {
        QTest::addColumn<QString>("file");
        for (const auto& entry : std::filesystem::directory_iterator(TACTUM_REPLAYS))
            if (entry.path().extension() == "." + std::string(kRecordingEnding))
                QTest::newRow(entry.path().filename().c_str())
                    << QString::fromStdString(entry.path().string());
    }

    void everyRecording() {
        QFETCH(const QString, file);
        auto recording = readRecording(file.toStdString());
        VERIFY_RESULT(recording);
        auto player = Player::open(std::make_shared<const RecordedRun>(recording->run));
        VERIFY_RESULT(player);
        player->advanceTo(recording->run.end());
        const ReplayCheck& check = player->check();
        QCOMPARE(check.proxySteps, recording->run.proxy.rows.size());
        QCOMPARE(check.servoSteps, recording->run.servo.rows.size());
        const std::string text = std::to_string(check.differ) + " steps differ; " + check.first +
                                 ". If that is meant, run make-replays and say why in the commit";
        QVERIFY2(check.differ == 0, text.c_str());
        double most = 0;
        for (const ServoRow& row : recording->run.servo.rows)
            most = std::max(most, vectorOf(row.force).norm());
        QCOMPARE_GT(most, 0.1); // N: it is about something
    }

    /// One of another version would let the fuzzer see no more than the refusal (make-fuzz-corpus).
    void theFuzzersRecordingIsReadToday() {
        VERIFY_RESULT(readRecording(std::filesystem::path(TACTUM_REPLAYS).parent_path() /
                                    "fuzz/corpus/recording/short.tactum-recording"));
    }
};

TACTUM_TEST(TestReplay)

} // namespace test_replay

#include "test_replay.moc"
