#include "core/dynamics/rows.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {

/// At most so many rounds, and none more when no impulse changes by this part of the largest any more.
constexpr int kRounds = 60;
constexpr double kSettled = 1e-12;
/// Bounces one after the other in one moment; what still approaches then is stopped all at once.
constexpr int kBounces = 64;
/// What approaches slower, m/s or rad/s, is rounding.
constexpr double kApproach = -1e-12;
/// What lies beyond a limit comes back no faster, m/s or rad/s.
constexpr double kFastestReturn = 0.05;
/// Numbers of rows that there is room for.
constexpr std::size_t kMostNumbers = std::size_t(1) << 22;

} // namespace

Rows::Rows(const Mechanism& mechanism)
    : mechanism_(mechanism), contacts_(mechanism), gaps_(2 * mechanism.limits.size()),
      end_(Coordinates::Zero(mechanism.vs)), held_(mechanism.links.size(), Vec6::Zero()) {
    const std::size_t places = contacts_.all().capacity();
    const std::size_t most = 2 * mechanism.limits.size() + mechanism.frictions.size() +
                             mechanism.springs.size() + (contacts_.empty() ? 0 : 3 * places);
    rows_.resize(most);
    ways_.resize(most);
    int widest = 0;
    for (const Island& island : mechanism.islands)
        widest = std::max(widest, island.velocities);
    jacobian_.resize(std::min(kMostNumbers, (2 * most + 1) * std::size_t(widest))); // one more to try
    change_.resize(jacobian_.size());
    Articulation articulation(mechanism);
    articulation.place(mechanism.q0, mechanism.v0);
    articulation.factor();
    for (const Spring& spring : mechanism.springs) {
        const double inertia = inertiaOf(articulation, spring.of);
        softness_.push_back(inertia > 0 ? 1 / inertia : 0);
    }
}

bool Rows::holdSprings() const noexcept {
    return std::any_of(rows_.begin(), rows_.begin() + std::ptrdiff_t(count_),
                       [](const Row& row) { return row.kind == Kind::Spring; });
}

double Rows::velocityOf(const Row& row, const Coordinates& v) const noexcept {
    double sum = 0;
    for (const Side& side : row.sides) {
        if (side.island < 0) continue;
        const Island& island = mechanism_.islands[std::size_t(side.island)];
        for (int i = 0; i < island.velocities; ++i)
            sum += jacobian_[side.first + std::size_t(i)] * v[island.v + i];
    }
    return sum;
}

void Rows::push(const Row& row, double impulse, Coordinates& v) const noexcept {
    for (const Side& side : row.sides) {
        if (side.island < 0) continue;
        const Island& island = mechanism_.islands[std::size_t(side.island)];
        for (int i = 0; i < island.velocities; ++i)
            v[island.v + i] += impulse * change_[side.first + std::size_t(i)];
    }
}

/// Gives how much the impulse of a row changed.
double Rows::relaxRow(std::size_t i, Coordinates& v) noexcept {
    Row& row = rows_[i];
    const double wanted = row.impulse + (row.target - velocityOf(row, v) - row.compliance * row.impulse) /
                                            (1 / row.yield + row.compliance);
    const double impulse = std::clamp(wanted, row.low, row.high);
    const double more = impulse - row.impulse;
    if (more != 0) push(row, more, v);
    row.impulse = impulse;
    return std::abs(more);
}

/// Both directions of a contact's friction at once: their impulse stays within the cone's circle.
double Rows::relaxRubs(std::size_t contact, Coordinates& v) noexcept {
    const double most = rows_[contact].friction * rows_[contact].impulse;
    std::array<double, 2> wanted{};
    for (std::size_t k = 0; k < 2; ++k) {
        const Row& rub = rows_[contact + 1 + k];
        wanted[k] = rub.impulse - velocityOf(rub, v) * rub.yield;
    }
    const double length = std::hypot(wanted[0], wanted[1]);
    const double share = length > most ? most / length : 1;
    double changed = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        Row& rub = rows_[contact + 1 + k];
        const double more = share * wanted[k] - rub.impulse;
        if (more != 0) push(rub, more, v);
        rub.impulse += more;
        changed = std::max(changed, std::abs(more));
    }
    return changed;
}

void Rows::relax(Coordinates& v, bool placesOnly) noexcept {
    for (int round = 0; round < kRounds; ++round) {
        double largest = 0, changed = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const Row& row = rows_[i];
            if (row.kind == Kind::Rub || (placesOnly && !row.isPlace())) continue;
            changed = std::max(changed, relaxRow(i, v));
            largest = std::max(largest, std::abs(row.impulse));
            if (row.kind == Kind::Contact) changed = std::max(changed, relaxRubs(i, v));
        }
        if (changed <= kSettled * largest) return;
    }
}

/// m/s or rad/s, below 0 where a place is not let go on.
double Rows::approachOf(const Row& row, const Coordinates& v) const noexcept {
    const double rate = velocityOf(row, v) - row.turning;
    return row.low < 0 ? -std::abs(rate) : rate;
}

/// Who is struck, and how fast it has to be afterwards. Whether that turns anything round.
bool Rows::beginBlow(const Coordinates& v) noexcept {
    bool bounces = false;
    for (std::size_t i = 0; i < count_; ++i) {
        Row& row = rows_[i];
        if (row.kind != Kind::Contact) continue;
        row.struck = approachOf(row, v) < kApproach;
        if (!row.struck) continue;
        row.impulse = rows_[i + 1].impulse = rows_[i + 2].impulse = 0;
        const double rate = velocityOf(row, v);
        // What a resting body gains in a step is no bounce.
        const bool turns = -rate > row.falls && row.bounce > 0;
        row.after = turns ? -row.bounce * rate : row.turning;
        bounces |= turns;
    }
    return bounces;
}

// One blow: every contact that approaches is turned round at once, with as much friction as the blow bears.
// Both ends of a rod that falls flat bounce together, and no order of blows turns it. What each contact is
// struck by goes on to those that it makes approach in the next blow: so a row of balls that touch hands it
// on, as Newton's cradle does. Without friction no blow gives energy: its impulses times the mean of the
// velocities before and after, (1 - e) v / 2, is at most none.
void Rows::strike(Coordinates& v) noexcept {
    // What turned as it rolled does so no more.
    if (beginBlow(v))
        for (std::size_t i = 0; i < count_; ++i)
            if (rows_[i].kind == Kind::Contact) rows_[i].turning = rows_[i].target = 0;
    for (int round = 0; round < kRounds; ++round) {
        double largest = 0, changed = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            Row& row = rows_[i];
            if (!row.struck) continue;
            const double impulse = std::max(0.0, row.impulse + (row.after - velocityOf(row, v)) * row.yield);
            push(row, impulse - row.impulse, v);
            changed = std::max(changed, std::abs(impulse - row.impulse));
            row.impulse = impulse;
            largest = std::max(largest, impulse);
            changed = std::max(changed, relaxRubs(i, v));
        }
        if (changed <= kSettled * largest) break;
    }
}

bool Rows::stopApproaches(Coordinates& v) noexcept {
    bool any = false;
    for (int blow = 0; blow < kBounces; ++blow) {
        std::size_t hardest = count_;
        double fastest = kApproach;
        for (std::size_t i = 0; i < count_; ++i) {
            if (!rows_[i].isPlace()) continue;
            const double rate = approachOf(rows_[i], v);
            if (rate >= fastest) continue;
            fastest = rate;
            hardest = i;
        }
        if (hardest == count_) break;
        any = true;
        const Row& row = rows_[hardest];
        if (blow + 1 == kBounces) {
            for (std::size_t i = 0; i < count_; ++i)
                rows_[i].impulse = 0;
            relax(v, true);
        } else if (row.kind == Kind::Contact) {
            strike(v);
        } else {
            push(row, (row.turning - velocityOf(row, v)) * row.yield, v);
        }
    }
    return any;
}

/// For the next step to begin with.
void Rows::keepForces(double dt) noexcept {
    for (Touching& touching : contacts_.all())
        touching.force.setZero();
    for (std::size_t i = 0; i < count_; ++i) {
        if (rows_[i].kind != Kind::Contact) continue;
        Touching& touching = contacts_.all()[std::size_t(rows_[i].contact)];
        const Vec3& normal = touching.normal;
        touching.force = (rows_[i].impulse * normal + rows_[i + 1].impulse * ways_[i + 1] +
                          rows_[i + 2].impulse * ways_[i + 2]) /
                         dt;
    }
}

void Rows::solve(const Coordinates& v, double dt, Coordinates& along, Coordinates& acceleration) noexcept {
    end_ = v + dt * acceleration;
    for (std::size_t i = 0; i < count_; ++i) // what contacts did in the last step is a good guess
        if (rows_[i].impulse != 0) push(rows_[i], rows_[i].impulse, end_);
    relax(end_, false);
    acceleration = (end_ - v) / dt;
    for (std::size_t i = 0; i < count_; ++i)
        hold(rows_[i], dt, along);
    keepForces(dt);
}

// A torque between two bodies is one on every link that leads to them too, and there what their frames have
// of it adds up to nothing. Held along frames that turn within the step it does not: a thread of 0.1 g, whose
// moment about itself is 1e-10 kg m^2, got 400 rad/s a step of what stayed. So it is held on the bodies.
void Rows::hold(const Row& row, double dt, Coordinates& along) noexcept {
    if (row.link >= 0) {
        const Link& link = mechanism_.links[std::size_t(row.link)];
        along[link.v] += row.sense * row.impulse / dt;
        return;
    }
    for (std::size_t k = 0; k < 2; ++k)
        if (row.links[k] >= 0) held_[std::size_t(row.links[k])] += row.impulse / dt * row.wrenches[k];
    holds_ = true;
}

void Rows::addHeld(Articulation& articulation) const noexcept {
    if (!holds_) return;
    for (std::size_t i = 0; i < held_.size(); ++i) {
        if (held_[i].isZero(0)) continue;
        const Wrench on{linear(held_[i]), articulation.link(int(i)).pose.translation, angular(held_[i])};
        articulation.addForce(Place{}, Place{int(i), Pose{}}, on, 1);
    }
}

void Rows::letGo() noexcept {
    if (!holds_) return;
    holds_ = false;
    for (Vec6& one : held_)
        one.setZero();
}

bool Rows::correction(double dt, Coordinates& shift) noexcept {
    bool any = false;
    for (std::size_t i = 0; i < count_; ++i) {
        const Row& row = rows_[i];
        if (!row.isPlace() || std::abs(row.depth) < 1e-12) continue;
        if (!any) shift.setZero();
        any = true;
        const double back =
            std::clamp(std::min(1.0, kClosing * dt) * row.depth, -kFastestReturn * dt, kFastestReturn * dt);
        push(row, back * row.yield, shift);
    }
    return any;
}

double Rows::forceAlong(int link, double dt) const noexcept {
    double sum = 0;
    for (std::size_t i = 0; i < count_; ++i)
        if (rows_[i].link == link) sum += rows_[i].sense * rows_[i].impulse;
    return sum / dt;
}

} // namespace tactum
