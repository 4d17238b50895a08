#include "core/recording/row_checks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/geometry/soup_builder.h"
#include "core/port/device_check.h"
#include "core/port/workspace.h"
#include "core/safety/inhibit_words.h"

namespace tactum {
namespace {

constexpr double kLongestDt = 1; ///< s
/// s. The rings hold a minute, and a live recording is cut to it; inside that minute rows may be any time
/// apart: a device that gives no readings has no haptic steps, and a program that was stopped has no rows at
/// all.
constexpr double kLongestRun = 2 * kRecorded;
/// s. A clock that began with the loops; far beyond it a second more would be the same number.
constexpr double kLatest = 1e9;

bool isTime(double time) {
    return std::abs(time) <= kLatest;
}

bool isPlace(const Triple& v) {
    return std::ranges::all_of(v, isCoordinate);
}

bool isFrame(const ServoRow& row) {
    const DeviceFrame frame = frameOf(row);
    const bool none = std::all_of(row.axes.begin() + 3, row.axes.end(), [](int axis) { return axis == 0; });
    return none && checkWorkspace({.scale = frame.scale, .axes = frame.axes, .offset = frame.offset});
}

/// What is wrong with a row's time; nullptr when nothing is. `begin`: of the whole run.
const char* faultIn(double time, double before, double begin) {
    if (!isTime(time)) return "has a time that cannot be";
    if (time < before) return "is earlier than the one before it";
    if (time - begin > kLongestRun) return "is minutes after the beginning, longer than a recording is";
    return nullptr;
}

const char* faultIn(const ProxyRow& row) {
    const bool possible = row.dt > 0 && row.dt <= kLongestDt && row.pace >= 0 && row.pace <= 1 &&
                          row.coupling[0] >= 0 && row.coupling[1] >= 0 && row.coupling[2] >= 0 &&
                          std::isfinite(row.coupling[2]) &&
                          (row.flags & ~std::uint32_t(ProxyRow::kAllFlags)) == 0 && isPlace(row.finger) &&
                          isPlace(row.velocity);
    return possible ? nullptr : "has a length, a place or a flag that cannot be";
}

const char* faultIn(const ServoRow& row, std::uint64_t model, std::uint64_t models) {
    if (row.model < model || row.model > models) return "has a model that cannot be";
    const bool possible = (row.flags & ~std::uint32_t(ServoRow::kAllFlags)) == 0 && isFrame(row) &&
                          isPlace(row.outside) && row.border >= 0 && isCoordinate(row.border) &&
                          row.inhibit < kInhibitWords.size();
    return possible ? nullptr : "has a frame, a flag or a reason that cannot be";
}

/// Of what has a time at all.
double beginOf(const RecordedRun& run) {
    double begin = kLatest;
    if (!run.proxy.rows.empty() && isTime(run.proxy.rows.front().time))
        begin = std::min(begin, run.proxy.rows.front().time);
    for (std::size_t i = 0; i < run.hands(); ++i) {
        const auto& servo = run.hand(i).servo.rows;
        if (!servo.empty() && isTime(servo.front().time)) begin = std::min(begin, servo.front().time);
    }
    return begin;
}

/// Of the first row that something is wrong with: which it is, and what. `faultOf` looks at all but times.
template <class Row, class Check>
std::string faultIn(const char* what, const NumberedRows<Row>& rows, double begin, const Check& faultOf) {
    double before = begin;
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        const Row& row = rows.rows[i];
        const char* fault = faultIn(row.time, before, begin);
        if (!fault) fault = faultOf(row);
        if (fault) return what + std::to_string(rows.first + i) + ' ' + fault;
        before = row.time;
    }
    return {};
}

std::string faultIn(const HandRecord& hand, double begin) {
    if (!checkDevice(hand.device)) return "its device has figures that cannot be";
    std::string fault =
        faultIn("haptic step ", hand.proxy, begin, [](const ProxyRow& row) { return faultIn(row); });
    if (!fault.empty()) return fault;
    std::uint64_t model = 0;
    return faultIn("servo tick ", hand.servo, begin, [&](const ServoRow& row) {
        return faultIn(row, std::exchange(model, row.model), hand.proxy.end());
    });
}

/// Whether both are of one step. What else they should share only the first hand's row decides.
bool areOfOneStep(const ProxyRow& first, const ProxyRow& other) {
    return first.time == other.time && first.world == other.world;
}

bool haveTheSameSteps(const HandRecord& first, const HandRecord& other) {
    return first.proxy.first == other.proxy.first &&
           std::ranges::equal(first.proxy.rows, other.proxy.rows, areOfOneStep);
}

} // namespace

std::string faultIn(const RecordedRun& run) {
    if (run.hands() > std::size_t(kMaxHands)) return "it has more hands than can be";
    const double begin = beginOf(run);
    for (std::size_t i = 0; i < run.hands(); ++i) {
        const std::string fault = faultIn(run.hand(i), begin);
        if (!fault.empty()) return i == 0 ? fault : "hand " + std::to_string(i + 1) + ": " + fault;
        if (!haveTheSameSteps(run, run.hand(i))) return "its hands have not the same haptic steps";
    }
    return {};
}

} // namespace tactum
