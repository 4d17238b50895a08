#include "core/dynamics/mechanism_build.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "core/base/text.h"
#include "core/dynamics/articulation.h"
#include "core/dynamics/joint_freedom.h"
#include "core/dynamics/mechanism_touchables.h"

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
    for (const std::vector<Vec3>* all : {&joint.path.points, &joint.path.ups})
        for (const Vec3& one : *all)
            if (!one.allFinite())
                return fail("has a path with a value that is not a finite number; correct it");
    for (const JointLimit& limit : joint.limits)
        if (std::isnan(limit.min) || std::isnan(limit.max) || limit.min > limit.max ||
            !(limit.stiffness >= 0) || !(limit.damping >= 0) || limit.axes == 0 || limit.axes > kAllAxes)
            return fail("has a limit whose minimum is above its maximum or whose stiffness is negative; "
                        "correct it");
    for (const JointDrive& drive : joint.drives)
        if (!(drive.stiffness >= 0) || !(drive.damping >= 0) || !(drive.maxForce >= 0) ||
            !std::isfinite(drive.position) || !std::isfinite(drive.velocity) ||
            !(drive.spacing >= 0 && std::isfinite(drive.spacing)) || drive.axis < 0 || drive.axis > 2)
            return fail("has a drive with a negative or endless value; correct it");
    for (const JointFriction& friction : joint.frictions)
        if (!(friction.force >= 0) || friction.axis < 0 || friction.axis > 2)
            return fail("has negative friction; give a force from 0 up");
    return {};
}

bool isTurning(LinkKind kind) {
    return kind == LinkKind::Turn || kind == LinkKind::Ball;
}

/// Grows the trees from the world and from what nothing moves, joint by joint.
class Builder {
public:
    Builder(std::span<const RigidBody> bodies, std::span<const Joint> joints)
        : bodies_(bodies), joints_(joints), children_(bodies.size() + 1), reached_(bodies.size(), false),
          used_(joints.size(), false), stages_(joints.size()), jointsOf_(bodies.size() + 1) {
        made_.bodies.assign(bodies.begin(), bodies.end());
        made_.places.resize(bodies.size());
        for (std::size_t i = 0; i < bodies.size(); ++i)
            numbers_.emplace(bodies[i].id, int(i));
    }

    Result<Mechanism> run();

private:
    struct Branch {
        std::size_t joint;
        int child;
    };
    struct IslandParts {
        std::vector<Branch> branches; ///< on the world
        std::vector<int> roots;
        std::vector<std::size_t> loops; ///< joints
    };
    struct Stage {
        bool angular;
        int axis, link;
        double sense;
    };
    struct Ends {
        int a, b;
    };

    /// -1 for the world.
    int indexOf(BodyId id) const {
        if (id == kWorldBody) return -1;
        const auto found = numbers_.find(id);
        return found == numbers_.end() ? -2 : found->second;
    }
    Pose poseOf(int body) const { return body < 0 ? Pose{} : bodies_[std::size_t(body)].pose; }
    Place placeOf(int body) const { return body < 0 ? Place{} : made_.places[std::size_t(body)]; }
    Place frameOn(int body, const Pose& frame) const {
        const Place place = placeOf(body);
        return {place.link, place.pose * frame};
    }
    bool isReached(int body) const { return body < 0 || reached_[std::size_t(body)]; }
    /// X_ab at the time 0.
    Pose startOf(std::size_t joint) const {
        const Joint& of = joints_[joint];
        return (poseOf(ends_[joint].a) * of.frameA).inverse() * poseOf(ends_[joint].b) * of.frameB;
    }
    /// The body at the other end of a joint, if the joint ends at this one.
    std::optional<int> beyond(std::size_t joint, int body) const {
        if (ends_[joint].a == body) return ends_[joint].b;
        if (ends_[joint].b == body) return ends_[joint].a;
        return std::nullopt;
    }
    const std::vector<std::size_t>& jointsOf(int body) const { return jointsOf_[std::size_t(body + 1)]; }

    void findTrees();
    void reachFrom(int body);
    void plant(int body);
    void grow(int body);
    std::vector<int> findIslands() const;
    void growIsland(const IslandParts& of);
    std::vector<IslandParts> partsOfIslands() const;
    void plantFree(int body);
    int addLink(const LinkStage& stage, int parent, const Pose& base, AxisSet driven);
    Result<void> addPath(std::size_t joint);
    Result<void> checkPaths() const;
    JointFreedom alongPath(std::size_t joint) const;
    int addStages(const JointFreedom& freedom, Place from, AxisSet driven);
    void carry(int body, const Place& place);
    void attach(std::size_t joint, int parent, int child);
    void closeLoop(std::size_t joint);
    void addActions(std::size_t joint);
    Coordinate rateOf(std::size_t joint, bool angular, int axis) const;
    void addDrive(std::size_t joint, const JointDrive& drive);
    Coordinate coordinateOf(std::size_t joint, bool angular, AxisSet axes) const;

    std::span<const RigidBody> bodies_;
    std::span<const Joint> joints_;
    Mechanism made_;
    std::map<BodyId, int> numbers_;
    std::vector<std::vector<Branch>> children_; ///< of the world, and of each body
    std::vector<int> roots_;                    ///< bodies that no joint holds
    std::vector<bool> reached_, used_;          ///< bodies; joints that are links
    std::vector<std::vector<Stage>> stages_;    ///< of each joint, which link is which of its coordinates
    std::vector<Ends> ends_;                    ///< bodies of each joint
    std::vector<int> pathOf_;                   ///< of each joint, or -1
    std::vector<std::vector<std::size_t>> jointsOf_; ///< of the world, and of each body
    std::vector<double> start_;                      ///< q
};

int Builder::addLink(const LinkStage& stage, int parent, const Pose& base, AxisSet driven) {
    Link link;
    link.kind = stage.kind;
    link.axis = stage.axis;
    link.parent = parent;
    link.base = base;
    link.driven = driven;
    link.path = stage.path;
    link.carriesPath = stage.carriesPath;
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
    const bool forward = ends_[number].a == parent && ends_[number].b == child;
    JointFreedom freedom = pathOf_[number] < 0 ? freedomOf(joint, startOf(number)) : alongPath(number);
    if (!forward) freedom = reversed(freedom);
    const Place from = frameOn(parent, forward ? joint.frameA : joint.frameB);
    const RigidBody& body = bodies_[std::size_t(child)];
    const AxisSet driven = isFixed(body) || infiniteAxes(body) == kAllAxes ? kAllAxes : infiniteAxes(body);
    const std::size_t first = made_.links.size();
    const int last = addStages(freedom, from, driven);
    for (std::size_t i = 0; i < freedom.stages.size(); ++i)
        stages_[number].push_back({isTurning(freedom.stages[i].kind), freedom.stages[i].axis, int(first + i),
                                   freedom.stages[i].sense});
    const Pose& frame = forward ? joint.frameB : joint.frameA;
    const Pose below = freedom.after * frame.inverse();
    const bool welded = freedom.stages.empty();
    carry(child, welded ? Place{from.link, from.pose * freedom.before * below} : Place{last, below});
}

Result<void> Builder::addPath(std::size_t number) {
    pathOf_.push_back(-1);
    const Joint& joint = joints_[number];
    if (!joint.path.isThere() || joint.a == joint.b) return {};
    auto curve = PathCurve::through(joint.path);
    if (!curve) return inputError("joint " + inQuotes(joint.name) + ": " + curve.error().text);
    pathOf_.back() = int(made_.paths.size());
    made_.paths.push_back(std::move(*curve));
    return {};
}

/// Links alone ride on paths: there are no multipliers for one that closes a loop.
Result<void> Builder::checkPaths() const {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
        const bool stands = placeOf(ends_[i].a).link < 0 && placeOf(ends_[i].b).link < 0;
        if (pathOf_[i] >= 0 && !used_[i] && !stands)
            return inputError("joint " + inQuotes(joints_[i].name) +
                              ": its path closes a loop; let the body that rides on it hang on nothing else, "
                              "and hang others on that body");
    }
    return {};
}

/// The way alone, from where the curve is nearest at the time 0.
JointFreedom Builder::alongPath(std::size_t number) const {
    LinkStage stage{LinkKind::Path};
    stage.path = pathOf_[number];
    stage.start = made_.paths[std::size_t(stage.path)].nearest(startOf(number));
    return {{}, {stage}, {}};
}

/// From body to body, nearest first, so that a loop is cut where it is farthest from what stands still.
void Builder::reachFrom(int body) {
    std::vector<int> reached{body};
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (const std::size_t i : jointsOf(reached[next])) {
            const int other = *beyond(i, reached[next]);
            if (used_[i] || isReached(other)) continue;
            if (pathOf_[i] < 0 && !isTreeJoint(joints_[i], startOf(i), kAligned)) continue;
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
    std::vector<std::size_t> byMass(bodies_.size());
    std::iota(byMass.begin(), byMass.end(), std::size_t(0));
    std::ranges::stable_sort(byMass,
                             [&](std::size_t x, std::size_t y) { return bodies_[x].mass > bodies_[y].mass; });
    for (const std::size_t i : byMass)
        if (!reached_[i]) plant(int(i));
}

/// Which bodies joints connect without the world; bodies that nothing holds are alone.
std::vector<int> Builder::findIslands() const {
    int islands = 0;
    std::vector<int> of(bodies_.size(), -1);
    for (std::size_t first = 0; first < bodies_.size(); ++first) {
        if (of[first] >= 0) continue;
        std::vector<int> reached{int(first)};
        of[first] = islands;
        for (std::size_t next = 0; next < reached.size(); ++next)
            for (const std::size_t i : jointsOf(reached[next])) {
                const int other = *beyond(i, reached[next]);
                if (other >= 0 && std::exchange(of[std::size_t(other)], islands) < 0)
                    reached.push_back(other);
            }
        ++islands;
    }
    return of;
}

std::vector<Builder::IslandParts> Builder::partsOfIslands() const {
    const std::vector<int> islandOf = findIslands();
    std::vector<IslandParts> parts;
    const auto at = [&](int body) -> IslandParts& {
        const std::size_t island = std::size_t(islandOf[std::size_t(body)]);
        if (parts.size() <= island) parts.resize(island + 1);
        return parts[island];
    };
    for (const Branch& branch : children_[0])
        at(branch.child).branches.push_back(branch);
    for (const int root : roots_)
        at(root).roots.push_back(root);
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (const int body = std::max(ends_[i].a, ends_[i].b); !used_[i] && body >= 0)
            at(body).loops.push_back(i);
    return parts;
}

void Builder::growIsland(const IslandParts& of) {
    Island island;
    island.firstLink = int(made_.links.size());
    island.v = made_.vs;
    island.firstLoop = int(made_.loops.size());
    made_.islands.emplace_back();
    for (const Branch& branch : of.branches) {
        attach(branch.joint, -1, branch.child);
        grow(branch.child);
    }
    for (const int root : of.roots) {
        plantFree(root);
        grow(root);
    }
    for (const std::size_t joint : of.loops)
        closeLoop(joint);
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
    const auto [a, b] = ends_[number];
    if (placeOf(a).link < 0 && placeOf(b).link < 0) return;
    const std::vector<Lock> locks = locksOf(joint, frameOn(a, joint.frameA), frameOn(b, joint.frameB));
    if (!locks.empty()) ++made_.loopJoints;
    made_.loops.insert(made_.loops.end(), locks.begin(), locks.end());
}

Coordinate Builder::coordinateOf(std::size_t number, bool angular, AxisSet axes) const {
    const Joint& joint = joints_[number];
    const std::vector<Stage>& stages = stages_[number];
    Coordinate of = coordinate(angular, axes);
    if (pathOf_[number] >= 0) of.measure = Measure::Way;
    of.a = frameOn(ends_[number].a, joint.frameA);
    of.b = frameOn(ends_[number].b, joint.frameB);
    if (of.measure != Measure::Along && of.measure != Measure::Twist && of.measure != Measure::Way) return of;
    const auto turns = std::ranges::count_if(stages, &Stage::angular);
    for (const Stage& stage : stages)
        if (stage.angular == angular && stage.axis == of.axis &&
            made_.links[std::size_t(stage.link)].kind != LinkKind::Ball && (!angular || turns == 1)) {
            of.link = stage.link;
            of.sense = stage.sense;
        }
    return of;
}

/// Of what acts against a rate, wherever it is.
Coordinate Builder::rateOf(std::size_t number, bool angular, int axis) const {
    Coordinate of = coordinateOf(number, angular, AxisSet(1 << axis));
    if (of.measure == Measure::Twist && of.link < 0) of.measure = Measure::Spin;
    return of;
}

/// Its spring acts on an angle, its damper on the rate: near half a turn about another axis an angle changes
/// as fast as one likes. Where both share a bound they stay one.
void Builder::addDrive(std::size_t number, const JointDrive& drive) {
    if (!(drive.stiffness > 0 || drive.damping > 0)) return;
    const Coordinate angle = coordinateOf(number, drive.angular, AxisSet(1 << drive.axis)),
                     rate = rateOf(number, drive.angular, drive.axis);
    const bool both = drive.stiffness > 0 && drive.damping > 0, apart = angle.measure != rate.measure;
    if (!both || !apart || drive.maxForce < kUnbounded) { // what shares a bound acts along one direction
        made_.springs.push_back({drive.damping > 0 ? rate : angle, drive});
        return;
    }
    JointDrive spring = drive, damper = drive;
    spring.damping = damper.stiffness = damper.spacing = 0;
    made_.springs.push_back({angle, spring});
    made_.springs.push_back({rate, damper});
}

void Builder::addActions(std::size_t number) {
    const Joint& joint = joints_[number];
    const auto [a, b] = ends_[number];
    if (placeOf(a).link < 0 && placeOf(b).link < 0) return;
    const bool rides = pathOf_[number] >= 0;
    const auto isHeld = [rides](bool angular, AxisSet axes) { return rides && (angular || axes != 1); };
    if (rides)
        if (const PathCurve& path = made_.paths[std::size_t(pathOf_[number])]; !path.isClosed())
            made_.limits.push_back({coordinateOf(number, false, 1), 0, path.length()});
    for (const JointLimit& limit : joint.limits) {
        if (isHeld(limit.angular, limit.axes)) continue;
        if (!rides && takesAxes(limit)) continue; // its axes are gone, or locked
        const Coordinate of = coordinateOf(number, limit.angular, limit.axes);
        if (limit.isHard()) {
            made_.limits.push_back({of, limit.min, limit.max});
            continue;
        }
        JointDrive drive;
        drive.angular = limit.angular;
        drive.stiffness = limit.stiffness;
        drive.damping = limit.damping;
        const bool isPoint = limit.max == 0 && (limit.axes & (limit.axes - 1)) != 0;
        if (isPoint && !rides) { // a distance has no direction at 0, and its parts along the axes have
            for (drive.axis = 0; drive.axis < 3; ++drive.axis)
                if (limit.axes >> drive.axis & 1) addDrive(number, drive);
            continue;
        }
        made_.springs.push_back({of, drive, limit.min, limit.max, true});
    }
    for (const JointDrive& drive : joint.drives)
        if (!isHeld(drive.angular, AxisSet(1 << drive.axis))) addDrive(number, drive);
    for (const JointFriction& friction : joint.frictions)
        if (!isHeld(friction.angular, AxisSet(1 << friction.axis)) && friction.force > 0)
            made_.frictions.push_back({rateOf(number, friction.angular, friction.axis), friction.force});
}

Result<Mechanism> Builder::run() {
    for (const RigidBody& body : bodies_)
        if (auto fine = check(body); !fine) return tl::unexpected(fine.error());
    for (const Joint& joint : joints_) {
        if (auto fine = check(joint); !fine) return tl::unexpected(fine.error());
        ends_.push_back({indexOf(joint.a), indexOf(joint.b)});
        if (ends_.back().a == -2 || ends_.back().b == -2)
            return inputError("joint " + inQuotes(joint.name) +
                              ": names a body that is not there; choose one");
        if (const auto added = addPath(ends_.size() - 1); !added) return tl::unexpected(added.error());
    }
    for (const bool rides : {true, false}) // what rides on a path hangs on nothing else
        for (std::size_t i = 0; i < joints_.size(); ++i)
            if (joints_[i].a != joints_[i].b && rides == (pathOf_[i] >= 0))
                for (const int body : {ends_[i].a, ends_[i].b})
                    jointsOf_[std::size_t(body + 1)].push_back(i);
    for (std::size_t i = 0; i < joints_.size(); ++i)
        used_[i] = joints_[i].a == joints_[i].b;
    findTrees();
    for (const IslandParts& parts : partsOfIslands())
        growIsland(parts);
    if (const auto fine = checkPaths(); !fine) return tl::unexpected(fine.error());
    std::erase_if(made_.islands, [](const Island& one) { return one.velocities == 0; }); // all of it stands
    for (std::size_t i = 0; i < made_.islands.size(); ++i)
        for (int link = made_.islands[i].firstLink; link < made_.islands[i].endLink; ++link)
            made_.links[std::size_t(link)].island = int(i);
    for (std::size_t i = 0; i < joints_.size(); ++i)
        if (joints_[i].a != joints_[i].b) addActions(i);
    made_.q0 = Eigen::Map<const Eigen::VectorXd>(start_.data(), Eigen::Index(start_.size()));
    made_.v0 = Eigen::VectorXd::Zero(made_.vs);
    return std::move(made_);
}

} // namespace

Result<Mechanism> compileMechanism(std::span<const RigidBody> bodies, std::span<const Joint> joints,
                                   std::span<const Collider> colliders, double airDensity) {
    auto made = Builder(bodies, joints).run();
    if (!made) return made;
    made->air = airBoxesOf(bodies, made->places, colliders, airDensity);
    if (const auto added = addTouchables(*made, joints, colliders); !added)
        return tl::unexpected(added.error());
    startVelocities(*made);
    return made;
}

} // namespace tactum
