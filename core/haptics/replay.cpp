#include "core/haptics/replay.h"

#include <algorithm>
#include <chrono>
#include <numeric>

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

} // namespace

TouchTrace replay(const World& world, const std::vector<FingerPoint>& path) {
    return *replay(world, path, {});
}

Result<TouchTrace> replay(const World& world, const std::vector<FingerPoint>& path,
                          const Progress& progress) {
    constexpr std::size_t kLook = 512; // steps between two looks
    ProgressMeter meter(progress, path.size(), kLook);
    TouchTrace rows;
    rows.reserve(path.size());
    SimState state;
    if (!path.empty()) state.time = path.front().t - kFirstStep;
    for (const FingerPoint& point : path) {
        if (!meter.goesOn(rows.size())) return cancelledError();
        const double dt = rows.empty() ? kFirstStep : point.t - rows.back().t;
        HapticInput input{point.position, Vec3::Zero()};
        if (!rows.empty()) input.fingerVelocity = (point.position - rows.back().finger) / dt;
        const std::int64_t begin = nanoseconds();
        const HapticOutput output = hapticStep(world, state, input, dt);
        const std::int64_t end = nanoseconds();
        rows.push_back({point.t, point.position, output.proxy, output.force, output.contacts,
                        output.report.rounds, end - begin, tangentialOf(output)});
    }
    return rows;
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
