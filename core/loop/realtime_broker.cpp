#include "core/loop/realtime_broker.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <memory>
#include <sched.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <systemd/sd-bus.h>
#include <unistd.h>

namespace tactum {
namespace {

constexpr std::uint64_t kBusPatience = 500'000; // us

struct Service {
    PriorityBroker broker;
    int (*open)(sd_bus**);
    const char *name, *path, *interface;
};

constexpr std::array<Service, 2> kServices{
    {{PriorityBroker::RealtimeKit, sd_bus_open_system, "org.freedesktop.RealtimeKit1",
      "/org/freedesktop/RealtimeKit1", "org.freedesktop.RealtimeKit1"},
     {PriorityBroker::Portal, sd_bus_open_user, "org.freedesktop.portal.Desktop",
      "/org/freedesktop/portal/desktop", "org.freedesktop.portal.Realtime"}}};

struct CloseBus {
    void operator()(sd_bus* bus) const noexcept { sd_bus_flush_close_unref(bus); }
};
using Bus = std::unique_ptr<sd_bus, CloseBus>;

Bus opened(const Service& service) noexcept {
    sd_bus* bus = nullptr;
    if (service.open(&bus) < 0) return nullptr;
    sd_bus_set_method_call_timeout(bus, kBusPatience);
    return Bus(bus);
}

// Threads that a broker gave priority; 0 where there is none. A signal takes it away from all of them.
std::array<std::atomic<pid_t>, 16> promoted;

/// A loop that never waits has used up what brokers allow. Thread: any; only calls that a signal may make.
void demoteAll(int) {
    const int before = errno;
    const sched_param ordinary{};
    for (std::atomic<pid_t>& thread : promoted)
        if (const pid_t id = thread.exchange(0); id > 0)
            syscall(SYS_sched_setscheduler, id, SCHED_OTHER | SCHED_RESET_ON_FORK, &ordinary);
    errno = before;
}

/// What brokers demand: an end to how long a thread may run without waiting. The soft limit, half of what is
/// allowed, is where the thread is made an ordinary one; at the hard one the kernel would end the program.
bool limitTime(std::int64_t allowed) noexcept {
    rlimit limit{};
    if (allowed <= 0 || getrlimit(RLIMIT_RTTIME, &limit) != 0) return false;
    struct sigaction demote {};
    demote.sa_handler = demoteAll;
    demote.sa_flags = SA_RESTART;
    if (sigaction(SIGXCPU, &demote, nullptr) != 0) return false;
    limit.rlim_max = std::min(limit.rlim_max, rlim_t(allowed));
    limit.rlim_cur = std::min(limit.rlim_cur, limit.rlim_max / 2);
    return setrlimit(RLIMIT_RTTIME, &limit) == 0;
}

/// What the kernel says it is now.
int ownPriority() noexcept {
    sched_param parameters{};
    const int policy = sched_getscheduler(0) & ~SCHED_RESET_ON_FORK;
    if (policy != SCHED_RR && policy != SCHED_FIFO) return 0;
    return sched_getparam(0, &parameters) == 0 ? parameters.sched_priority : 0;
}

std::optional<BrokeredPriority> grantedBy(const Service& service, int asked) noexcept {
    const Bus bus = opened(service);
    if (!bus) return {};
    std::int64_t time = 0;
    std::int32_t highest = 0;
    const auto property = [&](const char* name, char type, void* value) {
        return sd_bus_get_property_trivial(bus.get(), service.name, service.path, service.interface, name,
                                           nullptr, type, value) >= 0;
    };
    if (!property("RTTimeUSecMax", 'x', &time) || !property("MaxRealtimePriority", 'i', &highest)) return {};
    if (!limitTime(time)) return {};
    const auto thread = pid_t(syscall(SYS_gettid));
    for (std::atomic<pid_t>& place : promoted) {
        pid_t none = 0;
        if (!place.compare_exchange_strong(none, thread)) continue;
        sd_bus_call_method(bus.get(), service.name, service.path, service.interface,
                           "MakeThreadRealtimeWithPID", nullptr, nullptr, "ttu", std::uint64_t(getpid()),
                           std::uint64_t(thread), std::uint32_t(std::max(onRung(asked, highest), 1)));
        if (const int priority = ownPriority(); priority > 0)
            return BrokeredPriority{service.broker, priority};
        place = 0;
        break;
    }
    return {};
}

} // namespace

std::optional<BrokeredPriority> priorityByBroker(int asked) noexcept {
    for (const Service& service : kServices)
        if (const auto granted = grantedBy(service, asked)) return granted;
    return {};
}

void forgetBroker() noexcept {
    const auto thread = pid_t(syscall(SYS_gettid));
    for (std::atomic<pid_t>& place : promoted) {
        pid_t own = thread;
        place.compare_exchange_strong(own, 0);
    }
}

} // namespace tactum
