// Experiments with a real device: its loop, at its pace and under the device watchdog.
#pragma once

#include <atomic>

#include "core/base/wait_free.h"
#include "core/loop/device_watchdog.h"
#include "core/loop/realtime_thread.h"
#include "core/self_test/trial_bench.h"

namespace tactum {

/// What the device says at this moment, for whoever looks on. Frame D, SI.
struct TrialLook {
    Vec3 position = Vec3::Zero();
    Vec3 force = Vec3::Zero(); ///< commanded
    std::uint32_t buttons = 0;
    std::uint64_t readings = 0; ///< so far: its growth is the rate
    double silent = 0;          ///< s without a reading
    double part = 0;            ///< of the experiment that runs, 0 to 1
    bool runs = false;          ///< an experiment
};

/// Talks to the device all the time, without force between the experiments. Thread of all members: one, not
/// real time, but where it says another.
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

    /// No force from the next tick on; an experiment that runs ends with an error, and so does every later
    /// one. Thread: any.
    void end() { ended_ = true; }
    /// The newest. Thread: one, not real time; may be another than that of the rest.
    const TrialLook& look() { return looks_.read(); }

private:
    struct Job;
    struct Finger;
    void loop() noexcept;

    HapticDevice& device_;
    DeviceInfo info_;
    DeviceWatchdog watchdog_;
    RealtimeThread thread_;
    std::atomic<bool> stop_{false};
    std::atomic<bool> ended_{false};
    TripleBuffer<TrialLook> looks_;
    std::atomic<Job*> job_{nullptr}; ///< the loop takes it away when it is done
};

} // namespace tactum
