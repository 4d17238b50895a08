// What the tests of the link plug in, and how they open it.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include <QTest>

#include "device/usb/usb_link.h"
#include "tests/device/usb/emulated_usb.h"
#include "tests/device/usb/shared_value.h"

namespace tactum::test {

inline constexpr UsbId kId{0x1209, 0x0001};
inline constexpr int kSocket = 3;

/// Says numbers, one a packet, and remembers what it was told.
class Counter final : public EmulatedUsbDevice {
public:
    explicit Counter(bool interrupt = false) : interrupt_(interrupt) {}

    UsbDescription describe() const override {
        UsbDescription about{kId.vendor, kId.product, 0x0100, "Tactum", "Counter"};
        about.interrupt = interrupt_;
        if (interrupt_) about.interfaceClass = 3;
        return about;
    }
    std::optional<Bytes> control(const UsbSetup& setup, std::span<const std::uint8_t>,
                                 std::int64_t) override {
        if (setup.request != 7) return std::nullopt;
        told = setup.value;
        return Bytes{};
    }
    void out(std::span<const std::uint8_t> bytes, std::int64_t) override {
        heard.assign(bytes.begin(), bytes.end());
        ++(*commands);
        *lastByte = bytes.empty() ? 0 : bytes.back();
    }
    std::optional<Bytes> in(std::int64_t) override {
        if (left == 0) return std::nullopt;
        --left;
        ++said;
        Bytes packet(length, 0);
        packet[0] = static_cast<std::uint8_t>(said);
        packet[1] = static_cast<std::uint8_t>(said >> 8);
        return packet;
    }
    std::int64_t nextIn(std::int64_t now) const override { return now + 1'000'000; }

    int left = 0; ///< packets that it still has to say
    std::size_t length = 8;
    int said = 0;
    int told = -1;
    Bytes heard;
    SharedValue<std::atomic<int>> commands, lastByte;

private:
    bool interrupt_;
};

inline int numberIn(std::span<const std::uint8_t> packet) {
    return packet[0] | packet[1] << 8;
}

inline std::shared_ptr<Counter> plugCounter(bool interrupt = false) {
    auto device = std::make_shared<Counter>(interrupt);
    EmulatedBus::the().plug(kSocket, device);
    return device;
}

inline std::vector<UsbPlace> places() {
    const UsbId wanted[] = {kId};
    return listUsb(wanted).value();
}

inline Result<std::unique_ptr<UsbLink>> open(bool interrupt = false) {
    UsbEndpoints endpoints;
    endpoints.interrupt = interrupt;
    return UsbLink::open(places().at(0), endpoints);
}

inline void setFaults(const UsbFaults& faults) {
    EmulatedBus::the().setFaults(kSocket, faults);
}

inline bool isClean() {
    return EmulatedBus::the().openDescriptors() == 0 && EmulatedBus::the().pendingTransfers() == 0;
}

/// Until `wanted` holds: for what needs libusb's time-outs, which go by the real clock.
template <class Wanted> bool pollUntil(UsbLink& link, Wanted wanted) {
    for (int i = 0; i < 5000; ++i) {
        if (wanted()) return true;
        link.poll();
        QTest::qSleep(1);
    }
    return false;
}

inline const Bytes kHello{'h', 'e', 'l', 'l', 'o'};

} // namespace tactum::test
