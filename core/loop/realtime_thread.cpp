#include "core/loop/realtime_thread.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <sched.h>
#include <sys/mman.h>
#include <thread>

#include "core/base/clock.h"

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

using Body = std::function<void()>;

void* run(void* body) {
    touchStack();
    const std::unique_ptr<Body> own(static_cast<Body*>(body)); // an abandoned thread outlives its handle
    (*own)();
    return nullptr;
}

/// Begins with its priority, so that the body can rely on it.
int create(pthread_t& thread, int priority, Body* body) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    sched_param parameters{};
    parameters.sched_priority = priority;
    if (priority > 0) {
        pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
        pthread_attr_setschedpolicy(&attributes, SCHED_FIFO);
        pthread_attr_setschedparam(&attributes, &parameters);
    }
    const int failure = pthread_create(&thread, &attributes, run, body);
    pthread_attr_destroy(&attributes);
    return failure;
}

} // namespace

Result<void> RealtimeThread::start(const char* name, int priority, std::function<void()> body) {
    join();
    auto own = std::make_unique<Body>(std::move(body));
    refusal_ = create(thread_, priority, own.get());
    const int failure = refusal_ ? create(thread_, 0, own.get()) : 0; // an ordinary thread then
    if (failure)
        return machineError(std::string("Cannot start the thread ") + name + ": " + std::strerror(failure) +
                            "; close other programs and try again.");
    own.release(); // the thread has it
    running_ = true;
    pthread_setname_np(thread_, name);
    return {};
}

void RealtimeThread::join() {
    if (running_) pthread_join(thread_, nullptr);
    running_ = false;
}

// By looking: pthread_clockjoin_np is not known to every thread sanitizer, and the wall clock of the timed
// one jumps.
bool RealtimeThread::joinWithin(double patience) {
    const std::int64_t until = monotonicNanoseconds() + std::int64_t(1e9 * patience);
    while (running_ && pthread_tryjoin_np(thread_, nullptr) != 0) {
        if (monotonicNanoseconds() > until) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    running_ = false;
    return true;
}

void RealtimeThread::abandon() {
    if (running_) pthread_detach(thread_);
    running_ = false;
}

int lockPresentMemory() {
    return mlockall(MCL_CURRENT | MCL_ONFAULT) == 0 ? 0 : errno;
}

} // namespace tactum
