// What the view shows of the touch and of how things feel, beyond the model and the finger: plain values.
#pragma once

#include <optional>

namespace tactum {

/// A number of a surface that can be seen as a colour.
enum class FeltValue { Stiffness, Damping, StaticFriction, DynamicFriction, Viscosity, Height };

struct FeltOptions {
    // At the contacts.
    bool normals = true, planes = true;
    bool stylus = false; ///< a pen whose tip is the proxy
    bool loupe = false;  ///< a picture from nearby beside the view's
    bool cone = false;   ///< of friction
    bool trail = false;  ///< of the proxy, the last seconds
    // Of the picture as a whole.
    bool ground = true;     ///< beneath the scene, with its shadow and a grid
    bool boundaries = true; ///< thin lines between surfaces
    bool wireframe = false; ///< the model's triangles as lines
    // Of the whole model.
    bool spheres = false; ///< of the collision hierarchy,
    int sphereLevel = 2;  ///< so deep below its eight coarsest, which are 0
    bool feltNormals = false;
    std::optional<FeltValue> map; ///< drawn instead of the surfaces' own colours
    bool relief = true; ///< height layers in light and shade, on surfaces that show neither map nor bumps
    double bumps = 0;   ///< height layers drawn so many times as high as they are felt; 0: not at all

    bool operator==(const FeltOptions&) const = default;
};

inline constexpr int kDeepestLevel = 12;

} // namespace tactum
