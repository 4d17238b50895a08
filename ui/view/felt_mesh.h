// A textured surface as the touch knows it: fine enough for its layers, with a value at each vertex.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/haptics/world.h"
#include "ui/view/felt_options.h"

namespace tactum {

/// Normals to draw with, three to a triangle; body frame.
using CornerNormals = std::vector<Eigen::Vector3f>;

/// Those of the file, or smooth over edges below the crease angle of the drawing. Seconds for a million
/// triangles; empty when cancelled. Thread: any but real time.
CornerNormals drawnNormalsOf(const TriangleSoup& soup, const Progress& progress = {});

/// What is asked for of a surface.
struct FeltMeshWish {
    std::optional<FeltValue> value;
    double bumps = 0;                    ///< heights are drawn so many times; 0: flat
    std::size_t mostTriangles = 400'000; ///< a mesh that has more is not made finer
};

/// Vertices are not shared between the triangles of the mesh. Body frame, SI.
struct FeltMesh {
    std::vector<float> positions, normals; ///< x, y, z of each vertex; already displaced
    std::vector<float> values;             ///< one of each vertex; empty where none was asked for
    std::vector<int> triangles;            ///< three vertices each
    std::vector<Index> faces;              ///< those of the soup that were cut, in this order,
    int cuts = 1;                          ///< each edge into so many parts
    double low = 0, high = 0;              ///< of the values
    /// Part of the range that is too fine for the triangles and was left out: 0 none, 1 all.
    double lost = 0;
};

/// Calls f(weights of the corners) for each vertex of a triangle whose edges are cut, in the order of the
/// mesh.
template <class F> void eachCut(int cuts, F f) {
    for (int i = 0; i <= cuts; ++i)
        for (int j = 0; j <= cuts - i; ++j)
            f(Vec3(double(cuts - i - j) / cuts, double(i) / cuts, double(j) / cuts));
}

/// The value of a surface where no layer changes it. SI.
double plainValue(const Material& material, FeltValue value);

/// Whether a surface can be felt at all: hidden ones, and those that are only seen, cannot.
inline bool isFelt(const WorldBody& body, Index surface) {
    return surface >= body.sides.size() || body.sides[surface] != Sides::None;
}

/// Its layers; null: it has none.
inline const TextureStack* stackOf(const WorldBody& body, Index surface) {
    return surface < body.textures.size() ? body.textures[surface].get() : nullptr;
}

/// Whether the surface looks different from place to place, for this wish.
bool varies(const WorldBody& body, Index surface, const FeltMeshWish& wish);

/// Cuts each triangle of a surface into so many that the layers can be seen, as far as `mostTriangles` lets
/// it; what is still too fine is left out, as it is of the force. Empty when cancelled. Thread: any
/// but real time.
FeltMesh feltMesh(const WorldBody& body, Index surface, const CornerNormals& drawn, const FeltMeshWish& wish,
                  const Progress& progress = {});

} // namespace tactum
