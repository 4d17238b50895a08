#include "tests/core/self_test/plant_bench.h"

#include <algorithm>
#include <cmath>

namespace tactum::test {

Vec3 PlantBench::reading() {
    std::normal_distribution<double> noise(0, 1);
    Vec3 read;
    for (std::size_t i = 0; i < 3; ++i) {
        const int axis = plant_.read[i];
        const double seen = plant_.scale[std::size_t(axis)] * place[axis] + plant_.noise * noise(random_) +
                            (i == 0 ? plant_.crossed * place.y() : 0);
        read[int(i)] = plant_.step > 0 ? plant_.step * std::round(seen / plant_.step) : seen;
    }
    return read;
}

Vec3 PlantBench::pushOf(const Vec3& command) const {
    Vec3 push = Vec3::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        push[plant_.push[i]] += plant_.motorGain * plant_.motor[i] * command[int(i)];
    return push;
}

void PlantBench::move(double seconds, const Vec3& push) {
    constexpr double h = 1e-4;
    for (int n = 0; n < int(std::lround(seconds / h)); ++n) {
        lagged_ +=
            plant_.lag > 0 ? Vec3((push - lagged_) * (1 - std::exp(-h / plant_.lag))) : Vec3(push - lagged_);
        for (int axis = 0; axis < 3 && !held; ++axis) {
            const double mass = plant_.mass + (axis == 1 ? hung : 0);
            const double pull = axis == 1 ? -plant_.weight - 9.80665 * hung : 0;
            // Dry friction stops it within a step, or holds it, or acts against its motion.
            const double free =
                velocity[axis] + h / mass * (lagged_[axis] + pull - plant_.damping * velocity[axis]);
            const double brake = h / mass * plant_.friction;
            velocity[axis] = std::abs(free) <= brake ? 0 : free - std::copysign(brake, free);
            place[axis] += h * velocity[axis];
        }
    }
}

Result<std::vector<TrialRow>> PlantBench::run(double seconds, double limit, const TrialForce& force) {
    std::vector<TrialRow> rows;
    std::deque<Vec3> onTheWay(std::size_t(plant_.delay), Vec3::Zero());
    Vec3 before = reading(), speed = Vec3::Zero();
    lagged_.setZero();
    const double dt = 1 / plant_.rate;
    for (int tick = 0; tick * dt < seconds; ++tick) {
        TrialRow row;
        row.time = tick * dt;
        row.position = reading();
        row.valid = true;
        row.buttons = plant_.stuckButtons;
        if (presses && tick % 500 > 250) row.buttons |= (1U << (tick / 500 % 4)) & ~plant_.deafButtons;
        speed += 0.2 * ((row.position - before) / dt - speed);
        before = row.position;
        row.force = force(row, speed);
        if (row.force.norm() > limit) row.force *= limit / row.force.norm();
        strongest = std::max(strongest, row.force.norm());
        if (velocity.norm() > 1.5) return machineError("too fast");
        onTheWay.push_back(row.force);
        move(dt, pushOf(onTheWay.front()));
        onTheWay.pop_front();
        rows.push_back(row);
    }
    return rows;
}

bool PlantPerson::does(TrialAsk what, const TrialWords& words) {
    ++asked;
    if (leavesOut.contains(what) || words.empty()) return false;
    bench_.held =
        what == TrialAsk::Zero || what == TrialAsk::Right || what == TrialAsk::Up || what == TrialAsk::Toward;
    bench_.velocity.setZero();
    bench_.place = what == TrialAsk::Right    ? Vec3(kRulerWay, 0, 0)
                   : what == TrialAsk::Up     ? Vec3(0, kRulerWay, 0)
                   : what == TrialAsk::Toward ? Vec3(0, 0, kRulerWay)
                                              : Vec3(0.002, -0.003, 0.001);
    if (what == TrialAsk::Zero) bench_.place.setZero();
    bench_.hung = what == TrialAsk::Hang ? hangs.value_or(0) : 0;
    bench_.presses = what == TrialAsk::Press;
    return true;
}

} // namespace tactum::test
