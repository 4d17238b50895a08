#include "ui/engine/touched.h"

#include <algorithm>

#include <QObject>

#include "core/haptics/touched_place.h"
#include "ui/base/numbers.h"

namespace tactum {

std::optional<SurfaceRef> touchedSurface(const HapticOutput& touch, const World& world) {
    const TouchedPlace most = touchedPlace(touch, world);
    if (most.contacts == 0) return std::nullopt;
    return SurfaceRef{most.object, most.surface};
}

QString nameOfSurface(const Scene& scene, SurfaceRef ref) {
    const auto object = std::ranges::find(scene.objects, ref.object, &SceneObject::id);
    if (object == scene.objects.end() || ref.surface >= object->surfaces.size()) return {};
    const QString surface = QString::fromStdString(object->surfaces[ref.surface].name);
    const QString whole = QString::fromStdString(object->name);
    if (scene.objects.size() == 1 || surface == whole) return surface.isEmpty() ? whole : surface;
    return object->surfaces.size() == 1 ? whole : QStringLiteral("%1: %2").arg(whole, surface);
}

QString feelText(const Scene& scene, SurfaceRef ref) {
    const QString name = nameOfSurface(scene, ref);
    const SceneObject* object = scene.find(ref.object);
    if (!object || ref.surface >= object->surfaces.size()) return {};
    const Surface& surface = object->surfaces[ref.surface];
    if (surface.sides == Sides::None) return QObject::tr("%1: not felt").arg(name);
    const auto value = [&](const Parameter& parameter, double Material::*of) {
        return numberText(surface.material.*of, parameter.unit.empty() ? 2 : parameter.decimals);
    };
    return QObject::tr("%1: %2 N/m, friction %3 / %4")
        .arg(name, value(kStiffness, &Material::stiffness), value(kStaticFriction, &Material::staticFriction),
             value(kDynamicFriction, &Material::dynamicFriction));
}

} // namespace tactum
