#include "device/falcon/falcon_boot.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "core/base/realtime.h"
#include "device/falcon/falcon_line.h"

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using Bytes = std::vector<std::uint8_t>;

constexpr std::array<std::uint8_t, 3> kCall{'\n', 'C', '\r'};
constexpr std::array<std::uint8_t, 4> kBootAnswer{'\n', 'D', ',', '\r'};
constexpr std::array<std::uint8_t, 1> kLock{'A'}; // from it the boot program takes the rate

/// The first calls are often not heard.
constexpr int kCalls = 50;
constexpr milliseconds kCallPatience{40};
/// Its echo fills one packet with the chip's own two bytes, and so comes back at once.
constexpr std::size_t kBlock = 62;
constexpr milliseconds kEchoPatience{300};

/// Reads until `enough(heard)` or the time is over; returns what it came to.
template <class Enough>
Result<bool> hearUntil(UsbLink& link, Bytes& heard, milliseconds patience, Enough enough) {
    for (const auto end = Clock::now() + patience; !enough(heard) && Clock::now() < end;) {
        const auto more = hearFalcon(link, milliseconds(20));
        if (!more) return tl::unexpected(more.error());
        heard.insert(heard.end(), more->begin(), more->end());
    }
    return enough(heard);
}

template <std::size_t size> bool contains(const Bytes& heard, const std::array<std::uint8_t, size>& words) {
    return std::search(heard.begin(), heard.end(), words.begin(), words.end()) != heard.end();
}

/// Junk may come before the answer, and a part of it with the call before.
Result<FalconBoot> call(UsbLink& link, Opening& watcher, bool cancellable) {
    Bytes heard;
    for (int i = 0; i < kCalls; ++i) {
        if (cancellable && watcher.cancelled()) return FalconBoot::Cancelled;
        if (auto sent = link.write(kCall); !sent) return tl::unexpected(sent.error());
        const auto answered =
            hearUntil(link, heard, kCallPatience, [](const Bytes& h) { return contains(h, kBootAnswer); });
        if (!answered) return tl::unexpected(answered.error());
        if (*answered) return FalconBoot::Done;
    }
    return FalconBoot::NoAnswer;
}

/// Answers to earlier calls may still be on their way.
Result<void> drain(UsbLink& link) {
    constexpr int kMax = 16;
    for (int i = 0; i < kMax; ++i) {
        const auto more = hearFalcon(link, milliseconds(50));
        if (!more) return tl::unexpected(more.error());
        if (more->empty()) break;
    }
    return {};
}

Result<bool> echoes(UsbLink& link, std::span<const std::uint8_t> bytes) {
    if (auto sent = link.write(bytes); !sent) return tl::unexpected(sent.error());
    Bytes heard;
    const auto all =
        hearUntil(link, heard, kEchoPatience, [&](const Bytes& h) { return h.size() >= bytes.size(); });
    if (!all) return tl::unexpected(all.error());
    return std::equal(heard.begin(), heard.end(), bytes.begin(), bytes.end());
}

Result<FalconBoot> upload(UsbLink& link, std::span<const std::uint8_t> firmware, Opening& watcher,
                          bool cancellable) {
    for (std::size_t at = 0; at < firmware.size(); at += kBlock) {
        if (cancellable && watcher.cancelled()) return FalconBoot::Cancelled;
        const auto good = echoes(link, firmware.subspan(at, std::min(kBlock, firmware.size() - at)));
        if (!good) return tl::unexpected(good.error());
        if (!*good) return FalconBoot::LostBytes;
        watcher.progress(double(std::min(at + kBlock, firmware.size())) / double(firmware.size()));
    }
    return FalconBoot::Done;
}

} // namespace

Result<FalconBoot> bootFalcon(UsbLink& link, std::span<const std::uint8_t> firmware, double resetPause,
                              Opening& watcher, bool cancellable) {
    assertNotRealtime();
    const Result<void> reset =
        purgeFalcon(link).and_then([&] { return setFalconLine(link, kFalconBootLine); }).and_then([&] {
            return resetFalcon(link, resetPause);
        });
    if (!reset) return tl::unexpected(reset.error());
    const auto called = call(link, watcher, cancellable);
    if (!called || *called != FalconBoot::Done) return called;
    const Result<bool> locked = releaseFalconReset(link)
                                    .and_then([&] { return drain(link); })
                                    .and_then([&] { return setFalconLine(link, kFalconLoadLine); })
                                    .and_then([&] { return echoes(link, kLock); });
    if (!locked) return tl::unexpected(locked.error());
    if (!*locked) return FalconBoot::LostBytes;
    return upload(link, firmware, watcher, cancellable);
}

} // namespace tactum
