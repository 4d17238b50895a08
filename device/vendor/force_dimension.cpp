#include "device/vendor/force_dimension.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <mutex>
#include <string_view>
#include <thread>

#include "core/base/text.h"
#include "core/port/force_limiter.h"
#include "core/port/handle_limit.h"
#include "device/vendor/dhd_api.h"
#include "device/vendor/dhd_force_output.h"

namespace tactum {
namespace {

constexpr std::string_view kDhdPrefix = "forcedimension:";
constexpr int kMaxDevices = 16;
constexpr int kDhdMoment = 20;           ///< ms between two looks
constexpr int kDhdLetGo = 2000;          ///< ms for a person to let go of a device that will move
constexpr int kDhdQuiet = 500;           ///< exchanges without an error, and the device is believed again
constexpr unsigned char kWatchdog = 240; ///< times 125 us: 30 ms
constexpr const char* kDhdLoad = "Load the maker's library";
constexpr const char* kDhdConnect = "Connect";
constexpr const char* kDhdCalibrate = "Calibrate";

const double kDhdNothing = std::numeric_limits<double>::quiet_NaN();

// Theirs: x toward the user, y right, z up. D: x right, y up, z toward the user.
Vec3 inD(const Vec3& theirs) {
    return {theirs.y(), theirs.z(), theirs.x()};
}
Vec3 asTheirs(const Vec3& force_D) {
    return {force_D.z(), force_D.x(), force_D.y()};
}

/// Of this program. To open one of them again, only to ask for its name, would end in closing it.
std::atomic<int> inUse{0};

class ForceDimension final : public HapticDevice {
public:
    ForceDimension(int index, FiguresOf figures, const DeviceInfo& ofFamily)
        : index_(char(index)), figures_(std::move(figures)) {
        take(ofFamily);
    }
    ~ForceDimension() override { shutDown(); }

    DeviceInfo info() const override {
        const std::lock_guard lock(infoMutex_);
        return info_;
    }
    std::vector<std::string> steps() const override { return {kDhdLoad, kDhdConnect, kDhdCalibrate}; }
    Result<void> prepare(Opening& opening) override;
    Result<void> open() override;
    void close() override { shutDown(); }
    std::string trouble() const override {
        const int error = fault_;
        return error ? dhd::sentenceOf(error) : forces_.trouble();
    }
    std::string caution() const override {
        const std::lock_guard lock(infoMutex_);
        return caution_;
    }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override;
    HandleReading handle() noexcept override { return handle_; }

private:
    Result<void> connect(Opening& opening);
    Result<void> calibrate(Opening& opening);
    Result<void> moveToCalibrate(Opening& opening);
    Result<void> asksForCalibration(bool& asks) const;
    std::string armWatchdog();
    bool send(const Vec3& force_D, const HandleCommand& handle_D = {}) noexcept;
    bool read(DeviceSample& sample) noexcept;
    void readHandle() noexcept;
    void take(const DeviceInfo& figures);
    int lastError() const noexcept;
    tl::unexpected<Error> failure() const { return machineError(dhd::sentenceOf(lastError())); }
    void shutDown();

    char index_;
    dhd::Api api_{};
    int id_ = -1; ///< below 0: not connected
    mutable std::mutex infoMutex_;
    FiguresOf figures_;
    DeviceInfo info_;
    std::string caution_;
    ForceLimiter limiter_;
    DeviceInfo limits_; ///< the servo's own, of what is no force
    HandleReading handle_;
    bool wrist_ = false, gripper_ = false;
    dhd::ForceOutput forces_;
    bool moves_ = false;    ///< opened by the robotics library, and closed by it
    int quiet_ = kDhdQuiet; ///< exchanges since the last error
    bool open_ = false;
    std::atomic<int> fault_{dhd::kNoError};
};

DeviceSample ForceDimension::exchange(const DeviceCommand& command, double) noexcept {
    DeviceSample sample;
    if (!open_) return sample;
    const bool believed = quiet_ >= kDhdQuiet;
    // Both are tried whatever becomes of the other: zero has to get there.
    const bool sent =
        believed ? send(limiter_(command.force), heldTo(limits_, command.handle)) : send(Vec3::Zero());
    const bool whole = read(sample) && sent;
    if (!whole) fault_ = lastError();
    const bool on = forces_.look(api_, char(id_));
    if (forces_.error() != dhd::kNoError) fault_ = forces_.error();
    if (whole && on) {
        if (quiet_ < kDhdQuiet && ++quiet_ == kDhdQuiet) fault_ = dhd::kNoError;
    } else {
        quiet_ = 0;
        send(Vec3::Zero());
    }
    sample.valid = quiet_ >= kDhdQuiet && sample.position.allFinite() && sample.velocity.allFinite();
    return sample;
}

bool ForceDimension::send(const Vec3& force_D, const HandleCommand& handle_D) noexcept {
    const Vec3 force = asTheirs(force_D), torque = asTheirs(handle_D.torque);
    return api_.setForceAndTorqueAndGripperForce(force.x(), force.y(), force.z(), torque.x(), torque.y(),
                                                 torque.z(), handle_D.pinch, char(id_)) >= dhd::kNoError;
}

/// What cannot be read of it takes no force away: no force rests on it.
void ForceDimension::readHandle() noexcept {
    double rows[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double opening = 0;
    const bool turns = wrist_ && api_.getOrientationFrame(rows, char(id_)) >= dhd::kNoError;
    const bool grips = gripper_ && api_.getGripperGap(&opening, char(id_)) >= dhd::kNoError;
    Mat3 turned; // each axis of the handle, which has theirs at rest, in D
    for (int theirs = 0; theirs < 3; ++theirs)
        turned.col((theirs + 2) % 3) = inD({rows[0][theirs], rows[1][theirs], rows[2][theirs]});
    handle_ = {};
    if (turns && turned.allFinite()) handle_.orientation = Quat(turned).normalized(), handle_.turns = true;
    if (grips && std::isfinite(opening)) handle_.opening = opening, handle_.grips = true;
}

bool ForceDimension::read(DeviceSample& sample) noexcept {
    Vec3 position = Vec3::Constant(kDhdNothing), velocity = position;
    const char id = char(id_);
    const bool read =
        api_.getPosition(&position.x(), &position.y(), &position.z(), id) >= dhd::kNoError &&
        api_.getLinearVelocity(&velocity.x(), &velocity.y(), &velocity.z(), id) >= dhd::kNoError;
    sample.position = inD(position);
    sample.velocity = inD(velocity);
    sample.buttons = read ? api_.getButtonMask(id) : 0;
    if (read) readHandle();
    return read;
}

int ForceDimension::lastError() const noexcept {
    const int error = api_.errorGetLast();
    return error != dhd::kNoError ? error : dhd::kUnknown;
}

Result<void> ForceDimension::prepare(Opening& opening) {
    if (fault_ != dhd::kNoError) shutDown(); // what broke is begun anew
    if (id_ < 0)
        if (Result<void> connected = connect(opening); !connected) return connected;
    opening.begin(kDhdCalibrate);
    return calibrate(opening);
}

Result<void> ForceDimension::connect(Opening& opening) {
    opening.begin(kDhdLoad);
    Result<dhd::Api> api = dhd::load();
    if (!api) return tl::unexpected(api.error());
    api_ = *api;
    opening.begin(kDhdConnect);
    moves_ = api_.moves();
    id_ = moves_ ? api_.openIdToMove(index_) : api_.openId(index_);
    if (id_ < 0) return failure();
    ++inUse;
    wrist_ = api_.hasWrist && api_.hasWrist(char(id_));
    gripper_ = api_.hasGripper && api_.hasGripper(char(id_));
    fault_ = dhd::kNoError;
    quiet_ = kDhdQuiet;
    api_.enableForce(dhd::kOff, char(id_));
    const char* const name = api_.getSystemName(char(id_));
    const Result<DeviceInfo> figures = figures_(name ? printable(name) : std::string());
    if (!figures) {
        shutDown();
        return tl::unexpected(figures.error());
    }
    take(*figures);
    return {};
}

void ForceDimension::take(const DeviceInfo& figures) {
    const std::lock_guard lock(infoMutex_);
    info_ = figures;
    info_.real = true;
    limiter_.maxForce = info_.maxForce;
    limits_ = info_;
}

Result<void> ForceDimension::asksForCalibration(bool& asks) const {
    std::array<int, dhd::kRoomForStatus> status{};
    if (api_.getStatus(status.data(), char(id_)) < dhd::kNoError) return failure();
    asks = status[dhd::kStatusReset] != 0;
    return {};
}

Result<void> ForceDimension::calibrate(Opening& opening) {
    constexpr const char* kRequest = "Lead the handle to its rest and hold it there until the light of the "
                                     "device stops blinking, as its manual shows.";
    bool asks = false, said = false;
    while (true) {
        if (Result<void> known = asksForCalibration(asks); !known || !asks) return known;
        if (opening.cancelled())
            return machineError(std::string("The device is not calibrated. ") + kRequest);
        if (!said && moves_ && api_.canMove(char(id_))) {
            if (Result<void> moved = moveToCalibrate(opening); !moved) return moved;
        } else if (!said) {
            opening.begin(kDhdCalibrate, kRequest);
        }
        said = true;
        std::this_thread::sleep_for(std::chrono::milliseconds(kDhdMoment));
    }
}

/// Pushes by itself: only where a person was told so, and had the time to let go.
Result<void> ForceDimension::moveToCalibrate(Opening& opening) {
    opening.begin(kDhdCalibrate, "Let go of the handle and keep away from it: the device moves by itself to "
                                 "calibrate.");
    for (int waited = 0; waited < kDhdLetGo; waited += kDhdMoment) {
        if (opening.cancelled()) return machineError("The device is not calibrated: open it again.");
        opening.progress(double(waited) / kDhdLetGo);
        std::this_thread::sleep_for(std::chrono::milliseconds(kDhdMoment));
    }
    const bool moved = api_.moveToCalibrate(char(id_)) >= dhd::kNoError;
    const int error = moved ? int(dhd::kNoError) : lastError();
    api_.stopMoving(false, char(id_));
    api_.enableForce(dhd::kOff, char(id_));
    if (!moved) return machineError("The device could not calibrate itself. " + dhd::sentenceOf(error));
    return {};
}

/// Its own last line: nobody's signal handler can call this library. What is missing of it, or nothing.
std::string ForceDimension::armWatchdog() {
    constexpr const char* kAlone =
        "The device does not watch whether this computer falls silent and would go "
        "on pushing then: keep a hand at its force button. ";
    if (!api_.setWatchdog || !api_.enableExpertMode)
        return std::string(kAlone) + "The maker's library is older than 3.3.2: install its newest version.";
    const bool armed =
        api_.enableExpertMode() >= dhd::kNoError && api_.setWatchdog(kWatchdog, char(id_)) >= dhd::kNoError;
    const int error = armed ? int(dhd::kNoError) : lastError();
    if (api_.disableExpertMode) api_.disableExpertMode();
    return armed ? std::string() : kAlone + dhd::sentenceOf(error);
}

Result<void> ForceDimension::open() {
    Unattended nobody;
    if (Result<void> prepared = prepare(nobody); !prepared) return prepared;
    std::string caution = armWatchdog();
    {
        const std::lock_guard lock(infoMutex_);
        caution_ = std::move(caution);
    }
    if (!send(Vec3::Zero()) || api_.enableForce(dhd::kOn, char(id_)) < dhd::kNoError) return failure();
    forces_.begin();
    open_ = true;
    return {};
}

void ForceDimension::shutDown() {
    open_ = false;
    if (id_ < 0) return;
    send(Vec3::Zero());
    api_.enableForce(dhd::kOff, char(id_));
    api_.stop(char(id_));
    moves_ ? api_.closeToMove(char(id_)) : api_.close(char(id_));
    --inUse;
    id_ = -1;
}

DeviceListing listed(const dhd::Api& api, int index) {
    const std::string id = std::string(kDhdPrefix) + std::to_string(index);
    if (inUse > 0)
        return {id, "Force Dimension " + std::to_string(index), true,
                "connected; another one is in use here"};
    const int opened = api.openId(char(index));
    if (opened < 0)
        return {"", "Force Dimension " + std::to_string(index), false, dhd::sentenceOf(api.errorGetLast())};
    const char* name = api.getSystemName(char(opened));
    const std::string shown = "Force Dimension " + (name ? printable(name) : std::to_string(index));
    api.close(char(opened));
    return {id, shown, true, "connected; driven by its maker's library, never tried with a real one"};
}

} // namespace

std::vector<DeviceListing> listForceDimension() {
    const Result<dhd::Api> api = dhd::load();
    if (!api) return {{"", "omega, delta, sigma (Force Dimension)", false, api.error().text}};
    const int count = std::min(api->getDeviceCount(), kMaxDevices);
    if (count <= 0)
        return {{"", "Force Dimension", false,
                 "the maker's library is there, but no device: connect one and switch it on"}};
    std::vector<DeviceListing> listings;
    for (int index = 0; index < count; ++index)
        listings.push_back(listed(*api, index));
    return listings;
}

Result<std::unique_ptr<HapticDevice>> makeForceDimension(const std::string& id, FiguresOf figures) {
    std::int64_t index = -1;
    if (!id.starts_with(kDhdPrefix) || !parseNumber(std::string_view(id).substr(kDhdPrefix.size()), index) ||
        index < 0 || index >= kMaxDevices)
        return inputError("There is no device " + inQuotes(id) + ": those of Force Dimension are called " +
                          std::string(kDhdPrefix) + "0 and so on.");
    const Result<DeviceInfo> ofFamily = figures("");
    if (!ofFamily) return tl::unexpected(ofFamily.error());
    return std::make_unique<ForceDimension>(int(index), std::move(figures), *ofFamily);
}

} // namespace tactum
