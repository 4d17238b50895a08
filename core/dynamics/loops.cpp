#include "core/dynamics/loops.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

/// A row whose own part is smaller than this share of what it is for free bodies says nothing new: of a loop
/// in a plane three of the five rows of a hinge. The same of one that hardly moves at first order, as where a
/// loop is stretched out: its force would have no bound.
constexpr double kNew = 1e-6;

using Numbers = Eigen::Map<const Eigen::VectorXd>;

double softnessOf(const Mechanism& mechanism, const Lock& lock) {
    double least = kUnbounded; // the heavier of the two: the other may weigh next to nothing
    for (const int i : {lock.of.a.link, lock.of.b.link}) {
        if (i < 0) continue;
        const Link& link = mechanism.links[std::size_t(i)];
        least = std::min(least, lock.of.measure == Measure::Along ? 1 / link.mass : 3 / link.moments.trace());
    }
    return least;
}

bool sameFrames(const Coordinate& one, const Coordinate& other) {
    return one.a.link == other.a.link && one.b.link == other.b.link && one.a.pose == other.a.pose &&
           one.b.pose == other.b.pose;
}

} // namespace

Loops::Loops(const Mechanism& mechanism) : mechanism_(mechanism), rows_(mechanism.loops.size()) {
    std::size_t numbers = 0, squares = 0;
    for (const Island& island : mechanism.islands) {
        for (int i = island.firstLoop; i < island.endLoop; ++i) {
            rows_[std::size_t(i)].first = numbers;
            rows_[std::size_t(i)].free = softnessOf(mechanism, mechanism.loops[std::size_t(i)]);
            rows_[std::size_t(i)].framesAsBefore =
                i > island.firstLoop &&
                sameFrames(mechanism.loops[std::size_t(i - 1)].of, mechanism.loops[std::size_t(i)].of);
            numbers += std::size_t(island.velocities);
        }
        factorFirst_.push_back(squares);
        squares += std::size_t((island.endLoop - island.firstLoop) * (island.endLoop - island.firstLoop));
    }
    jacobian_.resize(numbers);
    change_.resize(numbers);
    factor_.resize(squares);
    rhs_.resize(rows_.size());
}

double& Loops::factorAt(const Island& island, int row, int column) noexcept {
    const std::size_t which = std::size_t(&island - mechanism_.islands.data());
    return factor_[factorFirst_[which] + std::size_t(row * (island.endLoop - island.firstLoop) + column)];
}

double Loops::factorAt(const Island& island, int row, int column) const noexcept {
    return const_cast<Loops*>(this)->factorAt(island, row, column);
}

void Loops::factor(Articulation& articulation) noexcept {
    gap_ = 0;
    for (const Island& island : mechanism_.islands) {
        const int count = island.endLoop - island.firstLoop, n = island.velocities;
        Frames frames;
        for (int r = 0; r < count; ++r) {
            const std::size_t i = std::size_t(island.firstLoop + r);
            const Lock& lock = mechanism_.loops[i];
            Row& row = rows_[i];
            if (!row.framesAsBefore)
                frames = {articulation.poseOf(lock.of.a), articulation.poseOf(lock.of.b)};
            row.frames = frames;
            row.now = measure(lock.of, frames.a, frames.b);
            gap_ = std::max(gap_, std::abs(row.now.value - lock.at));
            double* jacobian = jacobian_.data() + row.first;
            std::fill_n(jacobian, n, 0.0);
            articulation.addJacobian(lock.of.b.link, row.now.along, 1, jacobian);
            articulation.addJacobian(lock.of.a.link, row.now.along, -1, jacobian);
            articulation.respond(island, jacobian, change_.data() + row.first);
        }
        // Cholesky's factor, without the rows that are sums of others.
        for (int r = 0; r < count; ++r) {
            Row& row = rows_[std::size_t(island.firstLoop + r)];
            const Numbers own(jacobian_.data() + row.first, n);
            for (int c = 0; c <= r; ++c) {
                const Row& other = rows_[std::size_t(island.firstLoop + c)];
                double sum = own.dot(Numbers(change_.data() + other.first, n));
                for (int k = 0; k < c; ++k)
                    sum -= factorAt(island, r, k) * factorAt(island, c, k);
                if (c < r) {
                    factorAt(island, r, c) = other.holds ? sum / factorAt(island, c, c) : 0;
                } else {
                    row.holds = sum > kNew * row.free;
                    factorAt(island, r, r) = row.holds ? std::sqrt(sum) : 0;
                }
            }
            if (!row.holds)
                for (int c = 0; c <= r; ++c)
                    factorAt(island, r, c) = 0;
        }
    }
}

void Loops::solve(const Island& island, double* rhs) const noexcept {
    const int count = island.endLoop - island.firstLoop;
    for (int r = 0; r < count; ++r) {
        for (int k = 0; k < r; ++k)
            rhs[r] -= factorAt(island, r, k) * rhs[k];
        rhs[r] = rows_[std::size_t(island.firstLoop + r)].holds ? rhs[r] / factorAt(island, r, r) : 0;
    }
    for (int r = count; r-- > 0;) {
        for (int k = r + 1; k < count; ++k)
            rhs[r] -= factorAt(island, k, r) * rhs[k];
        rhs[r] = rows_[std::size_t(island.firstLoop + r)].holds ? rhs[r] / factorAt(island, r, r) : 0;
    }
}

void Loops::addAnswer(const Island& island, double* to) const noexcept {
    solve(island, rhs_.data());
    Eigen::Map<Eigen::VectorXd> answer(to, island.velocities);
    for (int i = island.firstLoop; i < island.endLoop; ++i)
        answer += rhs_[std::size_t(i - island.firstLoop)] *
                  Numbers(change_.data() + rows_[std::size_t(i)].first, island.velocities);
}

void Loops::correct(const Articulation& articulation, Coordinates& acceleration) noexcept {
    for (const Island& island : mechanism_.islands) {
        const int count = island.endLoop - island.firstLoop;
        if (count == 0) continue;
        FrameVelocity a, b;
        for (int r = 0; r < count; ++r) {
            const std::size_t i = std::size_t(island.firstLoop + r);
            const Lock& lock = mechanism_.loops[i];
            const Coordinate& of = lock.of;
            const Row& row = rows_[i];
            const Measured& now = row.now;
            if (!row.framesAsBefore) a = articulation.velocityOf(of.a), b = articulation.velocityOf(of.b);
            const Wrench rate = rateOf(of, row.frames.a, row.frames.b, a, b);
            const double velocity = articulation.powerOf(of.a, of.b, now.along);
            rhs_[std::size_t(r)] = -articulation.accelerationAlong(of.a, of.b, now.along) -
                                   articulation.powerOf(of.a, of.b, rate) - 2 * kClosing * velocity -
                                   kClosing * kClosing * (now.value - lock.at);
        }
        addAnswer(island, acceleration.data() + island.v);
    }
}

void Loops::project(const Island& island, double* change) const noexcept {
    const int count = island.endLoop - island.firstLoop;
    if (count == 0) return;
    const Numbers moved(change, island.velocities);
    for (int r = 0; r < count; ++r)
        rhs_[std::size_t(r)] =
            -Numbers(jacobian_.data() + rows_[std::size_t(island.firstLoop + r)].first, island.velocities)
                 .dot(moved);
    addAnswer(island, change);
}

void Loops::closing(Coordinates& shift) const noexcept {
    shift.setZero();
    for (const Island& island : mechanism_.islands) {
        const int count = island.endLoop - island.firstLoop;
        for (int r = 0; r < count; ++r) {
            const std::size_t i = std::size_t(island.firstLoop + r);
            rhs_[std::size_t(r)] = mechanism_.loops[i].at - rows_[i].now.value;
        }
        addAnswer(island, shift.data() + island.v);
    }
}

void Loops::projectAll(Coordinates& velocities) const noexcept {
    for (const Island& island : mechanism_.islands)
        project(island, velocities.data() + island.v);
}

} // namespace tactum
