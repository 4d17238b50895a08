#include "core/import/worker_process.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include "core/base/child_program.h"
#include "core/base/numbers.h"
#include "core/import/wire.h"

namespace tactum {
namespace {

constexpr int kMoment = 20; ///< ms between two looks at whether to go on

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true; // their shadows are larger than any limit
#else
constexpr bool kSanitized = false;
#endif

tl::unexpected<Error> cannotStart(const char* what, int code) {
    return machineError(std::string("the import process cannot be started (") + what + ": " +
                        std::strerror(code) + "); close other programs and try again");
}

/// Nothing of the person's but where libraries are, and what sanitizers are told.
std::vector<char*> smallEnvironment() {
    std::vector<char*> kept;
    for (char** entry = environ; *entry; ++entry)
        for (const char* name : {"LD_LIBRARY_PATH=", "ASAN_OPTIONS=", "UBSAN_OPTIONS=", "TSAN_OPTIONS="})
            if (std::strncmp(*entry, name, std::strlen(name)) == 0) kept.push_back(*entry);
    return kept;
}

int spawn(pid_t& child, const std::filesystem::path& worker, const std::filesystem::path& file, int talk,
          int memory) {
    ChildProgram program{.program = worker,
                         .arguments = {file.string()},
                         .silent = {0, 1},
                         .descriptors = {{talk, wire::kTalk}, {memory, wire::kSceneMemory}},
                         .environment = smallEnvironment()};
    if (!kSanitized) program.silent.push_back(2);
    return startChild(std::move(program), child);
}

void limit(pid_t child, const ImportLimits& limits) {
    const auto set = [&](auto what, std::uint64_t soft, std::uint64_t hard) {
        const rlimit both{soft, hard};
        prlimit(child, what, &both, nullptr);
    };
    const auto seconds = std::uint64_t(limits.processor.count());
    set(RLIMIT_CPU, seconds, seconds + 1);
    set(RLIMIT_CORE, 0, 0);
    set(RLIMIT_FSIZE, limits.memory, limits.memory); // holds for the memory of the scene too
    if (!kSanitized) set(RLIMIT_AS, limits.memory, limits.memory);
}

std::string inGibibytes(std::uint64_t bytes) {
    std::string text;
    appendNumber(text, std::round(10 * double(bytes) / double(1 << 30)) / 10);
    return text + " GiB";
}

std::string reasonOf(int status, const rusage& used, const ImportLimits& limits) {
    const std::string seconds = std::to_string(limits.processor.count()) + " s of the processor";
    if (WIFEXITED(status))
        return WEXITSTATUS(status) == wire::kOutOfMemory ? "needed more than " + inGibibytes(limits.memory)
                                                         : "ended without an answer";
    const int signal = WTERMSIG(status);
    const auto spent = used.ru_utime.tv_sec + used.ru_stime.tv_sec;
    if (signal == SIGXCPU || (signal == SIGKILL && spent >= limits.processor.count()))
        return "needed more than " + seconds;
    if (signal == SIGXFSZ) return "made more than " + inGibibytes(limits.memory) + " of it";
    if (signal == SIGKILL) return "was killed, perhaps because the memory of the machine was used up";
    return std::string("crashed: ") + strsignal(signal);
}

} // namespace

Descriptor::~Descriptor() {
    if (number_ >= 0) close(number_);
}

Result<WorkerProcess> WorkerProcess::start(const std::filesystem::path& worker,
                                           const std::filesystem::path& file, const ImportLimits& limits) {
    WorkerProcess process;
    process.limits_ = limits;
    process.memory_ = Descriptor(memfd_create("tactum-scene", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!process.memory_.open()) return cannotStart("shared memory", errno);
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0)
        return cannotStart("a socket", errno);
    process.talk_ = Descriptor(ends[0]);
    const Descriptor theirs(ends[1]);
    // Numbers that the child's own can never overwrite before they are used.
    const Descriptor talk(fcntl(theirs.number(), F_DUPFD_CLOEXEC, 16)),
        memory(fcntl(process.memory_.number(), F_DUPFD_CLOEXEC, 16));
    if (!talk.open() || !memory.open()) return cannotStart("open files", errno);
    if (const int fault = spawn(process.child_, worker, file, talk.number(), memory.number())) {
        process.child_ = -1;
        return cannotStart(worker.c_str(), fault);
    }
    limit(process.child_, limits);
    const char go = char(wire::Word::Go);
    send(process.talk_.number(), &go, 1, MSG_NOSIGNAL);
    return process;
}

WorkerProcess::WorkerProcess(WorkerProcess&& other) noexcept
    : child_(std::exchange(other.child_, -1)), limits_(other.limits_), talk_(std::move(other.talk_)),
      memory_(std::move(other.memory_)), mapped_(std::exchange(other.mapped_, nullptr)),
      mappedSize_(other.mappedSize_) {}

WorkerProcess::~WorkerProcess() {
    unmap();
    if (child_ < 0) return;
    kill(child_, SIGKILL);
    if (waitpid(child_, nullptr, WNOHANG) == child_) return;
    // Gigabytes take the machine some tenths of a second.
    try {
        std::thread([child = child_] { waitpid(child, nullptr, 0); }).detach();
    } catch (const std::system_error&) {
        waitpid(child_, nullptr, 0);
    }
}

WorkerProcess::Heard WorkerProcess::listen(std::string& packet) {
    pollfd line{.fd = talk_.number(), .events = POLLIN, .revents = 0};
    if (poll(&line, 1, kMoment) <= 0) return Heard::Nothing;
    packet.resize(wire::kLongest);
    const ssize_t got = recv(talk_.number(), packet.data(), packet.size(), MSG_DONTWAIT);
    // Reset: it died without having heard us. What it said before that comes next.
    if (got < 0 && (errno == EINTR || errno == EAGAIN || errno == ECONNRESET)) return Heard::Nothing;
    packet.resize(got > 0 ? std::size_t(got) : 0);
    return got > 0 ? Heard::Packet : Heard::Silence;
}

std::string_view WorkerProcess::scene(std::uint64_t size) {
    unmap();
    constexpr int kSealed = F_SEAL_WRITE | F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;
    if (fcntl(memory_.number(), F_ADD_SEALS, kSealed) != 0) return {};
    const off_t there = lseek(memory_.number(), 0, SEEK_END);
    if (size == 0 || there < 0 || size > std::uint64_t(there)) return {};
    void* mapped = mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_POPULATE, memory_.number(), 0);
    if (mapped == MAP_FAILED) return {};
    mapped_ = mapped;
    mappedSize_ = size;
    return {static_cast<const char*>(mapped), size};
}

void WorkerProcess::unmap() {
    if (mapped_) munmap(std::exchange(mapped_, nullptr), mappedSize_);
}

std::string WorkerProcess::whyItStopped() {
    int status = 0;
    rusage used{};
    // It closes its end in dying, or as good as dies: whoever lives on without a voice is killed.
    for (int look = 0; look < 100; ++look) {
        if (wait4(child_, &status, WNOHANG, &used) == child_) {
            child_ = -1;
            return reasonOf(status, used, limits_);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(kMoment));
    }
    return "stopped answering";
}

} // namespace tactum
