// A device for tests: the finger is where the test says, every exchange is noted.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "core/port/haptic_device.h"

namespace tactum {

struct Exchange {
    Vec3 force;
    double dt;
};

/// What the test and the device share. The log may be read when the loops have ended.
struct Probe {
    std::atomic<double> height{0.01}; ///< of the finger over the origin, m
    std::atomic<bool> valid{true};
    std::atomic<bool> nonsense{false}; ///< the finger's position is no number
    std::atomic<bool> refusesToOpen{false};
    std::atomic<bool> isOpen{false};
    std::atomic<double> rate{1000};   ///< Hz, that the driver names
    std::atomic<int> pause{0};        ///< ms, that the next exchange stands still
    std::atomic<bool> hangs{false};   ///< no exchange comes back while it is so
    std::atomic<bool> hanging{false}; ///< one does not come back now
    std::atomic<int> exchanges{0};
    std::atomic<bool> stopped{false};       ///< by emergencyStop()
    std::atomic<double> push{0};            ///< newest command along z, N
    std::atomic<double> continuousForce{0}; ///< N, 0: the largest
    bool real = false; ///< guarded; then there is no log, whose memory comes page by page
    int buttons = 0;
    std::string name = "Probe";
    std::vector<Exchange> log;
    int exchangesWhileClosed = 0;

    Probe() { log.reserve(1'000'000); }
};

class ProbeDevice final : public HapticDevice {
public:
    static constexpr double kMaxForce = 8;
    static constexpr double kSpeed = 1;  ///< m/s, with which the finger goes where the test wants it
    static constexpr double kGrip = 1e5; ///< N s/m, as if in a vice: no stiffness is too high

    explicit ProbeDevice(std::shared_ptr<Probe> probe) : probe_(std::move(probe)) {}

    DeviceInfo info() const override {
        return {.name = probe_->name,
                .maxForce = kMaxForce,
                .continuousForce = probe_->continuousForce,
                .rate = probe_->rate,
                .damping = kGrip,
                .buttons = probe_->buttons,
                .real = probe_->real};
    }
    Result<void> open() override {
        if (probe_->refusesToOpen) return machineError("The probe is not plugged in: plug it in.");
        probe_->isOpen = true;
        height_ = probe_->height;
        return {};
    }
    void close() override { probe_->isOpen = false; }
    DeviceSample exchange(const DeviceCommand& command, double dt) noexcept override {
        probe_->exchangesWhileClosed += !probe_->isOpen;
        probe_->push = command.force.z();
        ++probe_->exchanges;
        if (!probe_->real && probe_->log.size() < probe_->log.capacity())
            probe_->log.push_back({command.force, dt});
        if (const int pause = probe_->pause.exchange(0))
            std::this_thread::sleep_for(std::chrono::milliseconds(pause));
        for (; probe_->hangs; std::this_thread::sleep_for(std::chrono::milliseconds(1)))
            probe_->hanging = true;
        probe_->hanging = false;
        height_ += std::clamp(probe_->height - height_, -kSpeed * dt, kSpeed * dt);
        const double height = probe_->nonsense ? std::numeric_limits<double>::quiet_NaN() : height_;
        return {.position = {0, 0, height}, .valid = probe_->valid};
    }
    void emergencyStop() noexcept override { probe_->stopped = true; }

private:
    std::shared_ptr<Probe> probe_;
    double height_ = 0;
};

} // namespace tactum
