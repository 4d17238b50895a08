// How a surface feels: plain numbers, and the one table that describes them.
#pragma once

#include <array>

#include "core/surface/parameter.h"

namespace tactum {

inline constexpr Parameter kStiffness{
    "stiffness",
    "Stiffness",
    "N/m",
    1,
    10000,
    10,
    800,
    0,
    "Force of the virtual spring for each metre between proxy and finger (equation 24). Values above the "
    "device's ceiling are clamped to it."};
inline constexpr Parameter kDamping{
    "damping",
    "Damping",
    "N s/m",
    0,
    20,
    0.1,
    0,
    2,
    "Force against the speed of the finger into the surface. It never pulls the finger inward."};
inline constexpr Parameter kStaticFriction{
    "static-friction",
    "Static friction",
    "",
    0,
    2,
    0.01,
    0,
    3,
    "Largest ratio of tangential to normal force at which a resting contact holds (section 4.1)."};
inline constexpr Parameter kDynamicFriction{
    "dynamic-friction",
    "Dynamic friction",
    "",
    0,
    2,
    0.01,
    0,
    3,
    "Ratio of tangential to normal force while the contact slides; never above static friction "
    "(section 4.2, equation 21)."};
inline constexpr Parameter kViscosity{
    "viscosity",
    "Viscosity",
    "N s/m",
    0,
    50,
    0.1,
    0,
    2,
    "Additional tangential force for each metre per second of sliding: the b of equation 21."};

/// The feel of one surface. Values outside their parameter's range are found by validation, not here.
struct Material {
    double stiffness = kStiffness.initial;             ///< N/m
    double damping = kDamping.initial;                 ///< N s/m
    double staticFriction = kStaticFriction.initial;   ///< ratio
    double dynamicFriction = kDynamicFriction.initial; ///< ratio, at most staticFriction
    double viscosity = kViscosity.initial;             ///< N s/m

    bool operator==(const Material&) const = default;
};

struct MaterialField {
    const Parameter* parameter;
    double Material::*value;
};

/// Every number of a material, in the order in which a person reads them.
inline constexpr std::array<MaterialField, 5> kMaterialFields{{
    {&kStiffness, &Material::stiffness},
    {&kDamping, &Material::damping},
    {&kStaticFriction, &Material::staticFriction},
    {&kDynamicFriction, &Material::dynamicFriction},
    {&kViscosity, &Material::viscosity},
}};

/// Sets one field as a person does: the value is brought into its range, and of the two friction
/// coefficients the other one follows so that dynamic never exceeds static. Returns the new material.
inline Material withValue(Material material, const MaterialField& field, double value) {
    material.*field.value = field.parameter->clamped(value);
    if (field.parameter == &kStaticFriction)
        material.dynamicFriction = std::min(material.dynamicFriction, material.staticFriction);
    if (field.parameter == &kDynamicFriction)
        material.staticFriction = std::max(material.staticFriction, material.dynamicFriction);
    return material;
}

} // namespace tactum
