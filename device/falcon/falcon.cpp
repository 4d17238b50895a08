#include "device/falcon/falcon.h"

#include <limits>
#include <thread>

#include "core/base/realtime.h"
#include "device/falcon/falcon_line.h"
#include "device/falcon/falcon_preparation.h"

namespace tactum {
namespace {

constexpr int kButtons = 4;
constexpr int kMaxFailures = 5; ///< transfers in a row
constexpr auto kTick = std::chrono::milliseconds(1);

const char* sentenceOf(FalconTrouble trouble) {
    switch (trouble) {
    case FalconTrouble::None:
        return "";
    case FalconTrouble::Silent:
        return "The Falcon does not answer any more: is its power supply plugged in? Then connect it anew.";
    case FalconTrouble::NotHomed:
        return "The Falcon does not know where its grip is: pull the grip all the way out, then push it all "
               "the way in.";
    case FalconTrouble::Jumped:
        return "The Falcon's readings jumped: if the finger is in the wrong place, switch its power off and "
               "on and home it again.";
    case FalconTrouble::Impossible:
        return "The Falcon says that its arm is where none can be: switch its power off and on and home it "
               "again.";
    case FalconTrouble::Broken:
        return "The Falcon and this machine do not hear each other: look at its USB cable, then connect it "
               "anew.";
    case FalconTrouble::Gone:
        return "The Falcon was unplugged: plug it in and connect it anew.";
    }
    return "";
}

} // namespace

Falcon::Falcon(UsbPlace place, DeviceInfo profile, FalconSettings settings)
    : place_(std::move(place)), profile_(std::move(profile)), settings_(std::move(settings)),
      zero_(encodeCommand({.light = FalconLight::Red})) {
    profile_.buttons = kButtons;
}

Falcon::~Falcon() {
    close();
    connect(nullptr);
}

DeviceInfo Falcon::info() const {
    return profile_;
}

std::vector<std::string> Falcon::steps() const {
    return falconSteps();
}

std::string Falcon::trouble() const {
    return sentenceOf(trouble_.load(std::memory_order_relaxed));
}

// ---- Opening and closing

/// Whoever stops it in an emergency never sees a link that dies.
void Falcon::connect(std::unique_ptr<UsbLink> link) noexcept {
    emergencyLink_ = link.get();
    link_ = std::move(link);
}

Result<void> Falcon::prepare(Opening& watcher) {
    assertNotRealtime();
    close();
    if (link_ && !link_->gone() && isFalconReady(*link_)) return {};
    connect(nullptr);
    auto ready = prepareFalcon(place_, settings_.firmware, settings_.resetPause, watcher);
    if (!ready) return tl::unexpected(ready.error());
    connect(std::move(*ready));
    return {};
}

Result<void> Falcon::open() {
    assertNotRealtime();
    Unattended nobody;
    if (auto ready = prepare(nobody); !ready) return ready;
    const auto started = purgeFalcon(*link_).and_then([this] { return link_->startStream(); });
    if (!started) return started;
    streaming_ = true;
    stream_.restart();
    dropped_ = stream_.dropped();
    readings_.restart();
    unanswered_ = 0;
    unheard_ = 0;
    pushing_ = true; // for all that is known: the first zero does not wait
    trouble_ = FalconTrouble::None;
    if (startsToReport()) {
        readings_.pause(); // until the servo begins
        return {};
    }
    close();
    return machineError("The Falcon answered and fell silent: connect it anew.");
}

bool Falcon::startsToReport() {
    constexpr int kMax = 500;
    for (int i = 0; i < kMax && !link_->gone(); ++i) {
        if (exchange({}, 0).valid) return true;
        std::this_thread::sleep_for(kTick);
    }
    return false;
}

void Falcon::close() {
    if (!streaming_) return;
    sendLastZero();
    streaming_ = false;
    link_->stopStream();
}

/// Waits until all that was sent is answered; else the zero goes once more, by the short way.
void Falcon::sendLastZero() {
    constexpr int kMax = 20;
    bool sent = false;
    for (int i = 0; i < kMax && !link_->gone(); ++i) {
        link_->poll();
        newestReport();
        if (sent && unanswered_ == 0) return;
        sent = sent || send({});
        std::this_thread::sleep_for(kTick);
    }
    if (!link_->gone()) link_->sendNow(zero_);
}

// ---- The stream

DeviceSample Falcon::exchange(const DeviceCommand& wanted, double dt) noexcept {
    if (!streaming_) return {};
    link_->poll();
    DeviceSample sample = readings_(link_->gone() ? std::nullopt : newestReport(), dt);
    command(wanted.force, dt);
    const FalconTrouble trouble = troubleNow();
    trouble_.store(trouble, std::memory_order_relaxed);
    if (trouble == FalconTrouble::Gone || trouble == FalconTrouble::Broken) sample.valid = false;
    // What was read and cannot be true is no silence: the servo shall not go on from there by itself.
    else if (readings_.distrusted())
        sample = {.position = Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), .valid = true};
    return sample;
}

FalconTrouble Falcon::troubleNow() const noexcept {
    if (link_->gone()) return FalconTrouble::Gone;
    if (unheard_ > settings_.longestUnheard || link_->failures() > kMaxFailures) return FalconTrouble::Broken;
    return readings_.trouble();
}

std::optional<FalconReport> Falcon::newestReport() noexcept {
    std::optional<FalconReport> newest;
    for (auto packet = link_->take(); !packet.empty(); packet = link_->take())
        for (const std::uint8_t byte : falconPayload(packet))
            if (const auto report = stream_(byte)) {
                newest = report;
                unanswered_ = std::max(0, unanswered_ - 1);
            }
    // What broke on the way was an answer too.
    if (stream_.dropped() != dropped_) unanswered_ = 0;
    dropped_ = stream_.dropped();
    return newest;
}

/// Without a good reading there is no force, and the zero does not wait for answers.
void Falcon::command(const Vec3& force, double dt) noexcept {
    unheard_ += dt;
    if (readings_.silence() > FalconReadings::kStale) unanswered_ = 0;
    const Mat3* where = readings_.whereToPush();
    const FalconLegs motors =
        where && unheard_ <= settings_.longestUnheard
            ? falconMotors(*where, force,
                           {.countsPerTorque = settings_.countsPerTorque, .maxForce = profile_.maxForce})
            : FalconLegs{};
    const bool urgent = pushing_ && motors == FalconLegs{};
    if (urgent || unanswered_ < settings_.commandsOnWay) send(motors);
}

bool Falcon::send(const FalconLegs& motors) noexcept {
    const FalconLight light = readings_.homed() ? FalconLight::Blue : FalconLight::Red;
    if (!link_->send(encodeCommand({.motors = motors, .light = light}))) return false;
    pushing_ = motors != FalconLegs{};
    unheard_ = 0;
    ++unanswered_;
    return true;
}

/// The motors first; that the light is red then is right too.
void Falcon::emergencyStop() noexcept {
    if (UsbLink* link = emergencyLink_.load()) link->sendNow(zero_);
}

} // namespace tactum
