// Work over an index range on all cores, for building; never used on a real-time thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <thread>
#include <vector>

#include "core/base/realtime.h"

namespace tactum {

/// How many parts parallelFor cuts `count` items into: one for each core, one for a small range.
inline std::size_t parallelParts(std::size_t count) {
    constexpr std::size_t worthAThread = 16384;
    const std::size_t cores = std::max(1u, std::thread::hardware_concurrency());
    return std::clamp<std::size_t>(count / worthAThread, 1, cores);
}

/// Calls work(part, begin, end) for consecutive ranges, each part on its own thread; returns when all ended.
/// Thread: any but real time.
template <class Work> void parallelFor(std::size_t count, Work&& work) {
    assertNotRealtime();
    const std::size_t parts = parallelParts(count);
    std::vector<std::jthread> threads;
    for (std::size_t part = 1; part < parts; ++part)
        threads.emplace_back([&, part] { work(part, count * part / parts, count * (part + 1) / parts); });
    work(0, 0, count / parts);
}

} // namespace tactum
