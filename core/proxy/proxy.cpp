#include "core/proxy/proxy.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "core/surface/friction.h"

namespace tactum {

Triangle Obstacle::triangle(Index index) const {
    const TriangleSoup& soup = *mesh->soup;
    const auto& corner = soup.triangles[index];
    return {soup.positions[corner[0]], soup.positions[corner[1]], soup.positions[corner[2]]};
}

const Material& Obstacle::material(Index triangleIndex) const {
    return materials[mesh->soup->surfaceOf[triangleIndex]];
}

void restart(ProxyState& state, const Vec3& finger_W) noexcept {
    state.position = state.finger = finger_W;
    state.contactCount = 0;
    state.slidingOn = kNoBody;
}

namespace {

// A touch is kept while its gap is within this many skins; what is farther away is found by the sweep.
constexpr double kKeep = 2;
// Motion and change of the constraint planes below these parts of the radius count as rest.
constexpr double kRest = 1e-9;
constexpr double kSamePlane = 1e-12;

// One step: the state it works on and what stays the same during it.
class Step {
public:
    Step(ProxyState& state, std::span<const Obstacle> obstacles, double radius, const Vec3& finger, double dt)
        : state_(state), obstacles_(obstacles), radius_(radius), finger_(finger), timeLeft_(dt),
          fingerVelocity_((finger - state.finger) / dt) {}

    ProxyReport run() noexcept {
        ProxyReport report;
        refreshContacts();
        report.boundHit = true;
        for (rounds_ = 1; rounds_ <= kMaxRounds; ++rounds_) {
            if (!round()) {
                report.boundHit = false;
                break;
            }
        }
        report.rounds = std::min(rounds_, kMaxRounds);
        finish();
        return report;
    }

private:
    std::span<Contact> contacts() { return {state_.contacts.data(), std::size_t(state_.contactCount)}; }

    // Update (2.2), friction (4), move (2.1). False when the proxy has come to rest for this step.
    bool round() noexcept {
        const Vec3 wish = unconstrainedByFriction();
        const double excess = wish.norm();
        if (excess <= kRest * radius_) return false;
        const double slide = frictionAllows(wish, excess);
        if (slide <= 0) return false;
        // Friction that lets go entirely is none; the last rounds take no risks.
        const bool free = slide == excess && rounds_ < kMaxRounds - 2;
        const Vec3 motion = free ? alongCurvature(wish) : Vec3(wish * (slide / excess));
        const bool takesTime = slide < excess && isViscous();
        // A curved step is a guess: where it led onto a flat face it went too far, and the next round says
        // so.
        const bool guessed = free && motion != wish;
        std::uint32_t body = kNoBody;
        const SweepHit hit = sweep(motion, body);
        const double part = std::min(hit.t, 1.0);
        state_.position += part * motion;
        if (part * motion.norm() > kRest * radius_) forgetInactive();
        const bool planesTurned = refreshContacts();
        if (body != kNoBody) return meet(body, hit.triangle, part);
        // Whatever is met from here on in this step has no time left to be slid on against viscosity.
        if (takesTime) timeLeft_ = 0;
        return planesTurned || guessed;
    }

    // The update stage: where the proxy would go if nothing but the planes held it, relative to it.
    Vec3 unconstrainedByFriction() noexcept {
        std::array<ConstraintPlane, kMaxPlanes> planes;
        for (int i = 0; i < state_.contactCount; ++i)
            planes[i] = {state_.contacts[i].normal, -state_.contacts[i].gap};
        const std::span<ConstraintPlane> touched{planes.data(), std::size_t(state_.contactCount)};
        NearestPoint nearest = nearestPoint(finger_ - state_.position, touched);
        if (!nearest.feasible) {
            // Squeezed between surfaces that leave less room than the proxy needs: no plane lets it deeper,
            // and none insists on its full radius, so that it can still slide and leave.
            for (ConstraintPlane& plane : touched)
                plane.offset = std::min(plane.offset, 0.0);
            nearest = nearestPoint(finger_ - state_.position, touched);
        }
        for (int i = 0; i < state_.contactCount; ++i)
            state_.contacts[i].lambda = nearest.lambda[i];
        return nearest.x;
    }

    // The same on curved constraints. Around an edge or a vertex the C-obstacle is a cylinder or a sphere,
    // and going to the foot on its tangent plane again and again only halves the error; with the curvature in
    // the Hessian of the Lagrangian (4), I - sum lambda_i Hess(distance_i), the rounds converge like Newton's
    // method. Where that is not safely positive the proxy is rolling off, and it is only led to roll faster.
    Vec3 alongCurvature(const Vec3& flat) noexcept {
        constexpr double kMostCurved = 0.5;
        Mat3 bend = Mat3::Zero();
        double most = 0;
        for (const Contact& contact : contacts()) {
            bend += contact.lambda * contact.bend * contact.bent;
            most += contact.lambda * contact.bend;
        }
        if (!(most > 0)) return flat;
        bend *= std::min(1.0, kMostCurved / most);
        const Eigen::LLT<Mat3> root(Mat3::Identity() - bend);
        const auto lower = root.matrixL();
        std::array<ConstraintPlane, kMaxPlanes> planes;
        for (int i = 0; i < state_.contactCount; ++i) {
            const Vec3 normal = lower.solve(state_.contacts[i].normal);
            const double length = normal.norm();
            planes[i] = {normal / length, -state_.contacts[i].gap / length};
        }
        const NearestPoint nearest = nearestPoint(lower.solve(finger_ - state_.position),
                                                  {planes.data(), std::size_t(state_.contactCount)});
        return nearest.feasible ? Vec3(root.matrixU().solve(nearest.x)) : flat;
    }

    // Sections 4.1 and 4.2: any plane in static contact holds; of the sliding ones the lowest bound wins.
    double frictionAllows(const Vec3& wish, double excess) noexcept {
        if (isHeld(excess)) return 0;
        const double speed = fingerVelocity_.dot(wish) / excess;
        double slide = excess;
        for (Contact& contact : contacts()) {
            if (contact.lambda <= 0) continue;
            contact.slipping = true;
            state_.slidingOn = contact.body;
            const FrictionLimit limit = frictionLimit(materialOf(contact), true);
            slide = std::min(slide, allowedSlide(limit, excess, contact.lambda, speed, timeLeft_));
        }
        return slide;
    }

    bool isHeld(double excess) noexcept {
        bool held = false;
        for (Contact& contact : contacts()) {
            const FrictionLimit limit = frictionLimit(materialOf(contact), contact.slipping);
            if (contact.lambda > 0 && excess <= limit.coefficient * contact.lambda) held = true;
        }
        return held;
    }

    bool isViscous() noexcept {
        return std::ranges::any_of(contacts(), [&](const Contact& contact) {
            return contact.lambda > 0 && materialOf(contact).viscosity > 0;
        });
    }

    // The move stage. Primitives with a plane are left out: a C-obstacle is convex, so the half-space above
    // its plane is free of it.
    SweepHit sweep(const Vec3& motion, std::uint32_t& body) noexcept {
        SweepHit first;
        for (std::uint32_t i = 0; i < obstacles_.size(); ++i) {
            const Obstacle& obstacle = obstacles_[i];
            std::array<Index, kMaxPlanes> touched;
            std::size_t count = 0;
            for (const Contact& contact : contacts())
                if (contact.body == i) touched[count++] = contact.triangle;
            const SpherePath path{obstacle.pose.applyInverse(state_.position),
                                  obstacle.pose.rotateInverse(motion), radius_ * (1 - kSkin)};
            const SweepHit hit = obstacle.mesh->tree.sweep(*obstacle.mesh->soup, path,
                                                           {touched.data(), count}, state_.leafHint);
            if (hit.t < first.t) first = hit, body = i;
        }
        if (body != kNoBody) state_.leafHint = first.leaf;
        return first;
    }

    // Adds the primitive that ended a move. Without room for its plane the step ends here, outside.
    bool meet(std::uint32_t body, Index triangle, double part) noexcept {
        timeLeft_ *= 1 - part;
        if (state_.contactCount == kMaxPlanes) return false;
        Contact contact;
        contact.body = body;
        contact.triangle = triangle;
        contact.slipping = state_.slidingOn == body;
        locate(contact);
        state_.contacts[state_.contactCount++] = contact;
        return true;
    }

    // Finds the contact's constraint plane at the proxy's present position.
    void locate(Contact& contact) noexcept {
        const Obstacle& obstacle = obstacles_[contact.body];
        const Vec3 centre = obstacle.pose.applyInverse(state_.position);
        const ClosestPoint closest = closestPoint(obstacle.triangle(contact.triangle), centre);
        const Vec3 away = centre - closest.point;
        const double distance = away.norm();
        contact.point = obstacle.pose.apply(closest.point);
        if (distance > 0) contact.normal = obstacle.pose.rotate(away / distance);
        contact.gap = distance - radius_;
        contact.bend = closest.feature == Feature::Face ? 0 : 1 / std::max(distance, 0.5 * radius_);
        contact.bent = bentDirections(closest, obstacle, contact);
    }

    // The projector onto the directions in which the C-obstacle bends: none over a face, across an edge, all
    // around a vertex.
    static Mat3 bentDirections(const ClosestPoint& closest, const Obstacle& obstacle,
                               const Contact& contact) noexcept {
        if (closest.feature == Feature::Face) return Mat3::Zero();
        Mat3 across = Mat3::Identity() - contact.normal * contact.normal.transpose();
        if (closest.feature == Feature::Vertex) return across;
        const Triangle t = obstacle.triangle(contact.triangle);
        const std::array<Vec3, 3> opposite{t.c - t.b, t.a - t.c, t.b - t.a};
        int off = 0;
        closest.weights.cwiseAbs().minCoeff(&off);
        const Vec3 edge = obstacle.pose.rotate(opposite[off].normalized());
        return across - edge * edge.transpose();
    }

    // Recomputes every plane, drops what is no longer touched; says whether any plane turned or went.
    bool refreshContacts() noexcept {
        bool changed = false;
        int kept = 0;
        for (Contact contact : contacts()) {
            const Vec3 before = contact.normal;
            locate(contact);
            changed = changed || (contact.normal - before).squaredNorm() > kSamePlane * kSamePlane;
            if (contact.gap <= kKeep * kSkin * radius_)
                state_.contacts[kept++] = contact;
            else
                changed = true;
        }
        state_.contactCount = kept;
        return changed;
    }

    // After a real move, planes that did not push are found again by the sweep if they matter.
    void forgetInactive() noexcept {
        const auto kept = std::ranges::remove_if(contacts(), [](const Contact& c) { return c.lambda <= 0; });
        state_.contactCount -= int(kept.size());
    }

    // A contact sticks again when its motion has died out within a step.
    void finish() noexcept {
        const bool still = (state_.position - start_).norm() <= kRest * radius_;
        for (Contact& contact : contacts())
            if (still) contact.slipping = false;
        if (still || state_.contactCount == 0) state_.slidingOn = kNoBody;
        state_.finger = finger_;
    }

    const Material& materialOf(const Contact& contact) const {
        return obstacles_[contact.body].material(contact.triangle);
    }

    ProxyState& state_;
    std::span<const Obstacle> obstacles_;
    double radius_;
    Vec3 finger_;
    double timeLeft_;
    Vec3 fingerVelocity_;
    Vec3 start_ = state_.position;
    int rounds_ = 0;
};

} // namespace

ProxyReport moveAndUpdate(ProxyState& state, std::span<const Obstacle> obstacles, double radius,
                          const Vec3& finger_W, double dt) noexcept {
    return Step(state, obstacles, radius, finger_W, dt).run();
}

} // namespace tactum
