#include "core/dynamics/contacts.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/dynamics/round/pairs.h"

namespace tactum {

namespace {

/// Of all bodies together: eight for each of as many colliders as there can be.
constexpr std::size_t kMostPlaces = 65536;
/// Places that are nearer than this, m, are looked at whatever the speed.
constexpr double kNear = 1e-4;
/// A place is the same as one of the last step within this, m.
constexpr double kSame = 2e-3;
/// What approaches faster than this, m/s, is stopped before it can roll.
constexpr double kApproaches = 1e-9;
/// What leaves faster than this, m/s, and than it comes back within two steps, does not roll: nothing has to
/// hold it off as it turns.
constexpr double kLeaves = 1e-3;

} // namespace

Contacts::Contacts(const Mechanism& mechanism) : mechanism_(mechanism), poses_(mechanism.touchables.size()) {
    std::size_t corners = 0, faces = 0;
    for (std::size_t i = 0; i < mechanism.touchables.size(); ++i) {
        boxes_.push_back({Vec3::Zero(), Vec3::Zero(), int(i)});
        corners = std::max(corners, mechanism.touchables[i].convex.polytope.points.size());
        faces = std::max(faces, mechanism.touchables[i].convex.polytope.faces.size());
    }
    const std::size_t room = std::min(kMostPlaces, 64 + 16 * mechanism.touchables.size());
    now_.reserve(room), before_.reserve(room);
    scratch_.reserve(corners, faces);
}

void Contacts::box(const Articulation& articulation, double dt, Box& box) const noexcept {
    const Touchable& of = mechanism_.touchables[std::size_t(box.touchable)];
    const Pose& pose = poses_[std::size_t(box.touchable)];
    const Convex& convex = of.convex;
    if (convex.core == Convex::Core::HalfSpace) {
        box.low = Vec3::Constant(-1e300), box.high = Vec3::Constant(1e300);
        return;
    }
    Vec3 half = Vec3::Constant(convex.reach);
    Vec3 middle = pose.translation;
    if (convex.core == Convex::Core::Polytope) {
        const Mat3 turn = pose.rotation.toRotationMatrix();
        half = turn.cwiseAbs() * (0.5 * (convex.high - convex.low));
        middle = pose.apply(0.5 * (convex.high + convex.low));
    }
    const FrameVelocity v = articulation.velocityOf(of.place);
    const Vec3 way = (v.linear.norm() + v.angular.norm() * convex.reach) * dt * Vec3::Ones();
    box.low = middle - half - way - Vec3::Constant(kNear);
    box.high = middle + half + way + Vec3::Constant(kNear);
}

Vec3 Contacts::accelerationAt(const Articulation& articulation, int link, const Vec3& point) const noexcept {
    if (link < 0) return Vec3::Zero();
    const LinkNow& now = articulation.link(link);
    const Vec3 at = point - articulation.originOf(link);
    return velocityAt(now.acceleration, at) + angular(now.velocity).cross(velocityAt(now.velocity, at));
}

void Contacts::touch(const Articulation& articulation, int a, int b, double dt) noexcept {
    const Touchable &first = mechanism_.touchables[std::size_t(a)],
                    &second = mechanism_.touchables[std::size_t(b)];
    const FrameVelocity va = articulation.velocityOf(first.place), vb = articulation.velocityOf(second.place);
    const double turning = (std::isfinite(first.convex.reach) ? va.angular.norm() * first.convex.reach : 0) +
                           (std::isfinite(second.convex.reach) ? vb.angular.norm() * second.convex.reach : 0);
    const double margin = kNear + ((va.linear - vb.linear).norm() + turning) * dt;
    const TouchPoints points = touchPoints(first.convex, poses_[std::size_t(a)], second.convex,
                                           poses_[std::size_t(b)], margin, scratch_);
    int number = 0;
    for (const TouchPoint& at : points.all()) {
        if (now_.size() == now_.capacity()) {
            ++leftOut_;
            continue;
        }
        Touching place{a, b, number++, at, poses_[std::size_t(a)].applyInverse(at.point)};
        place.normal = at.normal, place.onAThen = place.onBThen = at.point;
        const Wrench normal{at.normal, at.point, Vec3::Zero()};
        place.rate = articulation.powerOf(first.place, second.place, normal);
        place.bend = at.normal.dot(accelerationAt(articulation, second.place.link, at.point) -
                                   accelerationAt(articulation, first.place.link, at.point));
        now_.push_back(place);
    }
    lookAhead(articulation, std::span(now_).last(std::size_t(number)), dt);
}

// A ball that rolls on another one leaves the plane that touched both at the beginning of the step. Pushed
// along where they touch in its middle it neither hops nor gains or loses speed.
void Contacts::lookAhead(const Articulation& articulation, std::span<Touching> places,
                         double dt) const noexcept {
    if (places.empty()) return;
    const std::size_t a = std::size_t(places[0].a), b = std::size_t(places[0].b);
    const Touchable &first = mechanism_.touchables[a], &second = mechanism_.touchables[b];
    if (first.convex.form == Convex::Form::Other || second.convex.form == Convex::Form::Other) return;
    const Pose a_W = ahead(poses_[a], articulation.velocityOf(first.place), 0.5 * dt),
               b_W = ahead(poses_[b], articulation.velocityOf(second.place), 0.5 * dt);
    const auto then = touchRound(first.convex, a_W, second.convex, b_W, kUnbounded);
    if (!then || then->size() != places.size()) return;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const TouchPoint& at = (*then)[i];
        Touching& place = places[i];
        const bool rolls = place.rate >= -kApproaches && place.rate <= kLeaves + fallsIn(place, dt);
        if (!rolls || at.normal.dot(place.at.normal) < kTurnsLittle) continue;
        place.normal = at.normal;
        place.onAThen = at.point - a_W.translation + poses_[a].translation;
        place.onBThen = at.point - b_W.translation + poses_[b].translation;
        place.turning = articulation.powerOf({}, second.place, {at.normal, place.onBThen, Vec3::Zero()}) -
                        articulation.powerOf({}, first.place, {at.normal, place.onAThen, Vec3::Zero()}) -
                        place.rate;
    }
}

/// What the places of the last step pushed, for those that are still there. Both are in order.
void Contacts::remember() noexcept {
    const auto pairOf = [](const Touching& one) { return std::pair{one.a, one.b}; };
    auto first = before_.begin();
    for (Touching& place : now_) {
        while (first != before_.end() && pairOf(*first) < pairOf(place))
            ++first;
        for (auto old = first; old != before_.end() && pairOf(*old) == pairOf(place); ++old) {
            if (old->place < 0 || (old->onA - place.onA).squaredNorm() >= kSame * kSame) continue;
            place.force = old->force;
            old->place = -1; // taken
            break;
        }
    }
}

// The order of the boxes is forgotten too: of two with the same x it would decide.
void Contacts::forget() noexcept {
    now_.clear(), before_.clear();
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        boxes_[i].touchable = int(i);
}

void Contacts::find(const Articulation& articulation, double dt) noexcept {
    std::swap(now_, before_);
    now_.clear();
    for (std::size_t i = 0; i < poses_.size(); ++i)
        poses_[i] = articulation.poseOf(mechanism_.touchables[i].place);
    for (Box& each : boxes_)
        box(articulation, dt, each);
    for (std::size_t i = 1; i < boxes_.size(); ++i) { // insertion: they were sorted a step ago
        const Box moved = boxes_[i];
        std::size_t to = i;
        for (; to > 0 && boxes_[to - 1].low.x() > moved.low.x(); --to)
            boxes_[to] = boxes_[to - 1];
        boxes_[to] = moved;
    }
    for (std::size_t i = 0; i < boxes_.size(); ++i)
        for (std::size_t j = i + 1; j < boxes_.size() && boxes_[j].low.x() <= boxes_[i].high.x(); ++j) {
            const Box &p = boxes_[i], &q = boxes_[j];
            if (p.low.y() > q.high.y() || q.low.y() > p.high.y() || p.low.z() > q.high.z() ||
                q.low.z() > p.high.z())
                continue;
            const auto [a, b] = std::minmax(p.touchable, q.touchable);
            if (mechanism_.mayTouch(a, b)) touch(articulation, a, b, dt);
        }
    // The order of the boxes is that of the past: that of the bodies is always the same.
    std::ranges::sort(now_, {}, [](const Touching& one) { return std::tuple{one.a, one.b, one.place}; });
    remember();
}

} // namespace tactum
