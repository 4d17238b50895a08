#include "device/vendor/hd_api.h"

#include <algorithm>
#include <iterator>

namespace tactum::hd {
namespace {

struct HdExplained {
    ErrorCode code;
    const char* sentence;
};

constexpr HdExplained kHdExplained[] = {
    {kWarmMotors, "The motors of the device are too warm: let go of it and wait some minutes."},
    {kExceededMaxForce, "The device was asked for more force than it can give and took the force away: lower "
                        "the stiffness and arm again."},
    {kExceededMaxForceImpulse, "The force changed faster than the device allows and it took the force away: "
                               "lower the stiffness and arm again."},
    {kExceededMaxVelocity, "The device was moved too fast and took the force away: hold it and arm again."},
    {kForceError, "The device reports a fault of its force: switch it off and on, then open it again."},
    {kDeviceFault, "The device reports a fault: check its cable and its power, then open it again."},
    {kDeviceAlreadyInitiated, "The device is in use already: close the other program that uses it."},
    {kCommError, "The device does not answer: check its cable and its power, and that the maker's setup "
                 "program finds it."},
    {kCommConfigError, "The device is not set up: run the maker's setup program, which pairs it with this "
                       "computer."},
    {kTimerError, "The maker's driver has no timer: close other programs that use the device and open it "
                  "again."},
    {kBadHandle, "The device is not there any more: connect it and open it again."},
    {kInvalidLicence, "The maker's library has no valid licence: install one as its manual says."},
    {kSchedulerFull, "The maker's driver has too many tasks: close other programs that use the device."},
};

} // namespace

const LibraryWanted& library() {
    static const LibraryWanted wanted{
        "OpenHaptics",
        "TACTUM_LIBHD",
        {"libHD.so", "libHD.so.3.4", "libHD.so.3.0", "/usr/lib/libHD.so", "/usr/lib64/libHD.so"},
        "install the device driver and OpenHaptics from 3D Systems (both are free of charge, for registered "
        "users)."};
    return wanted;
}

Result<Api> load() {
    Result<SharedLibrary> opened = SharedLibrary::open(library());
    if (!opened) return tl::unexpected(opened.error());
    Api api{};
    opened->need("hdInitDevice", api.initDevice);
    opened->need("hdDisableDevice", api.disableDevice);
    opened->need("hdMakeCurrentDevice", api.makeCurrentDevice);
    opened->need("hdEnable", api.enable);
    opened->need("hdDisable", api.disable);
    opened->need("hdBeginFrame", api.beginFrame);
    opened->need("hdEndFrame", api.endFrame);
    opened->need("hdGetDoublev", api.getDoublev);
    opened->need("hdGetIntegerv", api.getIntegerv);
    opened->need("hdGetString", api.getString);
    opened->need("hdSetDoublev", api.setDoublev);
    opened->need("hdGetError", api.getError);
    opened->need("hdCheckCalibration", api.checkCalibration);
    opened->need("hdUpdateCalibration", api.updateCalibration);
    opened->need("hdScheduleAsynchronous", api.scheduleAsynchronous);
    opened->need("hdUnschedule", api.unschedule);
    opened->need("hdStartScheduler", api.startScheduler);
    opened->need("hdStopScheduler", api.stopScheduler);
    if (Result<void> complete = opened->complete(); !complete) return tl::unexpected(complete.error());
    return api;
}

std::string sentenceOf(ErrorCode code) {
    const auto* found = std::ranges::find(kHdExplained, code, &HdExplained::code);
    if (found != std::end(kHdExplained)) return found->sentence;
    return "The maker's driver reports the error " + std::to_string(code) +
           ": open the device again; if it stays, run the maker's own test program.";
}

} // namespace tactum::hd
