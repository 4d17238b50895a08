// A shared library with the functions of the DHD API that the driver calls: it notes and answers, and moves
// nothing.
#include "tests/device/vendor/fake_dhd.h"

#include <algorithm>
#include <cmath>

using tactum::test::FakeDhd;

namespace {

FakeDhd fake;
int lastError = 0;
constexpr char kFirst = 3; ///< ids are not indices

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
    if (index < 0 || index >= fake.devices) return fail(5);
    if (fake.openError) return fail(fake.openError);
    ++fake.opened;
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
    std::fill(values, values + 16, 0);
    if (++fake.looks == fake.calibrateAt) fake.reset = 1;
    values[1] = 1;
    values[3] = fake.reset;
    return answer(fake.readError, id);
}
int dhdEnableForce(unsigned char on, char id) {
    fake.force = on == 1;
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
    fake.torque = std::hypot(tx, ty, tz) + std::abs(grip);
    if (fake.sendError == 0) {
        fake.motors[0] = fx;
        fake.motors[1] = fy;
        fake.motors[2] = fz;
    }
    return answer(fake.sendError, id);
}
unsigned dhdGetButtonMask(char) {
    return fake.buttons;
}
int dhdErrorGetLast() {
    return lastError;
}
#ifdef FAKE_DHD_OLD
#define dhdSetWatchdog dhdSetWatchdog1 // the library of another time
#endif
int dhdSetWatchdog(unsigned char periods, char id) {
    fake.watchdog = periods;
    return answer(0, id);
}
}
