// A shared library with the functions of the DHD and DRD API that the driver calls: it notes and answers, and
// moves nothing. Written from the maker's pages, and refuses what they refuse:
// - Haptic SDK 3.7.0, dhdc.h: names, error and status numbers, causes of FORCE OFF; dhdSetWatchdog stands in
// its
//   section "expert SDK".
// - Haptic SDK 3.16, reference "DHD": the four modes of a device (RESET waits for the calibration, IDLE,
// FORCE, BRAKE);
//   functions of the expert section need dhdEnableExpertMode; the watchdog counts in 125 us and disables the
//   forces; the cause of FORCE OFF is that of the last time, and stays when they are on again.
// - Robotic SDK 3.16, reference "DRD": drdAutoInit moves a device that drdOpenID opened and leaves its
// regulation
//   running; drdStop ends that.
// - the same, dhdGetOrientationFrame: the identity of devices without a wrist, whatever is asked;
//   dhdGetGripperGap: not available without a gripper.
// That commands succeed while the forces are off is what no page denies.
#include "tests/device/vendor/fake_dhd.h"

#include <algorithm>
#include <cmath>

using tactum::test::FakeDhd;

namespace {

FakeDhd fake;
int lastError = 0;
constexpr char kFirst = 3; ///< ids are not indices
constexpr int kExpertModeDisabled = 9, kNoDevice = 5, kNotAvailable = 6;
bool openedToMove = false;

int fail(int error) {
    lastError = error;
    return -1;
}

int answer(int error, char id) {
    if (id < kFirst) ++fake.misuses;
    return error ? fail(error) : fake.success.load();
}

int read(const std::array<std::atomic<double>, 3>& from, double* x, double* y, double* z, char id) {
    if (fake.readError == 0) {
        *x = from[0];
        *y = from[1];
        *z = from[2];
    }
    return answer(fake.readError, id);
}

} // namespace

extern "C" {

FakeDhd& fakeDhd() {
    return fake;
}

int dhdGetDeviceCount() {
    return fake.devices;
}
int dhdOpenID(char index) {
    if (index < 0 || index >= fake.devices) return fail(kNoDevice);
    if (fake.openError) return fail(fake.openError);
    ++fake.opened;
    openedToMove = false;
    return kFirst + index;
}
int dhdClose(char id) {
    ++fake.closed;
    return answer(0, id);
}
int dhdStop(char id) {
    ++fake.stopped;
    return answer(0, id);
}
const char* dhdGetSystemName(char) {
    return "omega.3";
}
int dhdGetStatus(int* values, char id) {
    std::fill(values, values + 14, 0);
    if (++fake.looks == fake.calibrateAt) fake.resetMode = false;
    values[0] = values[1] = values[2] = 1;
    values[3] = fake.resetMode;
    values[5] = fake.force;
    values[6] = !fake.force;
    if (fake.fillsCause) values[14] = fake.forceOffCause;
    return answer(fake.readError ? fake.readError : fake.statusError, id);
}
int dhdEnableForce(unsigned char on, char id) {
    if (fake.sendError == 0) {
        if (on == 1) {
            ++fake.enabled;
            const double now = std::hypot(fake.commanded[0], fake.commanded[1], fake.commanded[2]);
            fake.enabledWith = std::max(fake.enabledWith.load(), now);
            fake.silent = 0;
        } else {
            fake.takeForces(4);
        }
        fake.force = on == 1;
    }
    return answer(fake.sendError, id);
}
int dhdGetPosition(double* x, double* y, double* z, char id) {
    return read(fake.position, x, y, z, id);
}
int dhdGetLinearVelocity(double* x, double* y, double* z, char id) {
    return read(fake.velocity, x, y, z, id);
}
int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx, double ty, double tz,
                                        double grip, char id) {
    ++fake.commands;
    const double strength = std::hypot(fx, fy, fz);
    if (!std::isfinite(strength)) ++fake.notFinite;
    fake.strongest = std::max(fake.strongest.load(), strength);
    fake.handle[0] = tx;
    fake.handle[1] = ty;
    fake.handle[2] = tz;
    fake.handle[3] = grip;
    fake.torque = std::hypot(tx, ty, tz) + std::abs(grip);
    if (fake.regulating) ++fake.misuses; // two who push
    if (fake.sendError == 0) {
        const double theirs[] = {fx, fy, fz};
        for (std::size_t i = 0; i < 3; ++i) {
            fake.commanded[i] = theirs[i];
            fake.motors[i] = fake.force ? theirs[i] : 0;
        }
        fake.silent = 0;
    }
    return answer(fake.sendError, id);
}
unsigned dhdGetButtonMask(char) {
    return fake.buttons;
}
int dhdErrorGetLast() {
    return lastError;
}
#ifndef FAKE_DHD_OLD // the library of another time: no watchdog, nothing that moves or turns
bool dhdHasWrist(char) {
    return fake.wrist;
}
bool dhdHasGripper(char) {
    return fake.gripper;
}
int dhdGetOrientationFrame(double matrix[3][3], char id) {
    for (std::size_t i = 0; i < 9; ++i)
        matrix[i / 3][i % 3] = fake.rows[i];
    return answer(fake.handleError, id);
}
int dhdGetGripperGap(double* opening, char id) {
    if (!fake.gripper) return fail(kNotAvailable);
    *opening = fake.gap;
    return answer(fake.handleError, id);
}
int dhdEnableExpertMode() {
    fake.expert = true;
    return 0;
}
int dhdDisableExpertMode() {
    fake.expert = false;
    return 0;
}
int dhdSetWatchdog(unsigned char periods, char id) {
    if (!fake.expert) return fail(kExpertModeDisabled);
    if (fake.watchdogError == 0) fake.watchdog = periods;
    return answer(fake.watchdogError, id);
}
int drdOpenID(char index) {
    const int id = dhdOpenID(index);
    openedToMove = id >= 0;
    return id;
}
int drdClose(char id) {
    fake.regulating = false;
    if (!openedToMove) ++fake.misuses;
    return dhdClose(id);
}
bool drdIsSupported(char) {
    return fake.supported;
}
int drdAutoInit(char id) {
    if (!openedToMove) return fail(kNoDevice);
    if (fake.moveError) return fail(fake.moveError);
    ++fake.moved;
    fake.resetMode = false;
    fake.regulating = true;
    fake.force = true;
    return answer(0, id);
}
int drdStop(bool keepForce, char id) {
    fake.regulating = false;
    if (!keepForce) fake.takeForces(4);
    return answer(0, id);
}
#endif
}
