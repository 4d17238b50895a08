// The Falcon's packets: sixteen printable bytes each way, one report for each command, no checksum.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace tactum {

inline constexpr std::size_t kFalconPacket = 16;
using FalconPacket = std::array<std::uint8_t, kFalconPacket>;

/// A number for each leg: top, right, left, as the person sees them.
using FalconLegs = std::array<std::int16_t, 3>;

/// What the motors bear: the maker's own driver goes no further.
inline constexpr std::int16_t kFalconMostMotor = 4095;

enum class FalconLight : std::uint8_t { Off = 0, Green = 0x02, Blue = 0x04, Red = 0x08 };

struct FalconCommand {
    FalconLegs motors{}; ///< -kFalconMostMotor to kFalconMostMotor; positive pulls the grip in
    bool homing = true;  ///< look for the index marks; left on, for the device may forget them otherwise
    FalconLight light = FalconLight::Off;
};

struct FalconReport {
    FalconLegs counts{};      ///< of the encoders; without meaning until all are homed
    std::uint8_t buttons = 0; ///< 1 plus, 2 forward, 4 centre, 8 minus
    std::uint8_t homed = 0;   ///< a bit for each leg that has seen its index mark

    static constexpr std::uint8_t kAllHomed = 7;
    bool operator==(const FalconReport&) const = default;
};

/// Thread: real time.
FalconPacket encodeCommand(const FalconCommand& command) noexcept;
/// nullopt: not of a report's form. Thread: real time.
std::optional<FalconReport> decodeReport(const FalconPacket& packet) noexcept;

/// The bytes that a packet from the chip carries: it begins with two of the chip's own state.
/// Thread: real time.
std::span<const std::uint8_t> falconPayload(std::span<const std::uint8_t> usbPacket) noexcept;

/// Finds reports in a stream in which bytes may be missing, broken or too many. Thread: real time.
class FalconStream {
public:
    /// The next byte; the report that ends with it.
    std::optional<FalconReport> operator()(std::uint8_t byte) noexcept;
    /// What was begun will not be continued.
    void restart() noexcept { size_ = 0; }
    /// Bytes that belonged to no report.
    std::uint64_t dropped() const noexcept { return dropped_; }

private:
    void dropToNextBegin() noexcept;

    FalconPacket begun_{};
    std::size_t size_ = 0;
    std::uint64_t dropped_ = 0;
};

} // namespace tactum
