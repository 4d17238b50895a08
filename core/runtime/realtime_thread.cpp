#include "core/runtime/realtime_thread.h"

#include <cerrno>
#include <cstring>
#include <sys/mman.h>

namespace tactum {
namespace {

/// Ample: a haptic step keeps its state and its stack of nodes in some ten kilobytes.
constexpr std::size_t kStack = 256 * 1024;
constexpr std::size_t kPage = 4096;

[[gnu::noinline]] void touchStack() noexcept {
    [[maybe_unused]] volatile char stack[kStack];
    for (std::size_t at = 0; at < kStack; at += kPage)
        stack[at] = 0;
}

void* run(void* body) {
    touchStack();
    (*static_cast<std::function<void()>*>(body))();
    return nullptr;
}

int askForFifo(pthread_t thread, int priority) {
    sched_param parameters{};
    parameters.sched_priority = priority;
    return pthread_setschedparam(thread, SCHED_FIFO, &parameters);
}

} // namespace

Result<void> RealtimeThread::start(const char* name, int priority, std::function<void()> body) {
    join();
    body_ = std::move(body);
    const int failure = pthread_create(&thread_, nullptr, run, &body_);
    if (failure)
        return machineError(std::string("Cannot start the thread ") + name + ": " + std::strerror(failure) +
                            "; close other programs and try again.");
    running_ = true;
    pthread_setname_np(thread_, name);
    refusal_ = askForFifo(thread_, priority);
    return {};
}

void RealtimeThread::join() {
    if (running_) pthread_join(thread_, nullptr);
    running_ = false;
}

int lockPresentMemory() {
    return mlockall(MCL_CURRENT | MCL_ONFAULT) == 0 ? 0 : errno;
}

} // namespace tactum
