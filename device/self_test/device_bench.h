// Experiments with a real device: its loop, at its pace and under the device watchdog.
#pragma once

#include <atomic>

#include "core/loop/device_watchdog.h"
#include "core/loop/realtime_thread.h"
#include "device/self_test/trial_bench.h"

namespace tactum {

/// Talks to the device all the time, without force between the experiments. Thread of all members: one, not
/// real time.
class DeviceBench final : public TrialBench {
public:
    /// The device is open, and outlives this.
    explicit DeviceBench(HapticDevice& device) : device_(device), info_(device.info()) {}
    ~DeviceBench() override;
    DeviceBench(const DeviceBench&) = delete;
    DeviceBench& operator=(const DeviceBench&) = delete;

    /// Before the first run(). Errors: no device watchdog, no thread.
    Result<void> start();
    Result<std::vector<TrialRow>> run(double seconds, double limit, const TrialForce& force) override;

private:
    struct Job;
    struct Finger;
    void loop() noexcept;

    HapticDevice& device_;
    DeviceInfo info_;
    DeviceWatchdog watchdog_;
    RealtimeThread thread_;
    std::atomic<bool> stop_{false};
    std::atomic<Job*> job_{nullptr}; ///< the loop takes it away when it is done
};

} // namespace tactum
