// Whom an account without a limit asks for priority: the desktop's own services for it.
#pragma once

#include <optional>

#include "core/loop/urgency.h"

namespace tactum {

struct BrokeredPriority {
    PriorityBroker broker = PriorityBroker::None;
    int priority = 0;
};

/// The calling thread under SCHED_RR as high as the broker allows, on the rung of what is `asked` (onRung()),
/// by RealtimeKit (org.freedesktop.RealtimeKit1 on the system's bus) or the desktop portal
/// (org.freedesktop.portal.Realtime on the user's), which is how a program in a Flatpak is granted it;
/// nothing where neither is there or both refuse. Both demand RLIMIT_RTTIME: a thread that has run for half
/// of it (0.1 s, by RealtimeKit's setting) without once waiting loses its priority, and all threads of the
/// process with it, instead of ending the program. Waits half a second at most for each that does not answer.
/// Thread: the one that gets it, before its loop; never real time.
std::optional<BrokeredPriority> priorityByBroker(int asked) noexcept;

/// The calling thread is about to end: nobody takes its priority away any more. Safe without any.
void forgetBroker() noexcept;

} // namespace tactum
