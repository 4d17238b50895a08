#include "core/study/stimulus.h"

#include <algorithm>

#include "core/base/text.h"

namespace tactum {

namespace {

bool sameSoup(const std::shared_ptr<const TriangleSoup>& a, const std::shared_ptr<const TriangleSoup>& b) {
    return a == b || (a && b && haveSameShape(*a, *b));
}

bool samePlace(const SceneObject& a, const SceneObject& b) {
    return a.visible == b.visible && a.pose == b.pose && sameSoup(a.geometry, b.geometry) &&
           std::ranges::equal(a.surfaces, b.surfaces, [](const Surface& x, const Surface& y) {
               return x.visible == y.visible && x.sides == y.sides;
           });
}

} // namespace

Scene sceneOf(const Scene& condition, const StaircaseRule& rule, const Stimulus& stimulus) {
    Scene scene = condition;
    if (const auto value = valueOf(rule); value && stimulus.value)
        value->set(scene, placeOf(rule), *stimulus.value);
    return scene;
}

Result<void> checkStaircase(const Scene& condition, const StaircaseRule& rule) {
    const auto value = valueOf(rule);
    if (value && value->in(condition, placeOf(rule))) return {};
    std::string where;
    if (!rule.surface.empty()) where += " of a surface " + inQuotes(rule.surface);
    if (!rule.object.empty()) where += " of an object " + inQuotes(rule.object);
    return inputError("staircase.parameter: the first condition has no " + inQuotes(rule.parameter) + where +
                      "; choose another, or keep a state that has it");
}

bool sameShapes(const Scene& a, const Scene& b) {
    return a.proxyRadius == b.proxyRadius && a.reach == b.reach && a.mechanics == b.mechanics &&
           std::ranges::equal(a.objects, b.objects, samePlace);
}

} // namespace tactum
