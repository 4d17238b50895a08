// Everything that may be the matter with a scene, where it is, and which repair is at hand.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/mesh_problems.h"
#include "core/geometry/repair.h"
#include "core/scene/findings.h"
#include "core/scene/scene.h"

namespace tactum {

/// A repair of one mesh, but for the last: that one scales the whole scene.
enum class Repair { None, FillHoles, AgreeOnFronts, RemoveDuplicates, RepairSlivers, Scale };

/// A finding with all that helps to see it and to repair it.
struct PlacedFinding {
    Finding finding;
    ObjectId object = 0;            ///< 0: about the scene, or a value
    std::optional<Problem> problem; ///< its place, in the frame of the object's body
    Repair repair = Repair::None;
    double factor = 1; ///< of the repair Scale
};

/// What was found in one mesh, kept so that it need not be looked for again.
struct KnownMesh {
    std::shared_ptr<const TriangleSoup> soup;
    double proxyRadius = 0; ///< m
    std::vector<Sides> sides;
    std::vector<Problem> problems;
    MeshHealth health;
};

struct Examined {
    std::vector<PlacedFinding> findings;
    std::vector<KnownMesh> meshes; ///< for the next time
};

/// What validate() says, with places where a finding is about a mesh; then what takes a look inside: closed
/// parts that are inside out, parts out of reach. A mesh that is among `known` as it is now is
/// not looked at again. Some 4 s for a million triangles. Fails only when cancelled. Thread: any but real
/// time; uses all cores.
Result<Examined> examine(const Scene& scene, const std::vector<KnownMesh>& known = {},
                         const Progress& progress = {});

/// Fails only when cancelled. Thread: any but real time.
Result<Repaired> repair(const std::shared_ptr<const TriangleSoup>& soup, Repair repair,
                        const Progress& progress = {});

/// The factor that makes a size fit a hand when the unit was mistaken, and what it was taken for.
struct UnitGuess {
    double factor = 1;
    std::string_view unit; ///< "millimetres"
};
/// Nothing for a diagonal (m) between 5 mm and 2 m, and for one that no usual unit explains.
std::optional<UnitGuess> guessUnit(double diagonal);

} // namespace tactum
