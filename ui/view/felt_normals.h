// The normals that are felt, and how far they are from those that are drawn.
#pragma once

#include <vector>

#include "core/haptics/world.h"
#include "ui/view/felt_mesh.h"

namespace tactum {

/// More would be a fur: of a finer mesh, some of its places, evenly.
inline constexpr std::size_t kMaxNeedles = 4'000;

struct Needle {
    Vec3 at = Vec3::Zero(), normal = Vec3::UnitZ(); ///< body frame; unit length
    double lean = 0;                                ///< rad, from the normal that is drawn there
};

struct NeedleMesh {
    ObjectId object = 0;
    std::vector<float> positions; ///< root and tip of each, body frame
};

struct NormalNeedles {
    std::vector<NeedleMesh> meshes;
    std::size_t count = 0;
    double mostLean = 0;                 ///< rad, of all
    bool shaded = false, facets = false; ///< there are surfaces of this kind
};

/// Of a shaded surface one at each corner where normals differ, of any other one at the middle of each facet:
/// which way round a proxy feels them makes no difference, so they point as those that are drawn. At most
/// `most`. Thread: any but real time.
std::vector<Needle> needlesOf(const WorldBody& body, const CornerNormals& drawn, std::size_t most);

/// `length` in m. Thread: any but real time.
NormalNeedles normalNeedles(const World& world, double length, const Progress& progress = {});

} // namespace tactum
