// The part of Force Dimension's DHD API (3.x) that the driver calls: names, types and numbers as its public
// reference (dhdc.h and drdc.h of 3.7, the reference of 3.16) and the programs that use it show them.
// Declared here, because the maker's headers are not free. Never tried with the real library.
#pragma once

#include <string>

#include "core/base/result.h"
#include "device/vendor/shared_library.h"

namespace tactum::dhd {

inline constexpr unsigned char kOff = 0, kOn = 1;
/// Below 0: an error. 1 (a reading that is a fraction of a millisecond old) and 2 (a motor gives all that it
/// can) are none.
inline constexpr int kNoError = 0;
inline constexpr int kRoomForStatus = 32; ///< the library fills 13 to 16 numbers, more in every version
/// 1: in the mode in which it waits to be calibrated; so its force mode; and the event that took the forces
/// away the last time, where the library knows it.
inline constexpr int kStatusReset = 3, kStatusForce = 5, kStatusForceOffCause = 14;

enum ForceOff : int {
    kOffUnknown = -1, ///< ours: the library fills no such number
    kOffNone,
    kOffButton,
    kOffVelocity,
    kOffWatchdog,
    kOffSoftware,
    kOffUsb,
    kOffDeadMan,
};

enum Error : int {
    kUnknown = 1,
    kCommunication,
    kBusy,
    kNoDriver,
    kNoDevice,
    kNotAvailable,
    kTimeout,
    kGeometry,
    kExpertModeDisabled,
    kNotImplemented,
    kOutOfMemory,
    kDeviceNotReady,
    kFileNotFound,
    kConfiguration,
    kInvalidIndex,
    kDeprecated,
    kNullArgument,
    kRedundantFail,
    kNotEnabled,
    kDeviceInUse,
};

/// Metre, newton; x toward the user, y right, z up. The last argument is what openId() gave.
struct Api {
    int (*getDeviceCount)();
    int (*openId)(char index);
    int (*close)(char id);
    int (*stop)(char id); ///< forces off, brakes on
    const char* (*getSystemName)(char id);
    int (*getStatus)(int* values, char id);
    int (*enableForce)(unsigned char on, char id);
    int (*getPosition)(double* x, double* y, double* z, char id);
    int (*getLinearVelocity)(double* x, double* y, double* z, char id);
    int (*setForceAndTorqueAndGripperForce)(double fx, double fy, double fz, double tx, double ty, double tz,
                                            double grip, char id);
    unsigned int (*getButtonMask)(char id);
    int (*errorGetLast)();
    /// Null before 3.3.2: after so many times 125 us without a command the device takes the force away, and
    /// does not give it back. Of the expert section: refused outside of the expert mode.
    int (*setWatchdog)(unsigned char periods, char id);
    int (*enableExpertMode)();
    int (*disableExpertMode)();

    /// Of a handle that turns, null where the library cannot: from its axes to theirs, by rows.
    bool (*hasWrist)(char id);
    int (*getOrientationFrame)(double matrix[3][3], char id);
    /// Of one that grips, likewise; m.
    bool (*hasGripper)(char id);
    int (*getGripperGap)(double* opening, char id);

    /// All or none, only in libdrd: the robotics library moves the device to its calibration by itself. It
    /// knows only devices that it opened; `keepForce`: what the device is left in when its regulation ends.
    int (*openIdToMove)(char index);
    int (*closeToMove)(char id);
    bool (*canMove)(char id);
    int (*moveToCalibrate)(char id);
    int (*stopMoving)(bool keepForce, char id);
    bool moves() const { return openIdToMove; }
};

const LibraryWanted& library();
Result<Api> load();
/// What a person understands of an error, with what to do. Thread: any but real time.
std::string sentenceOf(int error);
/// Why the device took its forces away, with what brings them back. Thread: any but real time.
std::string sentenceOf(ForceOff cause);

} // namespace tactum::dhd
