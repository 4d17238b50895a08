#include "device/falcon/falcon_line.h"

#include <algorithm>
#include <thread>

namespace tactum {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

/// Requests of FTDI's chips, with the values of which there is one.
enum Request : std::uint8_t { kReset = 0, kModem = 1, kFlow = 2, kRate = 3, kFormat = 4, kTimer = 9 };
constexpr std::uint16_t kPurgeOne = 1, kPurgeOther = 2;
constexpr std::uint16_t kDtrLow = 0x0100, kDtrHigh = 0x0101, kRtsLow = 0x0200;
constexpr std::uint16_t kNoFlowControl = 0, kEightBits = 8;

struct Setting {
    Request request;
    std::uint16_t value;
};

Result<void> request(UsbLink& link, std::initializer_list<Setting> settings) {
    for (const Setting& setting : settings)
        if (auto done = link.request(setting.request, setting.value, 0); !done) return done;
    return {};
}

} // namespace

/// Always both: which is which is told both ways.
Result<void> purgeFalcon(UsbLink& link) {
    return request(link, {{kReset, kPurgeOne}, {kReset, kPurgeOther}});
}

Result<void> setFalconLine(UsbLink& link, const FalconLine& line) {
    return request(link, {{kTimer, line.timer}, {kRate, line.rate}});
}

Result<void> resetFalcon(UsbLink& link, double pause) {
    const Result<void> low =
        request(link, {{kFormat, kEightBits}, {kFlow, kNoFlowControl}, {kModem, kRtsLow}, {kModem, kDtrLow}});
    if (!low) return low;
    std::this_thread::sleep_for(std::chrono::duration<double>(pause));
    return request(link, {{kModem, kDtrHigh}});
}

Result<void> releaseFalconReset(UsbLink& link) {
    return request(link, {{kModem, kDtrLow}});
}

Result<std::vector<std::uint8_t>> hearFalcon(UsbLink& link, milliseconds patience) {
    auto packet = link.read(int(patience.count()));
    if (!packet) return packet;
    const auto heard = falconPayload(*packet);
    return std::vector<std::uint8_t>(heard.begin(), heard.end());
}

Result<std::optional<FalconReport>> askFalcon(UsbLink& link, const FalconCommand& command) {
    constexpr milliseconds kPatience{50}, kPacket{20};
    if (auto sent = link.write(encodeCommand(command)); !sent) return tl::unexpected(sent.error());
    FalconStream stream;
    std::optional<FalconReport> answer;
    for (const auto end = Clock::now() + kPatience; !answer && Clock::now() < end;) {
        const auto heard = hearFalcon(link, kPacket);
        if (!heard) return tl::unexpected(heard.error());
        for (const std::uint8_t byte : *heard)
            if (const auto report = stream(byte)) answer = report;
    }
    return answer;
}

} // namespace tactum
