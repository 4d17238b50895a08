#include "device/remote/keeper.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/control/device_mailbox.h"

namespace tactum {
namespace {

using Beat = std::atomic<std::int64_t>;

constexpr int kPriority = 85; ///< above the loop
constexpr int kLook = 4;      ///< ms between two looks at it
constexpr char kFarewell = 'f';

// In the child: nothing but async-signal-safe calls.

void standApart() {
    setsid();
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGPIPE})
        std::signal(signal, SIG_IGN);
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL})
        std::signal(signal, SIG_DFL);
    prctl(PR_SET_NAME, "tactum-keeper");
    const sched_param parameters{.sched_priority = kPriority};
    sched_setscheduler(0, SCHED_FIFO, &parameters); // where that is allowed
}

enum class News { None, Farewell, Death };
News listen(int lifeline) noexcept {
    pollfd line{.fd = lifeline, .events = POLLIN, .revents = 0};
    if (poll(&line, 1, kLook) <= 0) return News::None;
    char word = 0;
    const ssize_t got = read(lifeline, &word, 1);
    if (got < 0 && errno == EINTR) return News::None;
    return got == 1 && word == kFarewell ? News::Farewell : News::Death;
}

[[noreturn]] void watch(int lifeline, const Beat& beat, HapticDevice& device) noexcept {
    standApart();
    std::int64_t stoppedAt = 0; ///< the beat after which nothing came
    while (true) {
        const News news = listen(lifeline);
        if (news == News::Death) device.emergencyStop();
        if (news != News::None) _exit(0);
        const std::int64_t last = beat.load(std::memory_order_relaxed);
        if (last == 0 || last == stoppedAt || steadyNanoseconds() - last <= kOldestCommand) continue;
        device.emergencyStop();
        stoppedAt = last;
    }
}

tl::unexpected<Error> cannotKeep(const char* what) {
    return machineError(std::string("The device cannot be guarded (") + what + ": " + std::strerror(errno) +
                        "): close other programs and try again.");
}

} // namespace

Result<void> Keeper::start(HapticDevice& device) {
    stop();
    void* memory = mmap(nullptr, sizeof(Beat), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return cannotKeep("shared memory");
    beat_ = new (memory) Beat(0);
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return cannotKeep("a pipe");
    child_ = fork();
    if (child_ == 0) {
        close(ends[1]);
        watch(ends[0], *beat_, device);
    }
    close(ends[0]);
    lifeline_ = ends[1];
    if (child_ < 0) return cannotKeep("another process");
    return {};
}

void Keeper::stop() {
    if (child_ > 0) {
        [[maybe_unused]] const ssize_t written = write(lifeline_, &kFarewell, 1); // SIGPIPE is ignored here
        kill(child_, SIGCONT); // one that somebody stopped would never read it
        waitpid(child_, nullptr, 0);
    }
    if (lifeline_ >= 0) close(lifeline_);
    if (beat_) munmap(static_cast<void*>(beat_), sizeof(Beat));
    child_ = lifeline_ = -1;
    beat_ = nullptr;
}

} // namespace tactum
