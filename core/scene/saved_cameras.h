// Saved cameras: where a person looks from, kept with the scene under a name. Functions on values; the window
// puts each into one step of its history. Thread: any but real time.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/vec.h"
#include "core/scene/kept.h"

namespace tactum {

struct Scene;

/// As glTF has it: looks along -Z of its frame, +Y is up in the picture.
struct SavedCamera {
    std::string name;
    Pose pose;             ///< X_WC; its origin is the eye
    bool parallel = false; ///< without vanishing points
    double angle = 0.5;    ///< from the lower to the upper edge, rad; of one that is not parallel
    double height = 1;     ///< the same, m; of a parallel one
    double ahead = 1;      ///< from the eye to what it turns about, m
    double near = 0;       ///< what is nearer other programs do not draw, m
    double far = 0;        ///< the same of what is farther, m; 0: as it suits `ahead`
    Kept kept;             ///< of its glTF node
    Kept keptCamera;       ///< of its glTF camera

    bool operator==(const SavedCamera&) const = default;
};

/// Of a scene, whatever a file says.
inline constexpr std::size_t kMaxCameras = 256;

/// Something can be seen by it: numbers that are finite, lengths neither next to zero nor beyond 1e6 m, an
/// angle above 0 and below pi, a name.
bool isCamera(const SavedCamera& camera);
/// All of them are, each name is there once, and they are not more than the bound above.
bool areCameras(const std::vector<SavedCamera>& cameras);

/// nullptr for a name that none has.
const SavedCamera* findCamera(const Scene& scene, const std::string& name);
/// In place of the one of its name, else behind the others; nothing where there are as many as there can be.
void putCamera(Scene& scene, SavedCamera camera);
/// Nothing for a name that none has, or where another has the new one.
void renameCamera(Scene& scene, const std::string& from, const std::string& to);
void removeCamera(Scene& scene, const std::string& name);

} // namespace tactum
