// The rows of a recording: all that goes into a step of a loop, and what came out of it.
//
// The loops themselves step from the row that they are about to record, through these two functions. So
// nothing can influence a step that its row does not hold, and a replay is the same call with the same row.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>

#include "core/haptics/haptic_step.h"
#include "core/safety/servo_step.h"

namespace tactum {

using Triple = std::array<double, 3>;

inline Triple tripleOf(const Vec3& v) noexcept {
    return {v.x(), v.y(), v.z()};
}
inline Vec3 vectorOf(const Triple& v) noexcept {
    return {v[0], v[1], v[2]};
}

/// One hand's part of one hapticStep(). SI, world frame. Of several hands each has a row for every step; what
/// they share, `dt`, `pace`, `world`, Forget and Begin, is the same in all of them, and that of the first
/// counts. Its layout is that of the file: no gaps, a multiple of eight bytes.
struct ProxyRow {
    enum Flag : std::uint32_t {
        Restart = 1,   ///< HapticInput::restart
        Forget = 2,    ///< the sweep memories were emptied: the state before this row was kept
        Found = 4,     ///< HapticInput::found
        Absent = 8,    ///< the hand had no part in the step: its device gave no reading
        Begin = 16,    ///< BodiesTime::begin
        kFidelity = 8, ///< from this bit on: Fidelity
        kAllFlags = 31 | 3 << kFidelity
    };

    double time = 0; ///< s since the recorder was made: when the loop woke
    double dt = 0;
    double pace = 1; ///< BodiesTime::pace
    Triple coupling{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
                    0}; ///< HapticInput::coupling
    Triple finger{}, velocity{};
    std::uint64_t world = 0; ///< revision
    std::uint32_t anchoring = 0;
    std::uint32_t flags = 0;

    Triple proxy{}, force{};
    std::uint64_t contacts = 0;

    Fidelity fidelity() const noexcept { return Fidelity(flags >> kFidelity); }
};

/// One servoStep(). SI, frame D.
struct ServoRow {
    enum Flag : std::uint32_t {
        Valid = 1,
        Jumped = 2,
        Late = 4,
        Fresh = 8,
        Armed = 16,
        Override = 32,
        Unguarded = 64,
        Clutched = 128,
        Stopped = 256,
        Fading = 512,
        Grasped = 1024,
        kAllFlags = 2047
    };

    double time = 0, dt = 0;
    double apart = 0;              ///< ServoInput::apart
    Triple position{}, velocity{}; ///< as they were read
    Triple offset{};               ///< of the DeviceFrame, with its scale and axes
    double scale = 1;
    std::array<std::int8_t, 8> axes{1, 2, 3}; ///< the last five are zero
    Triple outside{};                         ///< ServoInput::outside_D
    double border = 0;                        ///< ServoInput::border
    std::uint64_t model = 0; ///< how many rows of the proxy led to the model; 0: there was none
    double period = 0;       ///< ServoSettings::period
    std::uint32_t buttons = 0, deadMan = 0;
    std::uint32_t flags = 0;

    std::uint32_t inhibit = 0; ///< InhibitReason
    Triple force{};            ///< that the device was sent
    double gain = 0;
    std::uint64_t faults = 0, oscillations = 0;
};

static_assert(sizeof(ProxyRow) == 168 && sizeof(ServoRow) == 224, "the layout of the file");

/// The step of the rows' inputs, one row of each hand. `first` holds what all
/// hands share, too, `others` the second hand and so on; as many rows as hands, at most kMaxHands. `outputs`:
/// of each hand. Thread: real time.
void stepFrom(std::span<const ProxyRow> rows, const World& world, SimState& first,
              std::span<HandState> others, std::span<HapticOutput> outputs) noexcept;
/// The same for one hand.
HapticOutput stepFrom(const ProxyRow& row, const World& world, SimState& state) noexcept;

/// Writes down what came out. Thread: real time.
inline void note(ProxyRow& row, const HapticOutput& output) noexcept {
    row.proxy = tripleOf(output.proxy);
    row.force = tripleOf(output.force);
    row.contacts = std::uint64_t(output.contacts);
}

inline DeviceFrame frameOf(const ServoRow& row) noexcept {
    return {row.scale, {row.axes[0], row.axes[1], row.axes[2]}, vectorOf(row.offset)};
}

/// Thread: real time.
inline ServoOutput stepFrom(const ServoRow& row, ServoState& state, const LocalContactModel& model) noexcept {
    const auto is = [&row](ServoRow::Flag flag) { return (row.flags & flag) != 0; };
    const ServoSettings settings{.armed = is(ServoRow::Armed),
                                 .fading = is(ServoRow::Fading),
                                 .deadMan = row.deadMan,
                                 .overrideCeiling = is(ServoRow::Override),
                                 .grasped = is(ServoRow::Grasped),
                                 .period = row.period};
    const DeviceSample sample{.position = vectorOf(row.position),
                              .velocity = vectorOf(row.velocity),
                              .buttons = row.buttons,
                              .valid = is(ServoRow::Valid),
                              .jumped = is(ServoRow::Jumped),
                              .stopped = is(ServoRow::Stopped)};
    return servoStep(state, settings,
                     {.sample = sample,
                      .frame = frameOf(row),
                      .dt = row.dt,
                      .apart = row.apart,
                      .late = is(ServoRow::Late),
                      .fresh = is(ServoRow::Fresh),
                      .unguarded = is(ServoRow::Unguarded),
                      .clutched = is(ServoRow::Clutched),
                      .outside_D = vectorOf(row.outside),
                      .border = row.border},
                     model);
}

/// Thread: real time.
inline void note(ServoRow& row, const ServoOutput& output, const ServoState& state) noexcept {
    row.force = tripleOf(output.force);
    row.inhibit = std::uint32_t(state.gate.inhibit());
    row.gain = state.gate.gain();
    row.faults = state.gate.faults();
    row.oscillations = state.schedule.oscillations();
}

} // namespace tactum
