#include "core/geometry/topology.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include "core/geometry/weld.h"

namespace tactum {
namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Halfedge = OpenMesh::HalfedgeHandle;
using Corners = std::array<Index, 3>;

bool hasArea(const Corners& t) {
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

/// Our soup as a half-edge mesh in which every triangle has its face. A half-edge mesh knows only edges with
/// two triangles of one orientation and vertices with one fan of triangles: corners become one vertex
/// only when they are linked by such edges, all others are vertices of their own at the same place. A fan is
/// cut open at every other edge, so no more than its two ends, one of each direction, can meet there: every
/// triangle fits.
class HalfEdges {
public:
    HalfEdges(const TriangleSoup& soup, const Progress& progress);

    HalfEdgeMesh mesh;
    std::vector<OpenMesh::FaceHandle> faceOf; ///< of each triangle; invalid for those without an area

private:
    void linkCorners();
    void link(std::size_t corner, std::size_t other);
    std::size_t fanOf(std::size_t corner);
    void addFaces();
    static OpenMesh::Vec3d point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

    const TriangleSoup& soup_;
    const Progress& progress_;
    std::vector<Corners> welded_;
    std::vector<Index> fan_; ///< union-find over corners (3 * triangle + corner)
};

HalfEdges::HalfEdges(const TriangleSoup& soup, const Progress& progress) : soup_(soup), progress_(progress) {
    [[maybe_unused]] static const bool quiet = (omerr().disable(), true); // it reports every complex edge
    const std::vector<Index> weld = weldMap(soup.positions, Progress{{}, progress.cancelled});
    welded_.reserve(soup.triangles.size());
    for (const Corners& t : soup.triangles)
        welded_.push_back({weld[t[0]], weld[t[1]], weld[t[2]]});
    fan_.resize(3 * welded_.size());
    std::iota(fan_.begin(), fan_.end(), Index{0});
    if (!progress.isCancelled()) linkCorners();
    if (!progress.isCancelled()) addFaces();
}

std::size_t HalfEdges::fanOf(std::size_t corner) {
    while (fan_[corner] != corner)
        corner = fan_[corner] = fan_[fan_[corner]];
    return corner;
}

void HalfEdges::link(std::size_t corner, std::size_t other) {
    const std::size_t a = fanOf(corner), b = fanOf(other);
    fan_[std::max(a, b)] = Index(std::min(a, b));
}

/// Links the corners on both ends of every edge that two triangles of one orientation share.
void HalfEdges::linkCorners() {
    struct Use {
        Index low, high, corner; ///< the corner where the edge starts, in its triangle's direction
        bool forward;
    };
    std::vector<Use> uses;
    uses.reserve(3 * welded_.size());
    for (std::size_t f = 0; f < welded_.size(); ++f) {
        const Corners& t = welded_[f];
        if (!hasArea(t)) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const Index a = t[i], b = t[(i + 1) % 3];
            uses.push_back({std::min(a, b), std::max(a, b), Index(3 * f + i), a < b});
        }
    }
    std::sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
        return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
    });
    const auto endOf = [](std::size_t corner) { return corner - corner % 3 + (corner + 1) % 3; };
    for (std::size_t i = 0, j; i < uses.size(); i = j) {
        for (j = i + 1; j < uses.size() && uses[j].low == uses[i].low && uses[j].high == uses[i].high;)
            ++j;
        if (j - i != 2 || uses[i].forward == uses[i + 1].forward) continue;
        link(uses[i].corner, endOf(uses[i + 1].corner));
        link(endOf(uses[i].corner), uses[i + 1].corner);
    }
}

void HalfEdges::addFaces() {
    mesh.reserve(welded_.size() / 2 + 3, welded_.size() * 3 / 2 + 3, welded_.size());
    std::vector<OpenMesh::VertexHandle> vertexOf(fan_.size());
    faceOf.resize(welded_.size());
    ProgressMeter meter(progress_, welded_.size(), 1 << 14);
    for (std::size_t f = 0; f < welded_.size() && meter.goesOn(f); ++f) {
        if (!hasArea(welded_[f])) continue;
        std::array<OpenMesh::VertexHandle, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            auto& vertex = vertexOf[fanOf(3 * f + i)];
            if (!vertex.is_valid()) vertex = mesh.add_vertex(point(soup_.positions[welded_[f][i]]));
            corners[i] = vertex;
        }
        faceOf[f] = mesh.add_face(corners.data(), 3);
        assert(faceOf[f].is_valid());
    }
}

/// The smoothed normal of one corner after the other.
class CornerNormals {
public:
    CornerNormals(HalfEdgeMesh& mesh, double creaseAngle)
        : mesh_(mesh), weighted_(mesh.n_halfedges(), OpenMesh::Vec3d(0.0)), smooth_(mesh.n_edges(), 0) {
        mesh_.request_face_normals();
        mesh_.update_face_normals();
        for (Halfedge h : mesh_.halfedges())
            if (!mesh_.is_boundary(h))
                weighted_[std::size_t(h.idx())] =
                    mesh_.calc_sector_angle(h) * mesh_.normal(mesh_.face_handle(h));
        const double leastCosine = std::cos(creaseAngle);
        for (OpenMesh::EdgeHandle e : mesh_.edges())
            smooth_[std::size_t(e.idx())] = !mesh_.is_boundary(e) && cosineAcross(e) >= leastCosine;
    }

    /// `into`: the half-edge of the triangle that ends in the corner.
    Eigen::Vector3f at(Halfedge into) const {
        OpenMesh::Vec3d sum = weighted(into);
        Halfedge h = forward(into);
        for (; h.is_valid() && h != into; h = forward(h))
            sum += weighted(h);
        if (!h.is_valid()) // a crease stopped us: the other way round as well
            for (h = backward(into); h.is_valid(); h = backward(h))
                sum += weighted(h);
        const double length = sum.norm();
        sum = length > 0 ? sum / length : mesh_.normal(mesh_.face_handle(into));
        return {float(sum[0]), float(sum[1]), float(sum[2])};
    }

private:
    const OpenMesh::Vec3d& weighted(Halfedge into) const { return weighted_[std::size_t(into.idx())]; }
    bool smooth(Halfedge h) const { return smooth_[std::size_t(h.idx() / 2)]; }
    double cosineAcross(OpenMesh::EdgeHandle e) const {
        const auto normal = [&](unsigned side) {
            return mesh_.normal(mesh_.face_handle(mesh_.halfedge_handle(e, side)));
        };
        return dot(normal(0), normal(1));
    }
    /// The neighbour across the edge that leaves the corner, or nothing at a crease.
    Halfedge forward(Halfedge into) const {
        const Halfedge out = mesh_.next_halfedge_handle(into);
        return smooth(out) ? mesh_.opposite_halfedge_handle(out) : Halfedge();
    }
    /// The neighbour across the edge that enters the corner.
    Halfedge backward(Halfedge into) const {
        return smooth(into) ? mesh_.prev_halfedge_handle(mesh_.opposite_halfedge_handle(into)) : Halfedge();
    }

    HalfEdgeMesh& mesh_;
    std::vector<OpenMesh::Vec3d>
        weighted_;             ///< of each half-edge: its triangle's normal times the angle where it ends
    std::vector<char> smooth_; ///< of each edge
};

} // namespace

Result<std::vector<Eigen::Vector3f>> cornerNormalsOf(const TriangleSoup& soup, double creaseAngle,
                                                     const Progress& progress) {
    if (progress.isCancelled()) return cancelledError();
    const Progress build = partOf(progress, 0, 0.6), smoothing = partOf(progress, 0.6, 1);
    HalfEdges edges(soup, build);
    if (progress.isCancelled()) return cancelledError();
    const CornerNormals normals(edges.mesh, creaseAngle);
    std::vector<Eigen::Vector3f> result(3 * soup.triangles.size(), Eigen::Vector3f::UnitZ());
    ProgressMeter meter(smoothing, soup.triangles.size(), 1 << 14);
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        if (!meter.goesOn(f)) return cancelledError();
        if (!edges.faceOf[f].is_valid()) continue;
        // The half-edge that ends in the first corner, whichever one add_face() has made the first.
        auto h = edges.mesh.halfedge_handle(edges.faceOf[f]);
        const OpenMesh::Vec3d first(soup.positions[soup.triangles[f][0]].data());
        while (edges.mesh.point(edges.mesh.to_vertex_handle(h)) != first)
            h = edges.mesh.next_halfedge_handle(h);
        for (std::size_t i = 0; i < 3; ++i, h = edges.mesh.next_halfedge_handle(h))
            result[3 * f + i] = normals.at(h);
    }
    return result;
}

} // namespace tactum
