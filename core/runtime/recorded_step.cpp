#include "core/runtime/recorded_step.h"

#include "core/base/inplace_vector.h"

namespace tactum {
namespace {

HapticInput inputOf(const ProxyRow& row) noexcept {
    HapticInput input{.finger = vectorOf(row.finger),
                      .fingerVelocity = vectorOf(row.velocity),
                      .restart = (row.flags & ProxyRow::Restart) != 0,
                      .fidelity = row.fidelity(),
                      .found = (row.flags & ProxyRow::Found) != 0,
                      .coupling = {row.coupling[0], row.coupling[1], row.coupling[2]}};
    // A step leaves out who is nowhere.
    if (row.flags & ProxyRow::Absent) input.finger.setConstant(std::numeric_limits<double>::quiet_NaN());
    return input;
}

} // namespace

void stepFrom(std::span<const ProxyRow> rows, const World& world, SimState& first,
              std::span<HandState> others, std::span<HapticOutput> outputs) noexcept {
    const ProxyRow& shared = rows.front();
    const bool forget = (shared.flags & ProxyRow::Forget) != 0;
    if (forget && world.moving) world.moving->forget();
    InplaceVector<HandStep, std::size_t(kMaxHands)> hands;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        HandState& state = i == 0 ? first : others[i - 1];
        if (forget) state.proxy.memories = {};
        state.model.anchoring = rows[i].anchoring;
        hands.push({state, inputOf(rows[i])});
    }
    hapticStep(world, first, hands.all(), shared.dt,
               {.pace = shared.pace, .begin = (shared.flags & ProxyRow::Begin) != 0});
    for (std::size_t i = 0; i < rows.size(); ++i)
        outputs[i] = hands[i].output;
}

HapticOutput stepFrom(const ProxyRow& row, const World& world, SimState& state) noexcept {
    HapticOutput output;
    stepFrom({&row, 1}, world, state, {}, {&output, 1});
    return output;
}

} // namespace tactum
