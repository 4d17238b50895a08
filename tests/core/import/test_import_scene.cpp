// The import process: gives what the reader gives, and whatever happens to it is one line here.
#include <chrono>
#include <thread>

#include <sys/resource.h>

#include <QTest>

#include "core/files/load_scene.h"
#include "core/files/save_scene.h"
#include "core/import/import_scene.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/quiet.h"
#include "tests/support/test_program.h"

namespace test_import_scene {

using namespace tactum;
using namespace std::chrono_literals;

namespace {

constexpr bool kSanitized =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#else
    false;
#endif

TriangleSoup grid(Index n) {
    TriangleSoup soup;
    for (Index i = 0; i <= n; ++i)
        for (Index k = 0; k <= n; ++k)
            soup.positions.emplace_back(i / 4096.0, k / 4096.0, double(i * k % 7) / 4096);
    for (Index i = 0; i < n; ++i)
        for (Index k = 0; k < n; ++k) {
            const Index a = i * (n + 1) + k, b = a + n + 1;
            soup.triangles.push_back({a, b, b + 1});
            soup.triangles.push_back({a, b + 1, a + 1});
        }
    return soup;
}

/// Findings without the one that says what this machine cannot do.
std::vector<std::string> sentencesOf(const LoadedScene& loaded) {
    std::vector<std::string> sentences;
    for (const Finding& finding : loaded.findings)
        if (finding.sentence.find("without the protection") == std::string::npos)
            sentences.push_back(finding.object + ": " + finding.sentence + "; " + finding.remedy);
    return sentences;
}

} // namespace

class TestImportScene : public QObject {
    Q_OBJECT

private slots:
    void givesWhatTheReaderGives() {
        for (const WrittenMesh& mesh : inEveryFormat(grid(5))) {
            const auto file = folder_.write(mesh.name, mesh.content);
            const auto direct = loadScene(file);
            auto imported = importScene(file);
            VERIFY_RESULT(imported);
            QCOMPARE(imported->scene.objects.size(), std::size_t(1));
            auto& geometry = imported->scene.objects[0].geometry;
            QVERIFY(*geometry == *direct->scene.objects[0].geometry);
            geometry = direct->scene.objects[0].geometry; // scenes compare what they share by its place
            QVERIFY2(imported->scene == direct->scene, mesh.name.c_str());
            QCOMPARE(sentencesOf(*imported), sentencesOf(*direct));
        }
    }

    void knowsOurOwnScenes() {
        const auto mesh = folder_.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const auto foreign = importScene(mesh);
        VERIFY_RESULT(foreign);
        QVERIFY(!foreign->ours);
        const auto file = folder_.path() / "own.glb";
        VERIFY_RESULT(saveScene(foreign->scene, file));
        const auto own = importScene(file);
        VERIFY_RESULT(own);
        QVERIFY(own->ours);
    }

    void errorsAreThoseOfTheReader() {
        folder_.write("broken.obj", "v 0 0 0\nf 1 2 3\n");
        for (const char* name : {"broken.obj", "missing.obj", "mesh.xyz"}) {
            const auto direct = loadScene(folder_.path() / name),
                       imported = importScene(folder_.path() / name);
            QVERIFY(!direct);
            QVERIFY(!imported);
            QCOMPARE(imported.error().text, direct.error().text);
            QCOMPARE(imported.error().kind, direct.error().kind);
        }
    }

    void readsWhatLiesBesideTheFileAndNothingElse() {
        folder_.write("red.mtl", "newmtl red\nKd 1 0 0\n");
        const auto inside = importScene(folder_.write("inside.obj", "mtllib red.mtl\nusemtl red\nv 0 0 0\n"
                                                                    "v 1 0 0\nv 0 1 0\nf 1 2 3\n"));
        VERIFY_RESULT(inside);
        QCOMPARE(inside->scene.objects[0].surfaces[0].colour, Eigen::Vector3f(1, 0, 0));
    }

    /// The program may have been started with any folder as its own.
    void aNameWithoutFolderIsFound() {
        const auto before = std::filesystem::current_path();
        folder_.write("here.off", asOff(grid(1)));
        std::filesystem::current_path(folder_.path());
        const auto imported = importScene("here.off");
        folder_.write("red.mtl", "newmtl red\nKd 1 0 0\n");
        folder_.write("red.obj", "mtllib red.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        const auto alone = importScene("red.obj"), dotted = importScene("./red.obj");
        std::filesystem::current_path(before);
        VERIFY_RESULT(imported);
        for (const auto* red : {&alone, &dotted}) // and what lies beside it
            QCOMPARE((*red)->scene.objects[0].surfaces[0].colour, Eigen::Vector3f(1, 0, 0));
    }

    void aLinkThatLeadsElsewhereIsFollowed() {
        FileFolder other;
        const auto file = other.write("real.off", asOff(grid(1)));
        std::filesystem::create_symlink(file, folder_.path() / "link.off");
        VERIFY_RESULT(importScene(folder_.path() / "link.off"));
    }

    void progressRisesToOne() {
        std::vector<double> fractions;
        Progress progress;
        progress.report = [&](double fraction) { fractions.push_back(fraction); };
        VERIFY_RESULT(importScene(folder_.write("grid.obj", asObj(grid(150))), progress));
        QCOMPARE_GT(fractions.size(), 2);
        QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
        QCOMPARE(fractions.back(), 1.0);
    }

    /// A file of many parts does not fill the line to the reading process.
    void progressIsSaidAHundredTimesAtMost() {
        std::string scene = "<X3D><Scene>";
        for (int i = 0; i < 1000; ++i)
            scene += "<Shape><Box/></Shape>";
        const auto file = folder_.write("boxes.x3d", scene + "</Scene></X3D>");
        int direct = 0, through = 0;
        Progress counted, progress;
        counted.report = [&](double) { ++direct; };
        VERIFY_RESULT(loadScene(file, counted));
        QCOMPARE_GT(direct, 1000);
        progress.report = [&](double) { ++through; };
        VERIFY_RESULT(importScene(file, progress));
        QCOMPARE_GT(through, 50);
        QCOMPARE_LE(through, 110);
    }

    void aReaderThatStopsIsOneLine_data() {
        QTest::addColumn<QString>("does");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("killed") << "killed"
                                << "was killed";
        QTest::newRow("crashes") << "crashes"
                                 << "crashed: Segmentation fault";
        QTest::newRow("loops") << "loops"
                               << "needed more than 1 s of the processor";
        QTest::newRow("sleeps") << "sleeps"
                                << "did not end within 3 s";
        QTest::newRow("mute") << "mute"
                              << "stopped answering";
        QTest::newRow("chatters") << "chatters"
                                  << "needed more than 1 s of the processor";
        QTest::newRow("fills") << "fills"
                               << "made more than 0.2 GiB of it";
        if (!kSanitized)
            QTest::newRow("eats") << "eats"
                                  << "needed more than 0.2 GiB";
        QTest::newRow("ends") << "ends"
                              << "ended without an answer";
        QTest::newRow("babbles") << "babbles"
                                 << "said what makes no sense";
        QTest::newRow("nothing") << "nothing"
                                 << "gave no scene";
        QTest::newRow("too much") << "too-much"
                                  << "gave no scene";
        QTest::newRow("no objects") << "no-objects"
                                    << "gave an empty scene";
    }
    void aReaderThatStopsIsOneLine() {
        QFETCH(QString, does);
        QFETCH(QString, sentence);
        const auto answer = hostile(does.toStdString());
        QVERIFY(!answer);
        const QString text = QString::fromStdString(answer.error().text);
        QVERIFY2(text.contains("the reader stopped (") && text.contains(sentence), qPrintable(text));
        QVERIFY(!text.contains('\n'));
    }

    void bytesThatLieAreRefused() {
        for (const char* does : {"lies", "zeros", "says-one-lives-on"}) {
            const auto answer = hostile(does);
            QVERIFY2(!answer, does);
            COMPARE_LACKS(answer.error().text, "\n");
        }
    }

    void wordsOfTheProcessAreMadePrintable() {
        const auto answer = hostile("escapes");
        QVERIFY(!answer);
        QCOMPARE(answer.error().text, std::string("red ?[31m and?a second line"));
    }

    void theRealReaderStopsAtItsLimitOfMemory() {
        if (kSanitized) QSKIP("a sanitizer needs more memory than any limit");
        const auto file = folder_.write("big.obj", asObj(grid(700)));
        ImportOptions options;
        options.limits = ImportLimits{std::uint64_t(96) << 20, 60s, 300s};
        const auto answer = importScene(file, {}, options);
        QVERIFY(!answer);
        COMPARE_CONTAINS(answer.error().text, "needed more than 0.1 GiB");
        VERIFY_RESULT(importScene(file));
    }

    void cancellingEndsItAtOnce() {
        auto quickest = 100000ms;
        for (int round = 0; round < 5; ++round) {
            std::atomic<bool> cancelled = false;
            Progress progress;
            progress.cancelled = &cancelled;
            std::chrono::steady_clock::time_point at;
            std::jthread person([&] {
                std::this_thread::sleep_for(50ms);
                at = std::chrono::steady_clock::now();
                cancelled = true;
            });
            ImportOptions options;
            options.worker = HOSTILE_WORKER;
            const auto answer = importScene(folder_.path() / "loops.obj", progress, options);
            person.join();
            QVERIFY(!answer);
            QCOMPARE(answer.error().text, std::string("cancelled"));
            quickest = std::min(quickest, std::chrono::duration_cast<std::chrono::milliseconds>(
                                              std::chrono::steady_clock::now() - at));
        }
        QVERIFY2(quickest < 200ms || test::mayBeBusy(), qPrintable(QString::number(quickest.count())));
    }

    void noProcessIsLeftBehind() {
        std::atomic<bool> cancelled = true;
        Progress progress;
        progress.cancelled = &cancelled;
        for (int round = 0; round < 20; ++round)
            importScene(folder_.write("a.off", asOff(grid(1))), progress);
        const auto children = [] {
            int count = 0;
            for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
                std::ifstream list(task.path() / "children");
                for (std::string child; list >> child;)
                    ++count;
            }
            return count;
        };
        QTRY_COMPARE(children(), 0);
    }

    void aProgramWithoutItsReaderSaysSo() {
        ImportOptions options;
        options.worker = folder_.path() / "nowhere";
        const auto answer = importScene(folder_.write("a.off", asOff(grid(1))), {}, options);
        QVERIFY(!answer);
        QCOMPARE(answer.error().kind, Error::Kind::Machine);
        COMPARE_CONTAINS(answer.error().text, "nowhere");
    }

    void hugeFilesMayUseMore() {
        QCOMPARE(limitsFor(1000).memory, std::uint64_t(4) << 30);
        QCOMPARE(limitsFor(std::uint64_t(1) << 30).memory, std::uint64_t(12) << 30);
        QCOMPARE(limitsFor(1000).processor, 60s);
        QCOMPARE(limitsFor(std::uint64_t(1) << 30).processor, 316s);
    }

    void costsLittle() {
        const auto file =
            folder_.write("four-million.stl",
                          asStlBinary(grid(qEnvironmentVariableIntValue("TACTUM_IMPORT_GRID") > 0
                                               ? Index(qEnvironmentVariableIntValue("TACTUM_IMPORT_GRID"))
                                               : 100)));
        const auto since = [](auto begin) {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        for (int round = 0; round < 2; ++round) { // TACTUM_IMPORT_GRID=1414 makes four million triangles
            auto begin = std::chrono::steady_clock::now();
            const auto direct = loadScene(file);
            const double here = since(begin);
            begin = std::chrono::steady_clock::now();
            const auto imported = importScene(file);
            qInfo("%zu triangles: %.2f s here, %.2f s there", triangleCount(direct->scene), here,
                  since(begin));
            QCOMPARE_EQ(imported->scene.objects.size(), direct->scene.objects.size());
        }
    }

private:
    Result<LoadedScene> hostile(const std::string& does) {
        ImportOptions options;
        options.worker = HOSTILE_WORKER;
        // A second of a busy machine takes long, and memory that is eaten there costs the processor, too.
        const bool busy = does == "loops" || does == "chatters";
        options.limits =
            ImportLimits{std::uint64_t(200) << 20, busy ? 1s : 30s, does == "sleeps" ? 3s : 120s};
        return importScene(folder_.path() / (does + ".obj"), {}, options);
    }

    FileFolder folder_;
};

TACTUM_TEST(TestImportScene)

} // namespace test_import_scene

#include "test_import_scene.moc"
