// What of a scene a file format keeps, degrades or loses: for the person who hands it on.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace tactum {

/// Where a scene can go.
enum class ExportTarget : std::uint8_t { Glb, X3d, Mpeg, KhrPhysics, Obj, Ply, Stl, Off };

/// A key for files and a label for the person, in the order of the enumerators.
inline constexpr std::array<NamedChoice, 8> kExportTargets{
    {{"glb", "Tactum .glb"},
     {"x3d", "X3D for H3D"},
     {"mpeg", "MPEG_haptic_material in glTF"},
     {"khr-physics", "KHR_physics_rigid_bodies in glTF"},
     {"obj", "OBJ with MTL"},
     {"ply", "PLY"},
     {"stl", "STL"},
     {"off", "OFF"}}};

enum class LossKind : std::uint8_t { Kept, Degraded, Lost };
inline constexpr std::array<std::string_view, 3> kLossKinds{"kept", "degraded", "lost"};

/// One thing that an object of this scene has, and what becomes of it.
struct Loss {
    ExportTarget target = ExportTarget::Glb;
    std::string object; ///< its name; of a surface "object / surface"; empty for the scene
    std::string what;   ///< "viscosity"
    LossKind kind = LossKind::Kept;
    std::string sentence; ///< why, or how; empty where it is kept as it is

    bool operator==(const Loss&) const = default;
};

/// One line: "lost: lid: damping: the format knows shapes, not how they feel".
std::string lineOf(const Loss& loss);

/// By the one table of loss_table.h, for everything that this scene has; in the order of the scene.
std::vector<Loss> lossesOf(const Scene& scene, ExportTarget target);
/// For every target.
std::vector<Loss> lossesOf(const Scene& scene);

/// For people, as Markdown: a chapter for each target that occurs; what is lost first, and objects of which
/// the same is said on one line. Names cannot break the text.
std::string reportMarkdown(const std::vector<Loss>& losses);
/// For programs: an array of objects with the members of Loss.
std::string reportJson(const std::vector<Loss>& losses);

} // namespace tactum
