#include "resources/make_samples/mesh.h"

#include <algorithm>
#include <map>

#include "core/base/single_precision.h"
namespace tactum::samples {
namespace {

std::vector<Eigen::Vector3f> normalsOf(const TriangleSoup& soup) {
    const auto key = [&](Index i) {
        const Vec3& p = soup.positions[i];
        return std::array{p.x(), p.y(), p.z()};
    };
    std::vector<Vec3> facets; // twice their areas
    std::map<std::array<double, 3>, std::vector<std::size_t>> around;
    for (const auto& t : soup.triangles) {
        const Vec3& a = soup.positions[t[0]];
        for (const Index corner : t)
            around[key(corner)].push_back(facets.size());
        facets.push_back((soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a));
    }
    constexpr double kSharp = 0.866; // cosine of 30 degrees
    std::vector<Eigen::Vector3f> normals;
    for (std::size_t i = 0; i < facets.size(); ++i)
        for (const Index corner : soup.triangles[i]) {
            Vec3 sum = Vec3::Zero();
            for (const std::size_t other : around[key(corner)])
                if (facets[other].normalized().dot(facets[i].normalized()) > kSharp) sum += facets[other];
            // Whole steps, so that coplanar facets share their vertices.
            normals.push_back(
                Vec3((sum.normalized() * 1e4).array().round() + 0.0).normalized().cast<float>());
        }
    return normals;
}

} // namespace

Index Mesh::point(const Vec3& p, const Uv& uv) {
    const Vec3 rounded = (p * 1e9).array().round() / 1e9 + 0.0; // 0 has no sign then
    soup_.positions.push_back(asSingle(rounded));
    uvs_.push_back(uv);
    return Index(soup_.positions.size() - 1);
}

void Mesh::triangle(Index a, Index b, Index c, Index surface) {
    soup_.triangles.push_back({a, b, c});
    soup_.surfaceOf.push_back(surface);
}

void Mesh::quad(Index a, Index b, Index c, Index d, Index surface) {
    triangle(a, b, c, surface);
    triangle(a, c, d, surface);
}

void Mesh::box(const Vec3& low, const Vec3& high, Index surface) {
    box(low, high, Pose{}, surface);
}

void Mesh::box(const Vec3& low, const Vec3& high, const Pose& place, Index surface) {
    std::array<Index, 8> corner;
    for (unsigned i = 0; i < 8; ++i)
        corner[i] = point(
            place.apply({(i & 1 ? high : low).x(), (i & 2 ? high : low).y(), (i & 4 ? high : low).z()}));
    constexpr std::array<std::array<unsigned, 4>, 6> kSides{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& side : kSides)
        quad(corner[side[0]], corner[side[1]], corner[side[2]], corner[side[3]], surface);
}

void Mesh::grid(const std::vector<double>& us, const std::vector<double>& vs, const Place& place,
                const SurfaceAt& surfaceAt, const UvAt& uvAt) {
    hasUvs_ = hasUvs_ || uvAt;
    const auto first = Index(soup_.positions.size()), width = Index(us.size());
    for (const double v : vs)
        for (const double u : us)
            point(place(u, v), uvAt ? uvAt(u, v) : Uv::Zero());
    for (Index row = 0; row + 1 < vs.size(); ++row)
        for (Index column = 0; column + 1 < width; ++column) {
            const Index a = first + row * width + column;
            const double u = (us[column] + us[column + 1]) / 2, v = (vs[row] + vs[row + 1]) / 2;
            quad(a, a + 1, a + width + 1, a + width, surfaceAt ? surfaceAt(u, v) : 0);
        }
}

void Mesh::fan(const Vec3& apex, const std::vector<Vec3>& rim, Index surface,
               const std::function<Uv(const Vec3&)>& uvAt) {
    const auto add = [&](const Vec3& p) { return point(p, uvAt ? uvAt(p) : Uv::Zero()); };
    const Index middle = add(apex), first = middle + 1, count = Index(rim.size());
    for (const Vec3& p : rim)
        add(p);
    for (Index i = 0; i < count; ++i)
        triangle(middle, first + i, first + (i + 1) % count, surface);
}

std::shared_ptr<const TriangleSoup> Mesh::soup() const {
    TriangleSoup whole = soup_;
    if (hasUvs_)
        for (const auto& corners : whole.triangles)
            for (const Index corner : corners)
                whole.cornerUvs.push_back(uvs_[corner]);
    if (hasUvs_) whole.cornerNormals = normalsOf(whole);
    return std::make_shared<const TriangleSoup>(std::move(whole));
}

std::vector<double> evenly(double low, double high, int count) {
    std::vector<double> all;
    for (int i = 0; i <= count; ++i)
        all.push_back(low + (high - low) * i / count);
    return all;
}

Surface surface(std::string name, const Eigen::Vector3f& colour, const Material& material) {
    Surface made;
    made.name = std::move(name);
    made.colour = colour;
    made.material = material;
    return made;
}

SceneObject object(std::string name, const Mesh& mesh, std::vector<Surface> surfaces) {
    SceneObject made;
    made.name = std::move(name);
    made.geometry = mesh.soup();
    made.surfaces = std::move(surfaces);
    return made;
}

double smoothStep(double low, double high, double x) {
    const double s = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

} // namespace tactum::samples
