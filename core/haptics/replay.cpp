#include "core/haptics/replay.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/haptics/haptic_step.h"

namespace tactum {

namespace {

// The first row has no time before it; devices run at 1 kHz.
constexpr double kFirstStep = 1e-3;

std::int64_t nanoseconds() {
    return std::chrono::duration_cast<std::chrono::nanoseconds>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// What is left of the force without the share of the normals that push.
double tangentialOf(const HapticOutput& output) {
    Vec3 rest = output.force;
    for (int i = 0; i < std::min(output.contacts, kMaxModelPlanes); ++i) {
        const Vec3& normal = output.contact[std::size_t(i)].normal;
        rest -= std::max(0.0, rest.dot(normal)) * normal;
    }
    return output.contacts > 0 ? rest.norm() : 0;
}

/// Where a path that is not empty has the finger at a time.
Vec3 fingerAt(const FingerPath& path, double t) {
    const auto after = std::ranges::lower_bound(path, t, {}, &FingerPoint::t);
    if (after == path.end()) return path.back().position;
    if (after == path.begin() || after->t == t) return after->position;
    const FingerPoint& before = *std::prev(after);
    const double part = (t - before.t) / (after->t - before.t);
    return before.position + part * (after->position - before.position);
}

/// Hands that go along their paths.
class HandsOnPaths {
public:
    HandsOnPaths(const World& world, std::span<const FingerPath> paths, double begin)
        : world_(world), paths_(paths), states_(paths.size()), traces_(paths.size()) {
        shared_.time = begin;
        for (HandState& state : states_)
            steps_.push_back({state, {}});
        for (TouchTrace& trace : traces_)
            trace.reserve(paths.front().size());
    }

    void step(double t) {
        const bool first = traces_[0].empty();
        const double dt = first ? kFirstStep : t - traces_[0].back().t;
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const Vec3 finger = fingerAt(paths_[i], t);
            steps_[i].input = {.finger = finger};
            if (!first) steps_[i].input.fingerVelocity = (finger - traces_[i].back().finger) / dt;
        }
        const std::int64_t begin = nanoseconds();
        hapticStep(world_, shared_, steps_, dt);
        const std::int64_t end = nanoseconds();
        for (std::size_t i = 0; i < steps_.size(); ++i) {
            const HapticOutput& output = steps_[i].output;
            traces_[i].push_back({t, steps_[i].input.finger, output.proxy, output.force, output.contacts,
                                  output.report.rounds, end - begin, tangentialOf(output)});
        }
    }
    std::vector<TouchTrace> take() { return std::move(traces_); }

private:
    const World& world_;
    std::span<const FingerPath> paths_;
    WorldState shared_;
    std::vector<HandState> states_;
    std::vector<HandStep> steps_; ///< refer to the states
    std::vector<TouchTrace> traces_;
};

} // namespace

TouchTrace replay(const World& world, const FingerPath& path) {
    return *replay(world, path, {});
}

Result<TouchTrace> replay(const World& world, const FingerPath& path, const Progress& progress) {
    auto traces = replay(world, std::span(&path, 1), progress);
    if (!traces) return tl::unexpected(traces.error());
    return std::move(traces->front());
}

Result<std::vector<TouchTrace>> replay(const World& world, std::span<const FingerPath> paths,
                                       const Progress& progress) {
    constexpr std::size_t kBetweenLooks = 512; // steps between two looks
    if (std::ranges::any_of(paths, &FingerPath::empty)) return std::vector<TouchTrace>(paths.size());
    HandsOnPaths hands(world, paths, paths[0].front().t - kFirstStep);
    ProgressMeter meter(progress, paths[0].size(), kBetweenLooks);
    for (std::size_t i = 0; i < paths[0].size(); ++i) {
        if (!meter.goesOn(i)) return cancelledError();
        hands.step(paths[0][i].t);
    }
    return hands.take();
}

UpdateTimes updateTimes(const TouchTrace& rows) {
    UpdateTimes times;
    if (rows.empty()) return times;
    std::vector<std::int64_t> sorted;
    for (const TouchRow& row : rows)
        sorted.push_back(row.updateNs);
    std::ranges::sort(sorted);
    const auto quantile = [&](double q) {
        return sorted[std::min(sorted.size() - 1, std::size_t(q * double(sorted.size())))];
    };
    times.mean =
        double(std::accumulate(sorted.begin(), sorted.end(), std::int64_t(0))) / double(sorted.size());
    times.median = quantile(0.5);
    times.p99 = quantile(0.99);
    times.p999 = quantile(0.999);
    times.max = sorted.back();
    return times;
}

} // namespace tactum
