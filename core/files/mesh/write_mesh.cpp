#include "core/files/mesh/write_mesh.h"

#include <algorithm>
#include <cstring>

#include "core/base/numbers.h"
#include "core/base/realtime.h"
#include "core/base/single_precision.h"
#include "core/base/text.h"
#include "core/files/corner_pool.h"

namespace tactum {
namespace {

/// Adds an object in the world frame. Where only some objects have normals or coordinates, the others get
/// those that the readers would give them: the triangle's own normal and (0, 0).
void appendObject(TriangleSoup& all, const SceneObject& object, bool normals, bool uvs) {
    const TriangleSoup& soup = *object.geometry;
    const Index first = Index(all.positions.size());
    for (const Vec3& p : soup.positions)
        all.positions.push_back(object.pose.apply(p));
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
        const auto& t = soup.triangles[i];
        all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
        const Vec3& a = soup.positions[t[0]];
        const Vec3 own = (soup.positions[t[1]] - a).cross(soup.positions[t[2]] - a);
        for (std::size_t k = 0; k < 3; ++k) {
            Vec3 n = own.norm() > 0 ? Vec3(own.normalized()) : Vec3::UnitZ();
            if (!soup.cornerNormals.empty()) n = soup.cornerNormals[3 * i + k].cast<double>();
            if (normals) all.cornerNormals.push_back(object.pose.rotate(n).cast<float>());
            if (uvs)
                all.cornerUvs.push_back(soup.cornerUvs.empty() ? Eigen::Vector2f(0, 0)
                                                               : soup.cornerUvs[3 * i + k]);
        }
    }
}

TriangleSoup inWorld(const Scene& scene) {
    const auto any = [&](auto&& has) { return std::ranges::any_of(scene.objects, has); };
    const bool normals = any([](auto& object) { return !object.geometry->cornerNormals.empty(); });
    const bool uvs = any([](auto& object) { return !object.geometry->cornerUvs.empty(); });
    TriangleSoup all;
    for (const SceneObject& object : scene.objects)
        appendObject(all, object, normals, uvs);
    return all;
}

bool hasTriangles(const Scene& scene) {
    return std::ranges::any_of(scene.objects, [](const SceneObject& object) {
        return std::ranges::any_of(object.geometry->triangles, [](auto& t) { return cornersOf(t) == 3; });
    });
}

/// Little-endian, whatever the machine.
template <std::size_t N> void appendBytes(std::string& out, std::uint64_t bits) {
    for (std::size_t i = 0; i < N; ++i)
        out += char(bits >> (8 * i) & 0xFF);
}
void appendFloat(std::string& out, float value) {
    appendBytes<4>(out, std::bit_cast<std::uint32_t>(value));
}
void appendDouble(std::string& out, double value) {
    appendBytes<8>(out, std::bit_cast<std::uint64_t>(value));
}

bool isFloat(const Vec3& p) {
    return asSingle(p) == p;
}

/// A vertex of the PLY file: position, normal, coordinates.
using PlyKey = CornerPool<6>::Key;

/// The soup as vertices that carry everything, and the faces between them.
struct PlyMesh {
    explicit PlyMesh(const TriangleSoup& soup) {
        for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
            const int corners = cornersOf(soup.triangles[i]);
            auto& list = corners == 3 ? triangles : edges;
            if (corners == 1) vertex(soup, i, 0); // a vertex that no face names
            for (int k = 0; k < corners && corners > 1; ++k)
                list.push_back(vertex(soup, i, std::size_t(k)));
        }
    }
    Index vertex(const TriangleSoup& soup, std::size_t triangle, std::size_t k) {
        PlyKey key{soup.triangles[triangle][k], 0, 0, 0, 0, 0};
        for (int i = 0; i < 3 && !soup.cornerNormals.empty(); ++i)
            key[std::size_t(1 + i)] = bitsOf(soup.cornerNormals[3 * triangle + k][i]);
        for (int i = 0; i < 2 && !soup.cornerUvs.empty(); ++i)
            key[std::size_t(4 + i)] = bitsOf(soup.cornerUvs[3 * triangle + k][i]);
        return vertices.numberOf(key);
    }

    CornerPool<6> vertices;
    std::vector<Index> triangles, edges;
};

std::string plyHeader(const TriangleSoup& soup, const PlyMesh& mesh, const std::string& real) {
    std::string out = "ply\nformat binary_little_endian 1.0\ncomment Tactum, metres\nelement vertex " +
                      std::to_string(mesh.vertices.keys().size()) + "\n";
    for (const char* axis : {"x", "y", "z"})
        out += "property " + real + " " + axis + "\n";
    if (!soup.cornerNormals.empty()) out += "property float nx\nproperty float ny\nproperty float nz\n";
    if (!soup.cornerUvs.empty()) out += "property float u\nproperty float v\n";
    out += "element face " + std::to_string(mesh.triangles.size() / 3) +
           "\nproperty list uchar uint vertex_indices\n";
    if (!mesh.edges.empty())
        out += "element edge " + std::to_string(mesh.edges.size() / 2) +
               "\nproperty uint vertex1\nproperty uint vertex2\n";
    return out + "end_header\n";
}

} // namespace

std::string asPly(const Scene& scene) {
    const TriangleSoup soup = inWorld(scene);
    const PlyMesh mesh(soup);
    const bool floats = std::ranges::all_of(soup.positions, isFloat);
    std::string out = plyHeader(soup, mesh, floats ? "float" : "double");
    for (const PlyKey& key : mesh.vertices.keys()) {
        for (const double x : soup.positions[key[0]])
            floats ? appendFloat(out, float(x)) : appendDouble(out, x);
        for (std::size_t i = 1; i < 4 && !soup.cornerNormals.empty(); ++i)
            appendBytes<4>(out, key[i]);
        for (std::size_t i = 4; i < 6 && !soup.cornerUvs.empty(); ++i)
            appendBytes<4>(out, key[i]);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i % 3 == 0) out += '\3';
        appendBytes<4>(out, mesh.triangles[i]);
    }
    for (const Index end : mesh.edges)
        appendBytes<4>(out, end);
    return out;
}

std::string asStl(const Scene& scene) {
    const TriangleSoup soup = inWorld(scene);
    std::string facets;
    std::uint32_t count = 0;
    for (const auto& t : soup.triangles) {
        if (cornersOf(t) < 3) continue;
        ++count;
        const Vec3 &a = soup.positions[t[0]], &b = soup.positions[t[1]], &c = soup.positions[t[2]];
        for (const Vec3& v : {Vec3((b - a).cross(c - a).normalized()), a, b, c})
            for (const double x : v)
                appendFloat(facets, float(x));
        facets += {'\0', '\0'};
    }
    std::string out = "Tactum, metres"; // not "solid": many programs would take it for text
    out.resize(80, ' ');
    appendBytes<4>(out, count);
    return out + facets;
}

std::string asOff(const Scene& scene) {
    const TriangleSoup soup = inWorld(scene);
    std::string out = "OFF\n" + std::to_string(soup.positions.size()) + " " +
                      std::to_string(soup.triangles.size()) + " 0\n";
    for (const Vec3& p : soup.positions)
        for (int i = 0; i < 3; ++i) {
            appendNumber(out, p[i]);
            out += i < 2 ? ' ' : '\n';
        }
    for (const auto& t : soup.triangles) {
        const int corners = cornersOf(t);
        out += std::to_string(corners);
        for (int k = 0; k < corners; ++k)
            out += " " + std::to_string(t[std::size_t(k)]);
        out += '\n';
    }
    return out;
}

const std::vector<std::string>& writableMeshEndings() {
    static const std::vector<std::string> endings{"obj", "ply", "stl", "off"};
    return endings;
}

Result<std::vector<MeshFile>> meshFilesOf(const Scene& scene, std::string_view ending,
                                          std::string_view stem) {
    assertNotRealtime();
    std::size_t positions = 0;
    for (const SceneObject& object : scene.objects)
        positions += object.geometry->positions.size();
    if (positions >= ~Index{0})
        return inputError("the scene has more vertices than a mesh file can number; export a part of it");
    if (ending == "obj") return asObj(scene, stem);
    const auto alone = [&](std::string bytes) {
        return std::vector<MeshFile>{{std::string(stem) + "." + std::string(ending), std::move(bytes)}};
    };
    if (ending == "ply") return alone(asPly(scene));
    if (ending == "stl" && !scene.objects.empty() && !hasTriangles(scene))
        return inputError(
            "the scene has no triangles, and STL holds nothing else; export it as .ply or .obj");
    if (ending == "stl") return alone(asStl(scene));
    if (ending == "off") return alone(asOff(scene));
    return inputError(inQuotes(ending) + " is no mesh format that can be written; use obj, ply, stl or off");
}

} // namespace tactum
