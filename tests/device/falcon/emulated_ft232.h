// The Falcon's USB chip, an FT232R: two bytes of its own in each packet, a latency timer, a serial line at a
// rate.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <span>

#include "tests/device/usb/emulated_usb.h"

namespace tactum::test {

/// `hurry`: how many times faster than a real one its timer and its line are. Times in ns.
class EmulatedFt232 {
public:
    explicit EmulatedFt232(double hurry) : hurry_(hurry) {}

    // The side of the host.

    /// nullopt: a request that it does not know.
    std::optional<Bytes> control(const UsbSetup& setup);
    void fromHost(std::span<const std::uint8_t> bytes, std::int64_t now);
    std::optional<Bytes> toHost(std::int64_t now);
    std::int64_t nextToHost(std::int64_t now) const;

    // The side of the processor.

    struct LineByte {
        std::uint8_t byte = 0;
        double baud = 0; ///< at which it was sent
        std::int64_t at = 0;
    };
    /// The next byte that has come down the line by now.
    std::optional<LineByte> fromLine(std::int64_t now);
    /// Sends a byte up the line; the other rate makes another byte of it.
    void toLine(std::uint8_t byte, double baud, std::int64_t now);
    double baud() const { return baud_; }
    /// Whether DTR rose since the last question.
    bool takeReset();

    bool split = false;  ///< packets go when they have a few bytes
    bool babble = false; ///< the next packet is longer than any may be
    int latency = 16;    ///< ms

private:
    std::int64_t scaled(double seconds) const { return std::int64_t(1e9 * seconds / hurry_); }

    double hurry_;
    double baud_ = 9600;
    bool dtr_ = false, reset_ = false;
    std::deque<LineByte> down_, up_;
    std::int64_t downBusy_ = 0, upBusy_ = 0; ///< until then the line carries what was sent before
    std::int64_t lastPacket_ = 0;
};

} // namespace tactum::test
