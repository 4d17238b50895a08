#include "tests/device/plugin/fake_2diy.h"

#include <cmath>
#include <cstring>

namespace tactum::test {
namespace {

constexpr double kInner = 0.07, kOuter = 0.09, kApart = 0.038, kMiddle = 0.13; // m
constexpr unsigned char kBoard = 5;
constexpr double kCounts = 4880; ///< a turn

struct Angles {
    double left, right; ///< rad, counter-clockwise from the way from the left motor to the right one
};

/// The left elbow stands out to the left, the right one to the right.
Angles anglesAt(const Vec3& handle) {
    const double x = kApart / 2 - handle.x(), y = kMiddle + handle.z();
    const auto corner = [](double far) {
        return std::acos((kInner * kInner + far * far - kOuter * kOuter) / (2 * kInner * far));
    };
    return {std::atan2(y, x) + corner(std::hypot(x, y)),
            std::atan2(y, x - kApart) - corner(std::hypot(x - kApart, y))};
}

float measured(double angle) {
    return float(std::round(angle / (2 * M_PI) * kCounts) * 360 / kCounts);
}

} // namespace

Fake2diy::Fake2diy() {
    plug();
}

Fake2diy::~Fake2diy() {
    unplug();
}

void Fake2diy::hold(const Vec3& position) {
    const std::lock_guard lock(mutex_);
    handle_ = position;
}

/// By virtual work: what the motors do as the handle moves a little along each axis.
Vec3 Fake2diy::pushed() const {
    const std::lock_guard lock(mutex_);
    constexpr double kStep = 1e-6; // m
    Vec3 force = Vec3::Zero();
    for (const int axis : {0, 2}) {
        const Vec3 step = kStep * Vec3::Unit(axis);
        const Angles after = anglesAt(handle_ + step), before = anglesAt(handle_ - step);
        force[axis] = (double(torques_[0]) * (after.left - before.left) +
                       double(torques_[1]) * (after.right - before.right)) /
                      (2 * kStep);
    }
    return force;
}

void Fake2diy::unplug() {
    port_.unplug();
    const std::lock_guard lock(mutex_);
    torques_ = {}; // its power came by the cable
}

void Fake2diy::plug() {
    bytes_.clear();
    reset_ = wired_ = false;
    port_.plug([this] { step(); });
}

void Fake2diy::step() {
    using namespace std::chrono_literals;
    const std::string_view more = port_.hear(5ms);
    bytes_.insert(bytes_.end(), more.begin(), more.end());
    takeWholePackets();
}

void Fake2diy::takeWholePackets() {
    static constexpr std::array<std::size_t, 3> kLengths{2, 2 + 8 + 16, 2 + 8}; // reset, set up, torques
    while (!bytes_.empty()) {
        const unsigned char kind = bytes_[0];
        if (kind > 2) {
            ++complaints_;
            bytes_.clear();
            return;
        }
        const std::size_t length = kLengths[kind];
        if (bytes_.size() < length) return;
        if (kind == 0) reset_ = true;
        if (kind == 1) {
            // Motors at ports 1 and 2, then encoders; no sensors, no outputs; the rest angles in degrees, and
            // counts.
            static constexpr std::array<unsigned char, 8> kWiring{3, 1, 1, 3, 1, 1, 0, 0};
            static constexpr std::array<float, 4> kEncoders{12, 4880, 168, 4880};
            wired_ = reset_ && std::memcmp(&bytes_[2], kWiring.data(), 8) == 0 &&
                     std::memcmp(&bytes_[10], kEncoders.data(), 16) == 0;
            if (!wired_) ++complaints_;
        }
        if (kind == 2 && !wired_) ++complaints_;
        if (kind == 2 && wired_) {
            const std::lock_guard lock(mutex_);
            std::memcpy(&torques_[1], &bytes_[2], 4); // port 1: the right motor
            std::memcpy(&torques_[0], &bytes_[6], 4);
        }
        bytes_.erase(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(length));
        if (kind == 2 && wired_) answer();
    }
}

void Fake2diy::answer() const {
    Angles angles{};
    {
        const std::lock_guard lock(mutex_);
        angles = anglesAt(handle_);
    }
    std::array<unsigned char, 9> packet{kBoard};
    const std::array<float, 2> byPort{measured(angles.right), measured(angles.left)};
    std::memcpy(&packet[1], byPort.data(), 8);
    port_.say({reinterpret_cast<const char*>(packet.data()), packet.size()});
}

} // namespace tactum::test
