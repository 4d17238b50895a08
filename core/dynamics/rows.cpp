#include "core/dynamics/rows.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

/// A limit is reached within this, m or rad: what rounding and events leave.
constexpr double kReached = 1e-7;
/// At most so many rounds, and none more when no impulse changes by this part of the largest any more.
constexpr int kRounds = 60;
constexpr double kSettled = 1e-12;
/// A spring whose k h^2 + d h exceeds this part of the inertia that it moves is not smooth in a step h. Runge
/// and Kutta's method is stable up to 7.8 for springs and 2.8 for dampers.
constexpr double kStiff = 0.5;
/// What lies beyond a limit comes back no faster, m/s or rad/s.
constexpr double kFastestReturn = 0.05;

} // namespace

Rows::Rows(const Mechanism& mechanism)
    : mechanism_(mechanism), gaps_(2 * mechanism.limits.size()), end_(Coordinates::Zero(mechanism.vs)) {
    const std::size_t most =
        2 * mechanism.limits.size() + mechanism.frictions.size() + mechanism.springs.size();
    rows_.resize(most);
    int widest = 0;
    for (const Island& island : mechanism.islands)
        widest = std::max(widest, island.velocities);
    jacobian_.resize((most + 1) * std::size_t(widest)); // one more to try
    change_.resize(jacobian_.size());
    Articulation articulation(mechanism);
    articulation.place(mechanism.q0, mechanism.v0);
    articulation.factor();
    for (const Spring& spring : mechanism.springs) {
        const double inertia = inertiaOf(articulation, spring.of);
        softness_.push_back(inertia > 0 ? 1 / inertia : 0);
    }
}

int Rows::islandOf(const Coordinate& of) const noexcept {
    return mechanism_.links[std::size_t(of.b.link >= 0 ? of.b.link : of.a.link)].island;
}

Rows::Reading Rows::read(const Articulation& articulation, const Coordinate& of,
                         const Coordinates& q) const noexcept {
    const Measured now = measure(of, articulation.poseOf(of.a), articulation.poseOf(of.b));
    Reading reading{now.value, now.along, articulation.powerOf(of.a, of.b, now.along)};
    if (of.link >= 0) reading.value = of.sense * q[mechanism_.links[std::size_t(of.link)].q];
    return reading;
}

Rows::Row* Rows::addRow(Articulation& articulation, const Loops& loops, const Coordinate& of,
                        const Wrench& along, double sense) noexcept {
    Row& row = rows_[count_];
    row = {};
    row.first = numbers_;
    row.island = islandOf(of);
    const Island& island = mechanism_.islands[std::size_t(row.island)];
    double* jacobian = jacobian_.data() + row.first;
    double* change = change_.data() + row.first;
    std::fill_n(jacobian, island.velocities, 0.0);
    articulation.addJacobian(of.b.link, along, sense, jacobian);
    articulation.addJacobian(of.a.link, along, -sense, jacobian);
    articulation.respond(island, jacobian, change);
    loops.project(island, change);
    double softness = 0;
    for (int i = 0; i < island.velocities; ++i)
        softness += jacobian[i] * change[i];
    if (!(softness > 1e-30)) return nullptr; // nothing there can move
    row.yield = 1 / softness;
    ++count_;
    numbers_ += std::size_t(island.velocities);
    return &row;
}

void Rows::gatherLimits(Articulation& articulation, const Loops& loops, const Coordinates& q) noexcept {
    for (std::size_t i = 0; i < mechanism_.limits.size(); ++i) {
        const Limit& limit = mechanism_.limits[i];
        const Reading now = read(articulation, limit.of, q);
        gaps_[2 * i] = {now.value - limit.min, now.rate, false};
        gaps_[2 * i + 1] = {limit.max - now.value, -now.rate, false};
        const bool both = limit.min == limit.max;
        for (const std::size_t side : {2 * i, 2 * i + 1}) {
            Gap& gap = gaps_[side];
            if (!both && gap.gap > kReached) continue;
            gap.reached = true;
            if (both && side != 2 * i) continue;
            Row* row = addRow(articulation, loops, limit.of, now.along, side == 2 * i ? 1 : -1);
            if (!row) continue;
            row->low = both ? -kUnbounded : 0;
            row->high = kUnbounded;
            row->depth = both ? -gap.gap : std::max(0.0, -gap.gap);
            row->isLimit = true;
        }
    }
}

void Rows::gatherSprings(Articulation& articulation, const Loops& loops, const Coordinates& q,
                         double dt) noexcept {
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
        if (!springIsRow(i, dt)) continue;
        const Spring& spring = mechanism_.springs[i];
        const Reading now = read(articulation, spring.of, q);
        const bool below = spring.isLimit && now.value < spring.min;
        if (spring.isLimit && !below && !(now.value > spring.max)) continue;
        Row* row = addRow(articulation, loops, spring.of, now.along, 1);
        if (!row) continue;
        // F = k (x0 - x) + d (v0 - v) at the end of the step.
        const double scale = spring.drive.acceleration ? row->yield : 1;
        const double k = scale * spring.drive.stiffness, d = scale * spring.drive.damping;
        const double x0 = spring.isLimit ? (below ? spring.min : spring.max) : spring.drive.position;
        row->compliance = 1 / (dt * (dt * k + d));
        row->target = row->compliance * dt * (k * (x0 - now.value) + d * spring.drive.velocity);
        row->high = spring.isLimit && !below ? 0 : scale * spring.drive.maxForce * dt;
        row->low = spring.isLimit && below ? 0 : -scale * spring.drive.maxForce * dt;
    }
}

void Rows::gather(Articulation& articulation, const Loops& loops, const Coordinates& q, double dt) noexcept {
    count_ = numbers_ = 0;
    gatherLimits(articulation, loops, q);
    gatherSprings(articulation, loops, q, dt);
    for (const DryFriction& friction : mechanism_.frictions) {
        const Reading now = read(articulation, friction.of, q);
        Row* row = addRow(articulation, loops, friction.of, now.along, 1);
        if (!row) continue;
        row->high = friction.force * dt;
        row->low = -row->high;
    }
}

double Rows::velocityOf(const Row& row, const Coordinates& v) const noexcept {
    const Island& island = mechanism_.islands[std::size_t(row.island)];
    double sum = 0;
    for (int i = 0; i < island.velocities; ++i)
        sum += jacobian_[row.first + std::size_t(i)] * v[island.v + i];
    return sum;
}

void Rows::push(const Row& row, double impulse, Coordinates& v) const noexcept {
    const Island& island = mechanism_.islands[std::size_t(row.island)];
    for (int i = 0; i < island.velocities; ++i)
        v[island.v + i] += impulse * change_[row.first + std::size_t(i)];
}

template <class Which> void Rows::relax(Coordinates& v, Which&& which) noexcept {
    for (int round = 0; round < kRounds; ++round) {
        double largest = 0, changed = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            Row& row = rows_[i];
            if (!which(row)) continue;
            const double wanted =
                row.impulse + (row.target - velocityOf(row, v) - row.compliance * row.impulse) /
                                  (1 / row.yield + row.compliance);
            const double impulse = std::clamp(wanted, row.low, row.high);
            const double more = impulse - row.impulse;
            if (more != 0) push(row, more, v);
            row.impulse = impulse;
            largest = std::max(largest, std::abs(impulse));
            changed = std::max(changed, std::abs(more));
        }
        if (changed <= kSettled * largest) return;
    }
}

bool Rows::stopApproaches(Coordinates& v) noexcept {
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i)
        if (rows_[i].isLimit) {
            const double rate = velocityOf(rows_[i], v);
            any = any || (rows_[i].low < 0 ? std::abs(rate) > 1e-12 : rate < -1e-12);
        }
    if (!any) return false;
    relax(v, [](const Row& row) { return row.isLimit; });
    for (std::size_t i = 0; i < count_; ++i)
        rows_[i].impulse = 0;
    return true;
}

void Rows::solve(const Coordinates& v, double dt, Coordinates& along, Coordinates& acceleration) noexcept {
    end_ = v + dt * acceleration;
    relax(end_, [](const Row&) { return true; });
    acceleration = (end_ - v) / dt;
    for (std::size_t i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        const Island& island = mechanism_.islands[std::size_t(row.island)];
        for (int k = 0; k < island.velocities; ++k)
            along[island.v + k] += row.impulse / dt * jacobian_[row.first + std::size_t(k)];
    }
}

double Rows::firstCrossing(const Articulation& end, const Coordinates& q, double dt) const noexcept {
    double first = 1;
    for (std::size_t i = 0; i < mechanism_.limits.size(); ++i) {
        const Limit& limit = mechanism_.limits[i];
        if (gaps_[2 * i].reached && gaps_[2 * i + 1].reached) continue;
        const Reading now = read(end, limit.of, q);
        const std::array<Gap, 2> ends{Gap{now.value - limit.min, now.rate, false},
                                      Gap{limit.max - now.value, -now.rate, false}};
        for (std::size_t side = 0; side < 2; ++side) {
            const Gap &before = gaps_[2 * i + side], &after = ends[side];
            if (before.reached || after.gap > -kReached) continue;
            // Where the cubic through both ends with their slopes passes zero.
            double low = 0, high = 1;
            for (int round = 0; round < 50; ++round) {
                const double s = 0.5 * (low + high), s2 = s * s, s3 = s2 * s;
                const double gap = (2 * s3 - 3 * s2 + 1) * before.gap + (s3 - 2 * s2 + s) * dt * before.rate +
                                   (3 * s2 - 2 * s3) * after.gap + (s3 - s2) * dt * after.rate;
                (gap > 0 ? low : high) = s;
            }
            first = std::min(first, high);
        }
    }
    return first;
}

bool Rows::correction(double dt, Coordinates& shift) noexcept {
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        if (!row.isLimit || std::abs(row.depth) < 1e-12) continue;
        if (!any) shift.setZero();
        any = true;
        const double back =
            std::clamp(std::min(1.0, kClosing * dt) * row.depth, -kFastestReturn * dt, kFastestReturn * dt);
        push(row, back * row.yield, shift);
    }
    return any;
}

bool Rows::springIsRow(std::size_t spring, double dt) const noexcept {
    const JointDrive& drive = mechanism_.springs[spring].drive;
    const double softness = drive.acceleration ? 1 : softness_[spring];
    return (drive.stiffness * dt * dt + drive.damping * dt) * softness > kStiff;
}

double Rows::inertiaOf(Articulation& articulation, const Coordinate& of) noexcept {
    const Island& island = mechanism_.islands[std::size_t(islandOf(of))];
    const Wrench along = measure(of, articulation.poseOf(of.a), articulation.poseOf(of.b)).along;
    const std::size_t last = jacobian_.size() - std::size_t(island.velocities);
    double* jacobian = jacobian_.data() + last;
    std::fill_n(jacobian, island.velocities, 0.0);
    articulation.addJacobian(of.b.link, along, 1, jacobian);
    articulation.addJacobian(of.a.link, along, -1, jacobian);
    articulation.respond(island, jacobian, change_.data() + last);
    double softness = 0;
    for (int i = 0; i < island.velocities; ++i)
        softness += jacobian[i] * change_[last + std::size_t(i)];
    return softness > 0 ? 1 / softness : 0;
}

} // namespace tactum
