// Which run something belongs to: marks as names, and what tells that a run has ended.
#include <fstream>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include "core/base/process_mark.h"
#include "tests/support/compare.h"
#include "tests/support/patience.h"
#include "tests/support/test_program.h"

namespace test_process_mark {

using namespace tactum;
namespace fs = std::filesystem;

namespace {

const auto kNow = [] { return fs::file_time_type::clock::now(); };

bool isPlain(const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](char c) { return std::isalnum(std::uint8_t(c)) || c == '-' || c == '.'; });
}

} // namespace

class TestProcessMark : public QObject {
    Q_OBJECT

private slots:
    void ourOwnIsWhatTheSystemSays() {
        const ProcessMark own = ownMark();
        QCOMPARE(own.pid, std::uint64_t(getpid()));
        QCOMPARE(own, ownMark());
        char host[65]{};
        QCOMPARE(gethostname(host, sizeof host - 1), 0);
        if (isPlain(host)) QCOMPARE(own.host, std::string(host));
        std::string boot;
        std::getline(std::ifstream("/proc/sys/kernel/random/boot_id"), boot);
        QCOMPARE(own.boot, boot.substr(0, 8));
        for (const std::string* part : {&own.host, &own.boot, &own.space})
            QVERIFY(isPlain(*part));
        COMPARE_BEGINS(own.space, "pid");
        QCOMPARE_GT(own.space.size(), 5u); // with its number
        // Field 22 of proc(5), behind a name that may hold anything.
        std::string line;
        std::getline(std::ifstream("/proc/self/stat"), line);
        std::istringstream rest(line.substr(line.rfind(')') + 2));
        std::string field;
        for (int i = 3; i <= 22; ++i)
            rest >> field;
        QCOMPARE(std::to_string(own.began), field);
    }

    void aNameIsReadAsItWasWritten() {
        const ProcessMark mark{"host-1.a", "b00t", "pid4026531836", 12, 345678901234};
        QCOMPARE(nameOf(mark), "host-1.a_b00t_pid4026531836_12_345678901234");
        QVERIFY(markNamed(nameOf(mark)) == mark);
        QVERIFY(markNamed("____").has_value() == false);
        const ProcessMark nameless{"", "", "", 1, 2};
        QVERIFY(markNamed("___1_2") == nameless);
    }

    void whatIsNoNameIsRefused_data() {
        QTest::addColumn<QByteArray>("name");
        for (const char* name : {"", "a", "a_b_c_1", "a_b_c_1_2_3", "a_b_c__2", "a_b_c_1_", "a_b_c_1x_2",
                                 "a_b_c_1_2x", "a_b_c_-1_2", "a_b_c_1_+2", "a_b_c_ 1_2",
                                 "a_b_c_99999999999999999999_2", "a_b_c_1_99999999999999999999"})
            QTest::newRow(name) << QByteArray(name);
    }

    void whatIsNoNameIsRefused() {
        QFETCH(QByteArray, name);
        QVERIFY(!markNamed(name.toStdString()));
    }

    /// On this machine the system knows, whatever the last sign of life says.
    void whoeverIsHereIsKnown() {
        const ProcessMark own = ownMark();
        const auto long_ago = kNow() - 10 * kSilence;
        QVERIFY(!hasEnded(own, kNow()));
        QVERIFY(!hasEnded(own, long_ago));
        ProcessMark reused = own;
        ++reused.began;
        QVERIFY(hasEnded(reused, kNow()));
        ProcessMark none = own;
        none.pid = 0;
        QVERIFY(hasEnded(none, kNow()));
    }

    void aChildThatNobodyCollectedHasEnded() {
        const pid_t child = fork();
        if (child == 0) _exit(0);
        ProcessMark mark = ownMark();
        mark.pid = std::uint64_t(child);
        // Its begin is field 22, also of what only waits to be collected.
        std::string line;
        std::getline(std::ifstream("/proc/" + std::to_string(child) + "/stat"), line);
        std::istringstream rest(line.substr(line.rfind(')') + 2));
        std::string field;
        for (int i = 3; i <= 22; ++i)
            rest >> field;
        mark.began = std::stoull(field);
        QVERIFY(test::eventually([&] { return hasEnded(mark, kNow()); }));
        QCOMPARE(waitpid(child, nullptr, 0), child);
        QVERIFY(hasEnded(mark, kNow()));
    }

    /// An earlier start of this machine is over; of another machine or container only its silence tells.
    void whoeverIsElsewhereCountsBySilence_data() {
        QTest::addColumn<QByteArray>("what");
        QTest::addColumn<bool>("over");
        QTest::newRow("an earlier start") << QByteArray("boot") << true;
        QTest::newRow("another machine") << QByteArray("host") << false;
        QTest::newRow("another machine and start") << QByteArray("both") << false;
        QTest::newRow("another container") << QByteArray("space") << false;
        QTest::newRow("no start known") << QByteArray("noboot") << false;
        QTest::newRow("nothing known") << QByteArray("nothing") << false;
    }

    void whoeverIsElsewhereCountsBySilence() {
        QFETCH(QByteArray, what);
        QFETCH(bool, over);
        ProcessMark mark = ownMark();
        mark.began += 1; // nobody here
        if (what == "boot" || what == "both") mark.boot = "other";
        if (what == "host" || what == "both") mark.host = "other";
        if (what == "space") mark.space = "pid1";
        if (what == "noboot" || what == "nothing") mark.boot.clear();
        if (what == "nothing") mark.host.clear();
        using std::chrono::seconds;
        QCOMPARE(hasEnded(mark, kNow()), over);
        QCOMPARE(hasEnded(mark, kNow() - kSilence + seconds(30)), over);
        QCOMPARE(hasEnded(mark, kNow() - kSilence - seconds(1)), true);
        QCOMPARE(hasEnded(mark, kNow() + seconds(1000)), over); // a clock that is ahead
        QCOMPARE(kSilence, seconds(600));
        QVERIFY(kSilence >= 3 * kSignOfLife); // a sign may be lost
    }
};

TACTUM_TEST(TestProcessMark)

} // namespace test_process_mark

#include "test_process_mark.moc"
