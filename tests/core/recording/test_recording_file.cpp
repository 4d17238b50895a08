// The file of a recording: what is written is read back and replays; what is damaged is refused in a
// sentence.
#include <cmath>
#include <fstream>
#include <random>

#include <QTemporaryDir>
#include <QTest>

#include "core/files/load_scene.h"
#include "core/haptics/compile.h"
#include "core/recording/events.h"
#include "core/recording/player.h"
#include "core/recording/recording_file.h"
#include "core/safety/inhibit_words.h"
#include "tests/core/recording/hand_made_run.h"
#include "tests/realtime/bumpy_scene.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_recording_file {

using namespace tactum;

namespace {

constexpr double kForEver = 1e9;

Recording shortRecording() {
    return {handMadeRun(1200), "a test wanted it", {}};
}

/// The sentence of whatever refuses the bytes; empty when they can be played.
std::string refusal(const std::string& bytes) {
    auto read = parseRecording(bytes, "hostile.tactum-recording");
    if (!read) return read.error().text;
    eventsOf(read->run);
    auto player = Player::open(std::make_shared<const RecordedRun>(read->run));
    if (!player) return player.error().text;
    player->advanceTo(read->run.begin() + 0.1);
    player->seek(read->run.end() - 0.1);
    return {};
}

bool isSentence(const std::string& text) {
    return !text.empty() && text.find('\n') == std::string::npos && text.find(": ") != std::string::npos;
}

} // namespace

class TestRecordingFile : public QObject {
    Q_OBJECT

    std::string bytes_;

private slots:
    void initTestCase() { bytes_ = recordingBytes(shortRecording()); }

    void readBackItIsTheSame() {
        const Recording written = shortRecording();
        const auto read = parseRecording(bytes_, "whole.tactum-recording");
        VERIFY_RESULT(read);
        QCOMPARE(read->reason, written.reason);
        QCOMPARE(read->run.scenes.size(), written.run.scenes.size());
        for (std::size_t i = 0; i < written.run.scenes.size(); ++i) {
            const Scene &a = *written.run.scenes[i].scene, &b = *read->run.scenes[i].scene;
            QCOMPARE(a.objects.size(), b.objects.size());
            for (std::size_t k = 0; k < a.objects.size(); ++k) {
                QVERIFY(*a.objects[k].geometry == *b.objects[k].geometry);
                QCOMPARE_EQ(a.objects[k].pose, b.objects[k].pose);
                QVERIFY(a.objects[k].surfaces == b.objects[k].surfaces);
            }
        }
        auto player = Player::open(std::make_shared<const RecordedRun>(read->run));
        VERIFY_RESULT(player);
        player->advanceTo(kForEver);
        QVERIFY2(player->check().differ == 0, player->check().first.c_str());
        QCOMPARE(player->check().proxySteps, written.run.proxy.rows.size());
        QCOMPARE(player->check().servoSteps, written.run.servo.rows.size());
        QCOMPARE(recordingBytes(*read), bytes_);
    }

    void whatItSharesIsWrittenOnce() {
        // Forty edits of one plate: the plate is there once.
        const Recording recording = shortRecording();
        const auto& soup = *recording.run.scenes.front().scene->objects.front().geometry;
        QCOMPARE_GE(recording.run.scenes.size(), 8);
        const std::size_t rows = recording.run.proxy.rows.size() * sizeof(ProxyRow) +
                                 recording.run.servo.rows.size() * sizeof(ServoRow);
        const std::size_t plates = 2 * soup.triangles.size() * (12 + 4 + 24);
        QCOMPARE_LT(bytes_.size(), rows + 2 * plates + 100'000);
    }

    void cutShortItIsRefused() {
        for (std::size_t length = 0; length < bytes_.size(); length += 1 + length / 3)
            for (const bool sealed : {false, true}) {
                std::string cut = bytes_.substr(0, length);
                if (sealed && length >= 24) sealRecording(cut);
                QVERIFY2(isSentence(refusal(cut)), refusal(cut).c_str());
            }
    }

    void oneFlippedBitIsSeen() {
        std::mt19937 random(7);
        for (int i = 0; i < 300; ++i) {
            std::string flipped = bytes_;
            flipped[random() % flipped.size()] ^= char(1 << random() % 8);
            QVERIFY(isSentence(refusal(flipped)));
        }
    }

    /// Whoever makes the fingerprint fit gets as far as the checks behind it, and no further than they let.
    void sealedNonsenseNeitherCrashesNorHangs() {
        std::mt19937 random(8);
        int refused = 0, played = 0;
        // The header, the scenes, the rows.
        constexpr std::size_t kRows = 500'000;
        const std::pair<std::size_t, std::size_t> places[] = {
            {12, 2000}, {2000, bytes_.size() - kRows}, {bytes_.size() - kRows, bytes_.size() - 8}};
        for (int i = 0; i < 240; ++i) {
            std::string hostile = bytes_;
            const auto [from, to] = places[i % 3];
            for (unsigned k = 0; k < 1 + random() % 3; ++k)
                hostile[from + random() % (to - from)] = char(random());
            sealRecording(hostile);
            const std::string text = refusal(hostile);
            (text.empty() ? played : refused) += 1;
            QVERIFY2(text.empty() || isSentence(text), text.c_str());
        }
        qInfo("%d refused, %d played", refused, played);
        QCOMPARE_GT(refused, 40);
        QCOMPARE_GT(played, 40); // both ways are taken;
    }

    void aReasonThatIsNoneIsRefused() {
        for (const std::uint32_t reason : {std::uint32_t(kInhibitWords.size()), 17u, 255u, ~0u}) {
            Recording recording = shortRecording();
            recording.run.servo.rows[100].inhibit = reason;
            const std::string text = refusal(recordingBytes(recording));
            QVERIFY2(isSentence(text) && text.find("servo tick 100") != std::string::npos, text.c_str());
        }
    }

    /// A state is some kilobytes in memory and may be none in the file.
    void moreStatesThanAMinuteHasAreRefused() {
        Recording recording = shortRecording();
        recording.run.servoStates.clear();
        for (std::uint64_t row = 0; row < 200; ++row) {
            ServoStateBytes& state = recording.run.servoStates.emplace_back();
            state.row = row;
            state.size = 0;
        }
        const std::string text = refusal(recordingBytes(recording));
        QVERIFY2(isSentence(text) && text.find("more states") != std::string::npos, text.c_str());
    }

    /// What the person added to a large model, or changed of it, is not in the model's file.
    void whatIsNotInTheLargeModelIsInTheRecording() {
        QTemporaryDir folder;
        const std::filesystem::path model = folder.filePath("grid.obj").toStdString();
        writeGrid(model, 330);
        const auto loaded = loadScene(model);
        VERIFY_RESULT(loaded);
        Scene repaired = loaded->scene;
        TriangleSoup fewer = *repaired.objects[0].geometry;
        fewer.triangles.pop_back();
        fewer.surfaceOf.pop_back();
        fewer.cornerNormals.clear();
        fewer.cornerUvs.clear();
        repaired.objects[0].geometry = std::make_shared<const TriangleSoup>(fewer);
        const Recording changed{handMadeRun(50, repaired), "a triangle less", {model}};
        QCOMPARE(refusal(recordingBytes(changed)), std::string());

        Scene layered = loaded->scene;
        TextureLayer layer;
        layer.pattern.source = TextureSource::Image;
        layer.pattern.image =
            std::make_shared<const TextureImage>(8, 8, std::vector<std::uint16_t>(64, 30'000));
        layer.pattern.size = 0.01;
        layered.objects[0].surfaces[0].layers = {layer};
        const std::string bytes = recordingBytes({handMadeRun(50, layered), "a picture more", {model}});
        QCOMPARE_LT(bytes.size(), 1'000'000); // the grid itself is left out
        QCOMPARE(refusal(bytes), std::string());
    }

    void largeScenesAreFoundInTheirFile() {
        QTemporaryDir folder;
        const std::filesystem::path model = folder.filePath("grid.obj").toStdString();
        writeGrid(model, 330); // 217 800 triangles
        const auto loaded = loadScene(model);
        VERIFY_RESULT(loaded);
        const Recording recording{handMadeRun(50, loaded->scene), "it is large", {model}};
        const std::string bytes = recordingBytes(recording);
        QCOMPARE_LT(bytes.size(), 1'000'000);
        QCOMPARE(refusal(bytes), std::string());

        std::ofstream(model, std::ios::app) << "v 0 0 1\nf 1 2 -1\n";
        const std::string text = refusal(bytes);
        QVERIFY2(isSentence(text) && text.find("was changed") != std::string::npos, text.c_str());
        std::filesystem::remove(model);
        QVERIFY(isSentence(refusal(bytes)));
    }

    void timesThatNoRunCanHaveAreRefused_data() {
        QTest::addColumn<bool>("servo");
        QTest::addColumn<std::size_t>("row");
        QTest::addColumn<double>("time");
        QTest::addColumn<QString>("sentence");
        const std::size_t last = 1199, first = 0, middle = 600;
        QTest::newRow("for ever") << true << last << 1e300 << "servo tick 1199 has a time";
        QTest::newRow("nearly") << true << last << 9e8 << "servo tick 1199 is minutes after";
        QTest::newRow("three minutes") << true << last << 180.0 << "servo tick 1199 is minutes after";
        QTest::newRow("long before") << true << first << -1e300 << "has a time";
        QTest::newRow("minutes before") << true << first << -180.0 << "0 is minutes after";
        QTest::newRow("falling") << true << middle << 0.1 << "servo tick 600 is earlier";
        QTest::newRow("no number") << true << middle << std::nan("") << "servo tick 600 has a time";
        QTest::newRow("proxy") << false << middle << 180.0 << "haptic step 600 is minutes after";
        QTest::newRow("proxy, falling") << false << middle << 0.1 << "haptic step 600 is earlier";
        QTest::newRow("proxy, for ever") << false << last << 1e300 << "haptic step 1199 has a time";
    }
    /// A player goes through a run by its times.
    void timesThatNoRunCanHaveAreRefused() {
        QFETCH(bool, servo);
        QFETCH(std::size_t, row);
        QFETCH(double, time);
        QFETCH(QString, sentence);
        Recording forged = shortRecording();
        (servo ? forged.run.servo.rows[row].time : forged.run.proxy.rows[row].time) = time;
        const auto read = parseRecording(recordingBytes(forged), "forged.tactum-recording");
        QVERIFY(!read);
        const std::string& text = read.error().text;
        QVERIFY2(isSentence(text) && text.find(sentence.toStdString()) != std::string::npos, text.c_str());
    }

    /// A device that gives no readings for most of the minute, or a program that was stopped.
    void aLongPauseIsPlayed() {
        Recording paused = shortRecording();
        for (std::size_t i = 600; i < paused.run.servo.rows.size(); ++i)
            paused.run.servo.rows[i].time += 55;
        for (std::size_t i = 1200; i < paused.run.proxy.rows.size(); ++i)
            paused.run.proxy.rows[i].time += 55;
        QCOMPARE(refusal(recordingBytes(paused)), std::string());
    }

    /// Its beginning says that it is none: nobody reads the gigabytes behind it.
    void aHugeFileIsJudgedByItsBeginning() {
        QTemporaryDir folder;
        const std::filesystem::path huge = folder.filePath("huge.bin").toStdString();
        std::ofstream(huge) << "a model, say";
        std::filesystem::resize_file(huge, std::uintmax_t(5) << 30); // a hole
        const auto model = readRecording(huge);
        QVERIFY(!model);
        COMPARE_CONTAINS(model.error().text, "is no recording");

        std::ofstream(huge) << bytes_;
        std::filesystem::resize_file(huge, std::uintmax_t(5) << 30);
        const auto recording = readRecording(huge);
        QVERIFY(!recording);
        COMPARE_CONTAINS(recording.error().text, "is larger than");
    }

    void whatIsNoFileIsNotMissing() {
        const auto device = readRecording("/dev/zero");
        QVERIFY(!device);
        QVERIFY(isSentence(device.error().text));
        COMPARE_CONTAINS(device.error().text, "cannot be read as a file");
        const auto missing = readRecording("/nowhere/at-all.tactum-recording");
        QVERIFY(!missing);
        COMPARE_CONTAINS(missing.error().text, "no such file");
    }

    void otherFilesAreRefused() {
        COMPARE_CONTAINS(refusal(""), "is no recording of Tactum");
        COMPARE_CONTAINS(refusal("solid cube\nfacet normal 0 0 1\nouter loop\n"), "is no recording");
        std::string newer = bytes_;
        newer[8] += 2; // the one between is of several hands
        COMPARE_CONTAINS(refusal(newer), "another version");
        const auto missing = readRecording("/nowhere/at-all.tactum-recording");
        QVERIFY(!missing);
        QVERIFY(isSentence(missing.error().text));
    }
};

TACTUM_TEST(TestRecordingFile)

} // namespace test_recording_file

#include "test_recording_file.moc"
