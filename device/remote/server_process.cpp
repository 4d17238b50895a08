#include "device/remote/server_process.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>

#include "core/base/child_program.h"

namespace tactum {
namespace {

constexpr int kProcessMoment = 5; ///< ms between two looks
constexpr int kPatience = 2000;   ///< ms, for its last acts
constexpr int kOutOfTheWay = 10;

tl::unexpected<Error> cannotStart(const char* what, int code) {
    return machineError(std::string("The process of the device cannot be started (") + what + ": " +
                        std::strerror(code) + "): close other programs and try again.");
}

/// Numbers that no descriptor of the server has.
int outOfTheWay(int descriptor) {
    const int moved = fcntl(descriptor, F_DUPFD_CLOEXEC, kOutOfTheWay);
    close(descriptor);
    return moved;
}

} // namespace

ServerProcess::ServerProcess(std::filesystem::path program, std::vector<std::string> arguments)
    : program_(std::move(program)), arguments_(std::move(arguments)) {}

ServerProcess::~ServerProcess() {
    end();
    if (block_) munmap(static_cast<void*>(block_), sizeof(wire::Block));
    if (memory_ >= 0) close(memory_);
}

/// Mapped once: whoever asks for trouble() meanwhile still finds memory there.
Result<void> ServerProcess::makeBlock() {
    if (!block_) {
        memory_ = memfd_create("tactum-device", MFD_CLOEXEC);
        if (memory_ < 0 || ftruncate(memory_, sizeof(wire::Block)) != 0) return cannotStart("memory", errno);
        memory_ = outOfTheWay(memory_);
        void* mapped = mmap(nullptr, sizeof(wire::Block), PROT_READ | PROT_WRITE, MAP_SHARED, memory_, 0);
        if (mapped == MAP_FAILED) return cannotStart("shared memory", errno);
        block_ = static_cast<wire::Block*>(mapped);
    }
    new (block_) wire::Block; // the last server may have left anything in it
    block_->program = getpid();
    return {};
}

Result<void> ServerProcess::start() {
    end();
    if (Result<void> made = makeBlock(); !made) return made;
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return cannotStart("a socket", errno);
    talk_ = ends[0];
    const int theirs = outOfTheWay(ends[1]);
    const int fault = spawn(theirs);
    close(theirs);
    if (fault) return cannotStart(program_.c_str(), fault);
    return {};
}

/// The terminal's signals are for the program, which then ends this one in order.
int ServerProcess::spawn(int talk) {
    constexpr int kIn = STDIN_FILENO, kOut = STDOUT_FILENO, kError = STDERR_FILENO;
    const std::lock_guard lock(mutex_);
    const int fault = startChild({.program = program_,
                                  .arguments = arguments_,
                                  .silent = {kIn},
                                  .descriptors = {{kError, kOut}, // makers' libraries chat
                                                  {talk, wire::kTalk},
                                                  {memory_, wire::kBlock}},
                                  .environment = {},
                                  .apart = true},
                                 pid_);
    if (fault) pid_ = -1;
    status_ = 0;
    return fault;
}

bool ServerProcess::hasEnded(int options) const {
    const std::lock_guard lock(mutex_);
    if (pid_ > 0 && waitpid(pid_, &status_, options) == pid_) pid_ = -1;
    return pid_ < 0;
}

bool ServerProcess::runs() const {
    return !hasEnded(WNOHANG);
}

void ServerProcess::kill() {
    if (hasEnded(WNOHANG)) return;
    {
        const std::lock_guard lock(mutex_);
        ::kill(pid_, SIGKILL);
    }
    hasEnded(0);
}

/// It ends when nobody talks to it any more. A forked device watchdog holds the socket as well: closing is
/// not enough.
void ServerProcess::end() {
    if (talk_ >= 0) {
        shutdown(talk_, SHUT_RDWR);
        close(talk_);
    }
    talk_ = -1;
    for (int waited = 0; !hasEnded(WNOHANG) && waited < kPatience; waited += kProcessMoment)
        std::this_thread::sleep_for(std::chrono::milliseconds(kProcessMoment));
    kill();
}

std::string ServerProcess::howItEnded() const {
    const std::lock_guard lock(mutex_);
    const std::string how = WIFSIGNALED(status_) ? strsignal(WTERMSIG(status_)) : "it ended by itself";
    return "The driver of the device crashed (" + how +
           "), and its force was taken away: open the device again. The program and the scene are as they "
           "were.";
}

} // namespace tactum
