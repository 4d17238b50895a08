// Counts every allocation, release, lock, wait, text and blocking call that happens inside a RealtimeScope,
// whoever calls it: our own code, Eigen, the standard library or a shared library.
//
// The program that links interposer.cpp defines malloc, pthread_mutex_lock and their kin itself; each of
// them looks at insideRealtime() of its own thread, notes a hit, and goes on to the C library's own.
#pragma once

#include <cstdint>
#include <string>

namespace tactum::interposer {

/// Forgets every hit. Call it outside a RealtimeScope, while no loop runs.
void reset();
/// How many calls were seen inside a RealtimeScope since reset().
std::uint64_t hits();
/// Name of the first function that was called there, and the addresses that led to it, for addr2line.
std::string firstHit();

} // namespace tactum::interposer
