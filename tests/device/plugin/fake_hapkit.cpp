#include "tests/device/plugin/fake_hapkit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>

#include <termios.h>

#include "tests/device/plugin/arduino/Arduino.h"

// ---- The Arduino. Thread: the board's, but where atomic.

namespace {

constexpr double kHandle = 0.065659, kPulley = 0.004191, kSector = 0.073152, kTorque = 0.03; // m, N m
constexpr int kLeast = 48, kMost = 971; ///< of the sensor

tactum::test::BoardPort* port = nullptr;
long boardsBaud = 0;
std::deque<std::uint8_t> heard;
double handle = 0; ///< m
std::atomic<int> duty{0}, level{0};

/// Bytes at another speed are none.
bool sameSpeed() {
    termios host{};
    return tcgetattr(port->master(), &host) == 0 && cfgetospeed(&host) == B500000 && boardsBaud == 500000;
}

void listen() {
    using namespace std::chrono_literals;
    const std::string_view bytes = port->hear(200us);
    if (!bytes.empty() && sameSpeed()) heard.insert(heard.end(), bytes.begin(), bytes.end());
}

} // namespace

std::uint8_t TCCR0B = 3; // 976 Hz, by which millis() counts milliseconds
ArduinoSerial Serial;

void pinMode(std::uint8_t, std::uint8_t) {}
void digitalWrite(std::uint8_t pin, std::uint8_t to) {
    if (pin == 8) level = to;
}
void analogWrite(std::uint8_t pin, int to) {
    if (pin == 5) duty = std::clamp(to, 0, 255);
}
int analogRead(std::uint8_t pin) {
    if (pin != A2) return 0;
    const double halfTurns = handle * kSector / (kHandle * kPulley * M_PI) + 0.3; // as it was glued on
    return kLeast + int(std::lround((halfTurns - std::floor(halfTurns)) * (kMost - kLeast)));
}
std::uint32_t millis() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    const auto real = std::chrono::duration_cast<std::chrono::milliseconds>(now).count();
    return std::uint32_t((TCCR0B & 7) == 1 ? 64 * real : real);
}
void ArduinoSerial::begin(long baud) {
    boardsBaud = baud;
}
int ArduinoSerial::available() {
    return int(heard.size());
}
int ArduinoSerial::read() {
    const int byte = heard.front();
    heard.pop_front();
    return byte;
}
std::size_t ArduinoSerial::write(const std::uint8_t* bytes, std::size_t count) {
    port->say({reinterpret_cast<const char*>(bytes), count});
    return count;
}

// ---- What it is built into

namespace tactum::test {

FakeHapkit::FakeHapkit() {
    port = &port_;
    plug();
}

FakeHapkit::~FakeHapkit() {
    unplug();
    port = nullptr;
}

void FakeHapkit::hold(double x) {
    wanted_ = x;
}

Vec3 FakeHapkit::pushed() const {
    const double part = duty / 255.0, force = kTorque * part * part * kSector / (kHandle * kPulley);
    return Vec3(level ? force : -force, 0, 0);
}

void FakeHapkit::unplug() {
    port_.unplug();
    duty = 0; // its power came by the cable
}

void FakeHapkit::plug() {
    wanted_ = handle = 0;
    heard.clear();
    setup();
    port_.plug([this] { step(); });
}

void FakeHapkit::say(std::string_view bytes) const {
    port_.say(bytes);
}

/// A millimetre at a time, a sixth of the half turn that the sensor tells apart.
void FakeHapkit::step() {
    listen();
    handle += std::clamp(wanted_ - handle, -1e-3, 1e-3);
    loop();
}

} // namespace tactum::test
