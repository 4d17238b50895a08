// What the import process cannot do any more: tried in a child that has entered the sandbox.
#include <cerrno>
#include <csignal>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTest>

#include "core/import/worker/sandbox.h"
#include "tests/core/files/mesh_files.h"
#include "tests/support/test_program.h"

namespace test_sandbox {

using namespace tactum;

namespace {

/// Whether `deed` succeeds behind bars.
bool succeeds(const std::filesystem::path& file, const std::function<bool()>& deed) {
    const pid_t child = fork();
    if (child == 0) {
        enterSandbox(file);
        _exit(deed() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

bool opens(const std::filesystem::path& file, int how) {
    return open(file.c_str(), how, 0600) >= 0;
}

} // namespace

class TestSandbox : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
        QSKIP("there is none under a sanitizer");
#endif
        file_ = folder_.write("model.obj", "v 0 0 0\n");
        folder_.write("model.mtl", "newmtl a\n");
        outside_ = other_.write("secret", "of the person");
        const pid_t child = fork();
        if (child == 0) _exit(int(enterSandbox(file_).size()));
        int status = 0;
        waitpid(child, &status, 0);
        if (status != 0) QSKIP("this kernel lacks a protection: the import says so to the person");
    }

    /// The folder may be the person's home.
    void readsOfTheFolderOnlyWhatTheFormatNames() {
        const auto notes = folder_.write("notes.txt", "private"), key = folder_.path() / ".keys";
        std::filesystem::create_directories(key);
        std::ofstream(key / "id.png") << "private";
        std::filesystem::create_directories(folder_.path() / "maps");
        std::ofstream(folder_.path() / "maps" / "grain.PNG") << "a picture";
        std::filesystem::create_symlink(outside_, folder_.path() / "link.png");
        const auto reads = [&](const char* model, const std::filesystem::path& other) {
            const auto file = folder_.write(model, "x");
            return succeeds(file, [&] { return opens(file, O_RDONLY); }) &&
                   succeeds(file, [&] { return opens(other, O_RDONLY); });
        };
        for (const char* model : {"a.stl", "a.ply", "a.off", "a.zip", "a.fbx", "a.obj", "a.gltf", "a.x3d"}) {
            QVERIFY2(!reads(model, notes), model);
            QVERIFY2(!reads(model, key / "id.png"), model);
            QVERIFY2(!reads(model, folder_.path() / "link.png"), model);
            QVERIFY2(!succeeds(folder_.path() / model,
                               [&] { return opens(folder_.path(), O_RDONLY | O_DIRECTORY); }),
                     model);
        }
        for (const char* model : {"a.fbx", "a.obj", "a.gltf", "a.x3d", "a.dae", "a.3ds"})
            QVERIFY2(reads(model, folder_.path() / "maps" / "grain.PNG"), model);
        for (const char* model : {"a.stl", "a.ply", "a.off", "a.zip"})
            QVERIFY2(!reads(model, folder_.path() / "maps" / "grain.PNG"), model);
    }

    void readsTheFileAndItsFolder() {
        QVERIFY(succeeds(file_, [&] { return opens(file_, O_RDONLY); }));
        QVERIFY(succeeds(file_, [&] { return opens(folder_.path() / "model.mtl", O_RDONLY); }));
        QVERIFY(succeeds(file_, [&] { return std::filesystem::is_regular_file(file_); }));
    }

    /// What a reader asks before it opens a file that is named beside its own.
    void findsItsFolder() {
        const auto folder = folder_.path() / ""; // a path that ends so is looked up by another call
        QVERIFY(succeeds(file_,
                         [&] { return std::filesystem::is_directory(std::filesystem::canonical(folder)); }));
    }

    void readsNothingElse() {
        QVERIFY(!succeeds(file_, [&] { return opens(outside_, O_RDONLY); }));
        QVERIFY(!succeeds(file_, [&] { return opens("/etc/passwd", O_RDONLY); }));
        QVERIFY(!succeeds(file_, [&] { return opens("/proc/self/environ", O_RDONLY); }));
    }

    void writesNothing() {
        QVERIFY(!succeeds(file_, [&] { return opens(file_, O_WRONLY); }));
        QVERIFY(!succeeds(file_, [&] { return opens(file_, O_RDWR); }));
        QVERIFY(!succeeds(file_, [&] { return opens(folder_.path() / "new", O_WRONLY | O_CREAT); }));
        QVERIFY(!succeeds(file_, [&] { return unlink(file_.c_str()) == 0; }));
        QVERIFY(!succeeds(file_, [&] { return mkdir((folder_.path() / "d").c_str(), 0700) == 0; }));
        QVERIFY(std::filesystem::exists(file_));
    }

    void reachesNobody() {
        QVERIFY(!succeeds(file_, [] { return socket(AF_INET, SOCK_STREAM, 0) >= 0; }));
        QVERIFY(!succeeds(file_, [] { return socket(AF_UNIX, SOCK_STREAM, 0) >= 0; }));
        QVERIFY(!succeeds(file_, [] { return kill(getppid(), 0) == 0; }));
    }

    void startsNothing() {
        QVERIFY(!succeeds(file_, [] { return fork() >= 0; }));
        QVERIFY(!succeeds(file_, [] { return execl("/bin/true", "true", nullptr) == 0; }));
        const auto code = [](int rights) {
            return mmap(nullptr, 4096, rights, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED;
        };
        QVERIFY(!succeeds(file_, [=] { return code(PROT_READ | PROT_EXEC); }));
        QVERIFY(succeeds(file_, [=] { return code(PROT_READ | PROT_WRITE); }));
    }

    void mayUseThreads() {
        QVERIFY(succeeds(file_, [] {
            bool ran = false;
            std::jthread([&] { ran = true; }).join();
            return ran;
        }));
    }

private:
    FileFolder folder_, other_;
    std::filesystem::path file_, outside_;
};

TACTUM_TEST(TestSandbox)

} // namespace test_sandbox

#include "test_sandbox.moc"
