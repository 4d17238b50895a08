// A save that is interrupted in any way leaves the old file or the new one.
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <random>
#include <sstream>

#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include "core/base/atomic_file.h"
#include "tests/support/compare.h"
#include "tests/support/repeats.h"
#include "tests/support/test_program.h"
#include "tests/system/failing_disk.h"

namespace test_atomic_save {

using namespace tactum;
using namespace tactum::test;
namespace fs = std::filesystem;

namespace {

/// The n-th version of a file, of another length than the others; every byte depends on n and its place.
std::string version(unsigned n, std::size_t size) {
    std::string bytes(size + 1001 * n, '\0');
    std::uint32_t state = 2654435761u * (n + 1);
    for (char& byte : bytes)
        byte = char((state = 1664525 * state + 1013904223) >> 24);
    return bytes;
}

std::string read(const fs::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

void write(const fs::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
}

/// A folder with a file in it that is saved, and what was there before.
struct Desk {
    enum class Before { Nothing, File, Backups, Link };

    explicit Desk(Before before) {
        if (before == Before::Nothing)
            old.clear();
        else
            write(file, old);
        if (before == Before::Backups)
            for (unsigned age = 1; age <= 3; ++age)
                write(backupOf(file, int(age)), version(age, kSize));
        if (before == Before::Link) {
            saved = folder / "elsewhere" / "link.glb";
            fs::create_directory(saved.parent_path());
            fs::create_symlink("../scene.glb", saved);
        }
    }
    std::vector<fs::path> temporaries() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.path().filename().native().starts_with(".tactum-")) found.push_back(entry.path());
        return found;
    }
    bool isOld() const { return old.empty() ? !fs::exists(file) : read(file) == old; }
    bool isNew() const { return read(file) == fresh; }
    bool backupsAreWhole() const {
        for (int age = 1; age <= 3; ++age) {
            const fs::path backup = backupOf(file, age);
            if (!fs::exists(backup)) continue;
            const std::string bytes = read(backup);
            bool known = bytes == old;
            for (unsigned n = 1; n <= 3; ++n)
                known |= bytes == version(n, kSize);
            if (!known) return false;
        }
        return true;
    }

    static constexpr std::size_t kSize = 20'000;
    QTemporaryDir root;
    fs::path folder = root.path().toStdString();
    fs::path file = folder / "scene.glb", saved = file;
    std::string old = version(0, kSize), fresh = version(7, kSize);
};

/// What the rest of the machine is like.
struct Situation {
    const char* name;
    Desk::Before before;
    const char* missing = "";
    int missingError = 0;
};
constexpr Situation kSituations[] = {
    {"a new file", Desk::Before::Nothing},
    {"a file", Desk::Before::File},
    {"a file with backups", Desk::Before::Backups},
    {"a link to a file", Desk::Before::Link},
    {"a disk without nameless files", Desk::Before::Backups, "openat of nameless", EOPNOTSUPP},
    {"a disk without second names", Desk::Before::Backups, "linkat", EPERM},
    {"a disk without owners", Desk::Before::File, "fchown", EPERM},
};

DiskFault faultIn(const Situation& situation, DiskFault fault) {
    fault.missing = situation.missing;
    fault.missingError = situation.missingError;
    return fault;
}

/// Saves in a process of its own and gives back how that ended. `afterwards`: what it does then.
template <class Call> int saveApart(const Desk& desk, const DiskFault& fault, Call afterwards) {
    const pid_t child = fork();
    if (child == 0) {
        spoilDisk(fault, desk.folder);
        const bool saved = writeFileAtomically(desk.saved, desk.fresh).has_value();
        if (saved) afterwards();
        _exit(saved ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

} // namespace

class TestAtomicSave : public QObject {
    Q_OBJECT

private:
    static void addSituations() {
        QTest::addColumn<int>("situation");
        for (int i = 0; i < int(std::size(kSituations)); ++i)
            QTest::newRow(kSituations[i].name) << i;
    }

private slots:
    void anyFailedCallLeavesTheOldOrTheNew_data() { addSituations(); }
    void anyFailedCallLeavesTheOldOrTheNew();
    void aDiskThatBreaksLeavesTheOldOrTheNew_data() { addSituations(); }
    void aDiskThatBreaksLeavesTheOldOrTheNew();
    void shortWritesAndSignalsDoNotMatter_data() { addSituations(); }
    void shortWritesAndSignalsDoNotMatter();
    void aPowerCutLeavesTheOldOrTheNew_data() { addSituations(); }
    void aPowerCutLeavesTheOldOrTheNew();
    void whatWasSavedOutlivesAPowerCut_data() { addSituations(); }
    void whatWasSavedOutlivesAPowerCut();
    void aKillBeforeAnyCallLeavesTheOldOrTheNew_data() { addSituations(); }
    void aKillBeforeAnyCallLeavesTheOldOrTheNew();
    void aKillAtAnyMomentLeavesTheOldOrTheNew();
};

void TestAtomicSave::anyFailedCallLeavesTheOldOrTheNew() {
    QFETCH(int, situation);
    const Situation& now = kSituations[situation];
    for (const int error : {ENOSPC, EIO}) {
        int failures = 0;
        for (int call = 0;; ++call) {
            Desk desk(now.before);
            spoilDisk(faultIn(now, {DiskFault::Kind::Fails, call, error}));
            const auto saved = writeFileAtomically(desk.saved, desk.fresh);
            const std::vector<std::string> names = healDisk();
            if (int(names.size()) <= call) break; // it was done before
            const QByteArray place = QByteArray::number(call) + ' ' + names[std::size_t(call)].c_str();
            const std::string text = saved ? "" : saved.error().text;
            const bool isLate = text.find(": was written, but") != std::string::npos;
            QVERIFY2(saved || isLate ? desk.isNew() : desk.isOld(), place + ' ' + text.c_str());
            QVERIFY2(desk.temporaries().empty(), place);
            QVERIFY2(desk.backupsAreWhole(), place);
            if (saved) continue;
            ++failures;
            QVERIFY2(text.starts_with(desk.saved.string() + ": ") && text.find('\n') == std::string::npos &&
                         text.find(std::strerror(error)) != std::string::npos,
                     place + ' ' + text.c_str());
        }
        QCOMPARE_GE(failures, 10);
    }
}

void TestAtomicSave::aDiskThatBreaksLeavesTheOldOrTheNew() {
    QFETCH(int, situation);
    const Situation& now = kSituations[situation];
    for (const int error : {ENOSPC, EIO})
        for (int call = 0;; ++call) {
            Desk desk(now.before);
            spoilDisk(faultIn(now, {DiskFault::Kind::Stays, call, error}));
            const auto saved = writeFileAtomically(desk.saved, desk.fresh);
            const std::vector<std::string> names = healDisk();
            if (int(names.size()) <= call) break;
            QVERIFY2(desk.isOld() || desk.isNew(), names.back().c_str());
            QVERIFY2(!saved || desk.isNew(), names.back().c_str());
            QVERIFY2(desk.backupsAreWhole(), names.back().c_str());
        }
}

void TestAtomicSave::shortWritesAndSignalsDoNotMatter() {
    QFETCH(int, situation);
    const Situation& now = kSituations[situation];
    Desk desk(now.before);
    DiskFault fault = faultIn(now, {});
    fault.stutters = true;
    spoilDisk(fault);
    const auto saved = writeFileAtomically(desk.saved, desk.fresh);
    const std::vector<std::string> names = healDisk();
    VERIFY_RESULT(saved);
    QCOMPARE_GT(std::ranges::count(names, "write"), 2 * int(Desk::kSize / 1000));
    QVERIFY(desk.isNew());
    QVERIFY(desk.backupsAreWhole());
    if (now.before != Desk::Before::Nothing) QCOMPARE_EQ(read(backupOf(desk.file, 1)), desk.old);
    QVERIFY(desk.temporaries().empty());
}

void TestAtomicSave::aPowerCutLeavesTheOldOrTheNew() {
    QFETCH(int, situation);
    const Situation& now = kSituations[situation];
    for (const bool namesSurvive : {true, false})
        for (int call = 0, status = kPowerWasCut << 8; status != 0; ++call) {
            Desk desk(now.before);
            DiskFault fault = faultIn(now, {DiskFault::Kind::PowerCut, call, 0, namesSurvive});
            status = saveApart(desk, fault, [] {});
            QVERIFY(status == 0 || WEXITSTATUS(status) == kPowerWasCut);
            const QByteArray place = QByteArray::number(call) + (namesSurvive ? " with" : " without");
            QVERIFY2(desk.isOld() || desk.isNew(), place);
            QVERIFY2(desk.backupsAreWhole(), place);
        }
}

void TestAtomicSave::whatWasSavedOutlivesAPowerCut() {
    QFETCH(int, situation);
    const Situation& now = kSituations[situation];
    for (const bool namesSurvive : {true, false}) {
        Desk desk(now.before);
        DiskFault fault = faultIn(now, {});
        fault.namesSurvive = namesSurvive;
        const int status = saveApart(desk, fault, cutPower);
        QCOMPARE(WEXITSTATUS(status), kPowerWasCut);
        QVERIFY(desk.isNew());
        QVERIFY(desk.backupsAreWhole());
        if (now.before != Desk::Before::Nothing) QCOMPARE_EQ(read(backupOf(desk.file, 1)), desk.old);
    }
}

void TestAtomicSave::aKillBeforeAnyCallLeavesTheOldOrTheNew() {
    QFETCH(int, situation);
    const Situation& now = kSituations[situation];
    for (int call = 0, status = SIGKILL; status != 0; ++call) {
        Desk desk(now.before);
        status = saveApart(desk, faultIn(now, {DiskFault::Kind::Killed, call}), [] {});
        QVERIFY(status == 0 || (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL));
        QVERIFY2(desk.isOld() || desk.isNew(), QByteArray::number(call));
        QVERIFY2(desk.backupsAreWhole(), QByteArray::number(call));
        // A name is given only to what is whole.
        if (std::string_view(now.missing).empty())
            for (const fs::path& left : desk.temporaries())
                QVERIFY2(read(left) == desk.old || read(left) == desk.fresh, QByteArray::number(call));
    }
}

/// A program that saves two versions in turn for as long as it lives, the one of index `first` first.
[[noreturn]] static void saveForEver(const fs::path& file, const std::string (&versions)[2], unsigned first) {
    for (unsigned i = first;; ++i)
        if (!writeFileAtomically(file, versions[i % 2])) _exit(1);
}

void TestAtomicSave::aKillAtAnyMomentLeavesTheOldOrTheNew() {
    const int kills = test::repeats("TACTUM_KILLS", 200);
    const std::string versions[] = {version(0, 3'000'000), version(1, 2'000'000)};
    QTemporaryDir root;
    const fs::path folder = root.path().toStdString(), file = folder / "scene.glb";
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < 6; ++i)
        VERIFY_RESULT(writeFileAtomically(file, versions[i % 2]));
    const auto oneSave = unsigned(timer.nsecsElapsed() / 6000); // us
    std::minstd_rand random(1);
    int changed = 0, left = 0;
    std::string before = versions[1];
    for (int i = 0; i < kills; ++i) {
        const pid_t child = fork();
        if (child == 0) saveForEver(file, versions, before == versions[0]); // what is not there
        usleep(unsigned(random()) % (2 * oneSave));
        kill(child, SIGKILL);
        int status = 0;
        QCOMPARE(waitpid(child, &status, 0), child);
        QVERIFY(WIFSIGNALED(status));
        const std::string bytes = read(file);
        QVERIFY2(bytes == versions[0] || bytes == versions[1], QByteArray::number(i));
        changed += bytes != before;
        before = bytes;
        for (const auto& entry : fs::directory_iterator(folder)) {
            const std::string beside = read(entry.path());
            QVERIFY2(beside == versions[0] || beside == versions[1], entry.path().c_str());
            if (!entry.path().filename().native().starts_with(".tactum-")) continue;
            ++left;
            fs::remove(entry.path());
        }
    }
    qInfo("%d kills: the file changed %d times; %d whole temporary files were left", kills, changed, left);
    QCOMPARE_GT(changed, 0);
    QCOMPARE_LT(changed, kills);
}

TACTUM_TEST(TestAtomicSave)

} // namespace test_atomic_save

#include "test_atomic_save.moc"
