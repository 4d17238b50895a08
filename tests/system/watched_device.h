// A device whose last command can be seen from outside the program: it lies in memory that both share.
#pragma once

#include <algorithm>
#include <atomic>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "core/base/clock.h"
#include "core/port/haptic_device.h"

namespace tactum::test {

/// What the motors of the watched device do.
struct Motors {
    std::atomic<double> push{0};            ///< N, along z: holds until the next command, as a real one does
    std::atomic<std::int64_t> stoppedAt{0}; ///< when an emergency stop last took a force away, ns
    std::atomic<int> stops{0}; ///< emergency stops: on a busy machine also of a servo that stood still
    std::atomic<std::uint64_t> exchanges{0};
    std::atomic<bool> down{false};       ///< where the finger is led: into the plate, or above it
    std::atomic<std::int64_t> diesAt{0}; ///< when the program begins to die by itself, ns
};

/// Maps the file, made with the right size if it is not; null when that fails.
inline Motors* mapMotors(const char* file) {
    const int fd = open(file, O_RDWR | O_CREAT, 0600);
    if (fd < 0 || ftruncate(fd, sizeof(Motors)) != 0) return nullptr;
    void* memory = mmap(nullptr, sizeof(Motors), PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
    close(fd);
    return memory == MAP_FAILED ? nullptr : static_cast<Motors*>(memory);
}

/// The finger comes down to `lowest` as long as it is led there.
class WatchedDevice final : public HapticDevice {
public:
    WatchedDevice(Motors& motors, double lowest) : motors_(motors), lowest_(lowest) {}

    DeviceInfo info() const override {
        return {.name = "Watched", .maxForce = 8, .rate = 1000, .damping = 1e5, .real = true};
    }
    Result<void> open() override { return {}; }
    void close() override {}
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        motors_.push = command.force.z();
        ++motors_.exchanges;
        height_ += std::clamp((motors_.down ? lowest_ : kAbove) - height_, -0.05 * dt, 0.05 * dt);
        return {.position = {0, 0, height_}, .valid = true};
    }
    void emergencyStop() noexcept override {
        if (motors_.push != 0) motors_.stoppedAt = monotonicNanoseconds();
        motors_.push = 0;
        ++motors_.stops;
    }

private:
    static constexpr double kAbove = 0.005;

    Motors& motors_;
    double lowest_;
    double height_ = kAbove;
};

} // namespace tactum::test
