// Which rows there are: what touches, which limits are reached, which springs are too stiff; and when more
// will be.
#include "core/dynamics/rows.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tactum {

namespace {

/// A limit is reached within this, m or rad: what rounding and events leave.
constexpr double kReached = 1e-7;
/// Bodies touch within this, m.
constexpr double kTouching = 1e-5;
/// What slides slower than this, m/s, sticks.
constexpr double kStill = 1e-3;
/// A spring whose k h^2 + d h exceeds this part of the inertia that it moves is not smooth in a step h. Runge
/// and Kutta's method is stable up to 7.8 for springs and 2.8 for dampers.
constexpr double kStiff = 0.5;

double combined(double a, double b, Combine modeA, Combine modeB) noexcept {
    switch (std::min(modeA, modeB)) {
    case Combine::Average:
        return 0.5 * (a + b);
    case Combine::Minimum:
        return std::min(a, b);
    case Combine::Maximum:
        return std::max(a, b);
    case Combine::Multiply:
        return a * b;
    }
    return 0;
}

} // namespace

Rows::Reading Rows::read(const Articulation& articulation, const Coordinate& of,
                         const Coordinates& q) const noexcept {
    const Measured now = measure(of, articulation.poseOf(of.a), articulation.poseOf(of.b));
    Reading reading{now.value, now.along, articulation.powerOf(of.a, of.b, now.along)};
    if (of.link >= 0) reading.value = of.sense * q[mechanism_.links[std::size_t(of.link)].q];
    return reading;
}

/// J and M^-1 J^T of the links of one island; gives J M^-1 J^T.
double Rows::addSide(Side& side, int linkA, int linkB, Articulation& articulation, const Loops& loops,
                     const Wrench& onA, const Wrench& onB, double sense) noexcept {
    side.island = mechanism_.links[std::size_t(std::max(linkA, linkB))].island;
    side.first = numbers_;
    const Island& island = mechanism_.islands[std::size_t(side.island)];
    double* jacobian = jacobian_.data() + side.first;
    double* change = change_.data() + side.first;
    std::fill_n(jacobian, island.velocities, 0.0);
    articulation.addJacobian(linkB, onB, sense, jacobian);
    articulation.addJacobian(linkA, onA, -sense, jacobian);
    articulation.respond(island, jacobian, change);
    loops.project(island, change);
    numbers_ += std::size_t(island.velocities);
    double softness = 0;
    for (int i = 0; i < island.velocities; ++i)
        softness += jacobian[i] * change[i];
    return softness;
}

Rows::Row* Rows::addRow(Kind kind, Articulation& articulation, const Loops& loops, const Place& a,
                        const Place& b, const Wrench& onA, const Wrench& onB, double sense) noexcept {
    const auto islandOf = [&](int link) {
        return link < 0 ? -1 : mechanism_.links[std::size_t(link)].island;
    };
    std::size_t needs = 0;
    for (const int link : {a.link, b.link})
        if (link >= 0) needs += std::size_t(mechanism_.islands[std::size_t(islandOf(link))].velocities);
    if (count_ == rows_.size() || numbers_ + needs > jacobian_.size()) return nullptr;
    Row& row = rows_[count_];
    row = {};
    row.kind = kind;
    const std::size_t before = numbers_;
    double softness = 0;
    if (islandOf(a.link) == islandOf(b.link)) {
        softness = addSide(row.sides[0], a.link, b.link, articulation, loops, onA, onB, sense);
    } else {
        if (a.link >= 0) softness += addSide(row.sides[0], a.link, -1, articulation, loops, onA, onB, sense);
        if (b.link >= 0) softness += addSide(row.sides[1], -1, b.link, articulation, loops, onA, onB, sense);
    }
    const bool moves = softness > 1e-30;
    if (!moves && kind != Kind::Rub) { // of a contact's friction one direction may be held by a joint
        numbers_ = before;
        return nullptr;
    }
    row.yield = moves ? 1 / softness : 0;
    row.links = {a.link, b.link};
    for (const std::size_t k : {0, 1}) {
        if (row.links[k] < 0) continue;
        const Wrench& on = k == 0 ? onA : onB;
        const Vec3 arm = on.point - articulation.link(row.links[k]).pose.translation;
        row.wrenches[k] = (k == 0 ? -sense : sense) * spatial(on.torque + arm.cross(on.force), on.force);
    }
    ++count_;
    return &row;
}

Rows::Row* Rows::addRow(Kind kind, Articulation& articulation, const Loops& loops, const Coordinate& of,
                        const Wrench& along, double sense) noexcept {
    Row* row = addRow(kind, articulation, loops, of.a, of.b, along, along, sense);
    if (row) row->link = of.link, row->sense = sense * of.sense;
    return row;
}

void Rows::gatherContact(int index, Articulation& articulation, const Loops& loops, double dt) noexcept {
    const Touching& touching = contacts_.all()[std::size_t(index)];
    const Touchable &a = mechanism_.touchables[std::size_t(touching.a)],
                    &b = mechanism_.touchables[std::size_t(touching.b)];
    const Vec3& normal = touching.normal;
    const std::size_t first = count_;
    const auto add = [&](Kind kind, const Vec3& way) {
        return addRow(kind, articulation, loops, a.place, b.place, {way, touching.onAThen, Vec3::Zero()},
                      {way, touching.onBThen, Vec3::Zero()}, 1);
    };
    Row* row = add(Kind::Contact, normal);
    if (!row) return;
    row->turning = touching.turning;
    row->target = -touching.turning;
    row->high = kUnbounded;
    row->depth = std::max(0.0, -touching.at.gap);
    row->contact = index;
    row->impulse = dt * std::max(0.0, touching.force.dot(normal));
    row->bounce = combined(a.material.restitution, b.material.restitution, a.material.restitutionCombine,
                           b.material.restitutionCombine);
    row->falls = fallsIn(touching, dt);
    const auto velocityAt = [&](const Place& place, const Vec3& point) {
        return articulation.velocityOf(
            {place.link,
             {Quat::Identity(),
              place.link < 0 ? point : articulation.link(place.link).pose.applyInverse(point)}});
    };
    const Vec3 slide =
        velocityAt(b.place, touching.onBThen).linear - velocityAt(a.place, touching.onAThen).linear;
    const Vec3 across = slide - normal.dot(slide) * normal;
    const bool still = across.norm() < kStill;
    row->friction = still ? combined(a.material.staticFriction, b.material.staticFriction,
                                     a.material.frictionCombine, b.material.frictionCombine)
                          : combined(a.material.dynamicFriction, b.material.dynamicFriction,
                                     a.material.frictionCombine, b.material.frictionCombine);
    const Vec3 way = still ? normal.unitOrthogonal() : Vec3(across.normalized());
    const std::array<Vec3, 2> ways{way, normal.cross(way)};
    for (const Vec3& rub : ways) {
        Row* sideways = add(Kind::Rub, rub);
        if (!sideways) { // never a contact with a part of its friction
            count_ = first;
            return;
        }
        sideways->impulse = dt * touching.force.dot(rub);
        ways_[count_ - 1] = rub;
        sideways->contact = index;
    }
}

void Rows::gatherContacts(Articulation& articulation, const Loops& loops, double dt, bool early) noexcept {
    if (contacts_.empty()) return;
    contacts_.find(articulation, dt);
    for (std::size_t i = 0; i < contacts_.all().size(); ++i) {
        Touching& touching = contacts_.all()[i];
        const bool soon = touching.at.gap + touching.rate * dt < kTouching;
        if (touching.at.gap <= kTouching || (early && soon)) {
            gatherContact(int(i), articulation, loops, dt);
            touching.rate = kUnbounded; // it is no event any more
        }
    }
}

double Rows::firstTouch(double dt) const noexcept {
    double first = dt;
    for (const Touching& touching : contacts_.all()) {
        if (touching.rate == kUnbounded) continue;
        // g + v t + a t^2 / 2 = 0, the earlier root ahead.
        const double g = touching.at.gap, v = touching.rate, a = touching.bend;
        const double under = v * v - 2 * a * g;
        if (under < 0) continue;
        const double root = std::sqrt(under);
        const double t = v < 0 ? 2 * g / (-v + root) : a < 0 ? (-v - root) / a : kUnbounded;
        if (t > 0) first = std::min(first, t);
    }
    return first / dt;
}

// A rope turns as what hangs on it swings. Held along where it points in the middle of a step, and so that
// the way of the whole step along that is none, it neither stretches nor takes or gives energy: what its end
// has along it is turned round from the step's beginning to its end.
Rows::Middle Rows::middleOf(const Articulation& articulation, const Coordinate& of, const Reading& now,
                            double dt) const noexcept {
    if (of.link >= 0) return {now.along};
    const Measured then =
        measure(of, ahead(articulation.poseOf(of.a), articulation.velocityOf(of.a), 0.5 * dt),
                ahead(articulation.poseOf(of.b), articulation.velocityOf(of.b), 0.5 * dt));
    const double turned = now.along.force.dot(then.along.force) + now.along.torque.dot(then.along.torque);
    const double size = now.along.force.squaredNorm() + now.along.torque.squaredNorm();
    if (turned < kTurnsLittle * size) return {now.along};
    // Where it acts the point goes on as well, but is of the body as it is.
    const Wrench along{then.along.force, now.along.point, then.along.torque};
    const Wrench moved{Vec3::Zero(), now.along.point,
                       (then.along.point - now.along.point).cross(along.force)};
    return {along, articulation.powerOf(of.a, of.b, along) - now.rate,
            2 * articulation.powerOf(of.a, of.b, moved) + dt * articulation.driftAlong(of.a, of.b, along)};
}

void Rows::gatherLimits(Articulation& articulation, const Loops& loops, const Coordinates& q,
                        double dt) noexcept {
    for (std::size_t i = 0; i < mechanism_.limits.size(); ++i) {
        const Limit& limit = mechanism_.limits[i];
        const Reading now = read(articulation, limit.of, q);
        gaps_[2 * i] = {now.value - limit.min, now.rate, false};
        gaps_[2 * i + 1] = {limit.max - now.value, -now.rate, false};
        const bool both = limit.min == limit.max;
        std::optional<Middle> middle;
        for (const std::size_t side : {2 * i, 2 * i + 1}) {
            Gap& gap = gaps_[side];
            if (!both && gap.gap > kReached) continue;
            gap.reached = true;
            if (both && side != 2 * i) continue;
            if (!middle) middle = middleOf(articulation, limit.of, now, dt);
            const double sense = side == 2 * i ? 1 : -1;
            Row* row = addRow(Kind::Limit, articulation, loops, limit.of, middle->along, sense);
            if (!row) continue;
            row->turning = sense * middle->turning;
            row->target = -sense * (middle->turning + middle->drift);
            row->low = both ? -kUnbounded : 0;
            row->high = kUnbounded;
            row->depth = both ? -gap.gap : std::max(0.0, -gap.gap);
        }
    }
}

void Rows::gatherSprings(Articulation& articulation, const Loops& loops, const Coordinates& q,
                         double dt) noexcept {
    for (std::size_t i = 0; i < mechanism_.springs.size(); ++i) {
        if (!springIsRow(i)) continue;
        const Spring& spring = mechanism_.springs[i];
        const Reading now = read(articulation, spring.of, q);
        // A limit counts from before it is met: what is light goes far beyond it in one step.
        const bool below = spring.isLimit && now.value - spring.min < spring.max - now.value;
        Row* row = addRow(Kind::Spring, articulation, loops, spring.of, now.along, 1);
        if (!row) continue;
        // F = k (x0 - x) + d (v0 - v) at the end of the step.
        const double scale = spring.drive.acceleration ? row->yield : 1;
        const double k = scale * spring.drive.stiffness, d = scale * spring.drive.damping;
        const double x0 = spring.isLimit ? (below ? spring.min : spring.max) : spring.drive.restAt(now.value);
        row->compliance = 1 / (dt * (dt * k + d));
        row->target = row->compliance * dt * (k * (x0 - now.value) + d * spring.drive.velocity);
        const bool oneSided = spring.isLimit && spring.min < spring.max;
        row->high = oneSided && !below ? 0 : scale * spring.drive.maxForce * dt;
        row->low = oneSided && below ? 0 : -scale * spring.drive.maxForce * dt;
    }
}

void Rows::gather(Articulation& articulation, const Loops& loops, const Coordinates& q, double dt,
                  bool early) noexcept {
    count_ = numbers_ = 0;
    gatherContacts(articulation, loops, dt, early);
    gatherLimits(articulation, loops, q, dt);
    gatherSprings(articulation, loops, q, dt);
    for (const DryFriction& friction : mechanism_.frictions) {
        const Reading now = read(articulation, friction.of, q);
        Row* row = addRow(Kind::DryFriction, articulation, loops, friction.of, now.along, 1);
        if (!row) continue;
        row->high = friction.force * dt;
        row->low = -row->high;
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

bool Rows::springIsRow(std::size_t spring) const noexcept {
    const JointDrive& drive = mechanism_.springs[spring].drive;
    const double softness = drive.acceleration ? 1 : softness_[spring];
    return (drive.stiffness * longest_ + drive.damping) * longest_ * softness > kStiff;
}

double Rows::inertiaOf(Articulation& articulation, const Coordinate& of) noexcept {
    const int link = std::max(of.a.link, of.b.link);
    const Island& island = mechanism_.islands[std::size_t(mechanism_.links[std::size_t(link)].island)];
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
