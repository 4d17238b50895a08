#include "core/proxy/felt_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace tactum {

namespace {

// A foot on the true planes that is below one of them by less than this part of the radius is on it.
constexpr double kOnPlane = 1e-9;
// What the proxy hovers over, by this part of the radius more than over the nearest, is not felt yet.
constexpr double kHovering = 4 * kSkin;
// In a corner it is, nearer than this part: as far as a sweep foresees.
constexpr double kInACorner = 1e-2;
// Two pairs of planes cross where the product of their sines is above this.
constexpr double kCrossing = 1e-4;
// What is felt of one face goes on over others whose normal has at least this cosine with its own.
constexpr double kHardlyLeans = 0.95;

} // namespace

const NearestPoint& FeltPasses::at(const Vec3& centre, Look where) noexcept {
    centre_ = centre;
    clear();
    double touching = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < on_->contacts.size(); ++i)
        touching = std::max(touching, locate(i, where));
    const Vec3 u = on_->finger - centre;
    result_ = {};
    if (isAboveAll(u)) {
        result_.x = u;
        pushing_ = {};
        return result_;
    }
    for (std::size_t i = 0; i < on_->contacts.size(); ++i)
        if (true_[i].offset >= touching - kHovering * on_->radius) look(i);
    const bool known = endsKnown(u) || (lookIntoCorner(u, touching) && endsKnown(u)) || goesOnOverAnother(u);
    if (!known) secondPass(pushing_.x);
    for (std::size_t i = 0; i < on_->contacts.size(); ++i)
        if (result_.lambda[i] > 0 && !looked_[i].isFelt) rub(i);
    return result_;
}

// The first pass, and whether it says where all of them end.
bool FeltPasses::endsKnown(const Vec3& u) noexcept {
    pushing_ = nearestPoint(u, felt_.all());
    return alongOneNormal(u) || alongBothNormals(u);
}

// In a corner what the proxy is about to touch holds it as well, and is felt. Says whether there is any.
bool FeltPasses::lookIntoCorner(const Vec3& u, double touching) noexcept {
    const NearestPoint plain = nearestPoint(u, true_.all());
    if (plain.active < 2) return false;
    const std::size_t before = felt_.size();
    for (std::size_t i = 0; i < on_->contacts.size(); ++i) {
        const bool isNear = true_[i].offset >= touching - kInACorner * on_->radius;
        if (plain.lambda[i] > 0 && isNear && !looked_[i].isFelt) look(i);
    }
    return felt_.size() > before;
}

void FeltPasses::clear() noexcept {
    true_.clear();
    felt_.clear();
    foot_.clear();
    material_.clear();
    owner_.clear();
    looked_.clear();
}

// Whether the last look was at these contacts, and beyond the edge of no face.
bool FeltPasses::hasLookedAt(std::span<const Contact> contacts) const noexcept {
    return std::ranges::equal(looked_.all(), contacts, [](const Looked& looked, const Contact& contact) {
        return looked.body == contact.body && looked.triangle == contact.triangle && !looked.isBeyond;
    });
}

bool FeltPasses::settleAsLooked(ProxyState& state, const FeltContacts& on) noexcept {
    if (!hasLookedAt(on.contacts)) return false;
    on_ = &on;
    settle(state);
    return true;
}

void FeltPasses::settle(ProxyState& state) const noexcept {
    for (std::size_t i = 0; i < on_->contacts.size(); ++i) {
        on_->contacts[i].lambda = result_.lambda[i];
        if (result_.lambda[i] > 0) on_->contacts[i].material = material_[i];
    }
    state.feltCount = 0;
    for (std::size_t j = 0; j < felt_.size(); ++j)
        if (pushing_.lambda[j] > 0 && state.feltCount < int(state.felt.size())) {
            const Contact& contact = on_->contacts[owner_[j]];
            state.felt[std::size_t(state.feltCount++)] = {felt_[j].normal, contact.body, contact.triangle};
        }
}

// The true plane of one contact; gives its offset, the greater the nearer.
double FeltPasses::locate(std::size_t i, Look where) noexcept {
    const Contact& contact = on_->contacts[i];
    const Obstacle& obstacle = on_->obstacles[contact.body];
    const Pose pose = poseNow(obstacle, on_->movers);
    const Vec3 centre = pose.applyInverse(centre_);
    const Foot foot = footAt(contact, obstacle, centre, where);
    const bool isBeyond = foot.triangle != contact.triangle || foot.point.weights.minCoeff() < 0;
    const Vec3 away = centre - foot.point.point;
    const double distance = away.norm();
    true_.push({distance > 0 ? pose.rotate(away / distance) : contact.normal, on_->radius - distance});
    material_.push(obstacle.material(foot.triangle));
    foot_.push(foot);
    looked_.push({contact.body, contact.triangle, isBeyond, false});
    return true_[i].offset;
}

// Its felt planes. They mean something only at the place that is touched; what the proxy hovers over has
// its true plane in pass 2.
void FeltPasses::look(std::size_t i) noexcept {
    looked_[i].isFelt = true;
    const Obstacle& obstacle = on_->obstacles[on_->contacts[i].body];
    const SurfaceFeel* feel = feelOf(obstacle, foot_[i].triangle);
    if (!feel) return add(i, true_[i].normal);
    const Pose pose = poseNow(obstacle, on_->movers);
    const FeltNormals normals = feltNormals(obstacle, *feel, foot_[i], pose.rotateInverse(true_[i].normal),
                                            finenessOn(pose), material_[i]);
    for (const Vec3& normal : normals.all())
        add(i, pose.rotate(normal));
}

// What is hovered over has no felt plane, but pass 2 may push there: it rubs as its layers say.
void FeltPasses::rub(std::size_t i) noexcept {
    const Obstacle& obstacle = on_->obstacles[on_->contacts[i].body];
    const SurfaceFeel* feel = feelOf(obstacle, foot_[i].triangle);
    if (!feel) return;
    const Pose pose = poseNow(obstacle, on_->movers);
    rubAsFelt(obstacle, *feel, foot_[i], pose.rotateInverse(true_[i].normal), finenessOn(pose), material_[i]);
}

Fineness FeltPasses::finenessOn(const Pose& pose) const noexcept {
    return {on_->smallestFeature, pose.rotateInverse(on_->passing)};
}

// Of a contact: the felt normal that pushes, if it is one alone.
std::optional<Vec3> FeltPasses::feltAlone(std::size_t i) const noexcept {
    std::optional<Vec3> found;
    for (std::size_t j = 0; j < felt_.size(); ++j) {
        if (owner_[j] != i || !(pushing_.lambda[j] > 0)) continue;
        if (found) return std::nullopt;
        found = felt_[j].normal;
    }
    return found;
}

// A felt plane goes through the proxy's foot on the true one; none asks the proxy to move.
void FeltPasses::add(std::size_t owner, const Vec3& normal) noexcept {
    if (felt_.size() == kMaxPlanes) return;
    const double offset = true_[owner].offset * normal.dot(true_[owner].normal);
    felt_.push({normal, std::min(offset, 0.0)});
    owner_.push(std::uint8_t(owner));
}

// A finger that is outside of everything touches nothing, whichever way a plane is felt to lean.
bool FeltPasses::isAboveAll(const Vec3& u) noexcept {
    return std::ranges::all_of(
        true_.all(), [&](const ConstraintPlane& plane) { return plane.normal.dot(u) >= plane.offset; });
}

// Where one felt plane pushes alone. Where faces hardly lean from each other the finger's end is mostly over
// another face than the proxy: there it is that one's plane, with what is felt of it.
bool FeltPasses::alongOneNormal(const Vec3& u) noexcept {
    if (theOnlyPlane() < 0) return false;
    const auto alone = std::size_t(theOnlyPlane());
    if (alongTheFeltNormal(u, alone, owner_[alone])) return true;
    const NearestPoint before = pushing_;
    for (std::size_t j = 0; j < felt_.size(); ++j) {
        if (j == alone) continue;
        pushing_.lambda[alone] = 0;
        if (alongTheFeltNormal(u, j, owner_[j])) return true;
    }
    pushing_ = before;
    return false;
}

// Where what is felt of it is not known yet: with what is felt here.
bool FeltPasses::goesOnOverAnother(const Vec3& u) noexcept {
    if (theOnlyPlane() < 0) return false;
    const auto alone = std::size_t(theOnlyPlane()), owner = std::size_t(owner_[alone]);
    for (std::size_t i = 0; i < true_.size(); ++i)
        if (!looked_[i].isFelt && true_[i].normal.dot(true_[owner].normal) > kHardlyLeans &&
            alongTheFeltNormal(u, alone, i))
            return true;
    return false;
}

// The felt plane that pushes, if it is one alone.
int FeltPasses::theOnlyPlane() const noexcept {
    if (pushing_.active == 0) return felt_.size() == 1 ? 0 : -1;
    if (pushing_.active > 1) return -1;
    int which = 0;
    while (pushing_.lambda[std::size_t(which)] <= 0)
        ++which;
    return which;
}

// Of a single plane the end of all passes is known: from the finger along the felt normal j up to the true
// plane i. False where that leads below another plane.
bool FeltPasses::alongTheFeltNormal(const Vec3& u, std::size_t j, std::size_t i) noexcept {
    const Vec3& normal = felt_[j].normal;
    const double depth = true_[i].offset - true_[i].normal.dot(u), lean = normal.dot(true_[i].normal);
    if (!(depth > 0 && lean > 0)) return false;
    const double length = depth / lean;
    const Vec3 x = u + length * normal;
    if (!isFree(x)) return false;
    result_.x = x;
    result_.lambda[owner_[j]] = length * normal.dot(true_[owner_[j]].normal);
    result_.active = 1;
    pushing_.lambda[j] = length;
    return true;
}

// Of two planes as well: from the finger along both felt normals onto both true planes, or within the one
// that both are felt for. False where their pushes would not be positive or lead below another plane.
bool FeltPasses::alongBothNormals(const Vec3& u) noexcept {
    if (pushing_.active != 2) return false;
    const auto [j, k] = bothPlanes();
    const std::size_t i = owner_[j], l = owner_[k];
    const Vec3 &a = felt_[j].normal, &b = felt_[k].normal;
    const ConstraintPlane& one = true_[i];
    const ConstraintPlane other =
        i == l ? ConstraintPlane{one.normal.cross(a.cross(b)).normalized(), 0} : true_[l];
    const double determinant =
        one.normal.dot(a) * other.normal.dot(b) - one.normal.dot(b) * other.normal.dot(a);
    if (!(std::abs(determinant) > kCrossing)) return false;
    const double depth = one.offset - one.normal.dot(u), deep = other.offset - other.normal.dot(u);
    const double p = (depth * other.normal.dot(b) - deep * one.normal.dot(b)) / determinant,
                 q = (deep * one.normal.dot(a) - depth * other.normal.dot(a)) / determinant;
    if (!(p > 0 && q > 0)) return false;
    const Vec3 x = u + p * a + q * b;
    if (!isFree(x)) return false;
    result_.x = x;
    pushing_.lambda[j] = p;
    pushing_.lambda[k] = q;
    pushAlongTrueNormals();
    result_.active = 1 + (i != l);
    return true;
}

std::array<std::size_t, 2> FeltPasses::bothPlanes() const noexcept {
    std::array<std::size_t, 2> both{};
    int count = 0;
    for (std::size_t j = 0; j < felt_.size() && count < 2; ++j)
        if (pushing_.lambda[j] > 0) both[std::size_t(count++)] = j;
    return both;
}

bool FeltPasses::isFree(const Vec3& x) noexcept {
    return std::ranges::all_of(true_.all(), [&](const ConstraintPlane& plane) {
        return plane.normal.dot(x) >= plane.offset - kOnPlane * on_->radius;
    });
}

void FeltPasses::pushAlongTrueNormals() noexcept {
    for (std::size_t j = 0; j < felt_.size(); ++j) {
        const std::size_t i = owner_[j];
        result_.lambda[i] += pushing_.lambda[j] * felt_[j].normal.dot(true_[i].normal);
    }
}

// From the sub-goal to the true planes. A multiplier is what pass 1 and pass 2 push along its true normal
// together: their sum holds the finger.
void FeltPasses::secondPass(const Vec3& subgoal) noexcept {
    pushAlongTrueNormals();
    if (!projectBack(subgoal)) {
        const NearestPoint nearest = nearestReachable(subgoal, true_.all());
        result_.x = nearest.x;
        result_.feasible = nearest.feasible;
        for (std::size_t i = 0; i < on_->contacts.size(); ++i)
            result_.lambda[i] += nearest.lambda[i];
    }
    for (std::size_t i = 0; i < on_->contacts.size(); ++i) {
        result_.lambda[i] = std::max(result_.lambda[i], 0.0);
        result_.active += result_.lambda[i] > 0;
    }
}

// A sub-goal above all true planes goes back onto the nearest: the proxy stays on the surface.
bool FeltPasses::projectBack(const Vec3& subgoal) noexcept {
    if (!isAboveAll(subgoal)) return false;
    std::size_t nearest = 0;
    double height = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < on_->contacts.size(); ++i) {
        const double above = true_[i].normal.dot(subgoal) - true_[i].offset;
        if (above < height) height = above, nearest = i;
    }
    result_.x = subgoal - height * true_[nearest].normal;
    result_.lambda[nearest] -= height;
    return true;
}

bool isFelt(std::span<const Obstacle> obstacles, std::span<const Contact> contacts) noexcept {
    return std::ranges::any_of(contacts, [&](const Contact& contact) {
        return feelOf(obstacles[contact.body], contact.triangle) != nullptr;
    });
}

NearestPoint updateFelt(ProxyState& state, const FeltContacts& on) noexcept {
    FeltPasses passes;
    return passes.update(state, on);
}

NearestPoint FeltPasses::update(ProxyState& state, const FeltContacts& on) noexcept {
    on_ = &on;
    if (state.position != centre_ || !hasLookedAt(on.contacts)) at(state.position, Look::Here);
    settle(state);
    return result_;
}

} // namespace tactum
