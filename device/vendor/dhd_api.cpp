#include "device/vendor/dhd_api.h"

#include <algorithm>
#include <iterator>

namespace tactum::dhd {
namespace {

struct DhdExplained {
    int error;
    const char* sentence;
};

constexpr const char* kForcesOff =
    "The forces of the device are off: press its force button, then arm again.";

constexpr DhdExplained kDhdExplained[] = {
    {kCommunication, "The device does not answer: check its cable and its power, then open it again."},
    {kBusy, "The controller of the device is busy: wait a moment and open it again."},
    {kNoDriver, "There is no right to use the device: install the maker's rule for USB devices, then plug it "
                "in again."},
    {kNoDevice, "The device is not there: connect it, switch it on and open it again."},
    {kExpertModeDisabled, "The maker's library keeps the function for experts: install its newest version."},
    {kNotAvailable, "The device cannot do that: install the newest firmware and library of the maker."},
    {kTimeout, "The device answers too late: connect it without a hub, then open it again."},
    {kGeometry, "The device cannot tell where its arms are: calibrate it, then open it again."},
    {kOutOfMemory, "The maker's library has no memory: close other programs and open the device again."},
    {kDeviceNotReady, "The device is not ready: switch it on, wait until it has calibrated itself, then open "
                      "it again."},
    {kConfiguration, "The device has no valid configuration: ask its maker."},
    {kRedundantFail, "The device found a fault of its sensors: switch it off and on, then open it again."},
    {kNotEnabled, kForcesOff},
    {kDeviceInUse, "The device is in use already: close the other program that uses it."},
};

constexpr const char* kForceOffExplained[] = {
    kForcesOff,
    "The force button of the device was pressed, which took its forces away: press it again, then arm again.",
    "The device was faster than it allows and took its forces away: it gets them back by itself; then arm "
    "again.",
    "The device heard no command for 30 ms and took its forces away, for this computer was too busy: it gets "
    "them back by itself; then arm again.",
    "Another program took the forces of the device away: end it. The device gets them back by itself; then "
    "arm "
    "again.",
    "The device lost its USB connection and took its forces away: check the cable, then open it again.",
    "The dead-man switch of the device was let go, which took its forces away: hold it, then arm again.",
};

/// Those of the robotics library, all or none.
void findMoving(const SharedLibrary& opened, Api& api) {
    const bool all = opened.find("drdOpenID", api.openIdToMove) && opened.find("drdClose", api.closeToMove) &&
                     opened.find("drdIsSupported", api.canMove) &&
                     opened.find("drdAutoInit", api.moveToCalibrate) &&
                     opened.find("drdStop", api.stopMoving);
    if (!all) api.openIdToMove = nullptr;
}

/// A library without them still gives every force that anybody feels.
void findHandle(const SharedLibrary& opened, Api& api) {
    const bool wrist = opened.find("dhdHasWrist", api.hasWrist) &&
                       opened.find("dhdGetOrientationFrame", api.getOrientationFrame);
    const bool gripper =
        opened.find("dhdHasGripper", api.hasGripper) && opened.find("dhdGetGripperGap", api.getGripperGap);
    if (!wrist) api.hasWrist = nullptr;
    if (!gripper) api.hasGripper = nullptr;
}

} // namespace

const LibraryWanted& library() {
    static const LibraryWanted wanted{
        "Force Dimension",
        "TACTUM_LIBDHD",
        {"libdrd.so", "libdrd.so.3", "libdhd.so", "libdhd.so.3"}, // libdrd has all of libdhd, and more
        "install the Force Dimension SDK, which its maker gives away free of charge."};
    return wanted;
}

Result<Api> load() {
    Result<SharedLibrary> opened = SharedLibrary::open(library());
    if (!opened) return tl::unexpected(opened.error());
    Api api{};
    opened->need("dhdGetDeviceCount", api.getDeviceCount);
    opened->need("dhdOpenID", api.openId);
    opened->need("dhdClose", api.close);
    opened->need("dhdStop", api.stop);
    opened->need("dhdGetSystemName", api.getSystemName);
    opened->need("dhdGetStatus", api.getStatus);
    opened->need("dhdEnableForce", api.enableForce);
    opened->need("dhdGetPosition", api.getPosition);
    opened->need("dhdGetLinearVelocity", api.getLinearVelocity);
    opened->need("dhdSetForceAndTorqueAndGripperForce", api.setForceAndTorqueAndGripperForce);
    opened->need("dhdGetButtonMask", api.getButtonMask);
    opened->need("dhdErrorGetLast", api.errorGetLast);
    if (Result<void> complete = opened->complete(); !complete) return tl::unexpected(complete.error());
    opened->find("dhdSetWatchdog", api.setWatchdog);
    opened->find("dhdEnableExpertMode", api.enableExpertMode);
    opened->find("dhdDisableExpertMode", api.disableExpertMode);
    findMoving(*opened, api);
    findHandle(*opened, api);
    return api;
}

std::string sentenceOf(int error) {
    const auto* found = std::ranges::find(kDhdExplained, error, &DhdExplained::error);
    if (found != std::end(kDhdExplained)) return found->sentence;
    return "The maker's library reports the error " + std::to_string(error) +
           ": open the device again; if it stays, run the maker's own test program.";
}

std::string sentenceOf(ForceOff cause) {
    const bool known = cause > kOffNone && cause < int(std::size(kForceOffExplained));
    return kForceOffExplained[known ? cause : kOffNone];
}

} // namespace tactum::dhd
