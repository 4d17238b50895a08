#include "core/self_test/device_bench.h"

#include <algorithm>
#include <cmath>

#include "core/loop/metronome.h"
#include "core/port/force_limiter.h"
#include "core/port/reading_clock.h"
#include "core/self_test/trial.h"

namespace tactum {
namespace {

constexpr double kBenchLooks = 50;     ///< a second, of whoever waits for the end
constexpr double kVelocityTime = 5e-3; ///< s, of the low pass
constexpr double kNoReading = 0.01;    ///< s without a reading or a tick: no force, as the port says
constexpr double kGivenUp = 1;         ///< s without a reading: the experiment ends
constexpr double kSettling = 0.1;      ///< s without force, before the first tick that counts
constexpr double kFastestTicks = 4;    ///< times the rate: as the metronome lets a device tick
constexpr int kBenchFarewells = 3;     ///< exchanges with zero, the last acts

} // namespace

/// One experiment, as the loop has it: rows are reserved before.
struct DeviceBench::Job {
    enum class End { Whole, TooFast, Silent, Stopped, Ended };

    double seconds;
    ForceLimiter limiter;
    const TrialForce& force;
    double begin = -1; ///< s of the metronome
    End end = End::Whole;
    std::vector<TrialRow> rows;
};

/// What the readings say, tick by tick.
struct DeviceBench::Finger {
    ReadingClock clock;
    TrialRow row;
    Vec3 velocity = Vec3::Zero();
    double silent = kGivenUp; ///< s
    std::uint64_t readings = 0;
    bool known = false;

    void hear(const DeviceSample& sample, double elapsed) noexcept {
        const double apart = clock(sample, elapsed, monotonicNanoseconds());
        row.valid = sample.valid && sample.position.allFinite();
        silent = row.valid ? 0 : silent + elapsed;
        if (!row.valid) return;
        if (apart > 0 && known)
            velocity +=
                std::min(1.0, apart / kVelocityTime) * ((sample.position - row.position) / apart - velocity);
        known = true;
        ++readings;
        row.position = sample.position;
        row.buttons = sample.buttons;
    }
};

DeviceBench::~DeviceBench() {
    stop_ = true;
    thread_.join();
    watchdog_.stop();
}

Result<void> DeviceBench::start() {
    lockPresentMemory();
    // Before the thread: the device watchdog is a fork, which has only the thread that forks.
    if (Result<void> watched = info_.real ? watchdog_.start(device_) : Result<void>{}; !watched)
        return watched;
    return thread_.start("tactum-trial", kServoPriority, [this] { loop(); });
}

Result<std::vector<TrialRow>> DeviceBench::run(double seconds, double limit, const TrialForce& force) {
    Job job{.seconds = seconds,
            .limiter = {.maxForce = std::min(limit, info_.maxForce)},
            .force = force,
            .rows = {}};
    job.rows.reserve(std::size_t(kFastestTicks * seconds * info_.rate) + 1);
    job_.store(&job, std::memory_order_release);
    for (Metronome looks(kBenchLooks); job_.load(std::memory_order_acquire);)
        looks.wait();
    const std::string trouble = device_.trouble().empty() ? "" : " " + device_.trouble();
    switch (job.end) {
    case Job::End::TooFast:
        return machineError(
            info_.name + " was faster than " + trialNumber("%.2g", info_.tripSpeed) +
            " m/s and got no force any more: keep your hands off it when you are asked to, and look "
            "whether it has its place.");
    case Job::End::Silent:
        return machineError(info_.name + " gives no readings: look at its cable and its supply." + trouble);
    case Job::End::Stopped:
        return machineError(info_.name + " was stopped by its own button: release it and begin again." +
                            trouble);
    case Job::End::Ended:
        return machineError("The self-test was ended; " + info_.name + " has no force any more.");
    case Job::End::Whole:
        break;
    }
    if (job.rows.size() < 2) return machineError(info_.name + " made no ticks: begin again." + trouble);
    return std::move(job.rows);
}

void DeviceBench::loop() noexcept {
    Finger finger;
    DeviceCommand command;
    /// What the device gets next; `over`: the experiment is.
    const auto step = [&](Job& job, double now, bool stopped, bool& over) -> Vec3 {
        if (job.begin < 0) job.begin = now + kSettling;
        finger.row.time = now - job.begin;
        if (finger.row.time < 0) return Vec3::Zero();
        const bool fast = finger.velocity.norm() > info_.tripSpeed;
        job.end = ended_.load(std::memory_order_relaxed) ? Job::End::Ended
                  : stopped && job.limiter.maxForce > 0  ? Job::End::Stopped
                  : finger.silent >= kGivenUp            ? Job::End::Silent
                  : fast                                 ? Job::End::TooFast
                                                         : Job::End::Whole;
        over = job.end != Job::End::Whole || finger.row.time >= job.seconds ||
               job.rows.size() == job.rows.capacity();
        if (over) return Vec3::Zero();
        const bool blind = finger.silent > kNoReading;
        finger.row.force = blind ? Vec3(Vec3::Zero()) : job.limiter(job.force(finger.row, finger.velocity));
        job.rows.push_back(finger.row); // reserved
        return finger.row.force;
    };
    Metronome metronome(info_.rate);
    while (!stop_.load(std::memory_order_relaxed)) {
        const Tick tick = metronome.wait(device_);
        // Nobody has felt the force of before a stall since; now it would be a kick.
        if (tick.elapsed > kNoReading) command = {};
        const DeviceSample sample = device_.exchange(command, tick.elapsed);
        watchdog_.beat();
        finger.hear(sample, tick.elapsed);
        Job* const job = job_.load(std::memory_order_acquire);
        bool over = false;
        command.force = job ? step(*job, tick.time, sample.stopped, over) : Vec3::Zero();
        device_.announce(command);
        looks_.write({.position = finger.row.position,
                      .force = command.force,
                      .buttons = finger.row.buttons,
                      .readings = finger.readings,
                      .silent = finger.silent,
                      .part = job ? std::clamp(finger.row.time / job->seconds, 0.0, 1.0) : 0,
                      .runs = job && !over});
        if (over) job_.store(nullptr, std::memory_order_release); // it is not ours any more
    }
    watchdog_.rest();
    for (int i = 0; i < kBenchFarewells; ++i)
        device_.exchange({}, metronome.period());
}

} // namespace tactum
