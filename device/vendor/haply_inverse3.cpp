#include "device/vendor/haply_inverse3.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <thread>

#include "core/base/text.h"
#include "core/loop/metronome.h"
#include "core/loop/realtime_thread.h"
#include "core/port/device_check.h"
#include "core/port/force_limiter.h"
#include "device/vendor/haply_messages.h"
#include "device/vendor/shared_mailbox.h"
#include "device/vendor/web_socket.h"

namespace tactum {
namespace {

constexpr std::string_view kHaplyPrefix = "haply:";
constexpr int kPort = 10001;
constexpr int kGreeting = 300;       ///< ms, for the service's first words
constexpr int kAnswer = 100;         ///< ms, for every other
constexpr int kHaplyMoment = 20;     ///< ms between two looks at the calibration
constexpr int kPresetPatience = 25;  ///< looks, for the workspace that was asked for
constexpr double kFelt = 0.1;        ///< N, that a service has to confirm
constexpr int kUnconfirmed = 300;    ///< commands in a row, and it is said
constexpr int kFarewells = 3;        ///< commands of zero, the last words
constexpr double kHaplySilent = 0.1; ///< s without a reading
constexpr const char* kHaplyConnect = "Connect to the Inverse Service";
constexpr const char* kHaplyCalibrate = "Calibrate";

constexpr const char* kGone = "Haply's Inverse Service does not answer any more: see that it runs, then open "
                              "the device again.";
constexpr const char* kUnplugged = "The Inverse3 is not there any more: check its cable and its power, then "
                                   "open it again.";

int port() {
    const char* named = std::getenv("TACTUM_HAPLY_PORT");
    std::int64_t number = 0;
    constexpr std::int64_t kLast = 65535;
    return named && parseNumber(named, number) && number > 0 && number <= kLast ? int(number) : kPort;
}

/// The service, and the devices of its first words.
struct Greeting {
    WebSocket socket;
    std::vector<haply::State> devices;
};

Result<Greeting> greet() {
    const auto failure = [](const std::string& why) {
        return machineError("Haply's Inverse Service does not answer at port " + std::to_string(port()) +
                            " of this machine (" + why +
                            "): install it from Haply and start it. Where it has another port, set "
                            "TACTUM_HAPLY_PORT.");
    };
    Result<WebSocket> socket = WebSocket::connect(port(), kGreeting);
    if (!socket) return failure(socket.error().text);
    std::string words;
    if (!socket->receive(words, kGreeting)) return failure("it says nothing");
    return Greeting{std::move(*socket), haply::read(words)};
}

class Haply final : public HapticDevice {
public:
    Haply(std::string id, DeviceInfo profile) : id_(std::move(id)), info_(std::move(profile)) {
        info_.real = true;
        if (info_.name.empty()) info_.name = "Inverse3";
        limiter_.maxForce = info_.maxForce;
    }
    ~Haply() override { shutDown(); }

    DeviceInfo info() const override { return info_; }
    std::vector<std::string> steps() const override { return {kHaplyConnect, kHaplyCalibrate}; }
    Result<void> prepare(Opening& opening) override;
    Result<void> open() override;
    void close() override { shutDown(); }
    std::string trouble() const override;
    std::string caution() const override;
    DeviceSample exchange(const DeviceCommand& command, double) noexcept override {
        const std::int64_t now = monotonicNanoseconds();
        mailbox_->command(command.force, now);
        return mailbox_->newest(now);
    }
    bool awaitFrame(std::int64_t until) noexcept override {
        mailbox_->awaitReading(until);
        return true;
    }
    void announce(const DeviceCommand& command) noexcept override {
        mailbox_->answer(command.force, monotonicNanoseconds());
    }
    void emergencyStop() noexcept override { mailbox_->stop(monotonicNanoseconds()); }

private:
    Result<void> connect();
    Result<void> configure();
    Result<void> calibrate(Opening& opening);
    bool talk(const Vec3& force, haply::State& state, haply::Asking asking = haply::Asking::Nothing);
    void judgeForce(const Vec3& commanded, const haply::State& state);
    void converse();
    void tick();
    void shutDown();

    std::string id_;
    DeviceInfo info_;
    SharedMailbox mailbox_;
    RealtimeThread thread_;
    std::atomic<bool> stop_{false}, open_{false};
    std::atomic<const char*> fault_{nullptr}; ///< a sentence
    std::atomic<std::int64_t> lastReading_{0};

    // Of the thread that talks, while it runs.
    std::optional<WebSocket> socket_;
    ForceLimiter limiter_;
    haply::Version version_;
    int unconfirmed_ = 0;
    std::atomic<bool> refused_{false}; ///< forces are asked for, and the service tells of none
    std::string words_;
};

/// Says what to push with, and takes in the answer. False: the service or the device is gone.
bool Haply::talk(const Vec3& force, haply::State& state, haply::Asking asking) {
    if (!socket_->send(haply::write(id_, force, asking, version_), kAnswer) ||
        !socket_->receive(words_, kAnswer)) {
        fault_ = kGone;
        return false;
    }
    const std::vector<haply::State> states = haply::read(words_);
    const auto mine = std::ranges::find(states, id_, &haply::State::id);
    if (mine == states.end()) {
        fault_ = kUnplugged;
        return false;
    }
    state = *mine;
    return true;
}

void Haply::tick() {
    haply::State state;
    const Vec3 force = limiter_(mailbox_->force(monotonicNanoseconds()));
    if (!talk(force, state)) {
        stop_ = true;
        return;
    }
    judgeForce(force, state);
    const std::int64_t now = monotonicNanoseconds();
    mailbox_->measured(state.sample, now);
    if (state.sample.valid) lastReading_ = now;
}

/// A service that does not understand a command answers as if it did.
void Haply::judgeForce(const Vec3& commanded, const haply::State& state) {
    if (!state.force || commanded.norm() < kFelt) return;
    unconfirmed_ = state.force->isZero(0) ? unconfirmed_ + 1 : 0;
    refused_ = unconfirmed_ > kUnconfirmed;
}

void Haply::converse() {
    Metronome metronome(info_.rate);
    while (!stop_) {
        metronome.wait();
        tick();
    }
    haply::State state;
    for (int i = 0; i < kFarewells; ++i)
        talk(Vec3::Zero(), state);
}

Result<void> Haply::connect() {
    version_ = haply::versionOf(httpGet(port(), "/version", kGreeting));
    Result<Greeting> greeting = greet();
    if (!greeting) return tl::unexpected(greeting.error());
    if (std::ranges::find(greeting->devices, id_, &haply::State::id) == greeting->devices.end())
        return machineError("The Inverse Service knows no device " + inQuotes(id_) +
                            ": connect it and switch it on.");
    socket_ = std::move(greeting->socket);
    fault_ = nullptr;
    refused_ = false;
    unconfirmed_ = 0;
    return configure();
}

/// Asks for the workspace and sees that it was taken: elsewhere the handle would be out of reach of the
/// scene.
Result<void> Haply::configure() {
    haply::State state;
    haply::Asking asking = haply::Asking::Workspace;
    for (int looks = 0; looks < kPresetPatience; ++looks) {
        if (!talk(Vec3::Zero(), state, asking)) return machineError(fault_.load());
        asking = haply::Asking::Configuration;
        if (state.preset == haply::kPreset) return {};
        std::this_thread::sleep_for(std::chrono::milliseconds(kHaplyMoment));
    }
    // A service that tells of no preset, as those before 3.5, is believed.
    if (state.preset.empty()) return {};
    socket_.reset();
    return machineError("The Inverse Service did not take the workspace " + inQuotes(haply::kPreset) +
                        " and keeps " + inQuotes(printable(state.preset)) +
                        ": install its version 3.5, or end the other program that uses the device.");
}

Result<void> Haply::calibrate(Opening& opening) {
    constexpr const char* kRequest =
        "Calibrate the device as its light asks: put the handle into its inkwell.";
    haply::State state;
    for (bool said = false;; said = true) {
        if (!talk(Vec3::Zero(), state)) return machineError(fault_.load());
        if (state.calibrated) return {};
        if (!said) opening.begin(kHaplyCalibrate, kRequest);
        if (opening.cancelled())
            return machineError(std::string("The device is not calibrated. ") + kRequest);
        std::this_thread::sleep_for(std::chrono::milliseconds(kHaplyMoment));
    }
}

Result<void> Haply::prepare(Opening& opening) {
    if (fault_) shutDown(); // what broke is begun anew
    opening.begin(kHaplyConnect);
    if (!socket_)
        if (Result<void> connected = connect(); !connected) return connected;
    opening.begin(kHaplyCalibrate);
    return calibrate(opening);
}

Result<void> Haply::open() {
    shutDown();
    if (Result<void> possible = checkDevice(info_); !possible) return possible;
    Unattended nobody;
    if (Result<void> prepared = prepare(nobody); !prepared) return prepared;
    emergencyStop(); // what an earlier use left in the mailbox
    stop_ = false;
    open_ = true;
    lastReading_ = monotonicNanoseconds();
    return thread_.start("tactum-haply", kServoPriority, [this] { converse(); });
}

void Haply::shutDown() {
    open_ = false;
    stop_ = true;
    thread_.join();
    socket_.reset();
    fault_ = nullptr;
}

std::string Haply::trouble() const {
    if (const char* fault = fault_) return fault;
    if (open_ && 1e-9 * double(monotonicNanoseconds() - lastReading_) > kHaplySilent)
        return "The Inverse Service tells no position: see in its own program that the device works.";
    return {};
}

std::string Haply::caution() const {
    if (!refused_) return {};
    return "The Inverse Service takes the forces and tells that it passes none of them on: see in Haply's "
           "own "
           "program that forces are not switched off, and install its version 3.5.";
}

} // namespace

std::vector<DeviceListing> listHaply() {
    const Result<Greeting> greeting = greet();
    if (!greeting) return {{"", "Inverse3 (Haply)", false, greeting.error().text}};
    std::vector<DeviceListing> listings;
    for (const haply::State& device : greeting->devices)
        listings.push_back({std::string(kHaplyPrefix) + device.id, "Haply Inverse3 " + printable(device.id),
                            true,
                            "connected; driven by Haply's Inverse Service, never tried with a real one"});
    if (listings.empty())
        listings.push_back({"", "Inverse3 (Haply)", false,
                            "the Inverse Service runs, but knows no device: connect one and switch it on"});
    return listings;
}

Result<std::unique_ptr<HapticDevice>> makeHaply(const std::string& id, DeviceInfo profile) {
    if (!id.starts_with(kHaplyPrefix) || id.size() == kHaplyPrefix.size())
        return inputError("There is no device " + inQuotes(id) + ": those of Haply are called " +
                          std::string(kHaplyPrefix) + "ID.");
    return std::make_unique<Haply>(id.substr(kHaplyPrefix.size()), std::move(profile));
}

} // namespace tactum
