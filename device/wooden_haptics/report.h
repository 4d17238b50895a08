// What goes over the wire of WoodenHaptics: HID reports of 8 bytes without a number of their own,
// little-endian.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/base/vec.h"

namespace tactum {

inline constexpr std::size_t kWoodenReportSize = 8;
using WoodenBytes = std::array<std::uint8_t, kWoodenReportSize>;

/// Both ways the same: three numbers, one for each motor, and a count of the reports.
struct WoodenReport {
    std::array<std::int16_t, 3> values{}; ///< from the device encoder counts, to it mA
    std::uint16_t counter = 0;
    bool operator==(const WoodenReport&) const = default;
};

/// Thread: real time.
inline WoodenBytes encode(const WoodenReport& report) noexcept {
    WoodenBytes bytes{};
    const auto put = [&](std::size_t at, std::uint16_t word) {
        bytes[at] = static_cast<std::uint8_t>(word);
        bytes[at + 1] = static_cast<std::uint8_t>(word >> 8);
    };
    for (std::size_t i = 0; i < 3; ++i)
        put(2 * i, static_cast<std::uint16_t>(report.values[i]));
    put(6, report.counter);
    return bytes;
}

/// nullopt: not a report. Thread: real time.
inline std::optional<WoodenReport> decode(std::span<const std::uint8_t> bytes) noexcept {
    if (bytes.size() != kWoodenReportSize) return std::nullopt;
    const auto word = [&](std::size_t at) {
        return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8);
    };
    WoodenReport report;
    for (std::size_t i = 0; i < 3; ++i)
        report.values[i] = static_cast<std::int16_t>(word(2 * i));
    report.counter = word(6);
    return report;
}

/// In the device's unit, rounded. Thread: real time.
inline std::array<std::int16_t, 3> milliamperes(const Vec3& amperes) noexcept {
    const auto rounded = [](double a) { return static_cast<std::int16_t>(std::lround(1000 * a)); };
    return {rounded(amperes[0]), rounded(amperes[1]), rounded(amperes[2])};
}

} // namespace tactum
