// The recovery journal: whole at every moment, written only where it changed, honest about damage.
#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <sstream>

#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include "core/base/process_mark.h"
#include "core/files/gltf/write_gltf.h"
#include "core/files/journal.h"
#include "core/files/load_scene.h"
#include "tests/support/compare.h"
#include "tests/support/hand.h"
#include "tests/support/random_scene.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"
#include "tests/system/failing_disk.h"

namespace test_journal {

using namespace tactum;
using namespace tactum::test;
namespace fs = std::filesystem;

namespace {

std::string read(const fs::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

JournalEntry entryOf(int edits) {
    return {"/home/someone/a \xff model.obj", 1234567890123456789, 987654321, true, "model.obj", edits};
}

/// A journal that holds the first of two scenes, and what the second would make of it.
struct Desk {
    explicit Desk(Scene later) : second(std::move(later)) {
        if (!writeJournal(folder, entryOf(1), first)) qFatal("the journal cannot be written");
    }
    /// The scene that the journal holds by its bytes: 1, 2, or 0 for none of both.
    int held() const {
        const auto entry = readJournalEntry(folder);
        const auto file = unpackJournal(folder);
        if (!entry || !file) return 0;
        const bool isFirst = read(*file) == *glbOf(first), isSecond = read(*file) == *glbOf(second);
        fs::remove(*file);
        if (isFirst && *entry == entryOf(1)) return 1;
        return isSecond && *entry == entryOf(2) ? 2 : 0;
    }
    int shapeFiles() const {
        int count = 0;
        for (const auto& each : fs::directory_iterator(folder))
            count += each.path().filename().string().starts_with("shapes-");
        return count;
    }

    QTemporaryDir root;
    fs::path folder = fs::path(root.path().toStdString()) / "journal";
    Scene first = SceneDice(1).scene(), second;
};

Scene otherShapes() {
    return SceneDice(2).scene();
}
Scene otherNumbers() {
    Scene scene = SceneDice(1).scene();
    scene.objects.front().surfaces.front().material.stiffness *= 0.5;
    return scene;
}

} // namespace

class TestJournal : public QObject {
    Q_OBJECT

private slots:
    void givesBackWhatWasWritten();
    void anEditOfANumberWritesNoMeshAgain();
    void anyFailedCallLeavesTheOldOrTheNew_data();
    void anyFailedCallLeavesTheOldOrTheNew();
    void aPowerCutLeavesTheOldOrTheNew_data() { anyFailedCallLeavesTheOldOrTheNew_data(); }
    void aPowerCutLeavesTheOldOrTheNew();
    void aKillAtAnyMomentLeavesTheOldOrTheNew();
    void anyDamagedByteIsNoticed();
    void aRunIsToldFromEveryOther();
};

void TestJournal::givesBackWhatWasWritten() {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        QTemporaryDir root;
        const fs::path folder = fs::path(root.path().toStdString()) / "deep" / "journal";
        const Scene scene = SceneDice(seed).scene();
        VERIFY_RESULT(writeJournal(folder, entryOf(7), scene));
        const auto entry = readJournalEntry(folder);
        VERIFY_RESULT(entry);
        QVERIFY(*entry == entryOf(7));
        const auto file = unpackJournal(folder);
        VERIFY_RESULT(file);
        const auto loaded = loadScene(*file);
        VERIFY_RESULT(loaded);
        QCOMPARE(difference(loaded->scene, scene), std::string());
        QCOMPARE_EQ(*glbOf(loaded->scene), *glbOf(scene));
    }
}

void TestJournal::anEditOfANumberWritesNoMeshAgain() {
    // Some 30 MB of mesh; the numbers of a material are in small pictures at its end as well.
    Scene mesh = sceneOf(sheet(0.1, 350), Material{});
    Desk desk(otherNumbers());
    desk.first = mesh;
    VERIFY_RESULT(writeJournal(desk.folder, entryOf(1), desk.first));
    const int blocks = desk.shapeFiles();
    QCOMPARE_GE(blocks, 4);
    std::map<std::string, fs::file_time_type> before;
    for (const auto& each : fs::directory_iterator(desk.folder)) {
        fs::last_write_time(each.path(), fs::file_time_type::clock::now() - std::chrono::hours(1));
        before[each.path().filename()] = fs::last_write_time(each.path());
    }
    mesh.objects.front().surfaces.front().material.stiffness *= 0.5;
    VERIFY_RESULT(writeJournal(desk.folder, entryOf(2), desk.second = mesh));
    QCOMPARE(desk.held(), 2);
    int kept = 0;
    for (const auto& each : fs::directory_iterator(desk.folder)) {
        const auto old = before.find(each.path().filename());
        kept += old != before.end() && old->second == fs::last_write_time(each.path());
    }
    QCOMPARE(kept, blocks - 1);
    QCOMPARE(desk.shapeFiles(), blocks);
    // Another mesh takes the place of the old one, which does not stay.
    VERIFY_RESULT(writeJournal(desk.folder, entryOf(2), desk.second = otherShapes()));
    QCOMPARE(desk.held(), 2);
    QCOMPARE(desk.shapeFiles(), 1);
}

void TestJournal::anyFailedCallLeavesTheOldOrTheNew_data() {
    QTest::addColumn<bool>("shapes");
    QTest::newRow("numbers alone") << false;
    QTest::newRow("meshes as well") << true;
}

void TestJournal::anyFailedCallLeavesTheOldOrTheNew() {
    QFETCH(bool, shapes);
    for (const auto kind : {DiskFault::Kind::Fails, DiskFault::Kind::Stays})
        for (const int error : {ENOSPC, EIO}) {
            int failures = 0;
            for (int call = 0;; ++call) {
                Desk desk(shapes ? otherShapes() : otherNumbers());
                spoilDisk({kind, call, error});
                const auto written = writeJournal(desk.folder, entryOf(2), desk.second);
                const std::vector<std::string> names = healDisk();
                if (int(names.size()) <= call) break;
                const QByteArray place = QByteArray::number(call) + ' ' + names[std::size_t(call)].c_str();
                const int held = desk.held();
                QVERIFY2(held == 2 || (held == 1 && !written), place);
                failures += !written;
                // Once there is room again everything is as it should be, and nothing is left of the attempt.
                QVERIFY2(writeJournal(desk.folder, entryOf(2), desk.second), place);
                QCOMPARE(desk.held(), 2);
                QCOMPARE(desk.shapeFiles(), 1);
            }
            QCOMPARE_GE(failures, 5);
        }
}

void TestJournal::aPowerCutLeavesTheOldOrTheNew() {
    QFETCH(bool, shapes);
    for (const bool namesSurvive : {true, false})
        for (int call = 0, status = kPowerWasCut << 8; status != 0; ++call) {
            Desk desk(shapes ? otherShapes() : otherNumbers());
            const pid_t child = fork();
            if (child == 0) {
                spoilDisk({DiskFault::Kind::PowerCut, call, 0, namesSurvive}, desk.folder);
                _exit(writeJournal(desk.folder, entryOf(2), desk.second) ? 0 : 1);
            }
            waitpid(child, &status, 0);
            QVERIFY(status == 0 || WEXITSTATUS(status) == kPowerWasCut);
            QVERIFY2(desk.held() != 0, QByteArray::number(call) + (namesSurvive ? " with" : " without"));
        }
}

/// Writes the two scenes in turn for as long as the program lives, and says into `told` how long a save takes
/// once it has done each of them twice: the journal holds what it held before, and the first touch of each
/// page is over.
[[noreturn]] static void journalForEver(const Desk& desk, int first, int told) {
    QElapsedTimer timer;
    for (int i = first;; ++i) {
        if (i == first + 2) timer.start();
        if (i == first + 4) {
            const auto oneSave = timer.nsecsElapsed() / 2;
            if (::write(told, &oneSave, sizeof oneSave) != sizeof oneSave) _exit(1);
        }
        if (!writeJournal(desk.folder, entryOf(1 + i % 2), i % 2 == 0 ? desk.first : desk.second)) _exit(1);
    }
}

void TestJournal::aKillAtAnyMomentLeavesTheOldOrTheNew() {
    const int kills = test::repeats("TACTUM_KILLS", 200);
    Desk desk(otherShapes());
    std::minstd_rand random(1);
    int changed = 0, before = desk.held();
    for (int i = 0; i < kills; ++i) {
        std::array<int, 2> told{};
        QCOMPARE(pipe(told.data()), 0);
        const pid_t child = fork();
        if (child == 0) journalForEver(desk, before == 1, told[1]);
        close(told[1]);
        // Measured by the child: a save there may take many times as long as here.
        qint64 oneSave = 0; // ns
        QCOMPARE(::read(told[0], &oneSave, sizeof oneSave), ssize_t(sizeof oneSave));
        usleep(unsigned(random()) % unsigned(2 * oneSave / 1000));
        kill(child, SIGKILL);
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        close(told[0]);
        QVERIFY(WIFSIGNALED(status));
        const int held = desk.held();
        QVERIFY2(held != 0, QByteArray::number(i));
        changed += held != before;
        before = held;
    }
    qInfo("%d kills: the journal changed %d times", kills, changed);
    QCOMPARE_GT(changed, 0);
    QCOMPARE_LT(changed, kills);
}

void TestJournal::anyDamagedByteIsNoticed() {
    const Desk desk(otherNumbers());
    QCOMPARE(desk.held(), 1);
    for (const auto& each : fs::directory_iterator(desk.folder)) {
        const std::string whole = read(each.path());
        const std::size_t step = std::max<std::size_t>(1, whole.size() / 300);
        for (std::size_t at = 0; at < whole.size(); at += step) {
            std::string bytes = whole;
            bytes[at] = char(bytes[at] ^ 0x20);
            std::ofstream(each.path(), std::ios::binary) << bytes;
            const auto unpacked = unpackJournal(desk.folder);
            QVERIFY2(!unpacked && unpacked.error().kind == Error::Kind::Input,
                     QByteArray::number(qint64(at)));
            COMPARE_LACKS(unpacked.error().text, "\n");
        }
        for (const std::size_t length :
             {std::size_t(0), std::size_t(5), whole.size() / 2, whole.size() - 1}) {
            std::ofstream(each.path(), std::ios::binary) << whole.substr(0, length);
            QVERIFY(!unpackJournal(desk.folder));
        }
        fs::remove(each.path());
        QVERIFY(!unpackJournal(desk.folder));
        std::ofstream(each.path(), std::ios::binary) << whole;
        QCOMPARE(desk.held(), 1);
    }
}

void TestJournal::aRunIsToldFromEveryOther() {
    const auto now = fs::file_time_type::clock::now(), longAgo = now - std::chrono::hours(1);
    const ProcessMark own = ownMark();
    QCOMPARE_EQ(own.pid, std::uint64_t(getpid()));
    QCOMPARE_GT(own.began, 0);
    QVERIFY(!own.boot.empty());
    QVERIFY(!own.space.empty());
    QVERIFY(markNamed(nameOf(own)) == own);
    QVERIFY(!markNamed("damaged"));
    QVERIFY(!markNamed(nameOf(own) + "_1"));
    QVERIFY(!markNamed("a_b_c_d_e"));
    QVERIFY(!hasEnded(own, longAgo)); // a run that does nothing for an hour goes on
    ProcessMark reused = own;
    reused.began -= 1; // the id of an ended process was given again
    QVERIFY(hasEnded(reused, now));
    ProcessMark restarted = own;
    restarted.boot = "0badcafe";
    QVERIFY(hasEnded(restarted, now));
    for (ProcessMark elsewhere : {own, own}) {
        elsewhere.host = "another-machine";
        QVERIFY(!hasEnded(elsewhere, now));
        QVERIFY(hasEnded(elsewhere, longAgo));
    }
    ProcessMark contained = own;
    contained.space = "pid4711";
    contained.pid = 1;
    QVERIFY(!hasEnded(contained, now));
    QVERIFY(hasEnded(contained, longAgo));
    // Killed, and not yet collected by its parent.
    const pid_t child = fork();
    if (child == 0) pause();
    ProcessMark died = own;
    died.pid = std::uint64_t(child);
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    for (int field = 1; field <= 22; ++field) {
        std::string text;
        stat >> text;
        if (field == 22) died.began = std::stoull(text);
    }
    QVERIFY(!hasEnded(died, longAgo));
    kill(child, SIGKILL);
    siginfo_t ended{};
    waitid(P_PID, id_t(child), &ended, WEXITED | WNOWAIT);
    QVERIFY(hasEnded(died, now));
    waitpid(child, nullptr, 0);
    QVERIFY(hasEnded(died, now));
}

TACTUM_TEST(TestJournal)

} // namespace test_journal

#include "test_journal.moc"
