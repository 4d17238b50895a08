#include "tests/device/wooden_haptics/emulated_wooden_haptics.h"

#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "device/wooden_haptics/report.h"

namespace tactum::test {

namespace {

constexpr std::int64_t kPeriod = 1'000'000; // ns
constexpr int kWatchdog = 500;              // ms
constexpr std::size_t kMaxWaiting = 4;      // reports that the board keeps

Eigen::AngleAxisd about(const Vec3& axis, double angle) {
    return {angle, axis};
}

/// Turns of a motor for one rad of its joint.
double turnsPerRadian(const WoodenArm& arm, Eigen::Index joint) {
    return arm.direction[joint] * arm.disc[joint] / arm.capstan / (2 * std::numbers::pi);
}

} // namespace

Vec3 fingerByRotations(const WoodenArm& arm, const Vec3& joints) {
    const Vec3 shoulder(0, arm.column, 0);
    const Vec3 elbow = shoulder + about(Vec3::UnitX(), joints[1]) * Vec3(0, arm.upperArm, 0);
    const Vec3 finger = elbow + about(Vec3::UnitX(), -joints[2]) * Vec3(0, -arm.forearm, 0);
    return about(Vec3::UnitY(), joints[0]) * finger - arm.origin;
}

Mat3 jacobianByDifferences(const WoodenArm& arm, const Vec3& joints) {
    constexpr double kStep = 1e-5;
    Mat3 jacobian;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto at = [&](double steps) {
            return fingerByRotations(arm, joints + steps * kStep * Vec3::Unit(i));
        };
        // Of the fourth order: what is left out is far below the rounding.
        jacobian.col(i) = (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * kStep);
    }
    return jacobian;
}

UsbDescription EmulatedWoodenHaptics::describe() const {
    UsbDescription about{0x1234, 0x0006, 0x0001, "mbed.org", "HID DEVICE"};
    about.interrupt = true;
    about.out = 0x01;
    about.interfaceClass = 3;
    return about;
}

std::optional<Bytes> EmulatedWoodenHaptics::control(const UsbSetup&, std::span<const std::uint8_t>,
                                                    std::int64_t) {
    return std::nullopt;
}

void EmulatedWoodenHaptics::out(std::span<const std::uint8_t> bytes, std::int64_t) {
    const auto report = decode(bytes);
    if (!report) return;
    ++commands_;
    sinceCommand_ = 0;
    for (std::size_t i = 0; i < 3; ++i)
        (*currents_)[i] = report->values[i];
}

std::optional<Bytes> EmulatedWoodenHaptics::in(std::int64_t now) {
    if (paced && due_ == 0) due_ = now;
    for (; paced && due_ <= now; due_ += kPeriod)
        tick();
    if (reports_.empty()) return std::nullopt;
    Bytes report = std::move(reports_.front());
    reports_.pop_front();
    return report;
}

std::int64_t EmulatedWoodenHaptics::nextIn(std::int64_t now) const {
    return paced && due_ > now ? due_ : now + kPeriod;
}

void EmulatedWoodenHaptics::tick() {
    if (++sinceCommand_ > kWatchdog)
        for (auto& current : *currents_)
            current = 0;
    if (!held_) move(1e-3);
    if (!frozen) ++counter_;
    const WoodenBytes bytes = encode({counts(), counter_});
    reports_.emplace_back(bytes.begin(), bytes.end());
    reports_.back().resize(reportSize);
    if (reports_.size() > kMaxWaiting) reports_.pop_front();
}

void EmulatedWoodenHaptics::hold(const Vec3& joints) {
    held_ = true;
    joints_ = joints;
    velocity_ = Vec3::Zero();
}

void EmulatedWoodenHaptics::restart() {
    powerOn_ = joints_;
    counter_ = 0;
}

/// The work of the motors is the work at the finger.
Vec3 EmulatedWoodenHaptics::motorForce() const {
    Vec3 torques;
    for (Eigen::Index i = 0; i < 3; ++i)
        torques[i] = arm.torqueConstant * milliamperes(static_cast<std::size_t>(i)) / 1000 *
                     turnsPerRadian(arm, i) * 2 * std::numbers::pi;
    return jacobianByDifferences(arm, joints_).transpose().inverse() * torques;
}

void EmulatedWoodenHaptics::move(double dt) {
    velocity_ += (motorForce() + handForce - damping * velocity_) * (dt / mass);
    joints_ += jacobianByDifferences(arm, joints_).inverse() * velocity_ * dt;
}

Counts EmulatedWoodenHaptics::counts() const {
    Counts counts{};
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double turns = (joints_[i] - powerOn_[i]) * turnsPerRadian(arm, i);
        counts[static_cast<std::size_t>(i)] =
            static_cast<std::int16_t>(static_cast<std::uint16_t>(std::lround(turns * arm.countsPerTurn)));
    }
    return counts;
}

} // namespace tactum::test
