// The loop that belongs to the model: takes Worlds and orders, runs hapticStep, publishes what it found.
#pragma once

#include "core/runtime/channels.h"

namespace tactum {

/// The time that one step is told, whatever the clock measured. Unit: s.
inline constexpr double kShortestStep = 1e-4, kLongestStep = 5e-3;
/// A step that takes longer than its period still sleeps for this part of it.
inline constexpr double kProxyRest = 0.125;

/// A step is rehearsed while the last one, and what was rehearsed before it, took no more than this part of
/// the period.
inline constexpr double kRehearsed = 0.25;

/// Runs until channels.stop, `rate` times a second or as often as its work allows. Steps that take longer
/// than `budget` seconds in the mean are made at a lower fidelity. Without a World or any finger it waits; a
/// step is one of all hands, and a hand whose device gives no reading has no part in it. Thread: proxy. The
/// clock lies outside the RealtimeScope, all else inside it.
void proxyLoop(Channels& channels, double rate, double budget) noexcept;

} // namespace tactum
