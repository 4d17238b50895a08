#include "tests/support/random_touch.h"

#include "core/haptics/compile.h"
#include "core/haptics/haptic_step.h"
#include "core/port/force_limiter.h"
#include "tests/support/soups.h"

namespace tactum::test {
namespace {

constexpr int kStepsOfOne = 50;
constexpr double kTick = 1e-3;    // s
constexpr double kMaxForce = 3.3; // N, of a common device

/// A place on what is there, a little beside it.
Vec3 somewhere(const Scene& scene, Rng& rng) {
    const SceneObject& object = scene.objects[rng() % scene.objects.size()];
    const auto& places = object.geometry->positions;
    if (places.empty()) return inBox(rng, 0.1);
    const double beside = rng() % 2 ? 0 : 10 * scene.proxyRadius;
    return object.pose.apply(places[rng() % places.size()]) + inBox(rng, beside);
}

std::string faultOf(const HapticOutput& output, ForceLimiter& limiter) {
    if (!output.proxy.allFinite()) return "the proxy is nowhere";
    if (!output.force.allFinite()) return "the force is no number";
    const Vec3 given = limiter(output.force);
    if (!given.allFinite() || given.norm() > kMaxForce * (1 + 1e-12))
        return "the limiter lets too much through";
    for (int i = 0; i < output.contacts; ++i)
        if (!output.contact[std::size_t(i)].point.allFinite()) return "a contact is nowhere";
    return {};
}

} // namespace

std::string faultOfTouch(const Scene& scene, int strokes) {
    const auto world = compile(scene);
    if (!world || scene.objects.empty()) return {};
    Rng rng(2001);
    SimState state;
    ForceLimiter limiter{.maxForce = kMaxForce};
    Vec3 from = somewhere(scene, rng), before = from;
    for (int stroke = 0; stroke < strokes; ++stroke) {
        const Vec3 to = somewhere(scene, rng);
        for (int i = 1; i <= kStepsOfOne; ++i) {
            const Vec3 finger = from + (to - from) * (double(i) / kStepsOfOne);
            const HapticInput input{.finger = finger, .fingerVelocity = (finger - before) / kTick};
            const std::string fault = faultOf(hapticStep(**world, state, input, kTick), limiter);
            if (!fault.empty()) return fault + " at step " + std::to_string(stroke * kStepsOfOne + i);
            before = finger;
        }
        from = to;
    }
    return {};
}

} // namespace tactum::test
