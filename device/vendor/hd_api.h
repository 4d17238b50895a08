// The part of 3D Systems' HD API (OpenHaptics 3.x) that the driver calls: names, types and numbers as its
// public reference and the programs that use it show them. Declared here, because the maker's headers are not
// free. Never tried with the real library. Read in one place only, so less sure: the numbers of the nominal
// figures and of the workspace, the unit of the nominal stiffness (taken as N/mm; a wrong unit can only lower
// a limit), and kInvalidLicence.
#pragma once

#include <string>

#include "core/base/result.h"
#include "device/vendor/shared_library.h"

namespace tactum::hd {

using Handle = unsigned int;
using Enum = unsigned int;
using ErrorCode = unsigned int;
using CallbackCode = unsigned int;
using SchedulerHandle = unsigned long;
using Callback = CallbackCode (*)(void* data);

struct ErrorInfo {
    ErrorCode code;
    int internalCode;
    Handle device;
};

inline constexpr Handle kInvalidHandle = 0xFFFFFFFF;
inline constexpr CallbackCode kDone = 0, kContinue = 1;
inline constexpr unsigned short kHighestPriority = 0xFFFF;

enum Error : ErrorCode {
    kSuccess = 0,
    kInvalidEnum = 0x0100,
    kInvalidValue,
    kInvalidOperation,
    kInvalidInputType,
    kBadHandle,
    kWarmMotors = 0x0200,
    kExceededMaxForce,
    kExceededMaxForceImpulse,
    kExceededMaxVelocity,
    kForceError,
    kDeviceFault = 0x0300,
    kDeviceAlreadyInitiated,
    kCommError,
    kCommConfigError,
    kTimerError,
    kIllegalBegin = 0x0400,
    kIllegalEnd,
    kFrameError,
    kInvalidPriority = 0x0500,
    kSchedulerFull,
    kInvalidLicence = 0x0600,
};

enum Parameter : Enum {
    kCurrentButtons = 0x2000,            ///< int, a bit for each
    kCurrentPosition = 0x2050,           ///< 3 doubles, mm; x right, y up, z toward the user
    kCurrentVelocity = 0x2051,           ///< 3 doubles, mm/s
    kCurrentTransform = 0x2052,          ///< 16 doubles by columns: axes of the stylus, then its place, mm
    kDeviceModelType = 0x2501,           ///< string
    kMaxWorkspaceDimensions = 0x2550,    ///< 6 doubles, mm: least x, y, z, greatest x, y, z
    kCalibrationStyle = 0x2555,          ///< int, bits
    kNominalMaxStiffness = 0x2602,       ///< double
    kNominalMaxForce = 0x2603,           ///< double, N
    kNominalMaxContinuousForce = 0x2604, ///< double, N
    kCurrentForce = 0x2700,              ///< 3 doubles, N
    kForceOutput = 0x4000,               ///< to enable
    kMaxForceClamping = 0x4001,          ///< to enable
};

enum Calibration : Enum { kCalibrated = 0x5000, kNeedsUpdate, kNeedsManualInput };
enum CalibrationStyle : int { kEncoderReset = 1, kAutomatic = 2, kInkwell = 4 };

struct Api {
    Handle (*initDevice)(const char* name);
    void (*disableDevice)(Handle device);
    void (*makeCurrentDevice)(Handle device);
    void (*enable)(Enum capability);
    void (*disable)(Enum capability);
    void (*beginFrame)(Handle device);
    void (*endFrame)(Handle device);
    void (*getDoublev)(Enum parameter, double* values);
    void (*getIntegerv)(Enum parameter, int* values);
    const char* (*getString)(Enum parameter);
    void (*setDoublev)(Enum parameter, const double* values);
    ErrorInfo (*getError)(); ///< the newest on the stack, and takes it off
    Enum (*checkCalibration)();
    void (*updateCalibration)(Enum style);
    SchedulerHandle (*scheduleAsynchronous)(Callback callback, void* data, unsigned short priority);
    void (*unschedule)(SchedulerHandle handle);
    void (*startScheduler)();
    void (*stopScheduler)();
};

/// What `tactum` says when it is not there. Thread: any but real time.
const LibraryWanted& library();
Result<Api> load();
/// What a person understands of an error, with what to do. Thread: any but real time.
std::string sentenceOf(ErrorCode code);

} // namespace tactum::hd
