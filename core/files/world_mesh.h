// One object of a file whose nodes may scale, shear and mirror: its polygons, taken to the world. For this
// folder only.
#pragma once

#include "core/files/readers.h"
#include "core/geometry/weld.h"

namespace tactum {

/// The box of a scene in words, for a file that has no unit.
Finding unitGuess(const Scene& scene, std::string remedy = "scale it if that is not its size");

/// A small file can name one mesh very often.
inline constexpr std::size_t kMaxTriangles = std::size_t(1) << 26;

class WorldMesh {
public:
    /// `toWorld`: in metres.
    WorldMesh(const Source& source, const Eigen::Affine3d& toWorld);

    /// What comes now is at another place.
    void moveTo(const Eigen::Affine3d& toWorld);

    /// The vertex at `p`, as the file has it: a new one, or for `welded` the one that is there already.
    /// Throws ReadFault beyond 1e6 m.
    Index position(const Vec3& p, bool welded);
    Index normal(const Eigen::Vector3f& n);
    Index uv(const Eigen::Vector2f& uv);
    std::size_t positions() const { return pools_.positions.size(); }

    /// Corners counter-clockwise as the file sees it; a mirroring transform turns them over. Throws ReadFault
    /// beyond kMaxTriangles.
    void polygon(std::vector<PolygonCorner> corners, Index surface);
    void segment(Index a, Index b, Index surface) {
        builder_.addSegment({a, kNone, kNone}, {b, kNone, kNone}, surface);
    }
    void point(Index at, Index surface) { builder_.addPoint({at, kNone, kNone}, surface); }
    void addTo(LoadedScene& loaded, const std::string& name, std::vector<Surface> surfaces,
               const Progress& progress);

private:
    const Source& source_;
    Eigen::Affine3d toWorld_;
    Mat3 forNormals_;
    bool mirrored_, flat_;
    VertexPools pools_;
    PlaceTable places_;
    std::vector<Index> ofPlace_;
    SoupBuilder builder_{pools_};
};

} // namespace tactum
