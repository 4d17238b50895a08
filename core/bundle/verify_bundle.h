// Whether a bundle is true: what its scene feels like now, beside what its files say.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/scene/scene.h"

namespace tactum {

struct BundleVerdict {
    std::size_t steps = 0;
    double largestForce = 0;              ///< N
    double largestDifference = 0;         ///< N, between the forces of the bundle and those of its scene
    std::vector<std::string> differences; ///< one line each, with the file; empty: the bundle is true
    bool touches = false;                 ///< the finger path meets anything at all
};

/// What is called the same on another kind of processor. Units: N, m.
inline constexpr double kSameForce = 1e-6, kSamePlace = 1e-8;

/// Replays the finger path of a bundle over `scene`, which is that of the bundle as importScene() reads it,
/// and compares finger, proxy and force of every step; the files for H3D are compared with what the scene
/// gives. Errors: what BundleFiles::open() refuses, tables that cannot be read, a scene that cannot be
/// touched. Thread: any but real time.
Result<BundleVerdict> verifyBundle(const std::filesystem::path& file, const Scene& scene,
                                   const Progress& progress = {});

} // namespace tactum
