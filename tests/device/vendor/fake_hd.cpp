// A shared library with the functions of the HD API that the driver calls: it notes and answers, and moves
// nothing.
#include "tests/device/vendor/fake_hd.h"

#include <chrono>
#include <cmath>
#include <cstring>
#include <mutex>
#include <thread>
#include <vector>

using tactum::test::FakeHd;

namespace {

constexpr unsigned kHandle = 7;
constexpr unsigned kDone = 0;

struct Error {
    unsigned code;
    int internalCode;
    unsigned device;
};

FakeHd fake;
std::mutex errorsMutex;
std::vector<unsigned> errors;
std::jthread scheduler;
unsigned (*callback)(void*) = nullptr;
void* callbackData = nullptr;
thread_local bool onScheduler = false;
bool inFrame = false;
double commanded[3] = {};

void fail(unsigned code) {
    const std::lock_guard lock(errorsMutex);
    errors.push_back(code);
}

void needFrame() {
    if (!onScheduler || !inFrame) ++fake.misuses;
}

void run(const std::stop_token& stop) {
    onScheduler = true;
    bool goesOn = true;
    while (!stop.stop_requested()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (stop.stop_requested()) break; // at once: what was not sent yet never is
        if (!fake.frozen && goesOn && callback) goesOn = callback(callbackData) != kDone;
    }
}

} // namespace

extern "C" {

FakeHd& fakeHd() {
    return fake;
}

unsigned hdInitDevice(const char* name) {
    std::strncpy(fake.name.data(), name ? name : "(default)", fake.name.size() - 1);
    if (fake.initError) {
        fail(fake.initError);
        return 0xFFFFFFFF;
    }
    ++fake.opened;
    return kHandle;
}
void hdDisableDevice(unsigned) {
    ++fake.closed;
}
void hdMakeCurrentDevice(unsigned handle) {
    if (handle != kHandle) ++fake.misuses;
}
void hdEnable(unsigned what) {
    if (what == 0x4000) fake.output = true;
}
void hdDisable(unsigned what) {
    if (what == 0x4000) fake.output = false;
}
void hdBeginFrame(unsigned handle) {
    if (!onScheduler || inFrame || handle != kHandle) ++fake.misuses;
    inFrame = true;
}
void hdEndFrame(unsigned) {
    needFrame();
    inFrame = false;
    for (int i = 0; i < 3; ++i)
        fake.motors[i] = fake.output ? commanded[i] : 0;
    if (fake.frameError) {
        fail(fake.frameError);
        fail(0x0402); // one that follows from it
    }
    ++fake.frames;
}
void hdGetDoublev(unsigned what, double* values) {
    const auto copy = [&](const auto& from) {
        needFrame();
        for (int i = 0; i < 3; ++i)
            values[i] = from[i];
    };
    if (what == 0x2050) copy(fake.position);
    if (what == 0x2051) copy(fake.velocity);
    if (what == 0x2052) std::copy(fake.transform.begin(), fake.transform.end(), values);
    if (what == 0x2602) *values = fake.maxStiffness;
    if (what == 0x2603) *values = fake.maxForce;
    if (what == 0x2604) fail(0x0100); // this one does not know it
    if (what == 0x2550)
        for (int i = 0; i < 6; ++i)
            values[i] = i < 3 ? -65 : 120;
}
void hdGetIntegerv(unsigned what, int* values) {
    if (what == 0x2000) *values = fake.buttons;
    if (what == 0x2555) *values = fake.calibrationStyle;
}
const char* hdGetString(unsigned) {
    return "Fake Touch";
}
void hdSetDoublev(unsigned what, const double* values) {
    needFrame();
    if (what != 0x2700) return;
    double square = 0;
    for (int i = 0; i < 3; ++i) {
        commanded[i] = values[i];
        square += values[i] * values[i];
    }
    if (!std::isfinite(square)) ++fake.notFinite;
    if (std::sqrt(square) > fake.strongest) fake.strongest = std::sqrt(square);
}
Error hdGetError() {
    const std::lock_guard lock(errorsMutex);
    if (errors.empty()) return {0, 0, 0};
    const unsigned code = errors.back();
    errors.pop_back();
    return {code, -1, kHandle};
}
unsigned hdCheckCalibration() {
    return fake.calibration;
}
void hdUpdateCalibration(unsigned style) {
    if (style != 1 && style != 2 && style != 4) ++fake.misuses;
    ++fake.calibrated;
    fake.calibration = 0x5000;
}
unsigned long hdScheduleAsynchronous(unsigned (*wanted)(void*), void* data, unsigned short) {
    callback = wanted;
    callbackData = data;
    return 1;
}
void hdUnschedule(unsigned long) {
    callback = nullptr;
}
#ifdef FAKE_HD_TOO_OLD
#define hdStartScheduler hdStartScheduler1 // the library of another time
#endif
void hdStartScheduler() {
    scheduler = std::jthread(run);
}
void hdStopScheduler() {
    scheduler = {};
}
}
