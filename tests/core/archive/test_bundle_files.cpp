// The files of a bundle and their manifest, packed and read with distrust. Wrong itself if readZip() gave
// what is not in the zip: test_zip_archive and test_hostile_zips hold that.
#include <fstream>

#include <QTemporaryDir>
#include <QTest>

#include "core/archive/bundle_files.h"
#include "core/archive/sha256.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_bundle_files {

using namespace tactum;
using namespace tactum::test;

namespace {

// FIPS 180-4's own example, and the sum of nothing.
constexpr const char* kSumOfAbc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* kSumOfNothing = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";

const std::vector<ZipEntry> kFiles{{"scene.glb", "abc"}, {"textures/a.png", ""}};

/// The manifest of kFiles, with other words in it.
std::string manifestWith(const std::string& from = "", const std::string& to = "") {
    const auto file = [](const char* name, int bytes, const char* sum) {
        return "    {\n      \"name\": \"" + std::string(name) +
               "\",\n      \"bytes\": " + std::to_string(bytes) + ",\n      \"sha256\": \"" + sum +
               "\"\n    }";
    };
    std::string text = "{\n  \"format\": \"Tactum bundle\",\n  \"version\": \"1.1\",\n  \"files\": [\n" +
                       file("scene.glb", 3, kSumOfAbc) + ",\n" + file("textures/a.png", 0, kSumOfNothing) +
                       "\n  ]\n}\n";
    if (const auto place = text.find(from); !from.empty()) text.replace(place, from.size(), to);
    return text;
}

std::string zipOf(const std::string& manifest, std::vector<ZipEntry> files = kFiles) {
    files.insert(files.begin() + 1, {"manifest.json", manifest}); // wherever it is
    return writeZip(files);
}

std::string faultOf(const std::string& zip) {
    const auto bundle = BundleFiles::open(zip);
    return bundle ? "none" : bundle.error().text;
}

} // namespace

class TestBundleFiles : public QObject {
    Q_OBJECT
private slots:
    void whatIsPackedIsOpened() {
        const std::string zip = packBundle(kFiles);
        QCOMPARE(faultOf(zip), "none");
        const auto bundle = BundleFiles::open(zip);
        QVERIFY(std::ranges::equal(bundle->all(), kFiles)); // without the manifest
        QCOMPARE(std::string(bundle->file("scene.glb")), "abc");
        QCOMPARE(std::string(bundle->file("textures/a.png")), "");
        QCOMPARE(std::string(bundle->file("manifest.json")), "");
        QCOMPARE(std::string(bundle->file("scene")), "");
        QCOMPARE(zip, packBundle(kFiles));
        QCOMPARE(faultOf(packBundle({})), "none");
    }

    void theManifestComesFirst() {
        const auto entries = readZip(packBundle(kFiles));
        QCOMPARE(entries->size(), 3u);
        QCOMPARE(entries->front().name, "manifest.json");
        QCOMPARE(entries->front().bytes, manifestWith());
        QVERIFY(std::equal(entries->begin() + 1, entries->end(), kFiles.begin()));
        QCOMPARE(faultOf(zipOf(manifestWith())), "none");
        QCOMPARE(faultOf(zipOf(manifestWith("1.1", "1.7"))), "none"); // a later one of the same kind
    }

    void isRefusedForItsReason_data() {
        QTest::addColumn<std::string>("zip");
        QTest::addColumn<std::string>("fault");
        const std::string notOurs = "its manifest.json is not that of a Tactum bundle; export it again",
                          later = "is a bundle of a later Tactum; update the program",
                          changed = "its scene.glb is not the file that was exported; copy the bundle again",
                          count = "has fewer files than its manifest says, or more; copy the bundle again",
                          unknown = "its scene.glb is not in the manifest; export the bundle again";
        const auto row = [](const char* name, const std::string& zip, const std::string& fault) {
            QTest::newRow(name) << zip << fault;
        };
        row("no manifest", writeZip(kFiles),
            "is a zip without a manifest.json, so no bundle; unpack it and open the model that is inside");
        row("a manifest that is no JSON", zipOf("{"), notOurs);
        row("a list", zipOf("[]"), notOurs);
        row("another format", zipOf(manifestWith("Tactum bundle", "Tactum")), notOurs);
        row("no format", zipOf(manifestWith("\"format\"", "\"form\"")), notOurs);
        row("no version", zipOf(manifestWith("\"version\"", "\"v\"")), notOurs);
        row("a number for a version", zipOf(manifestWith("\"1.1\"", "1.1")), notOurs);
        row("no files", zipOf(manifestWith("\"files\"", "\"file\"")), notOurs);
        row("a later kind", zipOf(manifestWith("1.1", "2.0")), later);
        row("a much later kind", zipOf(manifestWith("1.1", "11.1")), later);
        row("another byte", zipOf(manifestWith(), {{"scene.glb", "abd"}, kFiles[1]}), changed);
        row("a byte more", zipOf(manifestWith(), {{"scene.glb", "abcd"}, kFiles[1]}), changed);
        row("another length said", zipOf(manifestWith("\"bytes\": 3", "\"bytes\": 4")), changed);
        row("a length that is no number", zipOf(manifestWith("\"bytes\": 3", "\"bytes\": \"3\"")), changed);
        row("another sum said", zipOf(manifestWith("ba7816bf", "ca7816bf")), changed);
        row("a file that is missing", zipOf(manifestWith(), {kFiles[0]}), count);
        row("a file more", zipOf(manifestWith(), {kFiles[0], kFiles[1], {"c", ""}}), count);
        row("a file that nobody said", zipOf(manifestWith("scene.glb", "other.glb")), unknown);
        row("a name that is none", zipOf(manifestWith("\"scene.glb\"", "7")), unknown);
        row("an entry that is none",
            zipOf(R"({"format": "Tactum bundle", "version": "1.1", "files": [1, 2]})"), unknown);
    }

    void isRefusedForItsReason() {
        QFETCH(std::string, zip);
        QFETCH(std::string, fault);
        QCOMPARE(faultOf(zip), fault);
    }

    void whatIsNoZipIsRefused() {
        COMPARE_CONTAINS(QString::fromStdString(faultOf("abc")), "is no zip archive");
    }

    void laterBundlesAreKnown() {
        const auto laterOf = [](const std::string& manifest) {
            return laterBundle(zipOf(manifest)).value_or("none");
        };
        QCOMPARE(laterOf(manifestWith()), "none");
        QCOMPARE(laterOf(manifestWith("1.1", "1.99")), "none");
        QCOMPARE(laterOf(manifestWith("1.1", "2")), "2");
        QCOMPARE(laterOf(manifestWith("1.1", "11.1")), "11.1");
        QCOMPARE(laterOf(R"({"format": "Tactum bundle", "version": 3, "what": "else"})"), "3");
        QCOMPARE(laterOf(manifestWith("1.1", "2.0 of a later age than ours")), "2.0 of a later ag...");
        QCOMPARE(laterOf(manifestWith("1.1", "2\\n1")), "2?1");
        QCOMPARE(laterOf(R"({"format": "Tactum bundle"})"), "none");
        QCOMPARE(laterOf(R"({"format": "another", "version": "2"})"), "none");
        QCOMPARE(laterOf(R"({"version": "2"})"), "none");
        QCOMPARE(laterOf("[2]"), "none");
        QCOMPARE(laterOf("{"), "none");
        QVERIFY(!laterBundle(writeZip(kFiles)));
        QVERIFY(!laterBundle("abc"));
    }

    void fingerprintsOfFiles() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath(QStringLiteral("abc")).toStdString();
        QCOMPARE(fingerprintOf(file), ""); // there is none
        std::ofstream(file) << "abc";
        QCOMPARE(fingerprintOf(file), kSumOfAbc);
        std::ofstream(file, std::ios::trunc).flush();
        QCOMPARE(fingerprintOf(file), kSumOfNothing);
        QCOMPARE(fingerprintOf(folder.path().toStdString()), ""); // a folder
    }

    /// Of a zip that need not keep our rules.
    void oneFileOfAZip() {
        const std::string zip = writeZip(kFiles);
        const auto file = [&](const std::string& name, std::size_t most) {
            const auto read = fileInZip(zip, name, most);
            return read ? *read : "! " + read.error().text;
        };
        QCOMPARE(file("scene.glb", 3), "abc");
        QCOMPARE(file("Scene.GLB", 100), "abc");
        QCOMPARE(file("textures/a.png", 0), "");
        QCOMPARE(file("scene.glb", 2),
                 "! entry \"scene.glb\": is larger than 2 bytes; use another one, or make it again");
        QCOMPARE(file("a.png", 9), "! entry \"a.png\": is not there; use another one, or make it again");
        QCOMPARE(fileInZip("abc", "abc", 3).error().text,
                 "is no zip archive, or one that was cut off; use another one, or make it again");
    }
};

TACTUM_TEST(TestBundleFiles)

} // namespace test_bundle_files

#include "test_bundle_files.moc"
