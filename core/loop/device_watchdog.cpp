#include "core/loop/device_watchdog.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/clock.h"
#include "core/loop/urgency.h"

namespace tactum {
namespace {

constexpr int kPriority = 85;                                     ///< above the loops
constexpr int kLook = 4;                                          ///< ms between two looks at the pulse
constexpr std::int64_t kPatience = 1'000'000 * kWatchdogPatience; ///< ns
constexpr char kFarewell = 'f';

// From here on in the child: nothing but async-signal-safe calls.

/// As early as this account may be woken: above the loops, with their limit, or before what else runs.
void hurry() noexcept {
    Urgency urgency{.asked = kPriority};
    for (const int priority : {kPriority, std::min(kPriority, allowedPriority())}) {
        const sched_param parameters{.sched_priority = priority};
        if (sched_setscheduler(0, SCHED_FIFO, &parameters) != 0) continue;
        urgency.priority = priority;
        break;
    }
    hasten(urgency);
}

/// The terminal's signals and those of a closing session reach the child too; it outlives the program. A
/// process group is enough for that. In a session of its own, Linux would schedule it as a group of its own
/// with next to no weight, as it hardly ever runs: on a busy machine it stood still for 0.8 s.
void standApart() noexcept {
    setpgid(0, 0);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGPIPE})
        std::signal(signal, SIG_IGN);
    prctl(PR_SET_NAME, "tactum-watchdog");
    hurry();
    // Locks are not inherited, and who waits for a page from the disk stops nothing in time.
    mlockall(MCL_CURRENT | MCL_ONFAULT);
}

bool isOfTheNetwork(int descriptor) noexcept {
    int domain = 0;
    socklen_t size = sizeof domain;
    return getsockopt(descriptor, SOL_SOCKET, SO_DOMAIN, &domain, &size) == 0 &&
           (domain == AF_INET || domain == AF_INET6);
}

/// What the program has open stays open here when it dies: a port of its server would be taken, and who reads
/// its output would wait for more. Neither is ever the way to a device.
void closeOthers(int lifeline) noexcept {
    constexpr int kMost = 65536;
    const int end = int(std::min<long>(sysconf(_SC_OPEN_MAX), kMost));
    for (int descriptor = 0; descriptor < end; ++descriptor) {
        struct stat is {};
        if (descriptor == lifeline || fstat(descriptor, &is) != 0) continue;
        if (S_ISFIFO(is.st_mode) || isOfTheNetwork(descriptor)) close(descriptor);
    }
}

/// Whether the program said farewell; nothing when there was no news before the next look.
enum class News { None, Farewell, Death };
News listen(int lifeline) noexcept {
    pollfd line{.fd = lifeline, .events = POLLIN, .revents = 0};
    if (poll(&line, 1, kLook) <= 0) return News::None;
    char word = 0;
    const ssize_t got = read(lifeline, &word, 1);
    if (got < 0 && errno == EINTR) return News::None;
    return got == 1 && word == kFarewell ? News::Farewell : News::Death;
}

[[noreturn]] void watch(int lifeline, DeviceWatchdog::Shared& shared, HapticDevice& device) noexcept {
    closeOthers(lifeline);
    standApart();
    std::uint64_t last = 0;
    std::int64_t since = monotonicNanoseconds();
    bool stopped = false;
    while (true) {
        DeviceWatchdog::raise(shared.looks);
        const News news = listen(lifeline);
        if (news == News::Farewell) _exit(0);
        if (news == News::Death) {
            device.emergencyStop();
            _exit(0);
        }
        const std::uint64_t beat = shared.beats.load(std::memory_order_relaxed);
        if (beat != last || beat == 0) {
            last = beat;
            since = monotonicNanoseconds();
            stopped = false;
        } else if (!stopped && monotonicNanoseconds() - since > kPatience) {
            device.emergencyStop();
            stopped = true;
        }
    }
}

tl::unexpected<Error> cannotGuard(const char* what) {
    return machineError(std::string("The device cannot be guarded (") + what + ": " + std::strerror(errno) +
                        "): close other programs and try again.");
}

} // namespace

Result<void> DeviceWatchdog::start(HapticDevice& device) {
    stop();
    void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return cannotGuard("shared memory");
    shared_ = new (memory) Shared;
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return cannotGuard("a pipe");
    child_ = fork();
    if (child_ == 0) {
        close(ends[1]);
        watch(ends[0], *shared_, device);
    }
    close(ends[0]);
    lifeline_ = ends[1];
    if (child_ < 0) return cannotGuard("another process");
    return {};
}

void DeviceWatchdog::stop() {
    if (child_ > 0) {
        // A child that was killed itself is no reason to be killed by SIGPIPE.
        void (*const handler)(int) = std::signal(SIGPIPE, SIG_IGN);
        [[maybe_unused]] const ssize_t written = write(lifeline_, &kFarewell, 1);
        std::signal(SIGPIPE, handler);
        kill(child_, SIGCONT); // one that somebody stopped would never read it
        waitpid(child_, nullptr, 0);
    }
    if (lifeline_ >= 0) close(lifeline_);
    if (shared_) munmap(static_cast<void*>(shared_), sizeof(Shared));
    child_ = lifeline_ = -1;
    shared_ = nullptr;
}

} // namespace tactum
