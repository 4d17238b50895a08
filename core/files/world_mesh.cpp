#include "core/files/world_mesh.h"

#include <algorithm>

#include "core/scene/value_checks.h"

namespace tactum {

namespace {
constexpr std::string_view kNoUnit = "has no unit: taken as metres; ";
}

Finding unitGuess(const Scene& scene, std::string remedy) {
    return {Finding::Severity::Note, "",
            std::string(kNoUnit) + withUnit(boundsOf(scene).diagonal(), "m") + " across", std::move(remedy)};
}

bool saysUnit(const Finding& finding) {
    return finding.sentence.starts_with(kNoUnit);
}

WorldMesh::WorldMesh(const Source& source, const Eigen::Affine3d& toWorld) : source_(source) {
    moveTo(toWorld);
}

void WorldMesh::moveTo(const Eigen::Affine3d& toWorld) {
    toWorld_ = toWorld;
    if (!toWorld.matrix().allFinite() || !isCoordinate(toWorld.matrix().cwiseAbs().maxCoeff()))
        source_.fail("a transform leads beyond 1e6 m; scale the model");
    const double volume = toWorld.linear().determinant();
    mirrored_ = volume < 0;
    flat_ = std::abs(volume) < 1e-30; // normals have no meaning any more
    forNormals_ = flat_ ? Mat3::Identity() : Mat3(toWorld.linear().inverse().transpose());
}

Index WorldMesh::position(const Vec3& p, bool welded) {
    const Vec3 p_W = toWorld_ * p;
    if (const std::string wrong = complaintOfPlace(p_W); !wrong.empty())
        source_.fail("coordinate of vertex " + std::to_string(positions()) + wrong);
    const Index next = Index(positions());
    if (welded) {
        const Index place = places_.numberOf(p_W);
        if (place < ofPlace_.size()) return ofPlace_[place];
        ofPlace_.push_back(next);
    }
    pools_.positions.push_back(p_W);
    return next;
}

Index WorldMesh::normal(const Eigen::Vector3f& n) {
    pools_.normals.push_back(flat_ ? Eigen::Vector3f::Zero().eval()
                                   : (forNormals_ * n.cast<double>()).normalized().cast<float>().eval());
    return Index(pools_.normals.size() - 1);
}

Index WorldMesh::uv(const Eigen::Vector2f& uv) {
    pools_.uvs.push_back(uv);
    return Index(pools_.uvs.size() - 1);
}

void WorldMesh::polygon(std::vector<PolygonCorner> corners, Index surface) {
    if (mirrored_) std::reverse(corners.begin(), corners.end());
    builder_.add(corners, surface);
    if (builder_.triangles() > kMaxTriangles)
        source_.fail("has more than 67 million triangles with all its copies; split or simplify it");
}

void WorldMesh::addTo(LoadedScene& loaded, const std::string& name, std::vector<Surface> surfaces,
                      const Progress& progress) {
    BuildReport report;
    TriangleSoup soup = builder_.finishCompact(report);
    addObject(loaded, name, report, std::move(soup), std::move(surfaces), Progress{{}, progress.cancelled});
}

} // namespace tactum
