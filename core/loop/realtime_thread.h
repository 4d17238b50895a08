// What the kernel is asked for: a thread that goes before all others, and memory that stays.
#pragma once

#include <functional>
#include <memory>
#include <pthread.h>

#include "core/base/result.h"
#include "core/loop/urgency.h"

namespace tactum {

/// A thread under SCHED_FIFO with the priority that is asked for, with as much as the account is allowed or
/// the desktop gives (realtime_broker.h), or an ordinary one that is hastened (urgency.h). Its stack is
/// touched before the body runs, so that the body meets no page fault there. Thread of every member: any one,
/// not real time.
class RealtimeThread {
public:
    RealtimeThread() = default;
    ~RealtimeThread() { join(); }
    RealtimeThread(const RealtimeThread&) = delete;
    RealtimeThread& operator=(const RealtimeThread&) = delete;

    /// Runs the body; priority 1 to 99, larger goes first. Name: at most 15 characters, for debuggers.
    /// The body neither throws nor returns before it was told to. Fails when there is no thread to be had.
    Result<void> start(const char* name, int priority, std::function<void()> body);
    /// Waits for the body's end. Safe without start().
    void join();
    /// Waits so long at most, in s; false: the body has not ended. Safe without start().
    bool joinWithin(double patience);
    /// Never waits for this body again. What the body touches must live for as long as it.
    void abandon();

    /// What start() was granted.
    const Urgency& urgency() const { return urgency_; }

private:
    pthread_t thread_{};
    bool running_ = false;
    Urgency urgency_;
};

/// Keeps the pages that the process has now in memory; returns errno, 0 for success.
/// It locks pages only as they are touched, and none that are mapped later. With MCL_FUTURE every later
/// allocation of the window would count against RLIMIT_MEMLOCK and *fail* beyond it; and without
/// MCL_ONFAULT the graphics libraries' hundreds of megabytes would be read in at once. Code, channels and
/// stacks of the loops are what this holds. A World is compiled later: its pages are in constant use.
int lockPresentMemory();

} // namespace tactum
