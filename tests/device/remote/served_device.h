// A device for a process of its own, whose motors and behaviour lie in memory that the test shares.
#pragma once

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/mman.h>
#include <thread>
#include <unistd.h>

#include "core/port/device_mailbox.h"

namespace tactum::test {

/// What the test sees of it, and asks of it.
struct Served {
    std::atomic<double> push{0};      ///< N, along z: holds until the next command, as a real motor does
    std::atomic<double> strongest{0}; ///< N
    std::atomic<double> torque{0};    ///< N m, about y, the newest
    std::atomic<int> notFinite{0};
    std::atomic<std::int64_t> zeroAt{0}; ///< ns, when the force became zero; 0 while there is some
    std::atomic<std::uint64_t> exchanges{0};
    std::atomic<int> stops{0}, opens{0}, closes{0}, prepares{0};
    std::atomic<pid_t> server{0};
    std::atomic<bool> troubled{false};
    std::atomic<int> zeros{0}, zerosAtClose{0}; ///< commands of zero in a row, the last ones
    std::atomic<int> between{0};                ///< commands of less than the 2 N that tests push with
    std::atomic<bool> ended{false};             ///< serveDevice() came back
    std::array<std::atomic<int>, 4> late{};     ///< frames, by how many frames old the answered reading was

    void command(double z) noexcept {
        if (z != 0) zeroAt = 0;
        push = z;
        if (z == 0 && zeroAt == 0) zeroAt = monotonicNanoseconds();
    }
};

/// Maps the file, made with the right size if it is not; null when that fails.
inline Served* mapServed(const char* file) {
    const int fd = open(file, O_RDWR | O_CREAT, 0600);
    if (fd < 0 || ftruncate(fd, sizeof(Served)) != 0) return nullptr;
    void* memory = mmap(nullptr, sizeof(Served), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    close(fd);
    return memory == MAP_FAILED ? nullptr : static_cast<Served*>(memory);
}

/// Forces that make its driver fail, along x.
inline constexpr double kCrash = 1, kAbort = 2, kOverflow = 3, kHang = 4;

class ServedDevice : public HapticDevice {
public:
    ServedDevice(Served& served, std::string way) : served_(served), way_(std::move(way)) {}

    DeviceInfo info() const override {
        return {.name = "Served",
                .maxForce = 8,
                .maxStiffness = 1234,
                .rate = 1000,
                .damping = 2.5,
                .buttons = 2,
                .real = true,
                .maxTorque = 0.5,
                .measuresVelocity = true};
    }
    std::vector<std::string> steps() const override { return {"Wake", "Home"}; }
    Result<void> prepare(Opening& opening) override {
        ++served_.prepares;
        opening.begin("Wake");
        opening.progress(0.5);
        opening.begin("Home", "Pull the handle.");
        while (way_ == "homes" && !opening.cancelled())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (way_ == "homes") return machineError("The device is not homed. Pull the handle.");
        return {};
    }
    Result<void> open() override {
        if (way_ == "closed") return inputError("The lid of the device is shut: open it.");
        if (way_ == "dies") std::abort();
        if (way_ == "sleeps") std::this_thread::sleep_for(std::chrono::hours(1));
        ++served_.opens;
        return {};
    }
    void close() override {
        ++served_.closes;
        served_.zerosAtClose = served_.zeros.load();
    }
    std::string trouble() const override { return served_.troubled ? "Its motors are warm." : std::string(); }
    DeviceSample exchange(const DeviceCommand& command, double) noexcept override {
        misbehave(command.force.x());
        const double strength = command.force.norm();
        if (!command.force.allFinite() || !command.handle.torque.allFinite()) ++served_.notFinite;
        served_.torque = command.handle.torque.y();
        if (strength > served_.strongest) served_.strongest = strength;
        served_.command(command.force.z());
        if (strength > 0.2 && strength < 1.8) ++served_.between;
        served_.zeros = strength == 0 ? served_.zeros + 1 : 0;
        const std::uint64_t number = ++served_.exchanges;
        return {
            .position = {0, 0.01, 0}, .velocity = {1e-6 * double(number), 0, 0}, .buttons = 2, .valid = true};
    }
    HandleReading handle() noexcept override {
        return {.orientation = Quat(0, 1, 0, 0), .opening = 0.02, .turns = true, .grips = true};
    }
    void emergencyStop() noexcept override {
        served_.command(0);
        ++served_.stops;
    }

protected:
    Served& served_;

private:
    static int overflow(int depth) {
        volatile char room[4096] = {};
        room[depth % 4096] = char(depth);
        return depth > 1'000'000'000 ? room[0] : overflow(depth + 1) + room[1];
    }
    static void misbehave(double how) noexcept {
        if (how == kCrash) *static_cast<volatile int*>(nullptr) = 1;
        if (how == kAbort) std::abort();
        if (how == kOverflow) std::_Exit(overflow(0));
        while (how == kHang)
            pause();
    }

    std::string way_;
};

/// A device whose frames come from a scheduler of its maker's, 500 a second. Each reading has a number, x, in
/// tenths; a servo that sends it back as the force tells how old the reading is that a frame answers.
class FramedDevice final : public ServedDevice {
public:
    using ServedDevice::ServedDevice;
    ~FramedDevice() override { end(); }

    Result<void> open() override {
        stop_ = false;
        scheduler_ = std::thread([this] {
            for (auto due = std::chrono::steady_clock::now(); !stop_; std::this_thread::sleep_until(due)) {
                frame();
                due += std::chrono::milliseconds(2);
            }
        });
        return ServedDevice::open();
    }
    void close() override {
        end();
        ServedDevice::close();
    }
    DeviceSample exchange(const DeviceCommand& command, double) noexcept override {
        const std::int64_t now = monotonicNanoseconds();
        box_.command(command.force, now);
        return box_.newest(now);
    }
    bool awaitFrame(std::int64_t until) noexcept override {
        box_.awaitReading(until);
        return true;
    }
    void announce(const DeviceCommand& command) noexcept override {
        box_.answer(command.force, monotonicNanoseconds());
    }

private:
    static constexpr int kNumbers = 64;

    void frame() noexcept {
        const std::int64_t now = monotonicNanoseconds();
        const int answered = int(std::lround(10 * box_.force(now).z()));
        number_ = (number_ + 1) % kNumbers;
        const std::size_t age = std::size_t(number_ - answered + kNumbers) % kNumbers;
        if (answered > 0) ++served_.late[std::min(age, served_.late.size() - 1)];
        box_.measured({.position = {0.1 * number_, 0, 0}, .valid = true}, now);
    }
    void end() {
        stop_ = true;
        if (scheduler_.joinable()) scheduler_.join();
    }

    DeviceMailbox box_;
    std::thread scheduler_;
    std::atomic<bool> stop_{false};
    int number_ = 0;
};

} // namespace tactum::test
