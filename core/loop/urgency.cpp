#include "core/loop/urgency.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <iterator>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace tactum {
namespace {

constexpr int kLowestNice = -15;
constexpr int kNiceZero = 20;             ///< RLIMIT_NICE counts from here downwards
constexpr std::uint64_t kSlice = 100'000; ///< ns, the shortest that the kernel takes

/// The kernel's struct sched_attr, which not every C library names.
struct Attributes {
    std::uint32_t size = sizeof(Attributes), policy = 0;
    std::uint64_t flags = 0;
    std::int32_t nice = 0;
    std::uint32_t priority = 0;
    std::uint64_t runtime = 0, deadline = 0, period = 0;
};
static_assert(sizeof(Attributes) == 48);

/// The hard limit, after the soft one was raised to it.
rlim_t raised(__rlimit_resource resource) noexcept {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0) return 0;
    limit.rlim_cur = limit.rlim_max;
    setrlimit(resource, &limit);
    return limit.rlim_max;
}

int grantedNice() noexcept {
    const rlim_t limit = raised(RLIMIT_NICE);
    const int lowest = limit > rlim_t(kNiceZero - kLowestNice) ? kLowestNice : kNiceZero - int(limit);
    for (const int nice : {kLowestNice, lowest})
        if (nice < 0 && setpriority(PRIO_PROCESS, 0, nice) == 0) return nice;
    return getpriority(PRIO_PROCESS, 0); // of whoever started the program
}

/// An older kernel takes the call and does nothing: so it is asked what it keeps.
bool grantedSlice(int nice) noexcept {
    Attributes wanted, kept;
    wanted.nice = nice;
    wanted.runtime = kSlice;
    return syscall(SYS_sched_setattr, 0, &wanted, 0) == 0 &&
           syscall(SYS_sched_getattr, 0, &kept, sizeof kept, 0) == 0 && kept.runtime == kSlice;
}

/// Of kUrgencyWords.
enum Said { Granted, WithPriority, WithNone, ByKit, ByPortal, WithSlices, WithTimers, Swapped, Remedy };
static_assert(std::size(kUrgencyWords) == Remedy + 1);

std::string said(Said what) {
    return std::string(kUrgencyWords[what]);
}

std::string givenBy(PriorityBroker broker) {
    if (broker == PriorityBroker::RealtimeKit) return said(ByKit);
    return broker == PriorityBroker::Portal ? said(ByPortal) : std::string();
}

std::string manner(const Urgency& urgency) {
    if (urgency.priority > 0)
        return said(WithPriority) + std::to_string(urgency.priority) + givenBy(urgency.broker);
    std::string words = said(WithNone);
    if (urgency.nice != 0) words += ", nice " + std::to_string(urgency.nice);
    return words + said(urgency.slice ? WithSlices : WithTimers);
}

} // namespace

int allowedPriority() noexcept {
    constexpr rlim_t kMost = 99;
    return int(std::min(raised(RLIMIT_RTPRIO), kMost));
}

bool mayHavePriority(int priority) noexcept {
    return geteuid() == 0 || allowedPriority() >= priority;
}

int onRung(int asked, int rung) {
    return std::min(asked, rung - std::max(kServoPriority - asked, 0) / 10);
}

std::vector<int> rungsOf(int asked, int allowed) {
    std::vector<int> rungs{asked};
    for (const int rung : {allowed, 50, 20}) {
        const int priority = onRung(asked, rung);
        if (priority > 0 && priority < rungs.back() && rung <= allowed) rungs.push_back(priority);
    }
    rungs.push_back(0);
    return rungs;
}

void hasten(Urgency& urgency) noexcept {
    prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
    if (urgency.priority > 0) return;
    urgency.nice = grantedNice();
    urgency.slice = grantedSlice(urgency.nice);
}

std::string sentenceOf(const Urgency& urgency, int unlocked) {
    const bool asAsked = urgency.priority > 0 && urgency.priority >= urgency.asked;
    if (asAsked && !unlocked) return said(Granted);
    const int why = urgency.refusal ? urgency.refusal : unlocked;
    return manner(urgency) + (unlocked ? said(Swapped) : std::string()) + " (" + std::strerror(why) + ")" +
           said(Remedy);
}

AwakeProcessors::AwakeProcessors() : file_(open("/dev/cpu_dma_latency", O_WRONLY | O_CLOEXEC)) {
    const std::int32_t microseconds = 0;
    if (file_ >= 0 && write(file_, &microseconds, sizeof microseconds) != sizeof microseconds) {
        close(file_);
        file_ = -1;
    }
}

AwakeProcessors::~AwakeProcessors() {
    if (file_ >= 0) close(file_);
}

} // namespace tactum
