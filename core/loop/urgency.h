// How early the kernel lets a thread run: what is asked for, what an ordinary account is granted, and in
// words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tactum {

/// What a servo asks for. Loops that may wait for it ask for less.
inline constexpr int kServoPriority = 80;

/// Who gives priority to accounts without a limit (realtime_broker.h).
enum class PriorityBroker { None, RealtimeKit, Portal };

/// What one thread was granted: the first rung of the ladder that nobody refused.
struct Urgency {
    int asked = 0;                                ///< priority, 1 to 99
    int priority = 0;                             ///< under SCHED_FIFO, by a broker under SCHED_RR; 0: none
    PriorityBroker broker = PriorityBroker::None; ///< who gave the priority where the kernel refused it
    int refusal = 0;                              ///< errno of what was asked for; 0: granted as asked
    int nice = 0;       ///< where there is no priority; below 0: before ordinary threads
    bool slice = false; ///< woken at once where an ordinary thread would have to wait (Linux 6.12 and later)
};

/// The largest priority that a thread of this process may ask for. Raises the soft limit to the hard one.
/// Thread: any but real time.
int allowedPriority() noexcept;

/// Whether a thread of this process would be granted it: an administrator's always. Thread: as above.
bool mayHavePriority(int priority) noexcept;

/// What is tried one after the other where so much is allowed: as asked, as allowed, 50, 20, and 0, which is
/// none. Whoever asks for less than a servo is that much lower on each rung, by a tenth, so that it never
/// stands in a servo's way.
std::vector<int> rungsOf(int asked, int allowed);
/// On a rung that is as high as this.
int onRung(int asked, int rung);

/// Everything that helps without priority: nice as the limit allows, the shortest slice, timers without
/// slack. None of it is missed where there is priority. Thread: the one that gets it, before its loop.
void hasten(Urgency& urgency) noexcept;

/// What sentenceOf() is made of beside numbers and the words of the system, so that a window can say it in
/// another language.
inline constexpr std::string_view kUrgencyWords[] = {
    "Real-time priority and locked memory were granted.",
    "The loops run with real-time priority ",
    "The loops run with no real-time priority",
    " by RealtimeKit",
    " by the desktop portal",
    ", but slices of 0.1 ms and exact timers",
    ", but exact timers",
    " and memory that may be swapped out",
    ": allow more with the lines \"<user> - rtprio 90\", \"<user> - nice -15\" and \"<user> - memlock "
    "unlimited\" "
    "in /etc/security/limits.d/tactum.conf, then log in again.",
};

/// One sentence: what the loops were granted and what helps. `unlocked`: errno of lockPresentMemory().
std::string sentenceOf(const Urgency& urgency, int unlocked);

/// As long as it lives no processor falls so deep asleep that it wakes late, where the system allows it: to
/// the administrator, and to whom the rule gives /dev/cpu_dma_latency. Thread: any but real time.
class AwakeProcessors {
public:
    AwakeProcessors();
    ~AwakeProcessors();
    AwakeProcessors(const AwakeProcessors&) = delete;
    AwakeProcessors& operator=(const AwakeProcessors&) = delete;

    bool granted() const { return file_ >= 0; }

private:
    int file_;
};

} // namespace tactum
