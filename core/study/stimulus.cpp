#include "core/study/stimulus.h"

#include <algorithm>

namespace tactum {

namespace {

bool isMeant(const Surface& surface, const StaircaseRule& rule) {
    return rule.surface.empty() || surface.name == rule.surface;
}

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
    const MaterialField* field = fieldOf(rule);
    if (!stimulus.value || !field) return scene;
    for (SceneObject& object : scene.objects)
        for (Surface& surface : object.surfaces)
            if (isMeant(surface, rule))
                surface.material = withValue(surface.material, *field, *stimulus.value);
    return scene;
}

bool changesAnything(const Scene& condition, const StaircaseRule& rule) {
    return std::ranges::any_of(condition.objects, [&](const SceneObject& object) {
        return std::ranges::any_of(object.surfaces,
                                   [&](const Surface& surface) { return isMeant(surface, rule); });
    });
}

bool sameShapes(const Scene& a, const Scene& b) {
    return a.proxyRadius == b.proxyRadius && a.mechanics == b.mechanics &&
           std::ranges::equal(a.objects, b.objects, samePlace);
}

} // namespace tactum
