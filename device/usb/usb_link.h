// A USB device through libusb: found, claimed, and streamed without ever waiting. No other file knows libusb.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace tactum {

struct UsbId {
    std::uint16_t vendor = 0, product = 0;
    bool operator==(const UsbId&) const = default;
};

/// A device on the bus, not opened.
struct UsbPlace {
    UsbId id;
    int bus = 0, address = 0; ///< change with every plugging
    std::string port;         ///< "1-4.2": bus and sockets, the same when it is plugged in there again
};

/// Of its one interface.
struct UsbEndpoints {
    int interface = 0;
    std::uint8_t in = 0x81, out = 0x02;
    bool interrupt = false; ///< else bulk
    std::size_t packet = 64;
};

/// What the device is plugged into; opens nothing, so that it needs no permission.
/// Thread: any but real time.
Result<std::vector<UsbPlace>> listUsb(std::span<const UsbId> wanted);

/// One claimed device with a context of its own. Thread of a member: where it does not say otherwise any but
/// real time, and one at a time.
class UsbLink {
public:
    /// Errors: not there any more, no permission (says how the rule is installed), claimed by another.
    static Result<std::unique_ptr<UsbLink>> open(const UsbPlace& place, const UsbEndpoints& endpoints);
    /// Ends the stream, gives the device back.
    ~UsbLink();
    UsbLink(const UsbLink&) = delete;
    UsbLink& operator=(const UsbLink&) = delete;

    // Setting up: waits at most `timeout` ms. Not while the stream runs.

    /// A vendor request without data, to the device.
    Result<void> request(std::uint8_t request, std::uint16_t value, std::uint16_t index, int timeout = 200);
    Result<void> write(std::span<const std::uint8_t> bytes, int timeout = 200);
    /// Whatever one transfer of a packet brings; empty when nothing came in time.
    Result<std::vector<std::uint8_t>> read(int timeout = 50);

    // The stream: `reads` transfers wait for packets at any time, for as long as it takes; writes go beside
    // them, each with a time-out of 5 ms.

    Result<void> startStream(int reads = 3);
    void stopStream();
    /// Hands a packet over and returns; false when the one before is still under way: it was not sent.
    /// Thread: servo. Allocates and locks inside libusb, never waits.
    bool send(std::span<const std::uint8_t> bytes) noexcept;
    /// Takes in what has come since the last call, without waiting; but for a stalled endpoint, whose
    /// clearing takes about a millisecond. Packets that nobody takes make room for newer ones. Thread: as
    /// send().
    void poll() noexcept;
    /// The oldest packet that was not taken yet, its bytes valid until the next poll(); empty when there is
    /// none. Thread: as send().
    std::span<const std::uint8_t> take() noexcept;
    /// Transfers that failed or timed out in a row, of writing or of reading, whichever is worse. Thread: as
    /// send().
    int failures() const noexcept;
    /// The device is not there any more: no transfer will ever succeed, and take() has nothing. Thread: any.
    bool gone() const noexcept;

    /// The shortest way to the device, past libusb: for HapticDevice::emergencyStop(). Thread: any, also a
    /// signal handler and a forked child; async-signal-safe.
    void sendNow(std::span<const std::uint8_t> bytes) noexcept;

private:
    struct Impl;
    explicit UsbLink(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

} // namespace tactum
