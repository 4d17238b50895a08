// A whole scene made larger, or set upright: for files that have no unit or another axis that points up.
#pragma once

#include <optional>
#include <string_view>

#include "core/scene/scene.h"

namespace tactum {

/// A unit that files are in.
struct LengthUnit {
    std::string_view name;
    double metres;
};
inline constexpr LengthUnit kLengthUnits[] = {{"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"in", 0.0254}};
/// By its name; nothing for another word.
std::optional<double> metresOf(std::string_view unit);

/// What a file means that says neither.
struct FileAxes {
    double unit = 1;  ///< m that one unit is
    bool zUp = false; ///< else y is up

    bool operator==(const FileAxes&) const = default;
};

/// Whether a hand at a desktop device can go around what is so many metres across.
bool fitsHand(double across);
/// Of a file that was read as metres with y up: millimetres where those fit a hand, for metres do not then.
/// Nothing tells which axis is up; y it is.
FileAxes guessAxes(const Scene& asMetres);
/// The axes with which a scene that was read as metres with y up has most nearly the sides of another one;
/// what is given stays. For a model that was exported once more.
FileAxes axesLike(const Scene& asMetres, const Scene& like, std::optional<double> unit = {},
                  std::optional<bool> zUp = {});
/// Takes a scene that was read as metres with y up for what it is. A scene of bodies stays upright.
void placeAs(Scene& asMetres, const FileAxes& axes);

/// Scales every object, what moves, the cameras, and the finger that shows the scene, about a point that
/// becomes the origin.
void scaleScene(Scene& scene, double factor, const Vec3& about);

/// Moves everything by so many metres, world frame.
void moveScene(Scene& scene, const Vec3& way);

/// From z up to y up: x stays, z becomes y. Not for a scene of bodies, which have their own gravity: returns
/// false and leaves it as it is.
bool turnUpright(Scene& scene);

} // namespace tactum
