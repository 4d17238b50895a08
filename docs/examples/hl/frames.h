// What the examples share: a picture's pace, and the end of a program that was told what went wrong.
#pragma once

#include <chrono>
#include <cstdio>
#include <thread>

#include "app/hl/hl.h"

/// Calls frame(seconds) sixty times a second until it returns true, for `longest` seconds at most.
template <class Frame> bool run(double longest, Frame frame) {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    for (long long i = 0;; ++i) {
        const double now = std::chrono::duration<double>(Clock::now() - begin).count();
        if (frame(now)) return true;
        if (now > longest) return false;
        std::this_thread::sleep_until(begin + i * std::chrono::microseconds(16667));
    }
}

/// For the last line of main().
inline int ended(bool well, const char* what) {
    const std::string why = hl::error();
    std::printf("%s%s%s\n", what, why.empty() ? "" : ": ", why.c_str());
    return well && why.empty() ? 0 : 1;
}
