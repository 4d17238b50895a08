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

/// Keeps the steps that are there of every hand: the rings of one are copied after those of another.
void keepCommonSteps(RecordedRun& run) {
    std::uint64_t first = 0, end = ~std::uint64_t(0);
    for (std::size_t i = 0; i < run.hands(); ++i) {
        first = std::max(first, run.hand(i).proxy.first);
        end = std::min(end, run.hand(i).proxy.end());
    }
    for (std::size_t i = 0; i < run.hands(); ++i) {
        auto& proxy = run.hand(i).proxy;
        dropBefore(proxy, std::min(first, end));
        proxy.rows.resize(std::size_t(end - std::min(end, proxy.first)));
        auto& ticks = run.hand(i).servo.rows;
        while (!ticks.empty() && ticks.back().model > end)
            ticks.pop_back();
    }
}

/// The steps that a replay of all hands may begin with.
std::vector<std::uint64_t> beginningSteps(const RecordedRun& run) {
    std::vector<std::uint64_t> found = beginnings(run.proxy, run.proxyStates);
    for (const HandRecord& other : run.others) {
        const std::vector<std::uint64_t> its = beginnings(other.proxy, other.proxyStates);
        std::erase_if(found, [&](std::uint64_t row) { return std::ranges::find(its, row) == its.end(); });
    }
    return found;
}

/// The first tick of a hand's servo whose model a replay from step `from` on comes to.
std::uint64_t firstTick(const HandRecord& hand, std::uint64_t from, double oldest) {
    const bool touched = hand.proxy.end() > 0;
    for (const std::uint64_t row : beginnings(hand.servo, hand.servoStates)) {
        const ServoRow& first = hand.servo.rows[std::size_t(row - hand.servo.first)];
        if (first.model >= from && first.time >= oldest && (!touched || from < hand.proxy.end())) return row;
    }
    return hand.servo.end();
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
    for (std::size_t i = 0; i < hands(); ++i)
        if (!hand(i).servo.rows.empty()) first = std::min(first, hand(i).servo.rows.front().time);
    return first;
}

double RecordedRun::end() const {
    double last = proxy.rows.empty() ? 0 : proxy.rows.back().time;
    for (std::size_t i = 0; i < hands(); ++i)
        if (!hand(i).servo.rows.empty()) last = std::max(last, hand(i).servo.rows.back().time);
    return last;
}

void trim(RecordedRun& run, double seconds) {
    keepCommonSteps(run);
    const double oldest = run.end() - seconds - kStateEvery;
    const std::uint64_t known = firstKnown(run);
    const std::vector<std::uint64_t> steps = beginningSteps(run);
    // Where no step is as young, for no reading came any more, the last ones stay, if they are not too old.
    const auto timeOf = [&](std::uint64_t row) {
        return run.proxy.rows[std::size_t(row - run.proxy.first)].time;
    };
    std::uint64_t from = run.proxy.end();
    for (const std::uint64_t row : steps) {
        if (row < known || timeOf(row) < oldest - seconds + 2 * kStateEvery) continue;
        from = row;
        if (timeOf(row) >= oldest) break;
    }
    for (std::size_t i = 0; i < run.hands(); ++i) {
        HandRecord& hand = run.hand(i);
        // Before the servo's first row come all rows of the proxy that led to its model.
        dropBefore(hand.servo, firstTick(hand, from, oldest));
        dropBefore(hand.proxy, from);
        dropStatesOutside(hand.proxyStates, hand.proxy);
        dropStatesOutside(hand.servoStates, hand.servo);
        if (run.hands() > 1)
            std::erase_if(hand.proxyStates, [&](const SimStateBytes& kept) {
                return !std::ranges::binary_search(steps, kept.row);
            });
    }
    std::set<std::uint64_t> felt;
    for (const ProxyRow& row : run.proxy.rows)
        felt.insert(row.world);
    std::erase_if(run.scenes,
                  [&](const RecordedScene& scene) { return !felt.contains(scene.numbers.revision); });
}

} // namespace tactum
