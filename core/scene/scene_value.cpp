#include "core/scene/scene_value.h"

#include <algorithm>
#include <charconv>
#include <functional>

#include "core/scene/bodies.h"
#include "core/surface/texture_matters.h"

namespace tactum {
namespace {

using Owner = SceneValue::Owner;
using Inside = SceneValue::Inside;

struct Listed {
    const Parameter* parameter;
    Owner owner;
};

/// What may stand there, in the order in which a person reads it.
std::vector<Listed> listedAt(Inside inside) {
    std::vector<Listed> all;
    const auto addAll = [&all](const auto& fields, Owner owner) {
        for (const auto& field : fields)
            all.push_back({field.parameter, owner});
    };
    switch (inside) {
    case Inside::Itself:
        addAll(kMaterialFields, Owner::Surface);
        all.push_back({&kCreaseAngle, Owner::Surface});
        addAll(kBodyFields, Owner::Object);
        for (const Parameter* parameter : {&kProxyRadius, &kShellRadius})
            all.push_back({parameter, Owner::Scene});
        addAll(kWorldFields, Owner::Scene);
        break;
    case Inside::Layer:
        for (const Parameter* parameter : {&kTextureHeight, &kTextureRatio, &kTextureOpacity})
            all.push_back({parameter, Owner::Surface});
        addAll(kPatternFields, Owner::Surface);
        break;
    case Inside::Mask:
        addAll(kPatternFields, Owner::Surface);
        break;
    case Inside::Joint:
        for (const AxisKind kind : {AxisKind::Hinge, AxisKind::Slider})
            for (const AxisField& field : kAxisFields)
                all.push_back({&field.of(kind), Owner::Object});
        break;
    }
    return all;
}

/// Takes "layers[3]." off the front of a path; nothing where it does not begin so.
std::optional<std::size_t> takeIndex(std::string_view& path, std::string_view list) {
    const std::size_t end = path.find("].");
    if (end == path.npos || !path.starts_with(list) || path.substr(list.size(), 1) != "[") return {};
    const std::string_view digits = path.substr(list.size() + 1, end - list.size() - 1);
    std::size_t index = 0;
    const auto [rest, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (fault != std::errc() || rest != digits.data() + digits.size()) return {};
    path.remove_prefix(end + 2);
    return index;
}

template <class Fields, class Of> auto memberIn(Of& of, const Fields& fields, const Parameter& parameter) {
    const auto found =
        std::ranges::find(fields, &parameter, [](const auto& field) { return field.parameter; });
    return found == fields.end() ? nullptr : &(of.*found->value);
}

double* numberIn(TextureLayer& layer, const Parameter& parameter) {
    if (&parameter == &kTextureOpacity) return &layer.opacity;
    if (&parameter == &kTextureHeight || &parameter == &kTextureRatio)
        return &parameter == &strengthParameter(layer.target) ? &layer.strength : nullptr;
    return memberIn(layer.pattern, kPatternFields, parameter);
}

double* numberIn(Surface& surface, const SceneValue& value) {
    const Parameter& parameter = value.parameter();
    if (value.inside() == Inside::Itself)
        return &parameter == &kCreaseAngle ? &surface.shading.creaseAngle
                                           : memberIn(surface.material, kMaterialFields, parameter);
    if (value.index() >= surface.layers.size()) return nullptr;
    TextureLayer& layer = surface.layers[value.index()];
    if (value.inside() == Inside::Layer) return numberIn(layer, parameter);
    return layer.mask ? memberIn(*layer.mask, kPatternFields, parameter) : nullptr;
}

double* numberOf(Scene& scene, const Parameter& parameter) {
    if (&parameter == &kProxyRadius) return &scene.proxyRadius;
    if (&parameter == &kShellRadius) return &scene.reach.shell;
    return memberIn(scene.mechanics, kWorldFields, parameter);
}

double* numberIn(AxisJoint& joint, const Parameter& parameter) {
    for (const AxisField& field : kAxisFields)
        if (&field.of(joint.kind) == &parameter) return &(joint.*field.value);
    return nullptr;
}

using SetNumber = std::function<void(double)>;
/// Is shown a number and how it is set where it stands.
using Visit = std::function<void(double now, const SetNumber& set)>;

void visitBody(Scene& scene, BodyId id, const SceneValue& value, const Visit& visit) {
    RigidBody* body = findBody(scene, id);
    if (!body) return;
    const Parameter& parameter = value.parameter();
    if (value.inside() == Inside::Itself) {
        double& number = *memberIn(*body, kBodyFields, parameter);
        return visit(number, [&](double to) {
            if (&parameter == &kBodyMass)
                setMass(*body, to); // the moments follow
            else
                number = to;
        });
    }
    std::optional<AxisJoint> joint = axisJointOf(scene, id, value.index());
    double* number = joint ? numberIn(*joint, parameter) : nullptr;
    if (number)
        visit(parameter.clamped(*number), [&](double to) {
            *number = to;
            setAxisJoint(scene, id, *joint, value.index());
        });
}

void visitSurface(Surface& surface, const SceneValue& value, const Visit& visit) {
    double* number = numberIn(surface, value);
    if (!number) return;
    const auto field = std::ranges::find(kMaterialFields, &value.parameter(), &MaterialField::parameter);
    visit(*number, [&](double to) {
        if (field != kMaterialFields.end())
            surface.material = withValue(surface.material, *field, to); // of two frictions the other follows
        else
            *number = to;
    });
}

void visitAll(Scene& scene, const SceneValue& value, const NamedPlace& place, const Visit& visit) {
    if (value.owner() == Owner::Scene) {
        double& number = *numberOf(scene, value.parameter());
        return visit(number, [&number](double to) { number = to; });
    }
    for (SceneObject& object : scene.objects) {
        if (!place.object.empty() && object.name != place.object) continue;
        if (value.owner() == Owner::Object)
            visitBody(scene, object.body, value, visit);
        else
            for (Surface& surface : object.surfaces)
                if (place.surface.empty() || surface.name == place.surface)
                    visitSurface(surface, value, visit);
    }
}

bool matters(const Parameter& parameter, const TexturePattern& pattern) {
    return std::ranges::any_of(kPatternFields, [&](const PatternField& field) {
        return field.parameter == &parameter && tactum::matters(field, pattern);
    });
}

bool matters(const Parameter& parameter, const TextureLayer& layer) {
    if (&parameter == &kTextureOpacity) return true;
    if (&parameter == &strengthParameter(layer.target)) return strengthMatters(layer);
    return matters(parameter, layer.pattern);
}

template <class Is> bool anySurface(const Scene& scene, const Is& is) {
    return std::ranges::any_of(
        scene.objects, [&](const SceneObject& object) { return std::ranges::any_of(object.surfaces, is); });
}

template <class Is> bool anyLayer(const Scene& scene, std::size_t index, const Is& is) {
    return anySurface(scene, [&](const Surface& surface) {
        return index < surface.layers.size() && is(surface.layers[index]);
    });
}

std::size_t layersIn(const Scene& scene) {
    std::size_t most = 0;
    for (const SceneObject& object : scene.objects)
        for (const Surface& surface : object.surfaces)
            most = std::max(most, surface.layers.size());
    return most;
}

std::size_t jointsIn(const Scene& scene) {
    std::size_t most = 0;
    for (const RigidBody& body : scene.mechanics.bodies)
        most = std::max(most, jointsOf(scene, body.id));
    return most;
}

/// Of what stands inside nothing.
bool isThere(const Scene& scene, const Parameter& parameter) {
    const auto isOneOf = [&](const auto& fields) {
        return std::ranges::any_of(fields, [&](const auto& field) { return field.parameter == &parameter; });
    };
    if (&parameter == &kCreaseAngle)
        return anySurface(scene, [](const Surface& surface) { return surface.shading.on; });
    if (&parameter == &kShellRadius) return scene.reach.mode == ReachMode::Rate;
    return !(isOneOf(kBodyFields) || isOneOf(kWorldFields)) || !scene.mechanics.bodies.empty();
}

} // namespace

std::optional<SceneValue> SceneValue::named(std::string_view path) {
    Inside inside = Inside::Itself;
    std::size_t index = 0;
    if (const auto layer = takeIndex(path, "layers")) {
        constexpr std::string_view kMask = "mask.";
        index = *layer;
        inside = path.starts_with(kMask) ? Inside::Mask : Inside::Layer;
        if (inside == Inside::Mask) path.remove_prefix(kMask.size());
    } else if (const auto joint = takeIndex(path, "joints")) {
        index = *joint;
        inside = Inside::Joint;
    }
    for (const Listed& each : listedAt(inside))
        if (each.parameter->key == path) return SceneValue(*each.parameter, each.owner, inside, index);
    return {};
}

std::string SceneValue::path() const {
    const std::string at = "[" + std::to_string(index_) + "].";
    const char* const list = inside_ == Inside::Joint ? "joints" : "layers";
    return (inside_ == Inside::Itself ? "" : list + at) + (inside_ == Inside::Mask ? "mask." : "") +
           std::string(parameter_->key);
}

std::optional<double> SceneValue::in(const Scene& scene, const NamedPlace& place) const {
    Scene copy = scene; // shares what is large
    std::optional<double> first;
    visitAll(copy, *this, place, [&](double now, const SetNumber&) { first = first.value_or(now); });
    return first;
}

std::size_t SceneValue::set(Scene& scene, const NamedPlace& place, double value) const {
    std::size_t places = 0;
    visitAll(scene, *this, place, [&](double, const SetNumber& set) {
        set(parameter_->clamped(value));
        ++places;
    });
    return places;
}

std::vector<SceneValue> valuesIn(const Scene& scene) {
    std::vector<SceneValue> values;
    const auto add = [&](Inside inside, std::size_t index, const auto& uses) {
        for (const Listed& each : listedAt(inside))
            if (uses(*each.parameter)) values.push_back({*each.parameter, each.owner, inside, index});
    };
    add(Inside::Itself, 0, [&](const Parameter& parameter) { return isThere(scene, parameter); });
    for (std::size_t i = 0; i < layersIn(scene); ++i) {
        add(Inside::Layer, i, [&](const Parameter& parameter) {
            return anyLayer(scene, i, [&](const TextureLayer& layer) { return matters(parameter, layer); });
        });
        add(Inside::Mask, i, [&](const Parameter& parameter) {
            return anyLayer(scene, i, [&](const TextureLayer& layer) {
                return layer.mask && matters(parameter, *layer.mask);
            });
        });
    }
    for (std::size_t i = 0; i < jointsIn(scene); ++i)
        add(Inside::Joint, i, [&](const Parameter& parameter) {
            return SceneValue(parameter, Owner::Object, Inside::Joint, i).in(scene, {}).has_value();
        });
    std::ranges::stable_sort(values, {}, &SceneValue::owner);
    return values;
}

} // namespace tactum
