// Waiting for a word in memory to change, between threads and between processes.
#pragma once

#include <atomic>
#include <climits>
#include <cstdint>
#include <ctime>
#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace tactum {

using FutexWord = std::atomic<std::uint32_t>;
static_assert(sizeof(FutexWord) == sizeof(std::uint32_t) && FutexWord::is_always_lock_free);

/// Wakes everybody who waits for the word. One system call, which waits for nobody. Thread: any, real time
/// too, also a maker's callback.
inline void wakeAll(FutexWord& word) noexcept {
    syscall(SYS_futex, &word, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

/// Until the word is no longer `known`, or until a moment in ns of monotonicNanoseconds(); returns the word
/// then. Thread: any, outside every RealtimeScope.
inline std::uint32_t waitForChange(const FutexWord& word, std::uint32_t known, std::int64_t until) noexcept {
    constexpr std::int64_t kSecond = 1'000'000'000;
    const timespec when{time_t(until / kSecond), long(until % kSecond)};
    while (true) {
        const std::uint32_t now = word.load(std::memory_order_acquire);
        if (now != known) return now;
        timespec clock{};
        clock_gettime(CLOCK_MONOTONIC, &clock);
        if (std::int64_t(clock.tv_sec) * kSecond + clock.tv_nsec >= until) return now;
        syscall(SYS_futex, &word, FUTEX_WAIT_BITSET, known, &when, nullptr, FUTEX_BITSET_MATCH_ANY);
    }
}

} // namespace tactum
