// One number of a scene by its name: what a study bends names it so in its file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace tactum {

/// Objects and surfaces of a scene, by their names; empty: all of them.
struct NamedPlace {
    std::string_view object, surface;
};

/// A row of the parameter tables and where it stands. Its path is the parameter's key, behind the member that
/// it is inside of:
///
///   stiffness, crease-angle ...                  of surfaces
///   layers[0].height, layers[0].mask.size ...    of their layers, from 0, which is the lowest
///   body-mass, joints[0].hinge-friction ...      of objects that move by forces; joints of theirs, from 0
///   proxy-radius, shell-radius, air-density ...  of the scene
///
/// A layer has a height, in m, or, where it changes anything else, a ratio. Thread: any but real time.
class SceneValue {
public:
    enum class Owner : std::uint8_t { Surface, Object, Scene };
    enum class Inside : std::uint8_t { Itself, Layer, Mask, Joint };

    /// Nothing where no table has it.
    static std::optional<SceneValue> named(std::string_view path);

    std::string path() const;
    const Parameter& parameter() const { return *parameter_; }
    Owner owner() const { return owner_; }
    Inside inside() const { return inside_; }
    std::size_t index() const { return index_; } ///< of the layer or joint

    /// What it is at the first of the places that have it; nothing where none has.
    std::optional<double> in(const Scene& scene, const NamedPlace& place) const;
    /// Sets it at all of them as a person does: inside its range, and what hangs on it follows. Returns their
    /// number.
    std::size_t set(Scene& scene, const NamedPlace& place, double value) const;

    bool operator==(const SceneValue&) const = default;

private:
    friend std::vector<SceneValue> valuesIn(const Scene& scene);
    SceneValue(const Parameter& parameter, Owner owner, Inside inside, std::size_t index)
        : parameter_(&parameter), owner_(owner), inside_(inside), index_(index) {}

    const Parameter* parameter_;
    Owner owner_;
    Inside inside_;
    std::size_t index_;
};

/// What there is to set in a scene and makes a difference there, in the order in which a person reads it. The
/// values of a material are always among them.
std::vector<SceneValue> valuesIn(const Scene& scene);

} // namespace tactum
