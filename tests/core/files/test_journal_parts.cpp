// The recovery journal as files: an edit of a number writes numbers alone, and every damaged part is noticed.
#include <fstream>
#include <set>
#include <sstream>

#include <QTest>

#include "core/archive/sha256.h"
#include "core/files/journal.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_journal_parts {

using namespace tactum;
using namespace tactum::test;
namespace fs = std::filesystem;

namespace {

/// A strip of so many corners; of 200,000 it takes several blocks.
Scene sceneOf(double stiffness = 500, Index corners = 4000) {
    auto soup = std::make_shared<TriangleSoup>();
    for (Index i = 0; i < corners; ++i) {
        soup->positions.emplace_back(1e-3 * i, 1e-3 * (i % 7), 1e-3 * (i % 11));
        if (i < 2) continue;
        soup->triangles.push_back({i - 2, i - 1, i});
        soup->surfaceOf.push_back(0);
    }
    Scene scene;
    SceneObject object;
    object.name = "strip";
    object.geometry = soup;
    object.surfaces.resize(1);
    object.surfaces[0].material.stiffness = stiffness;
    scene.add(object);
    return scene;
}

JournalEntry entryOf() {
    return {"/home/a/strip.obj", 123456789, 4321, true, "strip.obj", 1700000000};
}

std::string read(const fs::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

} // namespace

class TestJournalParts : public QObject {
    Q_OBJECT

    FileFolder root_;
    fs::path folder_;
    int count_ = 0;

    /// The parts with meshes and images.
    std::set<fs::path> shapes() {
        std::set<fs::path> found;
        for (const auto& each : fs::directory_iterator(folder_))
            if (each.path().filename().string().starts_with("shapes-")) found.insert(each.path());
        return found;
    }

private slots:
    void init() { folder_ = root_.path() / ("journal-" + std::to_string(count_++)); }

    void theSceneAndItsEntryComeBack() {
        QVERIFY(!holdsJournal(folder_));
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        QVERIFY(holdsJournal(folder_));
        const auto entry = readJournalEntry(folder_);
        VERIFY_RESULT(entry);
        QVERIFY(*entry == entryOf());
        const auto file = unpackJournal(folder_);
        VERIFY_RESULT(file);
        QCOMPARE(file->parent_path(), folder_);
        const auto loaded = loadScene(*file);
        VERIFY_RESULT(loaded);
    }

    void theHistoryComesBackAndSharesTheMesh() {
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        const Scene now = loadScene(*unpackJournal(folder_))->scene; // as readers make it
        const auto with = [&](double stiffness) {
            Scene scene = now;
            scene.objects[0].surfaces[0].material.stiffness = stiffness;
            scene.objects[0].sets = {{"rim", {{0, Index(stiffness)}}}};
            return scene;
        };
        const SceneHistory history{{{"cut", sceneOf(100, 50)}, {"softer", with(300)}},
                                   {{"harder", with(900)}}};
        VERIFY_RESULT(writeJournal(folder_, entryOf(), now, history));
        const auto loaded = loadScene(*unpackJournal(folder_));
        VERIFY_RESULT(loaded);
        const auto back = readJournalHistory(folder_, loaded->scene);
        VERIFY_RESULT(back);
        QCOMPARE(back->done.size(), 2u);
        QCOMPARE(back->undone.size(), 1u);
        QCOMPARE(back->done[1].text, "softer");
        QCOMPARE(back->done[1].scene.objects[0].surfaces[0].material.stiffness, 300.0);
        QCOMPARE(back->undone[0].scene.objects[0].surfaces[0].material.stiffness, 900.0);
        QCOMPARE(back->undone[0].scene.objects[0].sets, with(900).objects[0].sets);
        QCOMPARE(back->done[0].scene.objects[0].sets.size(), 0u);
        QVERIFY(back->done[1].scene.objects[0].geometry == loaded->scene.objects[0].geometry);
        QCOMPARE(back->done[0].scene.objects[0].geometry->positions.size(), 50u);
    }

    /// What does not fit is what is farthest from the present.
    void aLongHistoryIsCutAtItsEnds() {
        SceneHistory history;
        for (int i = 0; i < 6; ++i)
            history.done.push_back({std::to_string(i), sceneOf(i + 1, 100'000)}); // 4.4 MB each
        const Scene now = sceneOf();
        VERIFY_RESULT(writeJournal(folder_, entryOf(), now, history));
        QCOMPARE_LT(fs::file_size(folder_ / "journal"), std::uintmax_t(17) << 20);
        const auto back = readJournalHistory(folder_, loadScene(*unpackJournal(folder_))->scene);
        VERIFY_RESULT(back);
        QCOMPARE(back->done.size(), 3u);
        QCOMPARE(back->done.back().text, "5");
    }

    void aJournalWithoutAHistoryIsRead() {
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        const std::string now = read(folder_ / "journal");
        constexpr std::size_t kMagicLength = 17, kPrint = 64, kEmptyHistory = 8;
        const std::string rest =
            now.substr(kMagicLength + kPrint, now.size() - kMagicLength - kPrint - kEmptyHistory);
        std::ofstream(folder_ / "journal", std::ios::binary) << "tactum journal 1\n" << sha256(rest) << rest;
        const auto loaded = loadScene(*unpackJournal(folder_));
        VERIFY_RESULT(loaded);
        const auto back = readJournalHistory(folder_, loaded->scene);
        VERIFY_RESULT(back);
        QCOMPARE(back->size(), 0u);
    }

    void ofAJournalWhoseStepsHaveAnotherFormTheSceneIsReadAlone_data() {
        QTest::addColumn<char>("version");
        QTest::newRow("before groups") << '2';
        QTest::newRow("before the reach of hands") << '3';
    }
    void ofAJournalWhoseStepsHaveAnotherFormTheSceneIsReadAlone() {
        QFETCH(char, version);
        SceneHistory history;
        history.done.push_back({"softer", sceneOf(600)});
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf(), history));
        std::string bytes = read(folder_ / "journal");
        bytes[bytes.find('\n') - 1] = version;
        std::ofstream(folder_ / "journal", std::ios::binary) << bytes;
        const auto loaded = loadScene(*unpackJournal(folder_));
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects.size(), sceneOf().objects.size());
        const auto back = readJournalHistory(folder_, loaded->scene);
        VERIFY_RESULT(back);
        QCOMPARE(back->size(), 0u);
    }

    /// What an edit of a number costs is its numbers, and the last block: meshes lie in files that stay.
    void anEditWritesNumbersAlone() {
        constexpr Index kLarge = 200'000;
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf(500, kLarge)));
        const std::set<fs::path> before = shapes();
        QCOMPARE_GT(before.size(), 1u);
        std::uintmax_t bytes = 0;
        const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
        for (const fs::path& shape : before) {
            bytes += fs::file_size(shape);
            fs::last_write_time(shape, old);
        }
        QCOMPARE_GT(bytes, 200'000u * 24);
        QCOMPARE_LT(fs::file_size(folder_ / "journal"), 20'000u);
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf(600, kLarge)));
        const std::set<fs::path> after = shapes();
        QCOMPARE(after.size(), before.size());
        std::size_t stay = 0;
        for (const fs::path& shape : after) {
            QCOMPARE(before.contains(shape), fs::last_write_time(shape) == old);
            stay += before.contains(shape);
        }
        QCOMPARE(stay, before.size() - 1);
        const auto loaded = loadScene(*unpackJournal(folder_));
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects[0].surfaces[0].material.stiffness, 600.0);
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf(600))); // another mesh: the old one goes
        QCOMPARE(shapes().size(), 1u);
        QVERIFY(!before.contains(*shapes().begin()));
        QVERIFY(!fs::exists(folder_ / "scene.glb")); // what was put together before
    }

    void aShapeThatWasCutIsWrittenAgain() {
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        const fs::path shape = *shapes().begin();
        const std::string whole = read(shape);
        fs::resize_file(shape, whole.size() - 1);
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        QCOMPARE(read(shape), whole);
    }

    void damageIsNoticed() {
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        const fs::path numbers = folder_ / "journal", shape = *shapes().begin();
        for (const fs::path& file : {numbers, shape}) {
            const std::string whole = read(file);
            for (const std::size_t at :
                 {std::size_t(0), std::size_t(30), whole.size() / 2, whole.size() - 1}) {
                std::string bad = whole;
                bad[at] = char(bad[at] ^ 1);
                std::ofstream(file, std::ios::binary) << bad;
                const auto unpacked = unpackJournal(folder_);
                QVERIFY(!unpacked);
                QCOMPARE(unpacked.error().kind, Error::Kind::Input);
                COMPARE_CONTAINS(unpacked.error().text, "the journal is damaged");
                QCOMPARE(readJournalEntry(folder_).has_value(), file == shape);
            }
            std::ofstream(file, std::ios::binary) << whole;
        }
        VERIFY_RESULT(unpackJournal(folder_));
        std::ofstream(numbers, std::ios::binary) << "";
        QVERIFY(!readJournalEntry(folder_));
        fs::remove(numbers);
        const auto none = readJournalEntry(folder_);
        QVERIFY(!none);
        COMPARE_CONTAINS(none.error().text, "is missing");
        QVERIFY(!holdsJournal(folder_));
    }

    void aSignOfLifeIsTheLastWrite() {
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
        fs::last_write_time(folder_ / "journal", old);
        QVERIFY(lastSignOf(folder_) == old);
        touchJournal(folder_);
        QVERIFY(lastSignOf(folder_) > old + std::chrono::minutes(59));
        fs::remove(folder_ / "journal");
        touchJournal(folder_); // no harm
        fs::last_write_time(folder_, old);
        QVERIFY(lastSignOf(folder_) == old); // of the folder, then
    }

    void cancellingLeavesTheOneBefore() {
        VERIFY_RESULT(writeJournal(folder_, entryOf(), sceneOf()));
        const std::atomic<bool> cancelled = true;
        QVERIFY(!writeJournal(folder_, entryOf(), sceneOf(600), {}, {{}, &cancelled}));
        const auto loaded = loadScene(*unpackJournal(folder_));
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->scene.objects[0].surfaces[0].material.stiffness, 500.0);
    }
};

TACTUM_TEST(TestJournalParts)

} // namespace test_journal_parts

#include "test_journal_parts.moc"
