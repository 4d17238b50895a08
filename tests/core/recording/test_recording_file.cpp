// The file of a recording: what is written is read back and replays; what is damaged is refused in a
// sentence.
#include <fstream>
#include <random>

#include <QTemporaryDir>
#include <QtTest>

#include "core/files/load_scene.h"
#include "core/recording/player.h"
#include "core/recording/recording_file.h"
#include "core/runtime/compile.h"
#include "tests/core/recording/hand_made_run.h"
#include "tests/realtime/bumpy_scene.h"

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
        QVERIFY2(read.has_value(), read ? "" : read.error().text.c_str());
        QCOMPARE(read->reason, written.reason);
        QCOMPARE(read->run.scenes.size(), written.run.scenes.size());
        for (std::size_t i = 0; i < written.run.scenes.size(); ++i) {
            const Scene &a = *written.run.scenes[i].scene, &b = *read->run.scenes[i].scene;
            QCOMPARE(a.objects.size(), b.objects.size());
            for (std::size_t k = 0; k < a.objects.size(); ++k) {
                QVERIFY(*a.objects[k].geometry == *b.objects[k].geometry);
                QVERIFY(a.objects[k].pose == b.objects[k].pose);
                QVERIFY(a.objects[k].surfaces == b.objects[k].surfaces);
            }
        }
        auto player = Player::open(std::make_shared<const RecordedRun>(read->run));
        QVERIFY2(player.has_value(), player ? "" : player.error().text.c_str());
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
        QVERIFY(recording.run.scenes.size() >= 8);
        const std::size_t rows = recording.run.proxy.rows.size() * sizeof(ProxyRow) +
                                 recording.run.servo.rows.size() * sizeof(ServoRow);
        const std::size_t plates = 2 * soup.triangles.size() * (12 + 4 + 24);
        QVERIFY(bytes_.size() < rows + 2 * plates + 100'000);
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
        QVERIFY(refused > 40 && played > 40); // both ways are taken;
    }

    void largeScenesAreFoundInTheirFile() {
        QTemporaryDir folder;
        const std::filesystem::path model = folder.filePath("grid.obj").toStdString();
        writeGrid(model, 330); // 217 800 triangles
        const auto loaded = loadScene(model);
        QVERIFY(loaded.has_value());
        const Recording recording{handMadeRun(50, loaded->scene), "it is large", {model}};
        const std::string bytes = recordingBytes(recording);
        QVERIFY(bytes.size() < 1'000'000);
        QCOMPARE(refusal(bytes), std::string());

        std::ofstream(model, std::ios::app) << "v 0 0 1\nf 1 2 -1\n";
        const std::string text = refusal(bytes);
        QVERIFY2(isSentence(text) && text.find("was changed") != std::string::npos, text.c_str());
        std::filesystem::remove(model);
        QVERIFY(isSentence(refusal(bytes)));
    }

    void otherFilesAreRefused() {
        QVERIFY(refusal("").find("is no recording of Tactum") != std::string::npos);
        QVERIFY(refusal("solid cube\nfacet normal 0 0 1\nouter loop\n").find("is no recording") !=
                std::string::npos);
        std::string newer = bytes_;
        newer[8] = 9;
        QVERIFY(refusal(newer).find("another version") != std::string::npos);
        const auto missing = readRecording("/nowhere/at-all.tactum-recording");
        QVERIFY(!missing && isSentence(missing.error().text));
    }
};

QTEST_APPLESS_MAIN(TestRecordingFile)
#include "test_recording_file.moc"
