#include "core/proxy/felt_planes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/inplace_vector.h"
#include "core/proxy/surface_under.h"
#include "core/surface/friction.h"
#include "core/surface/shaded_normal.h"

namespace tactum {
namespace {

// A foot on the true planes that is below one of them by less than this part of the radius is on it.
constexpr double kOnPlane = 1e-9;
// What the proxy hovers over, by this part of the radius more than over the nearest, is not felt yet.
constexpr double kHovering = 4 * kSkin;
// Two pairs of planes cross where the product of their sines is above this.
constexpr double kCrossing = 1e-4;
constexpr double kFarthest = 2;
// A slide is good whose end wishes no more than this part of it back.
constexpr double kOvershoot = 0.02;
constexpr int kSearches = 8;

// All contacts of a proxy at one place: what is there, what is felt, and the two passes.
class Passes {
public:
    /// `ahead`: at places that the proxy may go to, where faces that it touches count as going on beyond
    /// their edges: what comes next there is not yet known, and seldom an end.
    Passes(const FeltContacts& on, bool ahead) noexcept : on_(on), ahead_(ahead) {}

    const NearestPoint& at(const Vec3& centre) noexcept {
        centre_ = centre;
        for (auto* planes : {&true_, &felt_})
            planes->clear();
        closest_.clear();
        foot_.clear();
        material_.clear();
        owner_.clear();
        double touching = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < on_.contacts.size(); ++i)
            touching = std::max(touching, locate(i));
        for (std::size_t i = 0; i < on_.contacts.size(); ++i)
            if (true_[i].offset >= touching - kHovering * on_.radius) look(i);
        const Vec3 u = on_.finger - centre;
        result_ = {};
        if (isAboveAll(u)) {
            result_.x = u;
            pushing_ = {};
            return result_;
        }
        pushing_ = nearestPoint(u, felt_.all());
        const int alone = theOnlyPlane();
        const bool isKnown = alone >= 0 ? alongTheFeltNormal(u, alone) : alongBothNormals(u);
        if (!isKnown) secondPass(pushing_.x);
        return result_;
    }

    // What dry friction holds back of a wish along the unit vector `way` where the proxy slides: the least of
    // the planes that push, m.
    double held(const Vec3& way) const noexcept {
        InplaceVector<Push, kMaxPlanes> pushes;
        for (std::size_t i = 0; i < on_.contacts.size(); ++i)
            pushes.push({true_[i].normal, result_.lambda[i], feltAlone(i)});
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < pushes.size(); ++i) {
            if (!(pushes[i].lambda > 0)) continue;
            const double coefficient = frictionLimit(material_[i], true).coefficient;
            least = std::min(least, coefficient * depthOnSlope(pushes.all(), i, coefficient, way));
        }
        return std::isfinite(least) ? least : 0;
    }

    void settle(ProxyState& state) const noexcept {
        for (std::size_t i = 0; i < on_.contacts.size(); ++i) {
            on_.contacts[i].lambda = result_.lambda[i];
            if (result_.lambda[i] > 0) on_.contacts[i].material = material_[i];
        }
        state.feltCount = 0;
        for (std::size_t j = 0; j < felt_.size(); ++j)
            if (pushing_.lambda[j] > 0 && state.feltCount < int(state.felt.size())) {
                const Contact& contact = on_.contacts[owner_[j]];
                state.felt[std::size_t(state.feltCount++)] = {felt_[j].normal, contact.body,
                                                              contact.triangle};
            }
    }

private:
    // The true plane of one contact; gives its offset, the greater the nearer.
    double locate(std::size_t i) noexcept {
        const Contact& contact = on_.contacts[i];
        const Obstacle& obstacle = on_.obstacles[contact.body];
        const Pose pose = poseNow(obstacle, on_.movers);
        const Vec3 centre = pose.applyInverse(centre_);
        const Triangle triangle = obstacle.triangle(contact.triangle);
        closest_.push(closestPoint(triangle, centre));
        foot_.push(ahead_ && contact.bend == 0 ? footOnPlane(triangle, centre) : closest_[i]);
        const Vec3 away = centre - foot_[i].point;
        const double distance = away.norm();
        true_.push({distance > 0 ? pose.rotate(away / distance) : contact.normal, on_.radius - distance});
        material_.push(obstacle.material(contact.triangle));
        return true_[i].offset;
    }

    // Its felt planes. They mean something only at the place that is touched; what the proxy hovers over has
    // its true plane in pass 2.
    void look(std::size_t i) noexcept {
        const Contact& contact = on_.contacts[i];
        const Obstacle& obstacle = on_.obstacles[contact.body];
        const SurfaceFeel* feel = feelOf(obstacle, contact.triangle);
        if (!feel) return add(i, true_[i].normal);
        const Pose pose = poseNow(obstacle, on_.movers);
        const Triangle triangle = obstacle.triangle(contact.triangle);
        const ClosestPoint& closest = closest_[i];
        const Vec3 away = pose.rotateInverse(true_[i].normal);
        const Vec3 base =
            feel->normals ? shadedNormal(*feel->normals, contact.triangle, triangle, closest, away) : away;
        if (!feel->texture) return add(i, pose.rotate(base));
        const TextureFeel touch =
            tactum::feel(*feel->texture, texturePointAt(obstacle, contact.triangle, triangle, foot_[i], base),
                         on_.smallestFeature);
        material_[i] = modulated(material_[i], touch);
        FeltSlopes slopes;
        const int count = slopesOf(touch, slopes);
        for (int k = 0; k < count; ++k)
            add(i, pose.rotate(leaningAtMost(bumpedNormal(base, slopes[std::size_t(k)]), away)));
    }

    // Of a contact: the felt normal that pushes, if it is one alone.
    std::optional<Vec3> feltAlone(std::size_t i) const noexcept {
        std::optional<Vec3> found;
        for (std::size_t j = 0; j < felt_.size(); ++j) {
            if (owner_[j] != i || !(pushing_.lambda[j] > 0)) continue;
            if (found) return std::nullopt;
            found = felt_[j].normal;
        }
        return found;
    }

    // A felt plane goes through the proxy's foot on the true one; none asks the proxy to move.
    void add(std::size_t owner, const Vec3& normal) noexcept {
        if (felt_.size() == kMaxPlanes) return;
        const double offset = true_[owner].offset * normal.dot(true_[owner].normal);
        felt_.push({normal, std::min(offset, 0.0)});
        owner_.push(std::uint8_t(owner));
    }

    // A finger that is outside of everything touches nothing, whichever way a plane is felt to lean.
    bool isAboveAll(const Vec3& u) noexcept {
        return std::ranges::all_of(
            true_.all(), [&](const ConstraintPlane& plane) { return plane.normal.dot(u) >= plane.offset; });
    }

    // The felt plane that pushes, if it is one alone.
    int theOnlyPlane() const noexcept {
        if (pushing_.active == 0) return felt_.size() == 1 ? 0 : -1;
        if (pushing_.active > 1) return -1;
        int which = 0;
        while (pushing_.lambda[std::size_t(which)] <= 0)
            ++which;
        return which;
    }

    // Of a single plane the end of all passes is known: from the finger along the felt normal up to the true
    // plane. False where that leads below another plane.
    bool alongTheFeltNormal(const Vec3& u, int j) noexcept {
        const std::size_t i = owner_[std::size_t(j)];
        const Vec3& normal = felt_[std::size_t(j)].normal;
        const double depth = true_[i].offset - true_[i].normal.dot(u);
        if (!(depth > 0)) return false;
        const double length = depth / normal.dot(true_[i].normal);
        const Vec3 x = u + length * normal;
        if (!isFree(x)) return false;
        result_.x = x;
        result_.lambda[i] = depth;
        result_.active = 1;
        pushing_.lambda[std::size_t(j)] = length;
        return true;
    }

    // Of two planes as well: from the finger along both felt normals onto both true planes, or within the one
    // that both are felt for. False where their pushes would not be positive or lead below another plane.
    bool alongBothNormals(const Vec3& u) noexcept {
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

    std::array<std::size_t, 2> bothPlanes() const noexcept {
        std::array<std::size_t, 2> both{};
        int count = 0;
        for (std::size_t j = 0; j < felt_.size() && count < 2; ++j)
            if (pushing_.lambda[j] > 0) both[std::size_t(count++)] = j;
        return both;
    }

    bool isFree(const Vec3& x) noexcept {
        return std::ranges::all_of(true_.all(), [&](const ConstraintPlane& plane) {
            return plane.normal.dot(x) >= plane.offset - kOnPlane * on_.radius;
        });
    }

    void pushAlongTrueNormals() noexcept {
        for (std::size_t j = 0; j < felt_.size(); ++j) {
            const std::size_t i = owner_[j];
            result_.lambda[i] += pushing_.lambda[j] * felt_[j].normal.dot(true_[i].normal);
        }
    }

    // From the sub-goal to the true planes. A multiplier is what pass 1 and pass 2 push along its true normal
    // together: their sum holds the finger.
    void secondPass(const Vec3& subgoal) noexcept {
        pushAlongTrueNormals();
        if (!projectBack(subgoal)) {
            const NearestPoint nearest = nearestReachable(subgoal, true_.all());
            result_.x = nearest.x;
            result_.feasible = nearest.feasible;
            for (std::size_t i = 0; i < on_.contacts.size(); ++i)
                result_.lambda[i] += nearest.lambda[i];
        }
        for (std::size_t i = 0; i < on_.contacts.size(); ++i) {
            result_.lambda[i] = std::max(result_.lambda[i], 0.0);
            result_.active += result_.lambda[i] > 0;
        }
    }

    // A sub-goal above all true planes goes back onto the nearest: the proxy stays on the surface.
    bool projectBack(const Vec3& subgoal) noexcept {
        if (!isAboveAll(subgoal)) return false;
        std::size_t nearest = 0;
        double height = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < on_.contacts.size(); ++i) {
            const double above = true_[i].normal.dot(subgoal) - true_[i].offset;
            if (above < height) height = above, nearest = i;
        }
        result_.x = subgoal - height * true_[nearest].normal;
        result_.lambda[nearest] -= height;
        return true;
    }

    const FeltContacts& on_;
    bool ahead_;
    Vec3 centre_ = Vec3::Zero();
    InplaceVector<ConstraintPlane, kMaxPlanes> true_, felt_;
    InplaceVector<ClosestPoint, kMaxPlanes> closest_,
        foot_; ///< on the triangles, and where they count as going on
    InplaceVector<Material, kMaxPlanes> material_;
    InplaceVector<std::uint8_t, kMaxPlanes> owner_; ///< of each felt plane: its contact
    NearestPoint pushing_;                          ///< of pass 1
    NearestPoint result_;                           ///< of both: the multipliers are the contacts'
};

} // namespace

bool isFelt(std::span<const Obstacle> obstacles, std::span<const Contact> contacts) noexcept {
    return std::ranges::any_of(contacts, [&](const Contact& contact) {
        return feelOf(obstacles[contact.body], contact.triangle) != nullptr;
    });
}

NearestPoint updateFelt(ProxyState& state, const FeltContacts& on) noexcept {
    Passes passes(on, false);
    const NearestPoint result = passes.at(state.position);
    passes.settle(state);
    return result;
}

double feltReach(const ProxyState& state, const FeltContacts& on, const Vec3& drop, const Vec3& slide,
                 double hold, bool mayExtend) noexcept {
    Passes passes(on, true);
    const double atStart = slide.norm();
    const Vec3 way = slide / atStart;
    double heldAtStart = 0;
    if (hold > 0) passes.at(state.position), heldAtStart = passes.held(way);
    const auto wishAfter = [&](double part) {
        const double wish = passes.at(state.position + drop + part * slide).x.dot(way);
        return hold > 0 ? wish - (hold + passes.held(way) - heldAtStart) : wish;
    };
    double low = 0, high = 1, atLow = atStart, atHigh = wishAfter(1);
    // What rubs does not come back from where it went too far: there nobody goes without a look, nor where
    // one sees less friction because the face that is touched ends.
    const auto isOnFace = [](const Contact& contact) { return contact.bend == 0; };
    const bool looks = hold > 0, goesOn = !looks || std::ranges::all_of(on.contacts, isOnFace);
    if (mayExtend && goesOn && atHigh > 0 && atHigh < atLow) {
        const double farther = std::min(atLow / (atLow - atHigh), kFarthest);
        if (!looks) return farther;
        low = 1, atLow = atHigh, high = farther, atHigh = wishAfter(farther);
    }
    if (atHigh >= -kOvershoot * atStart) return high;
    // The Illinois method, and hardly beyond the turning point: where the felt normal jumps, on the edge
    // between two painted triangles, the proxy comes to rest on the side that it came from.
    for (int i = 0; i < kSearches; ++i) {
        const double middle = low + (high - low) * atLow / (atLow - atHigh);
        const double there = wishAfter(middle);
        if (std::abs(there) <= kOvershoot * atStart) return middle;
        if (there > 0) {
            low = middle, atLow = there, atHigh *= 0.5;
        } else {
            high = middle, atHigh = there, atLow *= 0.5;
        }
    }
    return low;
}

} // namespace tactum
