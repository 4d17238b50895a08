#include "device/vendor/dhd_api.h"

#include <algorithm>
#include <iterator>

namespace tactum::dhd {
namespace {

struct DhdExplained {
    int error;
    const char* sentence;
};

constexpr DhdExplained kDhdExplained[] = {
    {kCommunication, "The device does not answer: check its cable and its power, then open it again."},
    {kBusy, "The controller of the device is busy: wait a moment and open it again."},
    {kNoDriver, "There is no right to use the device: install the maker's rule for USB devices, then plug it "
                "in again."},
    {kNoDevice, "The device is not there: connect it, switch it on and open it again."},
    {kNotAvailable, "The device cannot do that: install the newest firmware and library of the maker."},
    {kTimeout, "The device answers too late: connect it without a hub, then open it again."},
    {kGeometry, "The device cannot tell where its arms are: calibrate it, then open it again."},
    {kOutOfMemory, "The maker's library has no memory: close other programs and open the device again."},
    {kDeviceNotReady, "The device is not ready: switch it on, wait until it has calibrated itself, then open "
                      "it again."},
    {kConfiguration, "The device has no valid configuration: ask its maker."},
    {kRedundantFail, "The device found a fault of its sensors: switch it off and on, then open it again."},
    {kNotEnabled, "The forces of the device are off: press its force button, then arm again."},
    {kDeviceInUse, "The device is in use already: close the other program that uses it."},
};

} // namespace

const LibraryWanted& library() {
    static const LibraryWanted wanted{
        "Force Dimension",
        "TACTUM_LIBDHD",
        {"libdhd.so", "libdhd.so.3", "libdrd.so", "libdrd.so.3"},
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
    return api;
}

std::string sentenceOf(int error) {
    const auto* found = std::ranges::find(kDhdExplained, error, &DhdExplained::error);
    if (found != std::end(kDhdExplained)) return found->sentence;
    return "The maker's library reports the error " + std::to_string(error) +
           ": open the device again; if it stays, run the maker's own test program.";
}

} // namespace tactum::dhd
