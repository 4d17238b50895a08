#include "core/files/x3d/x3d_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tactum {
namespace {

/// Corners as places in the node's own lists, one polygon after the other.
using Outline = std::vector<std::size_t>;

/// One node with coordinates: its vertices, and how they are joined.
class Vertices {
public:
    Vertices(const X3dDocument& document, X3dNode node, WorldMesh& mesh, Index surface, bool welded)
        : document_(document), node_(node), mesh_(mesh), surface_(surface) {
        const X3dNode points = document.child(node, {"Coordinate", "CoordinateDouble"});
        const std::vector<double> xyz = points ? document.numbers(points, "point") : std::vector<double>();
        if (xyz.size() % 3 != 0)
            document.fail(points, "point has " + std::to_string(xyz.size()) +
                                      " numbers, which are not three for each point; export it again");
        for (std::size_t i = 0; i + 2 < xyz.size(); i += 3)
            positions_.push_back(mesh.position({xyz[i], xyz[i + 1], xyz[i + 2]}, welded));
        const X3dNode normals = document.child(node, {"Normal"});
        const std::vector<double> n = normals ? document.numbers(normals, "vector") : std::vector<double>();
        for (std::size_t i = 0; i + 2 < n.size(); i += 3)
            normals_.push_back(mesh.normal(Vec3(n[i], n[i + 1], n[i + 2]).cast<float>()));
        const X3dNode uvs = document.child(node, {"TextureCoordinate"});
        const std::vector<double> uv = uvs ? document.numbers(uvs, "point") : std::vector<double>();
        for (std::size_t i = 0; i + 1 < uv.size(); i += 2)
            uvs_.push_back(mesh.uv(Eigen::Vector2d(uv[i], uv[i + 1]).cast<float>()));
        perVertex_ = X3dDocument::flag(node, "normalPerVertex", true);
        turned_ = !X3dDocument::flag(node, "ccw", true);
    }

    std::size_t size() const { return positions_.size(); }

    /// A polygon whose corners have these vertices, normals and texture coordinates.
    void add(const Outline& vertices, const Outline& normals, const Outline& uvs) {
        std::vector<PolygonCorner> corners(vertices.size());
        for (std::size_t i = 0; i < vertices.size(); ++i) {
            corners[i].position = at(positions_, vertices[i], "point");
            if (!normals_.empty()) corners[i].normal = at(normals_, normals[i], "normal");
            if (!uvs_.empty()) corners[i].uv = at(uvs_, uvs[i], "texture coordinate");
        }
        if (turned_) std::reverse(corners.begin(), corners.end());
        mesh_.polygon(std::move(corners), surface_);
    }

    /// All three by the same number, as in the indexed triangle nodes; normals one for each face where it
    /// says so.
    void add(const Outline& vertices) {
        add(vertices, perVertex_ ? vertices : Outline(vertices.size(), faces_), vertices);
        ++faces_;
    }

    /// A line from vertex to vertex.
    void addLine(const Outline& vertices) {
        for (std::size_t i = 0; i + 1 < vertices.size(); ++i)
            mesh_.segment(at(positions_, vertices[i], "point"), at(positions_, vertices[i + 1], "point"),
                          surface_);
    }
    void addPoints() {
        for (const Index each : positions_)
            mesh_.point(each, surface_);
    }

    bool perVertex() const { return perVertex_; }
    bool hasNormals() const { return !normals_.empty(); }
    bool hasUvs() const { return !uvs_.empty(); }

private:
    Index at(const std::vector<Index>& list, std::size_t place, const char* what) const {
        if (place >= list.size())
            document_.fail(node_, std::string("refers to ") + what + " " + std::to_string(place) +
                                      ", but only " + std::to_string(list.size()) +
                                      " are there (from 0); export it again");
        return list[place];
    }

    const X3dDocument& document_;
    X3dNode node_;
    WorldMesh& mesh_;
    Index surface_;
    std::vector<Index> positions_, normals_, uvs_;
    bool perVertex_ = true, turned_ = false;
    std::size_t faces_ = 0;
};

Outline whole(const X3dDocument& document, X3dNode node, const char* field) {
    Outline numbers;
    for (const std::int64_t number : document.integers(node, field))
        numbers.push_back(std::size_t(number)); // -1 becomes the largest one, which ends a polygon
    return numbers;
}
constexpr std::size_t kEnd = ~std::size_t(0);

/// Lists of polygons that are ended by -1.
std::vector<Outline> polygonsOf(const Outline& indices) {
    std::vector<Outline> polygons(1);
    for (const std::size_t index : indices)
        if (index == kEnd)
            polygons.emplace_back();
        else
            polygons.back().push_back(index);
    if (polygons.back().empty()) polygons.pop_back();
    return polygons;
}

/// The indices of an attribute for the polygons of coordIndex: its own, or theirs.
std::vector<Outline> attributeOf(const X3dDocument& document, X3dNode node, const char* field, bool there,
                                 const std::vector<Outline>& polygons) {
    std::vector<Outline> own = polygonsOf(whole(document, node, field));
    if (!there || own.empty()) return polygons;
    if (own.size() != polygons.size())
        document.fail(node, std::string(field) + " has another number of faces");
    for (std::size_t i = 0; i < own.size(); ++i)
        if (own[i].size() != polygons[i].size())
            document.fail(node, std::string(field) + " has a face with another number of corners");
    return own;
}

void faceSet(const X3dDocument& document, X3dNode node, Vertices& vertices) {
    const std::vector<Outline> polygons = polygonsOf(whole(document, node, "coordIndex"));
    const auto uvs = attributeOf(document, node, "texCoordIndex", vertices.hasUvs(), polygons);
    const bool perVertex = vertices.perVertex() || !vertices.hasNormals();
    const auto normals =
        attributeOf(document, node, "normalIndex", vertices.hasNormals() && perVertex, polygons);
    const Outline ofFace = perVertex ? Outline() : whole(document, node, "normalIndex");
    for (std::size_t f = 0; f < polygons.size(); ++f) {
        const std::size_t number = ofFace.empty() ? f : f < ofFace.size() ? ofFace[f] : kEnd;
        vertices.add(polygons[f], perVertex ? normals[f] : Outline(polygons[f].size(), number), uvs[f]);
    }
}

/// Triangles out of a row of vertices. A fan goes around its first one, a strip turns every second triangle
/// over.
void triangles(Vertices& vertices, const Outline& row) {
    for (std::size_t i = 0; i + 2 < row.size(); i += 3)
        vertices.add({row[i], row[i + 1], row[i + 2]});
}
void fan(Vertices& vertices, const Outline& row) {
    for (std::size_t i = 1; i + 1 < row.size(); ++i)
        vertices.add({row[0], row[i], row[i + 1]});
}
void strip(Vertices& vertices, const Outline& row) {
    for (std::size_t i = 0; i + 2 < row.size(); ++i)
        vertices.add({row[i], row[i + 1 + i % 2], row[i + 2 - i % 2]});
}

void line(Vertices& vertices, const Outline& row) {
    vertices.addLine(row);
}

using Join = void (*)(Vertices&, const Outline&);

/// The vertices in their order, cut into rows by `count`; one row without it.
std::vector<Outline> rowsInOrder(const X3dDocument& document, X3dNode node, const char* count,
                                 std::size_t size) {
    Outline lengths = whole(document, node, count);
    if (lengths.empty()) lengths = {size};
    std::vector<Outline> rows;
    std::size_t next = 0;
    for (const std::size_t length : lengths) {
        Outline& row = rows.emplace_back();
        if (length > size - next)
            document.fail(node, std::string(count) + " counts more vertices than there are");
        for (std::size_t i = 0; i < length; ++i)
            row.push_back(next++);
    }
    return rows;
}

void box(const X3dDocument& document, X3dNode node, WorldMesh& mesh, Index surface) {
    const auto size = document.tuple(node, "size", {2, 2, 2});
    std::array<PolygonCorner, 8> corner;
    for (unsigned i = 0; i < 8; ++i)
        corner[i].position = mesh.position(
            {(i & 1 ? 0.5 : -0.5) * size[0], (i & 2 ? 0.5 : -0.5) * size[1], (i & 4 ? 0.5 : -0.5) * size[2]},
            false);
    constexpr std::array<std::array<unsigned, 4>, 6> kFaces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    for (const auto& f : kFaces)
        mesh.polygon({corner[f[0]], corner[f[1]], corner[f[2]], corner[f[3]]}, surface);
}

constexpr int kAround = 64; ///< facets of what is round

/// A surface of revolution about y: rings of (radius, height) from the top down; a ring of radius 0 is one
/// vertex.
void revolve(WorldMesh& mesh, Index surface, const std::vector<Eigen::Vector2d>& rings) {
    const auto ringAt = [&](const Eigen::Vector2d& ring) {
        std::vector<PolygonCorner> corners(kAround);
        for (int i = 0; i < kAround; ++i) {
            const double angle = 2 * std::numbers::pi * i / kAround;
            const bool pole = ring.x() == 0;
            corners[std::size_t(i)].position =
                pole && i > 0
                    ? corners[0].position
                    : mesh.position({ring.x() * std::sin(angle), ring.y(), ring.x() * std::cos(angle)},
                                    false);
        }
        return corners;
    };
    std::vector<PolygonCorner> above = ringAt(rings.front());
    for (std::size_t r = 1; r < rings.size(); ++r) {
        const std::vector<PolygonCorner> below = ringAt(rings[r]);
        for (std::size_t i = 0; i < kAround; ++i) {
            const std::size_t k = (i + 1) % kAround;
            if (rings[r - 1].x() == 0)
                mesh.polygon({above[i], below[i], below[k]}, surface);
            else if (rings[r].x() == 0)
                mesh.polygon({above[i], below[i], above[k]}, surface);
            else
                mesh.polygon({above[i], below[i], below[k], above[k]}, surface);
        }
        above = below;
    }
}

void sphere(const X3dDocument& document, X3dNode node, WorldMesh& mesh, Index surface) {
    const double radius = document.number(node, "radius", 1);
    std::vector<Eigen::Vector2d> rings;
    for (int i = 0; i <= kAround / 2; ++i) {
        const double angle = 2 * std::numbers::pi * i / kAround;
        const bool pole = i == 0 || i == kAround / 2;
        rings.emplace_back(pole ? 0 : radius * std::sin(angle), radius * std::cos(angle));
    }
    revolve(mesh, surface, rings);
}

void roundBody(const X3dDocument& document, X3dNode node, WorldMesh& mesh, Index surface, bool cone) {
    const double radius = document.number(node, cone ? "bottomRadius" : "radius", 1),
                 half = 0.5 * document.number(node, "height", 2);
    std::vector<Eigen::Vector2d> rings;
    if (cone || X3dDocument::flag(node, "top", true)) rings.emplace_back(0, half);
    if (!cone) rings.emplace_back(radius, half);
    rings.emplace_back(radius, -half);
    if (X3dDocument::flag(node, "bottom", true)) rings.emplace_back(0, -half);
    revolve(mesh, surface, rings);
}

void elevationGrid(const X3dDocument& document, X3dNode node, WorldMesh& mesh, Index surface) {
    const auto heights = document.numbers(node, "height");
    const double columns = document.number(node, "xDimension", 0),
                 rows = document.number(node, "zDimension", 0);
    if (columns < 0 || rows < 0 || columns * rows > double(heights.size()))
        document.fail(node, "has fewer heights than its dimensions ask for; export it again");
    const double dx = document.number(node, "xSpacing", 1), dz = document.number(node, "zSpacing", 1);
    const auto nx = std::size_t(columns), nz = std::size_t(rows);
    const bool turned = !X3dDocument::flag(node, "ccw", true);
    std::vector<PolygonCorner> grid(nx * nz);
    for (std::size_t i = 0; i < grid.size(); ++i)
        grid[i].position = mesh.position({dx * double(i % nx), heights[i], dz * double(i / nx)}, false);
    for (std::size_t z = 0; z + 1 < nz; ++z)
        for (std::size_t x = 0; x + 1 < nx; ++x) {
            const std::size_t a = z * nx + x;
            if (turned)
                mesh.polygon({grid[a], grid[a + 1], grid[a + nx + 1], grid[a + nx]}, surface);
            else
                mesh.polygon({grid[a], grid[a + nx], grid[a + nx + 1], grid[a + 1]}, surface);
        }
}

} // namespace

bool addGeometry(const X3dDocument& document, X3dNode node, WorldMesh& mesh, Index surface, bool welded) {
    const std::string_view kind = node.name();
    if (kind == "Box") return box(document, node, mesh, surface), true;
    if (kind == "Sphere") return sphere(document, node, mesh, surface), true;
    if (kind == "Cylinder" || kind == "Cone")
        return roundBody(document, node, mesh, surface, kind == "Cone"), true;
    if (kind == "ElevationGrid") return elevationGrid(document, node, mesh, surface), true;
    struct Rows {
        std::string_view kind;
        Join join;
        const char* index; ///< rows of numbers, or how many vertices each row has
        bool indexed;
    };
    static constexpr Rows kRows[] = {
        {"IndexedTriangleSet", triangles, "index", true},  {"IndexedTriangleFanSet", fan, "index", true},
        {"IndexedTriangleStripSet", strip, "index", true}, {"TriangleSet", triangles, "", false},
        {"TriangleFanSet", fan, "fanCount", false},        {"TriangleStripSet", strip, "stripCount", false},
        {"IndexedLineSet", line, "coordIndex", true},      {"LineSet", line, "vertexCount", false}};
    if (kind != "IndexedFaceSet" && kind != "PointSet" &&
        std::ranges::find(kRows, kind, &Rows::kind) == std::end(kRows))
        return false;
    Vertices vertices(document, node, mesh, surface, welded);
    if (kind == "IndexedFaceSet") return faceSet(document, node, vertices), true;
    if (kind == "PointSet") return vertices.addPoints(), true;
    const Rows& rows = *std::ranges::find(kRows, kind, &Rows::kind);
    for (const Outline& row : rows.indexed ? polygonsOf(whole(document, node, rows.index))
                                           : rowsInOrder(document, node, rows.index, vertices.size()))
        rows.join(vertices, row);
    return true;
}

} // namespace tactum
