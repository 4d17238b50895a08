#include "device/vendor/open_haptics.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <mutex>
#include <string_view>
#include <thread>

#include "core/base/text.h"
#include "core/port/force_limiter.h"
#include "device/vendor/hd_api.h"
#include "device/vendor/own_word.h"
#include "device/vendor/shared_mailbox.h"

namespace tactum {
namespace {

constexpr std::string_view kHdPrefix = "openhaptics:", kDefault = "default";
constexpr double kMetre = 1e-3;   ///< the library speaks in millimetres
constexpr int kHdQuiet = 500;     ///< frames without an error, and the device is believed again
constexpr int kMaxErrors = 32;    ///< taken off the stack in one frame
constexpr int kHdMoment = 5;      ///< ms between two looks
constexpr int kPatience = 2000;   ///< ms, for the scheduler's first frame and an automatic calibration
constexpr int kHold = 5000;       ///< ms, that the person holds the arms still
constexpr int kFarewell = 100;    ///< ms, for the last command
constexpr double kHdSilent = 0.1; ///< s without a frame
constexpr double kHdSkew = 1e-3;  ///< of three axes that are as long as they should be, and upright
constexpr const char* kHdLoad = "Load the maker's library";
constexpr const char* kHdConnect = "Connect";
constexpr const char* kHdCalibrate = "Calibrate";

const double kHdNothing = std::numeric_limits<double>::quiet_NaN();
using Triple = std::array<double, 3>;

void pause() {
    std::this_thread::sleep_for(std::chrono::milliseconds(kHdMoment));
}

/// Waits in moments, until `done` or for so many ms at most.
template <class Done> bool waitFor(int patience, Done done) {
    for (int waited = 0; !done(); waited += kHdMoment) {
        if (waited >= patience) return false;
        pause();
    }
    return true;
}

/// Everything between the library and D: x right, y up, z toward the user, in both.
Vec3 hdInD(const Triple& values, double unit) {
    return unit * Vec3(values[0], values[1], values[2]);
}

class OpenHaptics final : public HapticDevice {
public:
    /// `name` empty: the maker's default device.
    OpenHaptics(std::string name, FiguresOf figures, const DeviceInfo& ofFamily)
        : name_(std::move(name)), figures_(std::move(figures)) {
        take(ofFamily);
    }
    ~OpenHaptics() override { shutDown(); }

    DeviceInfo info() const override {
        const std::lock_guard lock(infoMutex_);
        return info_;
    }
    std::vector<std::string> steps() const override { return {kHdLoad, kHdConnect, kHdCalibrate}; }
    Result<void> prepare(Opening& opening) override;
    Result<void> open() override;
    void close() override { shutDown(); }
    std::string trouble() const override;
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
    HandleReading handle() noexcept override { return mailbox_->handle(); }
    void emergencyStop() noexcept override { mailbox_->stop(monotonicNanoseconds()); }

private:
    Result<void> connect(Opening& opening);
    Result<void> startScheduler();
    Result<void> calibrate(Opening& opening);
    Result<void> calibrateByHand(Opening& opening);
    void shutDown();
    void take(const DeviceInfo& figures);
    Result<void> askItself();
    double ask(hd::Parameter parameter) const;
    hd::ErrorCode takeErrors() const;

    // On the maker's thread.
    static hd::CallbackCode onTick(void* device) {
        static_cast<OpenHaptics*>(device)->frame();
        return hd::kContinue;
    }
    void frame();
    void followSwitches();
    DeviceSample haptics(const Vec3& force, HandleReading& handle);
    void noteErrors();

    std::string name_;
    hd::Api api_{};
    hd::Handle handle_ = hd::kInvalidHandle;
    hd::SchedulerHandle scheduled_ = 0;
    int calibrationStyle_ = 0;
    bool running_ = false;
    SharedMailbox mailbox_;
    mutable std::mutex infoMutex_;
    FiguresOf figures_;
    DeviceInfo info_;

    std::atomic<bool> open_{false}, calibrating_{false}, resetNow_{false};
    std::atomic<hd::Enum> calibration_{0};
    std::atomic<hd::ErrorCode> fault_{hd::kSuccess};
    std::atomic<std::uint64_t> frames_{0};
    std::atomic<std::int64_t> lastFrame_{0}; ///< ns

    // Of the maker's thread alone, while it runs.
    ForceLimiter limiter_;
    int quiet_ = kHdQuiet; ///< frames since the last error
    bool output_ = false;
};

// The library's calls are made on its own thread, as its reference asks: what a frame reads and writes
// belongs to the scheduler's tick in which it was begun.

void OpenHaptics::frame() {
    followSwitches();
    const std::int64_t now = monotonicNanoseconds();
    const bool fit = open_ && quiet_ >= kHdQuiet;
    HandleReading handle;
    DeviceSample sample = haptics(fit ? limiter_(mailbox_->force(now)) : Vec3::Zero(), handle);
    noteErrors();
    sample.valid = open_ && quiet_ >= kHdQuiet && sample.position.allFinite() && sample.velocity.allFinite();
    mailbox_->measured(sample, monotonicNanoseconds(), handle);
    lastFrame_ = now;
    ++frames_;
}

/// The axes of the stylus; what is none of a turned frame is left out.
HandleReading turnedAs(const std::array<double, 16>& columns) {
    Mat3 axes;
    for (int i = 0; i < 3; ++i)
        axes.col(i) = Vec3(columns[4 * i], columns[4 * i + 1], columns[4 * i + 2]);
    if (!((axes * axes.transpose() - Mat3::Identity()).norm() < kHdSkew)) return {};
    return {.orientation = Quat(axes).normalized(), .turns = true};
}

DeviceSample OpenHaptics::haptics(const Vec3& force, HandleReading& handle) {
    Triple position{kHdNothing, kHdNothing, kHdNothing}, velocity = position;
    const Triple sent{force.x(), force.y(), force.z()};
    int buttons = 0;
    api_.beginFrame(handle_);
    api_.getDoublev(hd::kCurrentPosition, position.data());
    api_.getDoublev(hd::kCurrentVelocity, velocity.data());
    std::array<double, 16> transform{};
    api_.getDoublev(hd::kCurrentTransform, transform.data());
    handle = turnedAs(transform);
    api_.getIntegerv(hd::kCurrentButtons, &buttons);
    api_.setDoublev(hd::kCurrentForce, sent.data());
    api_.endFrame(handle_);
    return {.position = hdInD(position, kMetre),
            .velocity = hdInD(velocity, kMetre),
            .buttons = std::uint32_t(buttons)};
}

void OpenHaptics::followSwitches() {
    if (output_ != open_) {
        output_ = !output_;
        api_.makeCurrentDevice(handle_);
        (output_ ? api_.enable : api_.disable)(hd::kForceOutput);
    }
    if (!calibrating_) return;
    api_.makeCurrentDevice(handle_);
    const hd::Enum status = api_.checkCalibration();
    if (status == hd::kNeedsUpdate || resetNow_.exchange(false))
        api_.updateCalibration(hd::Enum(calibrationStyle_));
    calibration_ = status;
}

void OpenHaptics::noteErrors() {
    if (const hd::ErrorCode code = takeErrors()) {
        fault_ = code;
        quiet_ = 0;
    } else if (quiet_ < kHdQuiet && ++quiet_ == kHdQuiet) {
        fault_ = hd::kSuccess;
    }
}

/// The first that happened, which is the last on the stack: the others follow from it.
hd::ErrorCode OpenHaptics::takeErrors() const {
    hd::ErrorCode first = hd::kSuccess;
    for (int i = 0; i < kMaxErrors; ++i) {
        const hd::ErrorCode code = api_.getError().code;
        if (code == hd::kSuccess) break;
        first = code;
    }
    return first;
}

Result<void> OpenHaptics::prepare(Opening& opening) {
    if (running_ && fault_ != hd::kSuccess) shutDown(); // what broke is begun anew
    if (!running_)
        if (Result<void> connected = connect(opening); !connected) {
            shutDown();
            return connected;
        }
    opening.begin(kHdCalibrate);
    Result<void> calibrated = calibrate(opening);
    calibrating_ = false;
    return calibrated;
}

Result<void> OpenHaptics::connect(Opening& opening) {
    opening.begin(kHdLoad);
    Result<hd::Api> api = hd::load();
    if (!api) return tl::unexpected(api.error());
    api_ = *api;
    opening.begin(kHdConnect);
    takeErrors(); // of whoever used it before
    handle_ = api_.initDevice(name_.empty() ? nullptr : name_.c_str());
    if (const hd::ErrorCode code = takeErrors(); code != hd::kSuccess || handle_ == hd::kInvalidHandle) {
        handle_ = hd::kInvalidHandle;
        return machineError(hd::sentenceOf(code ? code : hd::ErrorCode(hd::kBadHandle)));
    }
    api_.makeCurrentDevice(handle_);
    if (Result<void> known = askItself(); !known) {
        shutDown();
        return known;
    }
    return startScheduler();
}

double OpenHaptics::ask(hd::Parameter parameter) const {
    double value = 0;
    api_.getDoublev(parameter, &value);
    return value;
}

// The answer to a frame goes out with the next one, as in a loop of our own: no tick more than the profile's.
void OpenHaptics::take(const DeviceInfo& figures) {
    info_ = figures;
    info_.real = true;
}

Result<void> OpenHaptics::askItself() {
    constexpr double kPerMillimetre = 1e3;
    const char* const model = api_.getString(hd::kDeviceModelType);
    const Result<DeviceInfo> figures = figures_(model ? printable(model) : std::string());
    if (!figures) return tl::unexpected(figures.error());
    const std::lock_guard lock(infoMutex_);
    take(*figures);
    lowerTo(info_.maxForce, ask(hd::kNominalMaxForce));
    if (info_.continuousForce > 0) lowerTo(info_.continuousForce, ask(hd::kNominalMaxContinuousForce));
    lowerTo(info_.maxStiffness, kPerMillimetre * ask(hd::kNominalMaxStiffness));
    std::array<double, 6> box{};
    api_.getDoublev(hd::kMaxWorkspaceDimensions, box.data());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        lowerTo(info_.workspaceRadius, -kMetre * box[axis]);
        lowerTo(info_.workspaceRadius, kMetre * box[axis + 3]);
    }
    api_.getIntegerv(hd::kCalibrationStyle, &calibrationStyle_);
    // One at a time, the least trouble first.
    for (const int style : {hd::kAutomatic, hd::kInkwell, hd::kEncoderReset})
        if (calibrationStyle_ & style) {
            calibrationStyle_ = style;
            break;
        }
    api_.enable(hd::kMaxForceClamping);
    limiter_ = {.maxForce = info_.maxForce};
    takeErrors(); // of questions that this device does not know
    return {};
}

Result<void> OpenHaptics::startScheduler() {
    quiet_ = kHdQuiet;
    output_ = false;
    frames_ = 0;
    fault_ = hd::kSuccess;
    calibration_ = 0;
    api_.disable(hd::kForceOutput);
    scheduled_ = api_.scheduleAsynchronous(&onTick, this, hd::kHighestPriority);
    api_.startScheduler();
    running_ = true;
    if (const hd::ErrorCode code = takeErrors()) return machineError(hd::sentenceOf(code));
    return {};
}

Result<void> OpenHaptics::calibrate(Opening& opening) {
    calibration_ = 0;
    calibrating_ = true;
    const auto isKnown = [&] { return calibration_ != 0 || fault_ != hd::kSuccess; };
    if (!waitFor(kPatience, isKnown))
        return machineError("The maker's driver does not begin to run: close other programs that use the "
                            "device and open it again.");
    waitFor(kPatience, [&] { return calibration_ != hd::kNeedsUpdate || fault_ != hd::kSuccess; });
    if (calibration_ == hd::kNeedsManualInput)
        if (Result<void> byHand = calibrateByHand(opening); !byHand) return byHand;
    if (const hd::ErrorCode code = fault_) return machineError(hd::sentenceOf(code));
    if (calibration_ == hd::kCalibrated) return {};
    return machineError("The device does not calibrate itself: switch it off and on, then open it again.");
}

Result<void> OpenHaptics::calibrateByHand(Opening& opening) {
    const bool reset = calibrationStyle_ == hd::kEncoderReset;
    const std::string request =
        reset ? "Hold the arms of the device at right angles to each other, and keep still."
              : "Put the stylus into its inkwell.";
    opening.begin(kHdCalibrate, request);
    for (int waited = 0; calibration_ != hd::kCalibrated && fault_ == hd::kSuccess; waited += kHdMoment) {
        if (opening.cancelled()) return machineError("The device is not calibrated. " + request);
        if (reset) opening.progress(std::min(1.0, double(waited) / kHold));
        if (reset && waited % kHold == kHold - kHdMoment) resetNow_ = true;
        pause();
    }
    return {};
}

Result<void> OpenHaptics::open() {
    Unattended nobody;
    if (Result<void> prepared = prepare(nobody); !prepared) return prepared;
    emergencyStop(); // what an earlier use left in the mailbox
    open_ = true;
    return {};
}

void OpenHaptics::shutDown() {
    open_ = false;
    if (running_) {
        // Two frames from now the device has got zero, whichever frame is under way.
        const std::uint64_t last = frames_ + 2;
        waitFor(kFarewell, [&] { return frames_ >= last; });
        api_.stopScheduler();
        api_.unschedule(scheduled_);
    }
    if (handle_ != hd::kInvalidHandle) api_.disableDevice(handle_);
    handle_ = hd::kInvalidHandle;
    running_ = false;
}

std::string OpenHaptics::trouble() const {
    if (const hd::ErrorCode code = fault_) return hd::sentenceOf(code);
    if (open_ && 1e-9 * double(monotonicNanoseconds() - lastFrame_) > kHdSilent)
        return "The maker's driver stands still: check the cable of the device, then open it again.";
    return {};
}

/// The maker's setup program leaves a file for every device.
std::vector<std::string> setUpDevices() {
    const char* home = std::getenv("GTDD_HOME");
    const std::filesystem::path folder =
        std::filesystem::path(home && *home ? home : "/usr/share/3DSystems") / "config";
    std::vector<std::string> names;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
        if (entry.path().extension() == ".config") names.push_back(entry.path().stem().string());
    std::ranges::sort(names);
    if (names.empty()) names.emplace_back(kDefault);
    return names;
}

} // namespace

std::vector<DeviceListing> listOpenHaptics() {
    if (const Result<hd::Api> api = hd::load(); !api)
        return {{"", "Touch, Phantom (OpenHaptics)", false, api.error().text}};
    std::vector<DeviceListing> listings;
    for (const std::string& name : setUpDevices())
        listings.push_back({std::string(kHdPrefix) + name, "OpenHaptics: " + printable(name), true,
                            "3D Systems' library is there; whether the device is connected shows when it is "
                            "opened; never tried with a real one"});
    return listings;
}

Result<std::unique_ptr<HapticDevice>> makeOpenHaptics(const std::string& id, FiguresOf figures) {
    if (!id.starts_with(kHdPrefix) || id.size() == kHdPrefix.size())
        return inputError("There is no device " + inQuotes(id) + ": those of 3D Systems are called " +
                          std::string(kHdPrefix) + "NAME.");
    const std::string name = id.substr(kHdPrefix.size());
    const Result<DeviceInfo> ofFamily = figures("");
    if (!ofFamily) return tl::unexpected(ofFamily.error());
    return std::make_unique<OpenHaptics>(name == kDefault ? std::string() : name, std::move(figures),
                                         *ofFamily);
}

} // namespace tactum
