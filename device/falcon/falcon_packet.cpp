#include "device/falcon/falcon_packet.h"

#include <algorithm>

namespace tactum {
namespace {

constexpr std::uint8_t kBegin = '<', kEnd = '>', kZero = 'A';
constexpr std::size_t kFlags = 13, kUnknown = 14, kLast = 15;

/// Four letters, the lowest four bits first.
void putNumber(FalconPacket& packet, std::size_t at, std::int16_t value) noexcept {
    const auto bits = std::uint16_t(value);
    for (int i = 0; i < 4; ++i)
        packet[at + std::size_t(i)] = std::uint8_t(kZero + ((bits >> (4 * i)) & 15));
}

std::int16_t numberAt(const FalconPacket& packet, std::size_t at) noexcept {
    unsigned bits = 0;
    for (int i = 0; i < 4; ++i)
        bits |= unsigned(packet[at + std::size_t(i)] - kZero) << (4 * i);
    return std::int16_t(std::uint16_t(bits));
}

bool isLetter(std::uint8_t byte) noexcept {
    return byte >= kZero && byte <= kZero + 15;
}

/// The unknown byte is anything but a bracket: that would be a report with bytes missing.
bool hasForm(const FalconPacket& packet) noexcept {
    return packet[0] == kBegin && packet[kLast] == kEnd &&
           std::all_of(packet.begin() + 1, packet.begin() + kFlags, isLetter) && packet[kFlags] >= kZero &&
           packet[kFlags] < kZero + 0x80 && packet[kUnknown] != kBegin && packet[kUnknown] != kEnd;
}

} // namespace

FalconPacket encodeCommand(const FalconCommand& command) noexcept {
    FalconPacket packet;
    packet.fill(kZero);
    packet[0] = kBegin;
    for (std::size_t leg = 0; leg < 3; ++leg)
        putNumber(packet, 1 + 4 * leg, command.motors[leg]);
    packet[kFlags] = std::uint8_t(kZero + (command.homing ? 1 : 0) + std::uint8_t(command.light));
    packet[kLast] = kEnd;
    return packet;
}

std::optional<FalconReport> decodeReport(const FalconPacket& packet) noexcept {
    if (!hasForm(packet)) return std::nullopt;
    const unsigned flags = packet[kFlags] - kZero;
    FalconReport report{.buttons = std::uint8_t(flags & 15), .homed = std::uint8_t(flags >> 4)};
    for (std::size_t leg = 0; leg < 3; ++leg)
        report.counts[leg] = numberAt(packet, 1 + 4 * leg);
    return report;
}

std::span<const std::uint8_t> falconPayload(std::span<const std::uint8_t> usbPacket) noexcept {
    constexpr std::size_t kOfTheChip = 2;
    return usbPacket.size() > kOfTheChip ? usbPacket.subspan(kOfTheChip) : std::span<const std::uint8_t>();
}

std::optional<FalconReport> FalconStream::operator()(std::uint8_t byte) noexcept {
    if (size_ == 0 && byte != kBegin) {
        ++dropped_;
        return std::nullopt;
    }
    begun_[size_++] = byte;
    if (size_ < kFalconPacket) return std::nullopt;
    const std::optional<FalconReport> report = decodeReport(begun_);
    if (report)
        size_ = 0;
    else
        dropToNextBegin();
    return report;
}

/// A report may have begun inside what looked like one.
void FalconStream::dropToNextBegin() noexcept {
    const auto next = std::find(begun_.begin() + 1, begun_.end(), kBegin);
    size_ = std::size_t(begun_.end() - next);
    dropped_ += kFalconPacket - size_;
    std::copy(next, begun_.end(), begun_.begin());
}

} // namespace tactum
