#include "core/runtime/recorded_run.h"

#include <algorithm>
#include <set>

namespace tactum {
namespace {

template <class Row> void dropBefore(NumberedRows<Row>& rows, std::uint64_t number) {
    const std::uint64_t dropped =
        std::min<std::uint64_t>(rows.rows.size(), number - std::min(number, rows.first));
    rows.rows.erase(rows.rows.begin(), rows.rows.begin() + std::ptrdiff_t(dropped));
    rows.first += dropped;
}

/// A state that was kept for a step that was still under way has no row.
template <class State, class Row>
void dropStatesOutside(std::vector<State>& states, const NumberedRows<Row>& rows) {
    std::erase_if(states,
                  [&](const State& state) { return state.row < rows.first || state.row >= rows.end(); });
}

/// The rows that a replay may begin with: the very first, and those before which a state was kept.
template <class Row, class State>
std::vector<std::uint64_t> beginnings(const NumberedRows<Row>& rows, const std::vector<State>& states) {
    std::vector<std::uint64_t> found;
    if (rows.first == 0 && !rows.rows.empty()) found.push_back(0);
    for (const State& state : states)
        if (state.size > 0 && state.row >= rows.first && state.row < rows.end()) found.push_back(state.row);
    return found;
}

/// The number of the first row from which on all scenes are known.
std::uint64_t firstKnown(const RecordedRun& run) {
    const auto& rows = run.proxy.rows;
    std::size_t i = rows.size();
    while (i > 0 &&
           ((i < rows.size() && rows[i - 1].world == rows[i].world) || run.sceneOf(rows[i - 1].world)))
        --i;
    return run.proxy.first + i;
}

} // namespace

const RecordedScene* RecordedRun::sceneOf(std::uint64_t revision) const {
    const auto found =
        std::ranges::find(scenes, revision, [](const RecordedScene& s) { return s.numbers.revision; });
    return found == scenes.end() ? nullptr : &*found;
}

double RecordedRun::begin() const {
    double first = end();
    if (!proxy.rows.empty()) first = std::min(first, proxy.rows.front().time);
    if (!servo.rows.empty()) first = std::min(first, servo.rows.front().time);
    return first;
}

double RecordedRun::end() const {
    return std::max(proxy.rows.empty() ? 0 : proxy.rows.back().time,
                    servo.rows.empty() ? 0 : servo.rows.back().time);
}

void trim(RecordedRun& run, double seconds) {
    const bool touched = run.proxy.end() > 0;
    const double oldest = run.end() - seconds - kStateEvery;
    const std::uint64_t known = firstKnown(run);
    // Where no step is as young, for no reading came any more, the last ones stay, if they are not too old.
    const auto timeOf = [&](std::uint64_t row) {
        return run.proxy.rows[std::size_t(row - run.proxy.first)].time;
    };
    std::uint64_t from = run.proxy.end();
    for (const std::uint64_t row : beginnings(run.proxy, run.proxyStates)) {
        if (row < known || timeOf(row) < oldest - seconds + 2 * kStateEvery) continue;
        from = row;
        if (timeOf(row) >= oldest) break;
    }
    // Before the servo's first row come all rows of the proxy that led to its model.
    std::uint64_t servoFrom = run.servo.end();
    for (const std::uint64_t row : beginnings(run.servo, run.servoStates)) {
        const ServoRow& first = run.servo.rows[std::size_t(row - run.servo.first)];
        if (first.model >= from && first.time >= oldest && (!touched || from < run.proxy.end())) {
            servoFrom = row;
            break;
        }
    }
    dropBefore(run.proxy, from);
    dropBefore(run.servo, servoFrom);
    dropStatesOutside(run.proxyStates, run.proxy);
    dropStatesOutside(run.servoStates, run.servo);
    std::set<std::uint64_t> felt;
    for (const ProxyRow& row : run.proxy.rows)
        felt.insert(row.world);
    std::erase_if(run.scenes,
                  [&](const RecordedScene& scene) { return !felt.contains(scene.numbers.revision); });
}

} // namespace tactum
