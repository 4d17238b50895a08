// The flight recorder: the last minute of both loops, always on.
//
// Each loop writes a row for each of its steps and, once a second, the state that it had before one. A minute
// takes 30 MB at 1 kHz and 116 MB at 4 kHz; all of it is touched before the loops start, and none before.
#pragma once

#include "core/base/clock.h"
#include "core/base/record_ring.h"
#include "core/runtime/recorded_run.h"

namespace tactum {

/// The rings of one hand. Writers: the two loops, each its own half. Reader: the thread that owns the engine.
class Recorder {
public:
    /// Rates in Hz. `start`: ns of monotonicNanoseconds(), the time 0 of its rows; that of all hands in one
    /// World is the same. Thread: any but real time.
    Recorder(double servoRate, double proxyRate, std::int64_t start = monotonicNanoseconds());

    /// All memory that the loops will write to. Thread: any but real time, before they start.
    void touch() noexcept;

    /// s since the recorder was made. Thread: real time.
    double now() const noexcept;

    // Of the proxy loop: begin() before the step, which may write to the row and to the state; end() after
    // it and before the model is published, so that no row of the servo names one that is not there.
    // Thread: real time, proxy.
    void begin(ProxyRow& row, SimState& state) noexcept { keep(row, state); }
    /// Of a hand beside the first.
    void begin(ProxyRow& row, HandState& state) noexcept { keep(row, state); }
    void end(const ProxyRow& row) noexcept { proxyRows_.push(row), ++proxyCount_; }
    /// The number of rows so far. Thread: proxy.
    std::uint64_t proxyCount() const noexcept { return proxyCount_; }

    // Of the servo loop. Thread: real time, servo.
    void begin(const ServoRow& row, const ServoState& state) noexcept;
    void end(const ServoRow& row) noexcept { servoRows_.push(row), ++servoCount_; }

    /// The last minute, or what there is of it, without scenes and device.
    /// Thread: any but real time, while the loops go on.
    RecordedRun copy() const;
    std::size_t bytes() const;

private:
    template <class State> void keep(ProxyRow& row, const State& state) noexcept;

    std::int64_t start_; ///< ns of the monotonic clock
    RecordRing<ProxyRow> proxyRows_;
    RecordRing<ServoRow> servoRows_;
    RecordRing<SimStateBytes> proxyStates_;
    RecordRing<ServoStateBytes> servoStates_;
    std::uint64_t proxyCount_ = 0, servoCount_ = 0;
    /// s. The proxy's first state is the empty one; the servo's has the heat that the motors had already.
    double proxyStateDue_ = kStateEvery, servoStateDue_ = 0;
};

} // namespace tactum
