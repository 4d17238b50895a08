#include "tests/device/usb/usb_descriptors.h"

namespace tactum::test {

namespace {

constexpr std::uint8_t kDevice = 1, kConfiguration = 2, kString = 3, kInterface = 4, kEndpoint = 5,
                       kHid = 0x21;
constexpr std::size_t kDeviceLength = 18;

std::uint8_t low(std::uint16_t value) {
    return static_cast<std::uint8_t>(value);
}
std::uint8_t high(std::uint16_t value) {
    return static_cast<std::uint8_t>(value >> 8);
}

void append(Bytes& to, const Bytes& more) {
    to.insert(to.end(), more.begin(), more.end());
}

Bytes deviceDescriptor(const UsbDescription& d) {
    return {kDeviceLength,
            kDevice,
            0x00,
            0x02,
            0,
            0,
            0,
            8,
            low(d.vendor),
            high(d.vendor),
            low(d.product),
            high(d.product),
            low(d.release),
            high(d.release),
            1,
            2,
            0,
            1};
}

Bytes endpointDescriptor(const UsbDescription& d, std::uint8_t address) {
    const std::uint8_t kind = d.interrupt ? 3 : 2;
    return {7, kEndpoint, address, kind, low(d.packet), high(d.packet), 1};
}

Bytes configuration(const UsbDescription& d) {
    Bytes parts{9, kInterface, 0, 0, 2, d.interfaceClass, 0, 0, 0};
    if (d.interfaceClass == 3) append(parts, {9, kHid, 0x11, 0x01, 0, 1, 0x22, 0, 0});
    append(parts, endpointDescriptor(d, 0x81));
    append(parts, endpointDescriptor(d, d.out));
    const auto total = static_cast<std::uint16_t>(9 + parts.size());
    Bytes whole{9, kConfiguration, low(total), high(total), 1, 1, 0, 0x80, 45};
    append(whole, parts);
    return whole;
}

/// Of the language US English, from plain ASCII.
Bytes stringDescriptor(const std::string& text) {
    Bytes bytes{static_cast<std::uint8_t>(2 + 2 * text.size()), kString};
    for (const char c : text)
        append(bytes, {static_cast<std::uint8_t>(c), 0});
    return bytes;
}

std::optional<Bytes> descriptor(const UsbDescription& d, std::uint16_t value) {
    switch (high(value)) {
    case kDevice:
        return deviceDescriptor(d);
    case kConfiguration:
        return configuration(d);
    case kString:
        if (low(value) == 0) return Bytes{4, kString, 0x09, 0x04};
        return stringDescriptor(low(value) == 1 ? d.maker : d.name);
    default:
        return std::nullopt;
    }
}

} // namespace

Bytes descriptorBytes(const UsbDescription& description) {
    Bytes bytes = deviceDescriptor(description);
    append(bytes, configuration(description));
    return bytes;
}

std::optional<Bytes> standardAnswer(const UsbDescription& description, const UsbSetup& setup) {
    if (setup.type == 0x80 && setup.request == 6) return descriptor(description, setup.value);
    if (setup.type == 0x80 && setup.request == 8) return Bytes{1};             // the configuration
    if ((setup.type & 0xfc) == 0x80 && setup.request == 0) return Bytes{0, 0}; // the status of anything
    return std::nullopt;
}

} // namespace tactum::test
