#include "tests/device/falcon/emulated_ft232.h"

#include <algorithm>
#include <utility>

namespace tactum::test {
namespace {

constexpr std::size_t kPayload = 62;
constexpr double kBits = 10; ///< of a byte on the line

double baudOf(std::uint16_t value) {
    if ((value & 0x3fff) == 0) return 3e6;
    constexpr double kEighths[] = {0, 0.5, 0.25, 0.125};
    return 3e6 / ((value & 0x3fff) + kEighths[value >> 14]);
}

} // namespace

std::optional<Bytes> EmulatedFt232::control(const UsbSetup& setup) {
    const std::uint16_t value = setup.value;
    if (setup.type == 0xc0 && setup.request == 10) return Bytes{std::uint8_t(latency)};
    if (setup.type != 0x40) return std::nullopt;
    switch (setup.request) {
    case 0:
        if (value > 2) return std::nullopt;
        if (value != 1) down_.clear();
        if (value != 2) up_.clear();
        return Bytes{};
    case 1: {
        const bool dtr = value & 0x100 ? value & 1 : dtr_;
        reset_ = reset_ || (dtr && !dtr_);
        dtr_ = dtr;
        return Bytes{};
    }
    case 2:
        return value == 0 ? std::optional(Bytes{}) : std::nullopt;
    case 3:
        baud_ = baudOf(value);
        return Bytes{};
    case 4:
        return value == 8 ? std::optional(Bytes{}) : std::nullopt;
    case 9:
        if (value < 1 || value > 255) return std::nullopt;
        latency = value;
        return Bytes{};
    default:
        return std::nullopt;
    }
}

bool EmulatedFt232::takeReset() {
    return std::exchange(reset_, false);
}

void EmulatedFt232::fromHost(std::span<const std::uint8_t> bytes, std::int64_t now) {
    for (const std::uint8_t byte : bytes) {
        downBusy_ = std::max(downBusy_, now) + scaled(kBits / baud_);
        down_.push_back({byte, baud_, downBusy_});
    }
}

std::optional<EmulatedFt232::LineByte> EmulatedFt232::fromLine(std::int64_t now) {
    if (down_.empty() || down_.front().at > now) return std::nullopt;
    const LineByte byte = down_.front();
    down_.pop_front();
    return byte;
}

void EmulatedFt232::toLine(std::uint8_t byte, double baud, std::int64_t now) {
    constexpr std::size_t kRoom = 256;
    upBusy_ = std::max(upBusy_, now) + scaled(kBits / baud);
    if (up_.size() >= kRoom) return; // nobody fetches them
    const bool readable = baud > 0.97 * baud_ && baud < 1.03 * baud_;
    up_.push_back({readable ? byte : std::uint8_t(byte * 7 ^ 0xe5), baud, upBusy_});
}

/// A full packet goes at once, any other when the timer says so.
std::optional<Bytes> EmulatedFt232::toHost(std::int64_t now) {
    const auto ready = std::size_t(
        std::count_if(up_.begin(), up_.end(), [now](const LineByte& byte) { return byte.at <= now; }));
    if (ready < kPayload && now < lastPacket_ + scaled(1e-3 * latency)) return std::nullopt;
    Bytes packet{0x01, 0x60};
    const std::size_t size = std::min(ready, split ? std::size_t(7) : kPayload);
    for (std::size_t i = 0; i < size; ++i, up_.pop_front())
        packet.push_back(up_.front().byte);
    if (std::exchange(babble, false)) packet.resize(80, '<');
    // The bus is looked at now and then; the host's reads waited all the while.
    constexpr int kReads = 3;
    const std::int64_t period = scaled(1e-3 * latency);
    lastPacket_ = std::clamp(lastPacket_ + period, now - kReads * period, now);
    return packet;
}

std::int64_t EmulatedFt232::nextToHost(std::int64_t now) const {
    std::int64_t next = lastPacket_ + scaled(1e-3 * latency);
    if (up_.size() >= kPayload) next = std::min(next, up_[kPayload - 1].at);
    // What is still on its way down may be answered as soon as it has arrived.
    if (!down_.empty()) next = std::min(next, down_.back().at + scaled(2 * kBits / down_.back().baud));
    return std::max(next, now);
}

} // namespace tactum::test
