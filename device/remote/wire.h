// What a device's process and the program say to each other: packets for what takes long, shared memory for
// what must not wait. Both sides are the same program, but one of them may have crashed.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <sys/types.h>
#include <type_traits>

#include "core/port/device_figures.h"
#include "core/port/device_mailbox.h"

namespace tactum::wire {

/// The descriptors that a server inherits: the socket of packets, and after it the memory of the block.
inline constexpr int kTalk = 3, kBlock = 4;
inline constexpr std::uint32_t kVersion = 3;

using Text = std::array<char, 512>;

/// Lies in memory of both. Nothing that the other side may write into it leads out of it: the mailbox's index
/// of a slot has two bits, and what is one beyond its slots lies within.
struct Block {
    std::uint32_t version = kVersion;
    pid_t program = 0;
    DeviceMailbox mailbox;
    TripleBuffer<Text> trouble, caution;   ///< of the device, in its own words
    std::atomic<std::int64_t> lastTick{0}; ///< of the server's loop, monotonicNanoseconds()
};
static_assert(std::atomic<std::int64_t>::is_always_lock_free &&
                  std::atomic<std::uint8_t>::is_always_lock_free,
              "processes share them");

enum class Kind : std::int32_t {
    // The program asks. Each but Cancel is answered by Done.
    Prepare, ///< value 1: nobody is at hand
    Cancel,
    Open,
    Close,
    // The server tells. First Info, a Step for each, Done.
    Info,     ///< figures, text: the name
    Step,     ///< text
    Begin,    ///< text: the step, more: what to do
    Progress, ///< value
    Done,     ///< value 0, or an Error::Kind with its text
};

/// One packet; whatever it does not use is empty.
struct Packet {
    Kind kind = Kind::Done;
    double value = 0;
    Text text{}, more{};
    std::array<double, std::size(kDeviceFigures)> figures{};
    std::int32_t buttons = 0;
    std::int32_t real = 0, measuresVelocity = 0;
};
static_assert(std::is_trivially_copyable_v<Packet>);

/// Cut where it is too long.
Text textOf(std::string_view words);
std::string stringOf(const Text& text);

Packet infoPacket(const DeviceInfo& info);
DeviceInfo infoOf(const Packet& packet);
Packet donePacket(const Result<void>& result);
Result<void> resultOf(const Packet& packet);

/// False when the other side is gone.
bool send(int socket, const Packet& packet);
enum class News { Packet, None, Gone };
/// Waits for so many ms at most; 0: not at all.
News receive(int socket, int patience, Packet& packet);

} // namespace tactum::wire
