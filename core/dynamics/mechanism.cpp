#include "core/dynamics/mechanism.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/text.h"
#include "core/dynamics/articulation.h"
#include "core/dynamics/joint_freedom.h"

namespace tactum {

namespace {

/// A joint that starts within this of where it is locked is taken as it stands. m and rad.
constexpr double kAligned = 1e-3;

bool isFixed(const RigidBody& body) {
    return body.kinematic || body.mass == 0;
}

AxisSet infiniteAxes(const RigidBody& body) {
    if (body.kinematic) return kAllAxes;
    AxisSet axes = 0;
    for (int i = 0; i < 3; ++i)
        if (body.inertia[i] == 0) axes = AxisSet(axes | 1 << i);
    return axes;
}

Result<void> check(const RigidBody& body) {
    const auto fail = [&](const char* what) {
        return inputError("body " + inQuotes(body.name) + ": " + what);
    };
    const bool finite = body.centre.allFinite() && body.inertia.allFinite() && body.velocity.allFinite() &&
                        body.angularVelocity.allFinite() && std::isfinite(body.mass) &&
                        std::isfinite(body.gravityFactor) && body.pose.translation.allFinite();
    if (!finite) return fail("has a value that is not a finite number; correct it");
    if (body.mass < 0 || body.inertia.minCoeff() < 0)
        return fail("has a negative mass or inertia; give positive ones, or 0 for what nothing moves");
    return {};
}

Result<void> check(const Joint& joint) {
    const auto fail = [&](const char* what) {
        return inputError("joint " + inQuotes(joint.name) + ": " + what);
    };
    for (const JointLimit& limit : joint.limits)
        if (std::isnan(limit.min) || std::isnan(limit.max) || limit.min > limit.max ||
            !(limit.stiffness >= 0) || !(limit.damping >= 0) || limit.axes == 0 || limit.axes > kAllAxes)
            return fail("has a limit whose minimum is above its maximum or whose stiffness is negative; "
                        "correct it");
    for (const JointDrive& drive : joint.drives)
        if (!(drive.stiffness >= 0) || !(drive.damping >= 0) || !(drive.maxForce >= 0) ||
            !std::isfinite(drive.position) || !std::isfinite(drive.velocity) || drive.axis < 0 ||
            drive.axis > 2)
            return fail("has a drive with a negative or endless value; correct it");
    for (const JointFriction& friction : joint.frictions)
        if (!(friction.force >= 0) || friction.axis < 0 || friction.axis > 2)
            return fail("has negative friction; give a force from 0 up");
    return {};
}

/// Grows the trees from the world and from what nothing moves, joint by joint.
class Builder {
public:
    Builder(std::span<const RigidBody> bodies, std::span<const Joint> joints)
        : bodies_(bodies), joints_(joints), children_(bodies.size() + 1), reached_(bodies.size(), false),
          used_(joints.size(), false) {
        made_.bodies.assign(bodies.begin(), bodies.end());
        made_.places.resize(bodies.size());
    }

    Result<Mechanism> run();

private:
    /// -1 for the world.
    int indexOf(BodyId id) const {
        if (id == kWorldBody) return -1;
        const auto found = std::ranges::find(bodies_, id, &RigidBody::id);
        return found == bodies_.end() ? -2 : int(found - bodies_.begin());
    }
    Pose poseOf(int body) const { return body < 0 ? Pose{} : bodies_[std::size_t(body)].pose; }
    Place placeOf(int body) const { return body < 0 ? Place{} : made_.places[std::size_t(body)]; }
    Place frameOn(int body, const Pose& frame) const {
        const Place place = placeOf(body);
        return {place.link, place.pose * frame};
    }
    bool isReached(int body) const { return body < 0 || reached_[std::size_t(body)]; }
    /// X_ab at the time 0.
    Pose startOf(const Joint& joint) const {
        return (poseOf(indexOf(joint.a)) * joint.frameA).inverse() * poseOf(indexOf(joint.b)) * joint.frameB;
    }

    void findTrees();
    void reachFrom(int body);
    void plant(int body);
    void grow(int body);
    std::vector<int> findIslands();
    void growIsland(int number, const std::vector<int>& islandOf);
    void plantFree(int body);
    int addLink(const LinkStage& stage, int parent, const Pose& base, AxisSet driven);
    int addStages(const JointFreedom& freedom, Place from, AxisSet driven);
    void carry(int body, const Place& place);
    void attach(std::size_t joint, int parent, int child);
    void closeLoop(std::size_t joint);
    void addActions(const Joint& joint);
    Coordinate coordinateOf(const Joint& joint, bool angular, AxisSet axes) const;

    std::span<const RigidBody> bodies_;
    std::span<const Joint> joints_;
    Mechanism made_;
    struct Branch {
        std::size_t joint;
        int child;
    };
    std::vector<std::vector<Branch>> children_; ///< of the world, and of each body
    std::vector<int> roots_;                    ///< bodies that no joint holds
    std::vector<bool> reached_, used_;          ///< bodies; joints that are links
    int islands_ = 0;
    struct Stage {
        const Joint* joint;
        bool angular;
        int axis, link;
        double sense;
    };
    std::vector<Stage> stages_; ///< which link is which coordinate of a joint
    std::vector<double> start_; ///< q
};

int Builder::addLink(const LinkStage& stage, int parent, const Pose& base, AxisSet driven) {
    Link link;
    link.kind = stage.kind;
    link.axis = stage.axis;
    link.parent = parent;
    link.base = base;
    link.driven = driven;
    link.q = made_.qs;
    link.v = made_.vs;
    link.island = int(made_.islands.size()) - 1;
    made_.qs += stage.kind == LinkKind::Ball ? 4 : 1;
    made_.vs += link.freedoms();
    if (stage.kind == LinkKind::Ball)
        for (int i = 0; i < 4; ++i)
            start_.push_back(stage.turn.coeffs()[i]);
    else
        start_.push_back(stage.start);
    made_.links.push_back(link);
    return int(made_.links.size()) - 1;
}

int Builder::addStages(const JointFreedom& freedom, Place from, AxisSet driven) {
    int parent = from.link;
    Pose base = from.pose * freedom.before;
    for (const LinkStage& stage : freedom.stages) {
        const AxisSet held = stage.kind == LinkKind::Ball ? driven : AxisSet(driven != 0);
        parent = addLink(stage, parent, base, held);
        base = Pose{};
    }
    return parent;
}

/// A body becomes a part of the link that it is placed on.
void Builder::carry(int index, const Place& place) {
    made_.places[std::size_t(index)] = place;
    if (place.link < 0) return;
    const RigidBody& body = bodies_[std::size_t(index)];
    Link& link = made_.links[std::size_t(place.link)];
    const double mass = body.mass > 0 ? body.mass : 1; // of a body that nothing moves any will do
    Vec3 principal = body.inertia;
    for (int i = 0; i < 3; ++i)
        if (principal[i] == 0) principal[i] = principal.maxCoeff() > 0 ? principal.maxCoeff() : mass;
    const Mat3 axes = (place.pose.rotation * body.inertiaFrame).toRotationMatrix();
    const Vec3 centre = place.pose.apply(body.centre);
    const Mat3 moments = axes * principal.asDiagonal() * axes.transpose();
    const double both = link.mass + mass;
    const Vec3 together = (link.mass * link.centre + mass * centre) / both;
    const auto about = [&](double m, const Vec3& at) {
        const Vec3 arm = at - together;
        return Mat3(m * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose()));
    };
    link.moments = link.moments + about(link.mass, link.centre) + moments + about(mass, centre);
    link.centre = together;
    link.mass = both;
    const double heavy = isFixed(body) ? 0 : mass * body.gravityFactor;
    if (heavy == 0) return;
    // The sum may vanish while its moment does not; then one of its parts counts as it is.
    const double sum = link.heavy + heavy;
    link.heavyCentre =
        std::abs(sum) > 1e-12 * mass ? Vec3((link.heavy * link.heavyCentre + heavy * centre) / sum) : centre;
    link.heavy = sum;
}

void Builder::plantFree(int index) {
    const RigidBody& body = bodies_[std::size_t(index)];
    const Pose inBody{body.inertiaFrame, body.centre}; // the principal frame
    const Pose start = body.pose * inBody;
    JointFreedom freedom = freeMotion(start);
    int parent = -1;
    const AxisSet turns = infiniteAxes(body);
    for (const LinkStage& stage : freedom.stages)
        parent =
            addLink(stage, parent, Pose{}, stage.kind == LinkKind::Ball ? turns : AxisSet(isFixed(body)));
    const Pose nodeInLink{body.inertiaFrame.conjugate(), -(body.inertiaFrame.conjugate() * body.centre)};
    carry(index, {parent, nodeInLink});
}

void Builder::attach(std::size_t number, int parent, int child) {
    const Joint& joint = joints_[number];
    const bool forward = indexOf(joint.a) == parent && indexOf(joint.b) == child;
    JointFreedom freedom = freedomOf(joint, startOf(joint));
    if (!forward) freedom = reversed(freedom);
    const Place from = frameOn(parent, forward ? joint.frameA : joint.frameB);
    const RigidBody& body = bodies_[std::size_t(child)];
    const AxisSet driven = isFixed(body) || infiniteAxes(body) == kAllAxes ? kAllAxes : infiniteAxes(body);
    const std::size_t first = made_.links.size();
    const int last = addStages(freedom, from, driven);
    for (std::size_t i = 0; i < freedom.stages.size(); ++i)
        stages_.push_back({&joint, freedom.stages[i].kind != LinkKind::Slide, freedom.stages[i].axis,
                           int(first + i), freedom.stages[i].sense});
    const Pose& frame = forward ? joint.frameB : joint.frameA;
    const Pose below = freedom.after * frame.inverse();
    const bool welded = freedom.stages.empty();
    carry(child, welded ? Place{from.link, from.pose * freedom.before * below} : Place{last, below});
}

/// From body to body, nearest first, so that a loop is cut where it is farthest from what stands still.
void Builder::reachFrom(int body) {
    std::vector<int> reached{body};
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (std::size_t i = 0; i < joints_.size(); ++i) {
            const int a = indexOf(joints_[i].a), b = indexOf(joints_[i].b);
            if (used_[i] || (a != reached[next] && b != reached[next])) continue;
            const int other = a == reached[next] ? b : a;
            if (isReached(other) || !isTreeJoint(joints_[i], startOf(joints_[i]), kAligned)) continue;
            used_[i] = reached_[std::size_t(other)] = true;
            children_[std::size_t(reached[next] + 1)].push_back({i, other});
            reached.push_back(other);
        }
}

void Builder::plant(int body) {
    reached_[std::size_t(body)] = true;
    roots_.push_back(body);
    reachFrom(body);
}

// What is joined to nothing that stands still hangs on its heaviest body.
void Builder::findTrees() {
    reachFrom(-1);
    for (std::size_t i = 0; i < bodies_.size(); ++i)
        if (isFixed(bodies_[i]) && !reached_[i]) plant(int(i));
    while (true) {
        int heaviest = -1;
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (!reached_[i] && (heaviest < 0 || bodies_[i].mass > bodies_[std::size_t(heaviest)].mass))
                heaviest = int(i);
        if (heaviest < 0) return;
        plant(heaviest);
    }
}

/// Which bodies joints connect without the world; bodies that nothing holds are alone.
std::vector<int> Builder::findIslands() {
    std::vector<int> of(bodies_.size(), -1);
    for (std::size_t first = 0; first < bodies_.size(); ++first) {
        if (of[first] >= 0) continue;
        std::vector<int> reached{int(first)};
        of[first] = islands_;
        for (std::size_t next = 0; next < reached.size(); ++next)
            for (const Joint& joint : joints_) {
                const int a = indexOf(joint.a), b = indexOf(joint.b);
                if (a < 0 || b < 0 || (a != reached[next] && b != reached[next])) continue;
                const int other = a == reached[next] ? b : a;
                if (std::exchange(of[std::size_t(other)], islands_) < 0) reached.push_back(other);
            }
        ++islands_;
    }
    return of;
}

void Builder::growIsland(int number, const std::vector<int>& islandOf) {
    Island island;
    island.firstLink = int(made_.links.size());
    island.v = made_.vs;
    island.firstLoop = int(made_.loops.size());
    made_.islands.emplace_back();
    for (const Branch& branch : children_[0])
        if (islandOf[std::size_t(branch.child)] == number) {
            attach(branch.joint, -1, branch.child);
            grow(branch.child);
        }
    for (const int root : roots_)
        if (islandOf[std::size_t(root)] == number) {
            plantFree(root);
            grow(root);
        }
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const int body = std::max(indexOf(joints_[i].a), indexOf(joints_[i].b));
        if (!used_[i] && body >= 0 && islandOf[std::size_t(body)] == number) closeLoop(i);
    }
    island.endLink = int(made_.links.size());
    island.velocities = made_.vs - island.v;
    island.endLoop = int(made_.loops.size());
    made_.islands.back() = island;
}

// Depth first: parents before children.
void Builder::grow(int body) {
    for (const Branch& branch : children_[std::size_t(body + 1)]) {
        attach(branch.joint, body, branch.child);
        grow(branch.child);
    }
}

void Builder::closeLoop(std::size_t number) {
    const Joint& joint = joints_[number];
    const int a = indexOf(joint.a), b = indexOf(joint.b);
    if (placeOf(a).link < 0 && placeOf(b).link < 0) return;
    const std::vector<Lock> locks = locksOf(joint, frameOn(a, joint.frameA), frameOn(b, joint.frameB));
    if (!locks.empty()) ++made_.loopJoints;
    made_.loops.insert(made_.loops.end(), locks.begin(), locks.end());
}

Coordinate Builder::coordinateOf(const Joint& joint, bool angular, AxisSet axes) const {
    Coordinate of = coordinate(angular, axes);
    of.a = frameOn(indexOf(joint.a), joint.frameA);
    of.b = frameOn(indexOf(joint.b), joint.frameB);
    if (of.measure != Measure::Along && of.measure != Measure::Twist) return of;
    const auto turns = std::ranges::count_if(
        stages_, [&](const Stage& stage) { return stage.joint == &joint && stage.angular; });
    for (const Stage& stage : stages_)
        if (stage.joint == &joint && stage.angular == angular && stage.axis == of.axis &&
            made_.links[std::size_t(stage.link)].kind != LinkKind::Ball && (!angular || turns == 1)) {
            of.link = stage.link;
            of.sense = stage.sense;
        }
    return of;
}

void Builder::addActions(const Joint& joint) {
    const int a = indexOf(joint.a), b = indexOf(joint.b);
    if (placeOf(a).link < 0 && placeOf(b).link < 0) return;
    for (const JointLimit& limit : joint.limits) {
        if (takesAxes(limit)) continue; // its axes are gone, or locked
        const Coordinate of = coordinateOf(joint, limit.angular, limit.axes);
        if (limit.isHard()) {
            made_.limits.push_back({of, limit.min, limit.max});
            continue;
        }
        JointDrive drive;
        drive.stiffness = limit.stiffness;
        drive.damping = limit.damping;
        made_.springs.push_back({of, drive, limit.min, limit.max, true});
    }
    for (const JointDrive& drive : joint.drives)
        if (drive.stiffness > 0 || drive.damping > 0)
            made_.springs.push_back({coordinateOf(joint, drive.angular, AxisSet(1 << drive.axis)), drive});
    for (const JointFriction& friction : joint.frictions)
        if (friction.force > 0)
            made_.frictions.push_back(
                {coordinateOf(joint, friction.angular, AxisSet(1 << friction.axis)), friction.force});
}

Result<Mechanism> Builder::run() {
    for (const RigidBody& body : bodies_)
        if (auto fine = check(body); !fine) return tl::unexpected(fine.error());
    for (const Joint& joint : joints_) {
        if (auto fine = check(joint); !fine) return tl::unexpected(fine.error());
        if (indexOf(joint.a) == -2 || indexOf(joint.b) == -2)
            return inputError("joint " + inQuotes(joint.name) +
                              ": names a body that is not there; choose one");
    }
    for (std::size_t i = 0; i < joints_.size(); ++i)
        used_[i] = joints_[i].a == joints_[i].b;
    findTrees();
    const std::vector<int> islandOf = findIslands();
    for (int island = 0; island < islands_; ++island)
        growIsland(island, islandOf);
    std::erase_if(made_.islands, [](const Island& one) { return one.velocities == 0; }); // all of it stands
    for (std::size_t i = 0; i < made_.islands.size(); ++i)
        for (int link = made_.islands[i].firstLink; link < made_.islands[i].endLink; ++link)
            made_.links[std::size_t(link)].island = int(i);
    for (const Joint& joint : joints_)
        if (joint.a != joint.b) addActions(joint);
    made_.q0 = Eigen::Map<const Eigen::VectorXd>(start_.data(), Eigen::Index(start_.size()));
    made_.v0 = Eigen::VectorXd::Zero(made_.vs);
    return std::move(made_);
}

bool hasAny(const std::vector<std::string>& names, const std::vector<std::string>& among) {
    return std::ranges::any_of(
        names, [&](const std::string& name) { return std::ranges::find(among, name) != among.end(); });
}

/// Whether one filter lets the other's systems come (KHR_physics_rigid_bodies, Collision Filtering).
bool lets(const CollisionFilter& own, const CollisionFilter& other) {
    if (!own.with.empty() && !hasAny(other.systems, own.with)) return false;
    return !hasAny(other.systems, own.notWith);
}

bool areJoined(std::span<const Joint> joints, BodyId a, BodyId b) {
    return std::ranges::any_of(joints, [&](const Joint& joint) {
        return !joint.collide && ((joint.a == a && joint.b == b) || (joint.a == b && joint.b == a));
    });
}

void addTouchables(Mechanism& made, std::span<const Joint> joints, std::span<const Collider> colliders) {
    std::vector<const Collider*> from;
    for (const Collider& collider : colliders) {
        const Place* body = made.placeOf(collider.body);
        Touchable touchable;
        touchable.place = body ? Place{body->link, body->pose * collider.pose} : Place{-1, collider.pose};
        touchable.convex = convexOf(collider.shape);
        touchable.material = collider.material;
        from.push_back(&collider);
        made.touchables.push_back(std::move(touchable));
    }
    const auto isFixedIn = [&](const Touchable& one) {
        if (one.place.link < 0) return true;
        const Link& link = made.links[std::size_t(one.place.link)];
        return link.driven == kAllAxes && link.kind == LinkKind::Ball && link.parent >= 0 &&
               made.links[std::size_t(link.parent)].driven != 0;
    };
    const std::size_t count = from.size();
    made.meets.assign(count * count, false);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j) {
            const Touchable &a = made.touchables[i], &b = made.touchables[j];
            const bool apart = from[i]->body != from[j]->body && a.place.link != b.place.link &&
                               !(isFixedIn(a) && isFixedIn(b));
            made.meets[i * count + j] = apart && !areJoined(joints, from[i]->body, from[j]->body) &&
                                        lets(from[i]->filter, from[j]->filter) &&
                                        lets(from[j]->filter, from[i]->filter);
        }
}

} // namespace

const Place* Mechanism::placeOf(BodyId body) const {
    const auto found = std::ranges::find(bodies, body, &RigidBody::id);
    return found == bodies.end() ? nullptr : &places[std::size_t(found - bodies.begin())];
}

Result<Mechanism> compileMechanism(std::span<const RigidBody> bodies, std::span<const Joint> joints,
                                   std::span<const Collider> colliders) {
    auto made = Builder(bodies, joints).run();
    if (!made) return made;
    addTouchables(*made, joints, colliders);
    startVelocities(*made);
    return made;
}

} // namespace tactum
