// A thread that asks for priority in a process of its own, which has given its rights away.
#pragma once

#include <chrono>
#include <cstdlib>
#include <functional>
#include <grp.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/loop/realtime_thread.h"

namespace tactum::test {

/// What a thread sees of itself.
struct Seen {
    Urgency told;
    int policy = -1, priority = -1, nice = 99, slack = -1;
    bool started = false, rights = true, reset = false;
};

/// With no right and these hard limits; false where this account has not so much to give.
inline bool dropTo(rlim_t priority, rlim_t nice) {
    const rlimit ofPriority{priority, priority}, ofNice{nice, nice};
    if (setrlimit(RLIMIT_RTPRIO, &ofPriority) != 0 || setrlimit(RLIMIT_NICE, &ofNice) != 0) return false;
    constexpr uid_t kNobody = 65534;
    if (geteuid() != 0) return true;
    return setgroups(0, nullptr) == 0 && setresgid(kNobody, kNobody, kNobody) == 0 &&
           setresuid(kNobody, kNobody, kNobody) == 0;
}

/// Where nothing listens.
inline constexpr const char* kNoBus = "unix:path=/nonexistent";

struct Account {
    rlim_t priority = 0, nice = 0; ///< hard limits
    int asked = kServoPriority;
    const char* systemBus = kNoBus; ///< addresses
    const char* userBus = kNoBus;
    double busy = 0; ///< s that the thread runs for without waiting before it looks at itself
};

inline Seen lookAtMyself(const Account& account) {
    Seen seen;
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() < account.busy) {
    }
    sched_param parameters{};
    const int policy = sched_getscheduler(0);
    seen.policy = policy & ~SCHED_RESET_ON_FORK;
    seen.reset = (policy & SCHED_RESET_ON_FORK) != 0;
    sched_getparam(0, &parameters);
    seen.priority = parameters.sched_priority;
    seen.nice = getpriority(PRIO_PROCESS, 0);
    seen.slack = prctl(PR_GET_TIMERSLACK, 0, 0, 0, 0);
    return seen;
}

/// What the thread saw; not started where the process has ended before.
inline Seen seenBy(const Account& account) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    Seen seen;
    const pid_t child = fork();
    if (child == 0) {
        setenv("DBUS_SYSTEM_BUS_ADDRESS", account.systemBus, 1);
        setenv("DBUS_SESSION_BUS_ADDRESS", account.userBus, 1);
        Seen own;
        if (dropTo(account.priority, account.nice)) {
            sched_param realtime{.sched_priority = int(account.priority) + 1};
            const bool rights = sched_setscheduler(0, SCHED_FIFO, &realtime) == 0;
            RealtimeThread thread;
            const bool started =
                thread.start("tactum-test", account.asked, [&] { own = lookAtMyself(account); }).has_value();
            thread.join();
            own.started = started;
            own.rights = rights;
            own.told = thread.urgency();
        }
        _exit(::write(ends[1], &own, sizeof own) == sizeof own ? 0 : 1);
    }
    close(ends[1]);
    if (::read(ends[0], &seen, sizeof seen) != sizeof seen) seen.started = false;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return seen;
}

} // namespace tactum::test
