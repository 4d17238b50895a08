// Marks code that runs on a real-time thread, and code that must not.
//
// A header says "Thread: real time" for a function that neither allocates, locks, throws, blocks nor
// writes text. `RealtimeScope` opens the section in which that holds; slow code calls
// `assertNotRealtime()`, so that a wrong call stops a debug build at the place of the mistake. The
// interposer test (tests/realtime) proves the same for malloc, free and locks, whoever calls them.
#pragma once

#include <cassert>

namespace tactum {

namespace detail {
inline thread_local int realtimeDepth = 0;
}

/// Thread: real time. Everything until the end of the scope is the haptic step of some loop.
class RealtimeScope {
public:
    RealtimeScope() noexcept { ++detail::realtimeDepth; }
    ~RealtimeScope() { --detail::realtimeDepth; }
    RealtimeScope(const RealtimeScope&) = delete;
    RealtimeScope& operator=(const RealtimeScope&) = delete;
};

inline bool insideRealtime() noexcept {
    return detail::realtimeDepth > 0;
}

/// Call first in everything that allocates, locks or waits.
inline void assertNotRealtime() noexcept {
    assert(!insideRealtime());
}

} // namespace tactum
