// Scene to World: off the real-time threads, reusing what did not change.
#pragma once

#include <memory>

#include "core/base/result.h"
#include "core/haptics/world.h"
#include "core/scene/scene.h"

namespace tactum {

/// Builds the World of a scene. Geometry whose soup `previous` already holds is shared, not rebuilt, so
/// that a change of a material costs microseconds; so are normals and textures that are asked for as before.
/// Invisible objects and surfaces are left out: what cannot be seen cannot be felt. Materials are clamped to
/// their parameters' ranges, dynamic to static friction. Fails when cancelled.
/// Thread: any but real time.
Result<std::shared_ptr<const World>> compile(const Scene& scene, const World* previous = nullptr,
                                             const Progress& progress = {});

/// Whether compile() takes longer than a frame although all shapes are known: something was painted on a
/// large mesh since `previous`. Thread: any but real time.
bool paintTakesTime(const Scene& scene, const World& previous);

/// The same World with the numbers that one of an earlier run had: for replays. Two of the same run have to
/// have the same shapeRevision exactly when they had it then. Thread: any but real time.
Result<std::shared_ptr<const World>> compileNumbered(const Scene& scene, const WorldNumbers& numbers,
                                                     const World* previous, const Progress& progress = {});
WorldNumbers numbersOf(const World& world);

} // namespace tactum
