// Another program: its words, what it finds open, its signals and its session.
#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QTest>

#include "core/base/child_program.h"
#include "tests/support/compare.h"
#include "tests/support/test_program.h"

namespace test_child_program {

using namespace tactum;

namespace {

struct Ended {
    int started = -1, code = -1;
    std::string said; ///< what it wrote to its descriptor 1
};

Ended run(std::vector<std::string> arguments, ChildProgram program = {}) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return {};
    if (program.program.empty()) program.program = "/bin/sh";
    program.arguments = std::move(arguments);
    program.descriptors.insert(program.descriptors.begin(), {ends[1], 1});
    Ended ended;
    pid_t child = -1;
    ended.started = startChild(program, child);
    close(ends[1]);
    char part[256];
    for (ssize_t count = 0; (count = read(ends[0], part, sizeof part)) > 0;)
        ended.said.append(part, std::size_t(count));
    close(ends[0]);
    int status = 0;
    if (ended.started == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status))
        ended.code = WEXITSTATUS(status);
    return ended;
}

/// A program with one thing set.
ChildProgram with(const std::function<void(ChildProgram&)>& set) {
    ChildProgram program;
    set(program);
    return program;
}

} // namespace

class TestChildProgram : public QObject {
    Q_OBJECT

private slots:
    void itGetsItsWordsAndItsDescriptors() {
        const Ended ended = run({"-c", "printf '%s|' \"$0\" \"$@\"; exit 7", "a b", "", "c"});
        QCOMPARE(ended.started, 0);
        QCOMPARE(ended.said, "a b||c|");
        QCOMPARE(ended.code, 7);
    }

    void whatThereIsNotCannotBeStarted() {
        QCOMPARE(run({}, with([&](ChildProgram& p) { p.program = "/none/such"; })).started, ENOENT);
    }

    /// Beside the program that runs, as it is built, or where an installation puts its helpers.
    void helpersStandBesideTheProgram() {
        const auto here = std::filesystem::path(QCoreApplication::applicationFilePath().toStdString());
        QCOMPARE(programBeside(here.filename()), here);
        QCOMPARE(programBeside("none-such"), std::filesystem::path());
        const auto helpers = here.parent_path() / "../libexec/tactum";
        const std::string name = "helper-" + std::to_string(getpid());
        std::filesystem::create_directories(helpers);
        std::ofstream(helpers / name) << "#!/bin/sh\n";
        QCOMPARE(programBeside(name), helpers / name);
        std::filesystem::remove(helpers / name);
        QCOMPARE(programBeside(name), std::filesystem::path());
    }

    void nothingElseIsOpen() {
        const int other = open("/dev/null", O_RDONLY); // without O_CLOEXEC
        const int far = fcntl(other, F_DUPFD, 100);
        QCOMPARE_GE(far, 100);
        const char* script = "for i; do [ -e /proc/$$/fd/$i ] && echo open || echo shut; done";
        const std::vector<std::string> words{
            "-c", script, "sh", "0", "1", "2", "5", "6", std::to_string(far)};
        QCOMPARE(run(words).said, "open\nopen\nopen\nshut\nshut\nshut\n");
        const Ended more = run(words, with([&](ChildProgram& p) { p.descriptors = {{other, 5}}; }));
        QCOMPARE(more.said, "open\nopen\nopen\nopen\nshut\nshut\n");
        close(other);
        close(far);
    }

    void whatIsSilentLeadsToNowhere() {
        const Ended ended =
            run({"-c", "readlink /proc/$$/fd/0 /proc/$$/fd/2; echo x >&2; cat"}, with([&](ChildProgram& p) {
                    p.silent = {0, 2};
                }));
        QCOMPARE(ended.said, "/dev/null\n/dev/null\n");
        QCOMPARE(ended.code, 0);
        QCOMPARE(run({"-c", "echo x >&0 && echo y"}, with([&](ChildProgram& p) { p.silent = {0}; })).said,
                 "y\n"); // to write, too
    }

    void itHasTheEnvironmentThatItIsGiven() {
        std::string one = "ONE=1", two = "TWO=2";
        const Ended given = run({"-c", "echo $ONE-$TWO-$TACTUM_OURS"}, with([&](ChildProgram& p) {
                                    p.environment = std::vector<char*>{one.data(), two.data()};
                                }));
        QCOMPARE(given.said, "1-2-\n");
        qputenv("TACTUM_OURS", "ours");
        QCOMPARE(run({"-c", "echo $TACTUM_OURS"}).said, "ours\n");
        qunsetenv("TACTUM_OURS");
    }

    void aSessionOfItsOwnWhereItIsToBeApart() {
        const char* script = "read a b c d e sid rest </proc/$$/stat; [ $sid = $$ ] && echo own || echo ours";
        QCOMPARE(run({"-c", script}).said, "ours\n");
        QCOMPARE(run({"-c", script}, with([&](ChildProgram& p) { p.apart = true; })).said, "own\n");
    }

    void itsSignalsAreAsTheyAreByDefault() {
        const auto before = std::signal(SIGTERM, SIG_IGN);
        sigset_t blocked, old;
        sigemptyset(&blocked);
        sigaddset(&blocked, SIGUSR1);
        pthread_sigmask(SIG_BLOCK, &blocked, &old);
        // Of the shell itself: one that waits for a grep of its own blocks signals meanwhile.
        const Ended ended = run({"-c", "exec grep -E 'SigBlk|SigIgn' /proc/$$/status"});
        pthread_sigmask(SIG_SETMASK, &old, nullptr);
        std::signal(SIGTERM, before);
        unsigned long long blockedThere = 1,
                           ignored = 1; // bit i is signal i + 1; 32 and 33 are the C library's own
        QCOMPARE(std::sscanf(ended.said.c_str(), "SigBlk:\t%llx\nSigIgn:\t%llx", &blockedThere, &ignored), 2);
        QCOMPARE(blockedThere, 0u);
        QCOMPARE(ignored & 0x7FFFFFFF, 0u);
    }
};

TACTUM_TEST(TestChildProgram)

} // namespace test_child_program

#include "test_child_program.moc"
