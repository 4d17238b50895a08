#include "device/falcon/falcon_preparation.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "core/base/realtime.h"
#include "device/falcon/falcon_boot.h"
#include "device/falcon/falcon_firmware.h"
#include "device/falcon/falcon_line.h"

namespace tactum {
namespace {

const std::string kFind = "Find", kFirmware = "Firmware", kAnswer = "Answer", kHome = "Home";

/// Loading fails often; the next attempt begins with opening anew.
constexpr int kAttempts = 10;
/// But who never answers has no power.
constexpr int kUnanswered = 2;
/// The first answer is often lost.
constexpr int kAsked = 3;

using Link = std::unique_ptr<UsbLink>;

tl::unexpected<Error> cancelled(const std::string& step) {
    return machineError("The Falcon was not made ready: you ended it at the step \"" + step + "\".");
}

tl::unexpected<Error> failed(const std::string& step, const std::string& sentence) {
    return machineError("Falcon, step \"" + step + "\": " + sentence);
}
tl::unexpected<Error> failed(const std::string& step, const Error& error) {
    return tl::unexpected(Error{error.kind, "Falcon, step \"" + step + "\": " + error.text});
}

class Preparation {
public:
    Preparation(UsbPlace& place, double resetPause, Opening& watcher)
        : place_(place), resetPause_(resetPause), watcher_(watcher), attended_(!watcher.cancelled()) {}

    Result<void> find();
    Result<void> load(const std::filesystem::path& firmware);
    Result<void> home();
    Link takeLink() { return std::move(link_); }

private:
    bool givenUp() const { return attended_ && watcher_.cancelled(); }
    Result<void> connect();
    Result<bool> answers();
    Result<FalconBoot> boot(const FalconFirmware& firmware);
    Result<void> waitForHome();

    UsbPlace& place_;
    double resetPause_; ///< s
    Opening& watcher_;
    bool attended_;
    Link link_;
};

Result<void> Preparation::find() {
    watcher_.begin(kFind);
    const UsbId wanted[] = {kFalconUsb};
    const auto found = listUsb(wanted);
    if (!found) return failed(kFind, found.error());
    auto here = std::ranges::find(*found, place_.port, &UsbPlace::port);
    if (here == found->end() && found->size() == 1) here = found->begin();
    if (here == found->end())
        return failed(kFind, "there is none at USB " + place_.port + ": plug in its USB cable.");
    place_ = *here;
    if (auto connected = connect(); !connected) return failed(kFind, connected.error());
    return {};
}

Result<void> Preparation::connect() {
    link_.reset();
    auto opened = UsbLink::open(place_, kFalconEndpoints);
    if (!opened) return tl::unexpected(opened.error());
    link_ = std::move(*opened);
    return {};
}

/// At the rate at which its firmware talks. The command has no torque: it is the first that it hears.
Result<bool> Preparation::answers() {
    const auto set =
        purgeFalcon(*link_).and_then([&] { return setFalconLine(*link_, kFalconRunLine); }).and_then([&] {
            return purgeFalcon(*link_);
        });
    if (!set) return tl::unexpected(set.error());
    for (int i = 0; i < kAsked; ++i) {
        const auto report = askFalcon(*link_, {.light = FalconLight::Red});
        if (!report) return tl::unexpected(report.error());
        if (*report) return true;
    }
    return false;
}

/// Firmware stays while the device has power: only who does not answer is given it.
Result<void> Preparation::load(const std::filesystem::path& path) {
    watcher_.begin(kFirmware);
    auto running = answers();
    if (!running) return failed(kFirmware, running.error());
    if (!*running) {
        const auto firmware = findFalconFirmware(path);
        if (!firmware) return failed(kFirmware, firmware.error());
        const auto booted = boot(*firmware);
        if (!booted) return failed(kFirmware, booted.error());
        if (*booted == FalconBoot::Cancelled) return cancelled(kFirmware);
        if (*booted == FalconBoot::NoAnswer)
            return failed(kFirmware, "no answer: is its power supply plugged in?");
        if (*booted == FalconBoot::LostBytes)
            return failed(kFirmware, "bytes are lost on the way: try another cable, or another socket.");
    }
    watcher_.begin(kAnswer);
    if (!*running) running = answers();
    if (!running) return failed(kAnswer, running.error());
    if (!*running)
        return failed(kAnswer, "the firmware was loaded and says nothing: is it the Falcon's? Take its power "
                               "away for some seconds, then try again.");
    return {};
}

Result<FalconBoot> Preparation::boot(const FalconFirmware& firmware) {
    Result<FalconBoot> result = FalconBoot::NoAnswer;
    for (int attempt = 0, unanswered = 0; attempt < kAttempts && unanswered < kUnanswered; ++attempt) {
        if (attempt > 0)
            if (auto connected = connect(); !connected) return tl::unexpected(connected.error());
        watcher_.begin(kFirmware);
        result = bootFalcon(*link_, firmware.bytes, resetPause_, watcher_, attended_);
        if (result && (*result == FalconBoot::Done || *result == FalconBoot::Cancelled)) return result;
        if (!result && link_->gone()) return result;
        unanswered += result && *result == FalconBoot::NoAnswer;
    }
    return result;
}

Result<void> Preparation::home() {
    watcher_.begin(kHome);
    const auto report = askFalcon(*link_, {.light = FalconLight::Red});
    if (!report) return failed(kHome, report.error());
    if (*report && (*report)->homed == FalconReport::kAllHomed) return {};
    if (!attended_)
        return failed(kHome, "it does not know where its grip is: make it ready with somebody at hand, who "
                             "pulls the grip all the way out and pushes it all the way in.");
    return waitForHome();
}

Result<void> Preparation::waitForHome() {
    constexpr int kMaxSilent = 20; // questions without an answer: a second
    watcher_.begin(kHome, "Pull the grip all the way out, then push it all the way in.");
    for (int silent = 0; silent < kMaxSilent;) {
        if (givenUp()) return cancelled(kHome);
        const auto report = askFalcon(*link_, {.light = FalconLight::Red});
        if (!report) return failed(kHome, report.error());
        silent = *report ? 0 : silent + 1;
        if (!*report) continue;
        watcher_.progress(std::popcount(unsigned((*report)->homed)) / 3.0);
        if ((*report)->homed == FalconReport::kAllHomed) return {};
    }
    return failed(kHome, "no answer any more: is its power supply plugged in?");
}

} // namespace

std::vector<std::string> falconSteps() {
    return {kFind, kFirmware, kAnswer, kHome};
}

bool isFalconReady(UsbLink& link) {
    if (!purgeFalcon(link)) return false;
    for (int i = 0; i < kAsked && !link.gone(); ++i) {
        const auto report = askFalcon(link, {.light = FalconLight::Blue});
        if (report && *report) return (*report)->homed == FalconReport::kAllHomed;
    }
    return false;
}

Result<Link> prepareFalcon(UsbPlace& place, const std::filesystem::path& firmware, double resetPause,
                           Opening& watcher) {
    assertNotRealtime();
    Preparation preparation(place, resetPause, watcher);
    const Result<void> ready =
        preparation.find().and_then([&] { return preparation.load(firmware); }).and_then([&] {
            return preparation.home();
        });
    if (!ready) return tl::unexpected(ready.error());
    return preparation.takeLink();
}

} // namespace tactum
