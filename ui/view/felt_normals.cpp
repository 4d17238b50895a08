#include "ui/view/felt_normals.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace tactum {

namespace {

constexpr float kSameFeltNormal = 0.9998f;

double angle(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Takes every so many of a list that may be long, spread over it.
class Every {
public:
    Every(std::size_t of, std::size_t most)
        : step_(std::max(1.0, double(of) / double(std::max<std::size_t>(most, 1)))) {}

    bool operator()() {
        if (double(seen_++) < next_) return false;
        next_ += step_;
        return true;
    }

private:
    double step_, next_ = 0;
    std::size_t seen_ = 0;
};

Needle needle(const Vec3& at, Vec3 felt, const Vec3& drawn) {
    if (felt.dot(drawn) < 0) felt = -felt;
    return {at, felt, angle(felt, drawn)};
}

/// Numbers of corners at which a normal stands that no earlier corner of the same place has.
std::vector<Index> distinctCorners(const TriangleSoup& soup, std::span<const Eigen::Vector3f> normals) {
    std::vector<int> first(soup.positions.size(), -1), next;
    std::vector<Index> corners;
    for (Index c = 0; c < Index(normals.size()); ++c) {
        const Index place = soup.triangles[c / 3][c % 3];
        int v = first[place];
        while (v >= 0 && normals[corners[std::size_t(v)]].dot(normals[c]) < kSameFeltNormal)
            v = next[std::size_t(v)];
        if (v >= 0) continue;
        next.push_back(first[place]);
        first[place] = int(corners.size());
        corners.push_back(c);
    }
    return corners;
}

const SmoothNormals* shadingOf(const WorldBody& body, Index surface) {
    return surface < body.normals.size() ? body.normals[surface].get() : nullptr;
}

} // namespace

std::vector<Needle> needlesOf(const WorldBody& body, const CornerNormals& drawn, std::size_t most) {
    const TriangleSoup& soup = *body.mesh->soup;
    std::vector<Needle> needles;
    if (drawn.size() != 3 * soup.triangles.size()) return needles;
    std::map<const SmoothNormals*, std::vector<Index>> shaded;
    std::size_t facets = 0;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        if (!isFelt(body, soup.surfaceOf[f])) continue;
        if (const SmoothNormals* normals = shadingOf(body, soup.surfaceOf[f]))
            shaded[normals];
        else
            ++facets;
    }
    std::size_t all = facets;
    for (auto& [normals, corners] : shaded) {
        corners = distinctCorners(soup, normals->corners);
        std::erase_if(corners, [&, normals = normals](Index c) {
            const Index surface = soup.surfaceOf[c / 3];
            return shadingOf(body, surface) != normals || !isFelt(body, surface);
        });
        all += corners.size();
    }
    Every chosen(all, most);
    for (const auto& [normals, corners] : shaded)
        for (Index c : corners)
            if (chosen())
                needles.push_back(needle(soup.positions[soup.triangles[c / 3][c % 3]],
                                         normals->corners[c].cast<double>(), drawn[c].cast<double>()));
    for (std::size_t f = 0; f < soup.triangles.size() && facets > 0; ++f) {
        const Index surface = soup.surfaceOf[f];
        if (shadingOf(body, surface) || !isFelt(body, surface) || !chosen()) continue;
        const auto& t = soup.triangles[f];
        const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
        const Vec3 across = (b - a).cross(c - a);
        if (!(across.norm() > 0)) continue;
        Needle at = needle((a + b + c) / 3, across.normalized(), drawn[3 * f].cast<double>());
        for (std::size_t k = 1; k < 3; ++k)
            at.lean = std::max(at.lean, angle(at.normal, drawn[3 * f + k].cast<double>()));
        needles.push_back(at);
    }
    return needles;
}

NormalNeedles normalNeedles(const World& world, double length, const Progress& progress) {
    NormalNeedles result;
    std::size_t all = 0;
    for (const WorldBody& body : world.bodies)
        all += body.mesh->soup->triangles.size();
    for (const WorldBody& body : world.bodies) {
        if (progress.isCancelled()) return {};
        const TriangleSoup& soup = *body.mesh->soup;
        const double share = double(soup.triangles.size()) / double(std::max<std::size_t>(all, 1));
        NeedleMesh mesh{body.object, {}};
        for (Index s = 0; s < Index(body.materials.size()); ++s)
            (shadingOf(body, s) ? result.shaded : result.facets) = true;
        for (const Needle& n : needlesOf(body, drawnNormalsOf(soup, progress),
                                         std::size_t(std::ceil(share * double(kMaxNeedles))))) {
            for (const Vec3& p : {n.at, Vec3(n.at + length * n.normal)})
                for (Eigen::Index k = 0; k < 3; ++k)
                    mesh.positions.push_back(float(p[k]));
            result.mostLean = std::max(result.mostLean, n.lean);
            ++result.count;
        }
        result.meshes.push_back(std::move(mesh));
    }
    return result;
}

} // namespace tactum
