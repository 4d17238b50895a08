#include "tests/device/plugin/fake_hapkit.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <deque>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include "tests/device/plugin/arduino/Arduino.h"

// ---- The Arduino. Thread: the board's, but where atomic.

namespace {

constexpr double kHandle = 0.065659, kPulley = 0.004191, kSector = 0.073152, kTorque = 0.03; // m, N m
constexpr int kLeast = 48, kMost = 971; ///< of the sensor

int master = -1;
long boardsBaud = 0;
std::deque<std::uint8_t> heard;
double handle = 0; ///< m
std::atomic<int> duty{0}, level{0};

/// Bytes at another speed are none.
bool sameSpeed() {
    termios host{};
    return tcgetattr(master, &host) == 0 && cfgetospeed(&host) == B500000 && boardsBaud == 500000;
}

void listen() {
    pollfd ready{.fd = master, .events = POLLIN, .revents = 0};
    const timespec soon{.tv_sec = 0, .tv_nsec = 200'000};
    if (ppoll(&ready, 1, &soon, nullptr) <= 0 || !(ready.revents & POLLIN)) return;
    std::array<std::uint8_t, 64> bytes;
    const ssize_t count = read(master, bytes.data(), bytes.size());
    if (count > 0 && sameSpeed()) heard.insert(heard.end(), bytes.begin(), bytes.begin() + count);
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
    return std::size_t(std::max<ssize_t>(::write(master, bytes, count), 0));
}

// ---- What it is built into

namespace tactum::test {

FakeHapkit::FakeHapkit() : port_(folder_.filePath("hapkit").toStdString()) {
    setenv("HAPKIT", port_.c_str(), 1);
    plug();
}

FakeHapkit::~FakeHapkit() {
    unplug();
    unsetenv("HAPKIT");
}

void FakeHapkit::hold(double x) {
    wanted_ = x;
}

Vec3 FakeHapkit::pushed() const {
    const double part = duty / 255.0, force = kTorque * part * part * kSector / (kHandle * kPulley);
    return Vec3(level ? force : -force, 0, 0);
}

void FakeHapkit::unplug() {
    if (master < 0) return;
    ends_ = true;
    thread_.join();
    close(std::exchange(master, -1));
    std::filesystem::remove(port_);
    duty = 0; // its power came by the cable
}

void FakeHapkit::plug() {
    master = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
    if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0) std::abort();
    std::filesystem::create_symlink(ptsname(master), port_);
    ends_ = false;
    wanted_ = handle = 0;
    heard.clear();
    thread_ = std::thread([this] { run(); });
}

void FakeHapkit::say(const char* bytes, std::size_t count) const {
    if (::write(master, bytes, count) < 0) std::abort();
}

/// A millimetre at a time, a sixth of the half turn that the sensor tells apart.
void FakeHapkit::run() {
    setup();
    while (!ends_) {
        listen();
        handle += std::clamp(wanted_ - handle, -1e-3, 1e-3);
        loop();
    }
}

} // namespace tactum::test
