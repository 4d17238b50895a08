// What a loop remembers, as bytes: what the recorder keeps of it, and what a replay begins with.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/haptics/haptic_step.h"
#include "core/safety/servo_step.h"

namespace tactum {

/// A state on entry to a row. Trivially copyable, so that it can cross threads in a ring.
template <std::size_t Room> struct StateBytes {
    std::uint64_t row = 0;  ///< number of the row that follows
    std::uint64_t size = 0; ///< bytes that are used; 0: the state did not fit
    std::array<std::byte, Room> bytes;

    std::span<const std::byte> used() const noexcept { return {bytes.data(), std::size_t(size)}; }
};
using SimStateBytes = StateBytes<32 * 1024>;
using ServoStateBytes = StateBytes<4 * 1024>;

/// All but the sweep memories, which only make the next steps faster.
/// Thread: real time; some microseconds.
void write(const SimState& state, SimStateBytes& to) noexcept;
/// Of a hand beside the first: without what all share.
void write(const HandState& state, SimStateBytes& to) noexcept;
void write(const ServoState& state, ServoStateBytes& to) noexcept;

/// False when the bytes cannot be those of a state; `state` is then half read. The servo's state may hold
/// numbers that are not finite, as after a fault. Thread: real time.
bool read(std::span<const std::byte> bytes, SimState& state) noexcept;
bool read(std::span<const std::byte> bytes, HandState& state) noexcept;
bool read(std::span<const std::byte> bytes, ServoState& state) noexcept;

/// Whether everything that the state names exists in the World, which it must be used with.
/// Thread: real time.
bool belongsTo(const HandState& state, const World& world) noexcept;

} // namespace tactum
