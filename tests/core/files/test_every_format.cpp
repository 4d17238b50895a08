// What holds for every format alike: no face is lost, nothing broken crashes, errors are one useful line.
#include <clocale>
#include <locale>
#include <random>
#include <thread>

#include <QTest>
#include <sys/stat.h>

#include "core/base/text.h"
#include "core/files/source.h"
#include "core/files/tell_format.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_every_format {

using namespace tactum;

namespace {

/// Triangles over few vertices: edges with many triangles, duplicates, segments, points.
TriangleSoup randomSoup(unsigned seed) {
    std::mt19937 random(seed);
    TriangleSoup soup;
    for (int i = 0; i < 12; ++i) {
        const auto coordinate = [&] { return double(int(random() % 2048) - 1024) / 4096; };
        const double x = coordinate(), y = coordinate();
        soup.positions.emplace_back(x, y, coordinate());
    }
    for (int i = 0; i < 60; ++i) {
        const auto corner = [&] { return Index(random() % 12); };
        const Index a = corner(), b = corner();
        soup.triangles.push_back({a, b, corner()});
    }
    return soup;
}

/// A triangle as the set of the places that it covers.
using Places = std::array<std::array<double, 3>, 3>;

std::vector<Places> placesOf(const TriangleSoup& soup) {
    std::vector<Places> all;
    for (const auto& t : soup.triangles) {
        Places places;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = soup.positions[t[i]];
            places[i] = {p.x(), p.y(), p.z()};
        }
        std::sort(places.begin(), places.end());
        if (places[0] == places[1]) places[1] = places[2]; // a segment repeats either end
        all.push_back(places);
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::string told(const std::string& file) {
    return std::string(toldEnding(file, file.size()));
}

bool isOneLine(const std::string& text) {
    return !text.empty() && text.find('\n') == std::string::npos;
}

} // namespace

class TestEveryFormat : public QObject {
    Q_OBJECT

private slots:
    // What comes by a pipe has no name.
    void theFirstBytesTellTheFormat() {
        TriangleSoup soup = randomSoup(1);
        for (const WrittenMesh& mesh : inEveryFormat(soup)) {
            const std::string ending = mesh.name.substr(mesh.name.rfind('.') + 1);
            QCOMPARE(told(mesh.content), ending);
        }
        QCOMPARE(told("\xEF\xBB\xBF\n <?xml version='1.0'?>\n<X3D>"), "x3d");
        QCOMPARE(told("\n  # a comment\n"), "obj");
        for (const std::string& nothing :
             {std::string("<html>"), std::string("v 0 0 0\0", 8), std::string("y\ny\ny\n"), std::string()})
            QCOMPARE(told(nothing), "");
    }

    /// How much of a pipe has to be read at most.
    void aHeadMaySayHowLongTheFileIs() {
        TriangleSoup soup = randomSoup(1);
        for (const WrittenMesh& mesh : inEveryFormat(soup)) {
            const auto size = announcedSize(mesh.content);
            QVERIFY2(!size || *size == mesh.content.size(), mesh.name.c_str());
            if (mesh.name.ends_with(".glb")) QVERIFY(size);
        }
        QCOMPARE(announcedSize(std::string(5000, '\0')).value_or(0), std::uint64_t(84));
        QVERIFY(!announcedSize("v 0 0 0\n"));
    }

    void aFaceOfTooManyCornersIsRefused() {
        std::string ring = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf", off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n200000";
        std::string ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                          "property float z\nelement face 1\nproperty list int int vertex_indices\n"
                          "end_header\n0 0 0\n1 0 0\n0 1 0\n200000";
        for (int i = 0; i < 200'000; ++i) {
            ring += " " + std::to_string(i % 3 + 1);
            off += " " + std::to_string(i % 3);
            ply += " " + std::to_string(i % 3);
        }
        for (const auto& [name, content] : {std::pair{"a.obj", ring}, {"a.off", off}, {"a.ply", ply}}) {
            const auto loaded = folder_.load(name, content + "\n");
            QVERIFY2(!loaded, name);
            COMPARE_CONTAINS(loaded.error().text, "a face has more than 100000 corners; cut it");
        }
    }

    void noFaceOfARandomSoupIsLost() {
        for (unsigned seed = 0; seed < 40; ++seed) {
            const TriangleSoup soup = randomSoup(seed);
            for (const WrittenMesh& mesh : inEveryFormat(soup)) {
                const auto loaded = folder_.load(mesh.name, mesh.content);
                VERIFY_RESULT(loaded);
                QCOMPARE(loaded->scene.objects.size(), std::size_t(1));
                QVERIFY2(placesOf(*loaded->scene.objects[0].geometry) == placesOf(soup), mesh.name.c_str());
            }
        }
    }

    void soupsKeepTheirContract() {
        for (const WrittenMesh& mesh : inEveryFormat(randomSoup(7))) {
            const auto loaded = folder_.load(mesh.name, mesh.content);
            VERIFY_RESULT(loaded);
            const SceneObject& object = loaded->scene.objects[0];
            QCOMPARE(object.geometry->surfaceOf.size(), object.geometry->triangles.size());
            for (Index surface : object.geometry->surfaceOf)
                QCOMPARE_LT(surface, object.surfaces.size());
            for (const auto& t : object.geometry->triangles) {
                QCOMPARE_LT(std::max({t[0], t[1], t[2]}), object.geometry->positions.size());
                const bool flat = t[0] == t[1] || t[1] == t[2] || t[0] == t[2];
                if (flat) QCOMPARE_EQ(t[1], t[2]); // segments and points repeat the last corner
            }
        }
    }

    void windingIsKept() {
        TriangleSoup soup;
        soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        soup.triangles = {{0, 1, 2}};
        for (const WrittenMesh& mesh : inEveryFormat(soup)) {
            const auto loaded = folder_.load(mesh.name, mesh.content);
            VERIFY_RESULT(loaded);
            const TriangleSoup& back = *loaded->scene.objects[0].geometry;
            const auto at = [&](std::size_t i) { return back.positions[back.triangles[0][i]]; };
            QCOMPARE_GT((at(1) - at(0)).cross(at(2) - at(0)).z(), 0);
        }
    }

    /// A decimal comma in the user's locale, of C and of C++, must not change what a file says.
    void numbersDoNotDependOnTheLocale() {
        struct Comma : std::numpunct<char> {
            char do_decimal_point() const override { return ','; }
        };
        for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8"})
            if (std::setlocale(LC_ALL, name)) break; // where one is installed
        std::locale::global(std::locale(std::locale(), new Comma));
        const TriangleSoup soup = randomSoup(3);
        for (const WrittenMesh& mesh : inEveryFormat(soup)) {
            const auto loaded = folder_.load(mesh.name, mesh.content);
            VERIFY_RESULT(loaded);
            QVERIFY(placesOf(*loaded->scene.objects[0].geometry) == placesOf(soup));
        }
        std::locale::global(std::locale::classic());
    }

    /// 300 files of each format with changed, lost and added bytes: an answer each time, never a crash.
    void mutatedFilesAreAnswered() {
        std::mt19937 random(20010);
        for (const WrittenMesh& mesh : inEveryFormat(randomSoup(1)))
            for (int round = 0; round < 300; ++round) {
                std::string content = mesh.content;
                for (unsigned k = 1 + random() % 6; k > 0 && !content.empty(); --k)
                    mutate(content, random);
                checkAnswer(folder_.load(mesh.name, content), content.size());
            }
    }

    void everyTruncationIsAnswered() {
        TriangleSoup soup = randomSoup(2);
        soup.triangles.resize(5);
        for (const WrittenMesh& mesh : inEveryFormat(soup))
            for (std::size_t size = 1; size < mesh.content.size(); size += 1 + mesh.content.size() / 150)
                checkAnswer(folder_.load(mesh.name, mesh.content.substr(0, size)), size);
    }

    void filesThatAreNoFilesAreRefusedInOneLine_data() {
        QTest::addColumn<QString>("ending");
        for (const std::string& ending : readableEndings())
            QTest::newRow(ending.c_str()) << QString::fromStdString(ending);
    }
    void filesThatAreNoFilesAreRefusedInOneLine() {
        QFETCH(QString, ending);
        const std::string suffix = "." + ending.toStdString();
        refused(loadScene(folder_.path() / ("missing" + suffix)), "no such file");
        std::filesystem::create_directory(folder_.path() / ("folder" + suffix));
        refused(loadScene(folder_.path() / ("folder" + suffix)), "is a folder");
        refused(folder_.load("empty" + suffix, ""), "is empty");
        refused(folder_.load("zeros" + suffix, std::string(4000, '\0')), "");
        refused(folder_.load("words" + suffix, "nothing of this kind\nis in here\n"), "");
    }

    /// What a file names is found in its folder and nowhere else; also an absolute path that happens to lead
    /// there is none of its references, nor is one that ends in its middle.
    void aReferenceStaysInItsFolder() {
        namespace fs = std::filesystem;
        const fs::path home = folder_.path() / "home";
        fs::create_directories(home / "parts");
        fs::create_directories(folder_.path() / "homely");
        for (const char* file : {"home/parts/a.bin", "homely/a.bin", "outside.bin"})
            folder_.write(file, "some bytes");
        fs::create_symlink(home / "parts" / "a.bin", home / "in");
        fs::create_symlink(folder_.path() / "outside.bin", home / "out");
        const std::string file = fs::canonical(home / "parts" / "a.bin").string();
        for (const std::string& reference :
             {std::string("parts/a.bin"), std::string("./parts/../parts//a.bin"), std::string("in")})
            QCOMPARE(insideFolder(home, reference).string(), file);
        for (const std::string& reference :
             {file, (home / "parts" / "a.bin").string(), std::string("parts/a.bin\0", 12),
              std::string("parts/a.bin\0.png", 16), std::string("../outside.bin"),
              std::string("../homely/a.bin"), std::string("../home/../outside.bin"), std::string("out"),
              std::string("parts"), std::string("."), std::string(), std::string("gone.bin")}) {
            const std::string found = insideFolder(home, reference).string();
            QVERIFY2(found.empty(), (inQuotes(reference) + " led to " + found).c_str());
        }
        // Without a folder it is the current one; where there is none nothing is taken from there.
        const fs::path current = fs::current_path();
        fs::current_path(home / "parts");
        const std::string here = insideFolder("", "a.bin").string(),
                          nowhere = insideFolder(folder_.path() / "nowhere", "a.bin").string();
        fs::current_path(current);
        QCOMPARE(here, file);
        QCOMPARE(nowhere, std::string());
    }

    void aFileAsLargeAsMayBeIsReadWhole() {
        const std::string content = "ten bytes\n";
        const auto file = folder_.write("ten.obj", content);
        QCOMPARE(std::string(Source::open(file, content.size()).bytes()), content);
        try {
            Source::open(file, content.size() - 1);
            QFAIL("a byte more than may be was read");
        } catch (const ReadFault& fault) {
            const std::string& text = fault.error.text;
            QVERIFY2(text.find("has 10 bytes, more than the 9") != std::string::npos, text.c_str());
        }
    }

    /// Somebody cuts the file short after the first 8 MiB were read.
    void aFileThatEndsWhileItIsReadIsGivenUp() {
        constexpr std::uint64_t kBlock = 8 << 20;
        const auto file = folder_.write("long.obj", "");
        std::filesystem::resize_file(file, kBlock + 1000);
        Progress progress;
        progress.report = [&](double) { std::filesystem::resize_file(file, kBlock); };
        try {
            Source::open(file, 2 * kBlock, progress);
            QFAIL("it was read to an end that is not there");
        } catch (const ReadFault& fault) {
            const std::string& text = fault.error.text;
            QVERIFY2(text.find("stopped being readable") != std::string::npos, text.c_str());
        }
    }

    /// A pipe is read where that is wanted, to its end and no farther than may be; else nobody waits for it.
    void aPipeIsReadToItsEnd() {
        const auto pipe = folder_.path() / "pipe.csv";
        QCOMPARE(mkfifo(pipe.c_str(), 0600), 0);
        const auto read = [&](const std::string& said, std::uint64_t limit) -> std::string {
            std::jthread writer([&] { std::ofstream(pipe, std::ios::binary) << said; });
            try {
                return std::string(Source::openFileOrPipe(pipe, limit).bytes());
            } catch (const ReadFault& fault) {
                return fault.error.text;
            }
        };
        const std::string ten = "ten bytes\n";
        QCOMPARE(read(ten, 10), ten);
        const std::string tooMuch = read(ten, 9), nothing = read("", 9);
        QVERIFY2(tooMuch.find("has 10 bytes, more than the 9") != std::string::npos, tooMuch.c_str());
        QVERIFY2(nothing.find("nothing came through the pipe") != std::string::npos, nothing.c_str());
        try {
            Source::open(pipe, 10);
            QFAIL("a pipe was waited for");
        } catch (const ReadFault& fault) {
            const std::string& text = fault.error.text;
            QVERIFY2(text.find("cannot be read as a file") != std::string::npos, text.c_str());
        }
    }

    void placesAreNamedByTheirLine() {
        const Source source = Source::ofBytes("a.obj", "one\ntwo\n\nfour");
        const char* first = source.bytes().data();
        const std::pair<int, std::size_t> places[] = {{0, 1}, {3, 1}, {4, 2}, {8, 3}, {9, 4}, {13, 4}};
        for (const auto& [at, line] : places)
            QCOMPARE(source.lineAt(first + at), line);
    }

    void archivesAndPicturesAreNamedForWhatTheyAre() {
        for (const std::string& ending : readableEndings()) {
            refused(folder_.load("packed." + ending, "PK\x03\x04 and more"),
                    ending == "zip" || ending == "tactum" ? "zip"
                    : ending == "3mf"                     ? "is no zip archive" // it is one by right
                                                          : "is a ZIP archive; unpack it");
            refused(folder_.load("packed." + ending, "\x1f\x8b\x08 and more"), "is compressed by gzip");
            refused(folder_.load("photo." + ending, "\xFF\xD8\xFF\xE0 and more"), "is a JPEG picture");
        }
    }

    /// As it was given, so that one of several files of a name is found.
    void errorsNameThePath() {
        refused(folder_.load("broken.obj", "v 0 0 0\nf 1 2 3\n"),
                (folder_.path() / "broken.obj:2: ").string());
        refused(folder_.load("mesh.xyz", "1 2 3\n"), (folder_.path() / "mesh.xyz: ").string());
    }

    void everyFindingHasARemedy() {
        const auto check = [](const Result<LoadedScene>& loaded) {
            VERIFY_RESULT(loaded);
            QVERIFY(!loaded->findings.empty());
            for (const Finding& finding : loaded->findings)
                QVERIFY2(!finding.remedy.empty(), finding.sentence.c_str());
        };
        for (unsigned seed = 0; seed < 10; ++seed)
            for (const WrittenMesh& mesh : inEveryFormat(randomSoup(seed)))
                check(folder_.load(mesh.name, mesh.content));
        check(folder_.load("two.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 5\nv 1 0 5\nv 0 1 5\n"
                                      "f 1 2 3\nf 4 5 6\n"));
    }

    void anUnknownEndingNamesTheKnownOnes() {
        refused(folder_.load("mesh.xyz", "1 2 3\n"), "obj, ply, stl, off, gltf, glb");
    }

    /// At the next look: what reports once more after that has gone on working.
    void cancelledWorkStops() {
        for (const WrittenMesh& mesh : inEveryFormat(bigGrid())) {
            std::atomic<bool> cancelled = false;
            int reports = 0;
            Progress progress;
            progress.cancelled = &cancelled;
            progress.report = [&](double) {
                cancelled = true;
                ++reports;
            };
            const auto loaded = loadScene(folder_.write(mesh.name, mesh.content), progress);
            QVERIFY2(!loaded && loaded.error().text == "cancelled", mesh.name.c_str());
            QCOMPARE(reports, 1);
        }
    }

    void progressRisesToOne() {
        for (const WrittenMesh& mesh : inEveryFormat(bigGrid())) {
            std::vector<double> fractions;
            Progress progress;
            progress.report = [&](double fraction) { fractions.push_back(fraction); };
            VERIFY_RESULT(loadScene(folder_.write(mesh.name, mesh.content), progress));
            QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
            QVERIFY(!fractions.empty());
            QCOMPARE(fractions.back(), 1.0);
        }
    }

private:
    static void mutate(std::string& content, std::mt19937& random) {
        const std::size_t at = random() % content.size();
        static const char* words[] = {
            "-1", "99999999999999999999", "nan", "1e999", "\xff\xff\xff\xff", "\n", "\"", "[[", "0"};
        switch (random() % 5) {
        case 0:
            content[at] = char(random());
            break;
        case 1:
            content[at] = char(content[at] ^ (1 << random() % 8));
            break;
        case 2:
            content.erase(at, random() % 40);
            break;
        case 3:
            content.insert(at, words[random() % std::size(words)]);
            break;
        default:
            content.insert(at, content.substr(random() % content.size(), random() % 60));
        }
    }

    /// Either a sound scene or one line that says why not.
    static void checkAnswer(const Result<LoadedScene>& loaded, std::size_t bytes) {
        if (!loaded) {
            QVERIFY2(isOneLine(loaded.error().text), loaded.error().text.c_str());
            return;
        }
        for (const SceneObject& object : loaded->scene.objects) {
            QCOMPARE_LE(object.geometry->triangles.size(), bytes);
            for (const Vec3& p : object.geometry->positions) {
                QVERIFY(p.allFinite());
                QCOMPARE_LE(p.cwiseAbs().maxCoeff(), 1e6);
            }
            for (const auto& t : object.geometry->triangles)
                QCOMPARE_LT(std::max({t[0], t[1], t[2]}), object.geometry->positions.size());
        }
    }

    static void refused(const Result<LoadedScene>& loaded, const std::string& part) {
        QVERIFY(!loaded);
        QVERIFY2(isOneLine(loaded.error().text), loaded.error().text.c_str());
        COMPARE_CONTAINS(loaded.error().text, part);
    }

    /// Large enough for every loop to look at its progress.
    static const TriangleSoup& bigGrid() {
        static const TriangleSoup soup = [] {
            TriangleSoup grid;
            constexpr Index n = 250;
            for (Index i = 0; i <= n; ++i)
                for (Index k = 0; k <= n; ++k)
                    grid.positions.emplace_back(i / 256.0, k / 256.0, 0);
            for (Index i = 0; i < n; ++i)
                for (Index k = 0; k < n; ++k) {
                    const Index a = i * (n + 1) + k, b = a + n + 1;
                    grid.triangles.push_back({a, b, b + 1});
                    grid.triangles.push_back({a, b + 1, a + 1});
                }
            return grid;
        }();
        return soup;
    }

    FileFolder folder_;
};

TACTUM_TEST(TestEveryFormat)

} // namespace test_every_format

#include "test_every_format.moc"
