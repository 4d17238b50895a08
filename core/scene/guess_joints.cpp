// What the form of a body says of how it may move.
#include <algorithm>
#include <array>
#include <utility>

#include "core/scene/bodies.h"

namespace tactum {
namespace {

/// A section is round whose sides differ by less than the one part, and that reaches no farther from its
/// middle than the other part of them; a square one reaches 0.71.
constexpr double kSameSides = 0.02, kRoundReach = 0.53;
/// How far beside a body something is looked for that would be in its way; a part of its side.
constexpr double kBeside = 0.1;
/// Of two as near the longer one: a tenth of a side counts as much as so long a way.
constexpr double kLengthCounts = 0.1;

struct Form {
    const Scene& scene;
    BodyId body;
    const SceneObject& object;
    Bounds box; ///< its own frame

    Vec3 size() const { return box.high - box.low; }

    /// To the nearest thing that does not move with it.
    double away(const Vec3& p_B) const {
        double nearest = kUnbounded;
        for (const Collider& collider : scene.mechanics.colliders) {
            if (collider.body == body) continue;
            const RigidBody* of = findBody(scene, collider.body);
            const Pose pose = (of ? of->pose : Pose{}) * collider.pose;
            nearest =
                std::min(nearest, distanceTo(collider.shape, pose.applyInverse(object.pose.apply(p_B))));
        }
        return nearest;
    }
    bool isRound(int axis) const {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double side = std::max(size()[u], size()[v]);
        if (std::abs(size()[u] - size()[v]) > kSameSides * side) return false;
        double reach = 0;
        for (const auto& corners : object.geometry->triangles)
            for (const Index corner : corners) {
                const Vec3 out = object.geometry->positions[corner] - box.centre();
                reach = std::max(reach, std::hypot(out[u], out[v]));
            }
        return reach <= kRoundReach * side;
    }
    AxisJoint joint(AxisKind kind, int axis, const Vec3& at_B) const {
        AxisJoint made;
        made.kind = kind;
        made.at = object.pose.apply(at_B);
        made.axis = object.pose.rotate(Vec3::Unit(axis));
        made.damping = (kind == AxisKind::Hinge ? kAxisFields[2].hinge : kAxisFields[2].slider)->initial;
        return made;
    }
};

using Guess = std::pair<double, AxisJoint>; ///< the less the likelier

std::vector<Guess> hinges(const Form& form) {
    std::vector<Guess> all;
    for (int axis = 0; axis < 3; ++axis) {
        if (form.isRound(axis))
            all.push_back({-2 * form.size().sum() + form.size()[axis],
                           form.joint(AxisKind::Hinge, axis, form.box.centre())});
        for (int corner = 0; corner < 4; ++corner) {
            Vec3 p = form.box.centre();
            p[(axis + 1) % 3] = (corner & 1 ? form.box.high : form.box.low)[(axis + 1) % 3];
            p[(axis + 2) % 3] = (corner & 2 ? form.box.high : form.box.low)[(axis + 2) % 3];
            const double cost = std::min(form.away(p), 1e3 * form.size().sum());
            all.push_back({cost - kLengthCounts * form.size()[axis], form.joint(AxisKind::Hinge, axis, p)});
        }
    }
    return all;
}

std::vector<Guess> sliders(const Form& form) {
    std::vector<Guess> all;
    for (int axis = 0; axis < 3; ++axis) {
        double room = 0;
        for (const double side : {-1.0, 1.0}) {
            const Vec3 beside =
                form.box.centre() + side * (0.5 + kBeside) * form.size()[axis] * Vec3::Unit(axis);
            room += std::min(form.away(beside), form.size().minCoeff());
        }
        all.push_back({-room - kLengthCounts * form.size()[axis],
                       form.joint(AxisKind::Slider, axis, form.box.centre())});
    }
    return all;
}

/// Straight along where it would slide, three of its lengths.
AxisJoint lineThrough(const AxisJoint& slider, const Form& form) {
    AxisJoint made = slider;
    made.kind = AxisKind::Path;
    for (const double part : {-1.5, 0.0, 1.5})
        made.path.points.push_back(made.at + part * form.size().maxCoeff() * made.axis);
    return made;
}

} // namespace

std::vector<AxisJoint> guessedJoints(const Scene& scene, BodyId body, AxisKind kind) {
    const auto object = std::ranges::find(scene.objects, body, &SceneObject::body);
    AxisJoint bare;
    bare.kind = kind;
    if (object == scene.objects.end() || !object->geometry || object->geometry->triangles.empty())
        return {bare};
    const Form form{scene, body, *object, tactum::boundsOf(*object->geometry)};
    std::vector<Guess> guesses = kind == AxisKind::Hinge ? hinges(form) : sliders(form);
    std::ranges::stable_sort(guesses, {}, &Guess::first);
    std::vector<AxisJoint> all;
    for (Guess& guess : guesses)
        all.push_back(kind == AxisKind::Path ? lineThrough(guess.second, form) : std::move(guess.second));
    return all;
}

AxisJoint guessedJoint(const Scene& scene, BodyId body, AxisKind kind) {
    return guessedJoints(scene, body, kind).front();
}

} // namespace tactum
