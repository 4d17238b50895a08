#include "core/runtime/recorder.h"

#include <cmath>

namespace tactum {
namespace {

/// More than is saved: what is being written over while it is copied is lost, and a replay begins at a state.
constexpr double kRoom = kRecorded + 3 * kStateEvery;

std::size_t rowsFor(double rate) {
    return std::size_t(std::ceil(kRoom * rate));
}

constexpr std::size_t kStates = std::size_t(kRoom / kStateEvery) + 1;

} // namespace

Recorder::Recorder(double servoRate, double proxyRate, std::int64_t start)
    : start_(start), proxyRows_(rowsFor(proxyRate)), servoRows_(rowsFor(servoRate)), proxyStates_(kStates),
      servoStates_(kStates) {}

void Recorder::touch() noexcept {
    proxyRows_.touch();
    servoRows_.touch();
    proxyStates_.touch();
    servoStates_.touch();
}

double Recorder::now() const noexcept {
    return 1e-9 * double(monotonicNanoseconds() - start_);
}

// The state is kept without its memories: so the loop, too, goes on without them.
template <class State> void Recorder::keep(ProxyRow& row, const State& state) noexcept {
    if (row.time < proxyStateDue_) return;
    proxyStateDue_ = row.time + kStateEvery;
    row.flags |= ProxyRow::Forget;
    SimStateBytes kept;
    kept.row = proxyCount_;
    write(state, kept);
    proxyStates_.push(kept);
}

template void Recorder::keep(ProxyRow& row, const SimState& state) noexcept;
template void Recorder::keep(ProxyRow& row, const HandState& state) noexcept;

void Recorder::begin(const ServoRow& row, const ServoState& state) noexcept {
    if (row.time < servoStateDue_) return;
    servoStateDue_ = row.time + kStateEvery;
    ServoStateBytes kept;
    kept.row = servoCount_;
    write(state, kept);
    servoStates_.push(kept);
}

RecordedRun Recorder::copy() const {
    RecordedRun run;
    // The servo's first: every row of the proxy that one of them names is then there already.
    run.servoStates = servoStates_.copy().rows;
    run.servo = servoRows_.copy();
    run.proxyStates = proxyStates_.copy().rows;
    run.proxy = proxyRows_.copy();
    return run;
}

std::size_t Recorder::bytes() const {
    return proxyRows_.bytes() + servoRows_.bytes() + proxyStates_.bytes() + servoStates_.bytes();
}

} // namespace tactum
