// An emulated USB bus under the real libusb: what a test plugs in, the driver finds, opens and talks to.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tactum::test {

using Bytes = std::vector<std::uint8_t>;

struct UsbSetup {
    std::uint8_t type = 0, request = 0;
    std::uint16_t value = 0, index = 0, length = 0;
};

/// What it says of itself.
struct UsbDescription {
    std::uint16_t vendor = 0, product = 0, release = 0;
    std::string maker, name;
    bool interrupt = false; ///< endpoints 0x81 and `out`: else bulk
    std::uint8_t out = 0x02;
    std::uint8_t interfaceClass = 0xff;
    std::uint16_t packet = 64;
};

/// The device's own side of the cable. All calls come with the bus locked, `now` in ns of CLOCK_MONOTONIC.
class EmulatedUsbDevice {
public:
    virtual ~EmulatedUsbDevice() = default;
    virtual UsbDescription describe() const = 0;
    /// A request other than the standard ones, which the bus answers. nullopt: stall.
    virtual std::optional<Bytes> control(const UsbSetup& setup, std::span<const std::uint8_t> data,
                                         std::int64_t now) = 0;
    virtual void out(std::span<const std::uint8_t> bytes, std::int64_t now) = 0;
    /// The next packet to the host if there is one at `now`. nullopt: not yet (NAK).
    virtual std::optional<Bytes> in(std::int64_t now) = 0;
    /// When in() may have something to say next; the bus asks again then. Never in the past.
    virtual std::int64_t nextIn(std::int64_t now) const = 0;
};

/// What goes wrong with the transfers of one device, until changed again.
struct UsbFaults {
    std::int64_t delay = 0; ///< ns that every completion takes longer
    bool stallIn = false, stallOut = false, stallControl = false;
    bool mute = false;   ///< nothing completes: time-outs
    int failSubmits = 0; ///< so many submissions fail with no memory
    int errors = 0;      ///< so many transfers end with a protocol error
};

/// The machine's only bus. Thread: any.
class EmulatedBus {
public:
    static EmulatedBus& the();
    /// In a socket, "1-1", "1-2", ... A device appears to the host at once.
    void plug(int socket, std::shared_ptr<EmulatedUsbDevice> device);
    /// Transfers under way end as they do on a real bus, and no later one succeeds.
    void unplug(int socket);
    void unplugAll();
    void setFaults(int socket, const UsbFaults& faults);
    /// Whether opening fails for lack of permission.
    void setForbidden(int socket, bool forbidden);
    /// Whether the kernel's own driver has it: that of HID devices, until somebody takes it away.
    bool kernelDriverHolds(int socket) const;
    /// How many file descriptors of devices libusb has open, and how many transfers it left: leaks.
    int openDescriptors() const;
    int pendingTransfers() const;
};

} // namespace tactum::test
