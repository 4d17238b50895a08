#include "core/recording/row_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/control/device_check.h"
#include "core/control/workspace.h"
#include "core/geometry/soup_builder.h"

namespace tactum {
namespace {

constexpr double kLongestDt = 1; ///< s
constexpr double kEver = -std::numeric_limits<double>::infinity();

bool isPlace(const Triple& v) {
    return std::ranges::all_of(v, isCoordinate);
}

bool canBe(const ProxyRow& row, double before) {
    return std::isfinite(row.time) && row.time >= before && row.dt > 0 && row.dt <= kLongestDt &&
           (row.flags & ~std::uint32_t(ProxyRow::kAllFlags)) == 0 && isPlace(row.finger) &&
           isPlace(row.velocity);
}

bool isFrame(const ServoRow& row) {
    const DeviceFrame frame = frameOf(row);
    const bool none = std::all_of(row.axes.begin() + 3, row.axes.end(), [](int axis) { return axis == 0; });
    return none && checkWorkspace({.scale = frame.scale, .axes = frame.axes, .offset = frame.offset});
}

bool canBe(const ServoRow& row, double before, std::uint64_t model) {
    return std::isfinite(row.time) && row.time >= before && row.model >= model &&
           (row.flags & ~std::uint32_t(ServoRow::kAllFlags)) == 0 && isFrame(row);
}

} // namespace

const char* faultIn(const RecordedRun& run) {
    if (!checkDevice(run.device)) return "its device has figures that cannot be";
    double before = kEver;
    for (const ProxyRow& row : run.proxy.rows) {
        if (!canBe(row, before)) return "a haptic step has times or places that cannot be";
        before = row.time;
    }
    before = kEver;
    std::uint64_t model = 0;
    for (const ServoRow& row : run.servo.rows) {
        if (!canBe(row, before, model) || row.model > run.proxy.end())
            return "a servo tick has times or models that cannot be";
        before = row.time;
        model = row.model;
    }
    return nullptr;
}

} // namespace tactum
