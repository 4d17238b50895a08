#include "tests/device/polhem/fake_polhem.h"

#include <cmath>
#include <cstdio>

namespace tactum::test {
namespace {

using Vec2 = Eigen::Vector2d;
using namespace std::chrono_literals;

// hfab_polhem.h and polhem_v3(), as the driver's: facts of the arm.
constexpr double kApart = 0.034, kUpper = 0.165, kCrank = 0.025, kRod = 0.190, kLever = 0.034,
                 kFore = 0.1308;                                           // m
constexpr std::array<double, 3> kOrigin{0.2045, 0, 0.0325};                // m, frame of the maker
constexpr std::array<double, 3> kHome{8312, -10366, 19764};                // counts
constexpr std::array<double, 3> kMotor{0.0603, 0.0538, 0.0538};            // N m/A
constexpr std::array<double, 3> kCapstan{0.0288534, 0.0136981, 0.0137281}; // m
constexpr std::array<double, 3> kDrum{0.175, 0.100, 0.100};
constexpr std::array<double, 3> kSign{1, -1, 1};

double gear(std::size_t i) {
    return kSign[i] * kCapstan[i] / kDrum[i];
}

double angle(const Vec2& way) {
    return std::atan2(way.y(), way.x());
}

struct Pose {
    std::array<double, 3> angles{};
    double height = 0; ///< kg m
    Vec2 forearm = Vec2::Zero();
};

/// From `from` at `radius`, on a circle of `other` about `to`: the one to the left of the way.
Vec2 crossing(const Vec2& from, double radius, const Vec2& to, double other) {
    const double far = (to - from).norm(), along = (radius * radius - other * other + far * far) / (2 * far);
    const Vec2 way = (to - from) / far;
    return from + along * way + std::sqrt(radius * radius - along * along) * Vec2(-way.y(), way.x());
}

double heightOf(double mass, const Vec2& inner, const Vec2& outer, double along, double aside) {
    const Vec2 way = (outer - inner).normalized();
    return mass * (inner.y() + along * way.y() + aside * way.x());
}

/// Frame of the maker.
Pose poseAt(const Vec3& finger) {
    const Vec3 at = finger + Vec3(kOrigin[0], kOrigin[1], kOrigin[2]);
    const Vec2 tip(std::hypot(at.x(), at.y()), at.z()), shoulder(kApart / 2, 0), axis(-kApart / 2, 0);
    const Vec2 elbow = crossing(shoulder, kUpper, tip, kFore);
    const Vec2 end = elbow - kLever / kFore * (tip - elbow);
    const Vec2 pin = crossing(axis, kCrank, end, kRod);
    double crank = angle(pin - axis);
    if (crank < 0) crank += 2 * M_PI; // it is never near there
    return {{std::atan2(at.y(), at.x()), angle(elbow - shoulder), crank},
            heightOf(0.15764, shoulder, elbow, 0.030123, 0.000484) +
                heightOf(0.07733, axis, pin, -0.004086, 0.001911) +
                heightOf(0.09767, pin, end, 0.087765, 0.001978) +
                heightOf(0.11265, elbow, tip, 0.061701, 0.000576),
            (tip - elbow).normalized()};
}

Vec3 toMaker(const Vec3& d) {
    return {d.z(), d.x(), d.y()};
}
Vec3 toD(const Vec3& maker) {
    return {maker.y(), maker.z(), maker.x()};
}

/// By virtual work: what motors and weights do as the finger moves a little along each axis.
Vec3 pushOf(const std::array<int, 3>& milliamperes, const Vec3& finger) {
    constexpr double kStep = 1e-6; // m
    if (milliamperes == std::array<int, 3>{}) return Vec3::Zero();
    Vec3 force;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = kStep * Vec3::Unit(axis);
        const Pose after = poseAt(finger + step), before = poseAt(finger - step);
        double work = -9.81 * (after.height - before.height);
        for (std::size_t i = 0; i < 3; ++i)
            work += 1e-3 * milliamperes[i] * kMotor[i] / gear(i) * (after.angles[i] - before.angles[i]);
        force[axis] = work / (2 * kStep);
    }
    return force;
}

} // namespace

FakePolhem::FakePolhem(Firmware firmware) : firmware_(firmware) {
    plug();
}

FakePolhem::~FakePolhem() {
    unplug();
}

void FakePolhem::hold(const Vec3& finger) {
    const std::lock_guard lock(mutex_);
    finger_ = finger;
}

void FakePolhem::turn(const Vec3& wrist) {
    const std::lock_guard lock(mutex_);
    wrist_ = wrist;
}

Vec3 FakePolhem::forearm() const {
    const std::lock_guard lock(mutex_);
    const Pose pose = poseAt(toMaker(finger_));
    const double column = pose.angles[0];
    return toD({std::cos(column) * pose.forearm.x(), std::sin(column) * pose.forearm.x(), pose.forearm.y()});
}

void FakePolhem::sayInstead(std::string answer) {
    const std::lock_guard lock(mutex_);
    instead_ = std::move(answer);
}

Vec3 FakePolhem::pushed() const {
    const std::lock_guard lock(mutex_);
    return toD(firmware_ == Firmware::Of2023 ? pushOf(milliamperes_, toMaker(finger_)) : force_);
}

void FakePolhem::unplug() {
    port_.unplug();
    const std::lock_guard lock(mutex_);
    force_ = Vec3::Zero();
    milliamperes_ = {};
}

void FakePolhem::plug() {
    askedForPlaces_ = false;
    line_.clear();
    port_.plug([this] { step(); });
}

void FakePolhem::step() {
    for (const char byte : port_.hear(2ms))
        takeByte(byte);
    if (firmware_ != Firmware::Of2023 && Clock::now() - understood_ > 100ms) {
        const std::lock_guard lock(mutex_);
        force_ = Vec3::Zero(); // nobody there
    }
}

void FakePolhem::takeByte(char byte) {
    if (firmware_ == Firmware::Of2023) {
        if (byte == '[') line_.clear();
        line_ += byte;
        if (byte != ']') return;
        takeCurrents();
    } else {
        line_ += byte;
        if (byte != '\n' && line_.size() < 64) return;
        if (byte != '\n') {
            line_.clear(); // the board's buffer is full: unheard
            return;
        }
        takeLine();
    }
    line_.clear();
    answer();
}

/// Seven numbers, as sscanf() finds them: up to the first zero byte.
void FakePolhem::takeLine() {
    std::array<short, 7> n{};
    const int found = std::sscanf(line_.c_str(), "%hd %hd %hd %hd %hd %hd %hd", &n[0], &n[1], &n[2], &n[3],
                                  &n[4], &n[5], &n[6]);
    const std::string said = line_.c_str(); // up to there
    const std::lock_guard lock(mutex_);
    force_ = Vec3::Zero();
    if (found != 7) {
        if (said != "\n" && said != "[0,0,0]\n" && !said.empty()) ++complaints_;
        return;
    }
    if (n[3] != 2 || n[4] != 0 || n[5] != 0 || n[6] != 0) {
        ++complaints_;
        return;
    }
    askedForPlaces_ = true;
    understood_ = Clock::now();
    force_ = 1e-3 * Vec3(n[0], n[1], n[2]);
}

void FakePolhem::takeCurrents() {
    std::array<int, 3> n{};
    int end = 0;
    const int found = std::sscanf(line_.c_str(), "[%d,%d,%d]%n", &n[0], &n[1], &n[2], &end);
    const std::lock_guard lock(mutex_);
    const bool right = found == 3 && std::size_t(end) == line_.size();
    for (const int current : n)
        if (!right || std::abs(current) > 6000) ++complaints_;
    if (right) milliamperes_ = n;
}

std::string FakePolhem::placeAnswer() const {
    const std::size_t size = firmware_ == Firmware::Of2021 ? 64 : 63;
    const Vec3 mm = 1e3 * toMaker(finger_);
    std::array<char, 128> text{};
    if (askedForPlaces_)
        std::snprintf(text.data(), text.size(), "% 8.3f % 8.3f % 8.3f % 7.4f % 7.4f % 7.4f % 7.4f %d", mm.x(),
                      mm.y(), mm.z(), poseAt(toMaker(finger_)).angles[0],
                      angle(poseAt(toMaker(finger_)).forearm), wrist_[0], wrist_[1], 0);
    else
        std::snprintf(text.data(), text.size(), "8298 -10771 19756 0 30 0 0");
    std::string answer = text.data();
    answer.resize(size - 1, ' ');
    return answer + '\n';
}

std::string FakePolhem::countAnswer() const {
    const Pose pose = poseAt(toMaker(finger_));
    std::array<long, 3> counts{};
    for (std::size_t i = 0; i < 3; ++i)
        counts[i] = std::lround(pose.angles[i] / gear(i) * 4096 / (2 * M_PI) - kHome[i]);
    std::array<char, 128> text{};
    const auto wrist = [this](int i, int sign, int rest) {
        return std::lround(sign * wrist_[i] * 1024 / (2 * M_PI)) - rest;
    };
    std::snprintf(text.data(), text.size(), "[%d,%ld,%ld,%ld,%ld,%ld,%ld,%d]\n", model.load(), counts[0],
                  counts[1], counts[2], wrist(0, -1, 0), wrist(1, -1, 30), wrist(2, 1, 0), error.load());
    return text.data();
}

void FakePolhem::answer() {
    if (mute) return;
    std::string text;
    {
        const std::lock_guard lock(mutex_);
        text = !instead_.empty() ? instead_ : firmware_ == Firmware::Of2023 ? countAnswer() : placeAnswer();
    }
    const std::size_t piece = inPieces ? text.size() / 3 + 1 : text.size();
    for (std::size_t at = 0; at < text.size(); at += piece) {
        if (at > 0) std::this_thread::sleep_for(2ms);
        port_.say(std::string_view(text).substr(at, piece));
    }
}

} // namespace tactum::test
