#include "core/loop/realtime_thread.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <future>
#include <sched.h>
#include <sys/mman.h>
#include <thread>

#include "core/base/clock.h"
#include "core/loop/realtime_broker.h"

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

/// What a thread begins with. It outlives start(): the thread has it.
struct Beginning {
    std::function<void()> body;
    Urgency urgency;
    std::promise<Urgency> granted;
};

void* run(void* beginning) {
    touchStack();
    const std::unique_ptr<Beginning> own(static_cast<Beginning*>(beginning));
    Urgency& urgency = own->urgency;
    if (urgency.priority == 0)
        if (const auto granted = priorityByBroker(urgency.asked)) {
            urgency.priority = granted->priority;
            urgency.broker = granted->broker;
        }
    hasten(urgency);
    own->granted.set_value(urgency);
    own->body();
    forgetBroker();
    return nullptr;
}

/// Begins with its priority, so that the body can rely on it.
int create(pthread_t& thread, int priority, Beginning* beginning) {
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    sched_param parameters{};
    parameters.sched_priority = priority;
    if (priority > 0) {
        pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
        pthread_attr_setschedpolicy(&attributes, SCHED_FIFO);
        pthread_attr_setschedparam(&attributes, &parameters);
    }
    const int failure = pthread_create(&thread, &attributes, run, beginning);
    pthread_attr_destroy(&attributes);
    return failure;
}

/// errno of the last rung.
int climb(pthread_t& thread, Beginning& beginning) {
    Urgency& urgency = beginning.urgency;
    int failure = 0;
    for (const int rung : rungsOf(urgency.asked, allowedPriority())) {
        urgency.priority = rung;
        failure = create(thread, rung, &beginning);
        if (!failure) break;
        if (rung == urgency.asked) urgency.refusal = failure;
    }
    return failure;
}

} // namespace

Result<void> RealtimeThread::start(const char* name, int priority, std::function<void()> body) {
    join();
    auto own = std::make_unique<Beginning>();
    own->body = std::move(body);
    own->urgency.asked = priority;
    std::future<Urgency> granted = own->granted.get_future();
    if (const int failure = climb(thread_, *own); failure)
        return machineError(std::string("Cannot start the thread ") + name + ": " + std::strerror(failure) +
                            "; close other programs and try again.");
    own.release(); // the thread has it
    urgency_ = granted.get();
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
