// glTF 2.0 and glb. Every node with a mesh is an object, every material of the mesh a surface. The rigid part
// of the node's transform is the object's pose, what is left of it goes into the vertices. A node that is
// animated, or has an animated ancestor, moves. Axes stay as in the file.
#include <map>
#include <optional>

#include "core/scene/gltf_motion.h"
#include "core/scene/gltf_nodes.h"
#include "core/scene/readers.h"
#include "core/scene/text.h"

namespace tactum {
namespace {

constexpr std::size_t kMostTriangles = std::size_t(1) << 26; // a small file can name one mesh very often

/// A mesh of the file as it is before any transform.
struct RawMesh {
    TriangleSoup soup;
    std::vector<Surface> surfaces;
    BuildReport report;
};

/// About how many vertices and indices there are to read.
std::size_t elementsOf(const tinygltf::Model& model) {
    std::size_t count = 0;
    for (const tinygltf::Accessor& accessor : model.accessors)
        count += std::min(accessor.count, kMostTriangles);
    return count;
}

class GltfReader {
public:
    GltfReader(const Source& source, const Progress& progress)
        : source_(source), progress_(progress), model_(parseGltf(source)),
          meter_(progress, elementsOf(model_)) {}

    LoadedScene read();

private:
    RawMesh readMesh(const tinygltf::Mesh& mesh);
    void readPrimitive(const tinygltf::Primitive& primitive, RawMesh& raw);
    Index readVertices(const tinygltf::Primitive& primitive);
    std::vector<Index> indicesOf(const tinygltf::Primitive& primitive, Index first) const;
    void addElements(SoupBuilder& builder, int mode, const std::vector<Index>& indices, Index surface);
    PolygonCorner corner(Index vertex) const {
        return {vertex, hasNormals_ ? vertex : kNone, hasUvs_ ? vertex : kNone};
    }
    Index surfaceFor(int material, RawMesh& raw);
    void place(LoadedScene& loaded, const PlacedMesh& placed, const RawMesh& raw);
    void countTriangles(std::size_t more);

    const Source& source_;
    const Progress& progress_;
    tinygltf::Model model_;
    ProgressMeter meter_;
    std::size_t done_ = 0, triangles_ = 0;
    VertexPools pools_; ///< of the mesh being read
    std::map<int, Index> surfaceOf_;
    SoupBuilder* builder_ = nullptr;
    bool hasNormals_ = false, hasUvs_ = false; ///< of the primitive being read
};

/// Scale, shear, mirroring and offset of a mesh; a mirror turns every triangle over, as glTF demands.
TriangleSoup stretched(TriangleSoup soup, const Mat3& stretch, const Vec3& offset) {
    const double volume = stretch.determinant();
    for (Vec3& p : soup.positions)
        p = stretch * p + offset;
    if (std::abs(volume) < 1e-30) {
        soup.cornerNormals.clear(); // flattened: they have no meaning any more
        return soup;
    }
    const Mat3 forNormals = stretch.inverse().transpose();
    for (auto& n : soup.cornerNormals)
        n = (forNormals * n.cast<double>()).normalized().cast<float>();
    if (volume > 0) return soup;
    for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
        if (soup.triangles[f][1] == soup.triangles[f][2]) continue; // a segment or a point has no sides
        std::swap(soup.triangles[f][1], soup.triangles[f][2]);
        if (!soup.cornerNormals.empty())
            std::swap(soup.cornerNormals[3 * f + 1], soup.cornerNormals[3 * f + 2]);
        if (!soup.cornerUvs.empty()) std::swap(soup.cornerUvs[3 * f + 1], soup.cornerUvs[3 * f + 2]);
    }
    return soup;
}

LoadedScene GltfReader::read() {
    LoadedScene loaded;
    std::map<int, RawMesh> meshes;
    const GltfMotions motions(source_, model_);
    loaded.findings = motions.findings();
    for (const PlacedMesh& placed : placedMeshes(source_, model_, motions)) {
        const auto [mesh, isNew] = meshes.try_emplace(placed.mesh);
        if (isNew)
            mesh->second = readMesh(model_.meshes[std::size_t(placed.mesh)]);
        else
            countTriangles(mesh->second.soup.triangles.size());
        place(loaded, placed, mesh->second);
    }
    return loaded;
}

void GltfReader::countTriangles(std::size_t more) {
    triangles_ += more;
    if (triangles_ > kMostTriangles)
        source_.fail("has more than 67 million triangles with all its copies; split or simplify it");
}

void GltfReader::place(LoadedScene& loaded, const PlacedMesh& placed, const RawMesh& raw) {
    const bool asItIs = placed.stretch == Mat3::Identity() && placed.offset.isZero(0);
    TriangleSoup soup = asItIs ? raw.soup : stretched(raw.soup, placed.stretch, placed.offset);
    for (const Vec3& p : soup.positions)
        if (!isCoordinate(p.cwiseAbs().maxCoeff()))
            source_.fail("coordinate of node " + inQuotes(placed.name) + " is beyond 1e6 m; scale the model");
    const std::size_t before = loaded.scene.objects.size();
    addObject(loaded, placed.name.empty() ? stemOf(source_) : placed.name, raw.report, std::move(soup),
              raw.surfaces, Progress{{}, progress_.cancelled});
    if (loaded.scene.objects.size() == before) return;
    SceneObject& object = loaded.scene.objects.back();
    object.pose = placed.pose;
    object.motion = placed.motion;
    const auto warn = [&](bool applies, const char* sentence, const char* remedy) {
        if (applies) loaded.findings.push_back({Finding::Severity::Warning, object.name, sentence, remedy});
    };
    warn(placed.bends, "is scaled or sheared while it moves",
         "only its rigid motion is felt; give its ancestors an even scale");
    warn(placed.deforms, "is deformed by a skin or by morph targets",
         "felt in the shape that it has at rest");
}

RawMesh GltfReader::readMesh(const tinygltf::Mesh& mesh) {
    RawMesh raw;
    pools_ = {};
    surfaceOf_.clear();
    SoupBuilder builder(pools_);
    builder_ = &builder;
    for (const tinygltf::Primitive& primitive : mesh.primitives)
        readPrimitive(primitive, raw);
    raw.soup = builder.finish(std::move(pools_.positions), raw.report);
    return raw;
}

void GltfReader::readPrimitive(const tinygltf::Primitive& primitive, RawMesh& raw) {
    if (!primitive.attributes.count("POSITION")) return; // glTF: to be ignored
    const Index first = readVertices(primitive);
    const std::vector<Index> indices = indicesOf(primitive, first);
    countTriangles(indices.size());
    addElements(*builder_, primitive.mode, indices, surfaceFor(primitive.material, raw));
}

/// Appends the vertices of a primitive to the pools; returns the place of its first.
Index GltfReader::readVertices(const tinygltf::Primitive& primitive) {
    const auto attribute = [&](const char* name, std::size_t components) -> std::optional<GltfAccessor> {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return std::nullopt;
        return GltfAccessor(source_, model_, found->second, components);
    };
    const auto positions = attribute("POSITION", 3);
    const auto normals = attribute("NORMAL", 3);
    const auto uvs = attribute("TEXCOORD_0", 2);
    const std::size_t first = pools_.positions.size(), count = positions->size();
    if (first + count > kMostTriangles)
        source_.fail("has more than 67 million vertices; split or simplify it");
    hasNormals_ = normals && normals->size() >= count;
    hasUvs_ = uvs && uvs->size() >= count;
    for (std::size_t i = 0; i < count; ++i) {
        demandGoingOn(meter_, ++done_);
        const Vec3 p(positions->number(i, 0), positions->number(i, 1), positions->number(i, 2));
        if (!isCoordinate(p.x()) || !isCoordinate(p.y()) || !isCoordinate(p.z()))
            source_.fail("coordinate of vertex " + std::to_string(i) +
                         " is not a number of at most 1e6 m; scale the model");
        pools_.positions.push_back(p);
    }
    pools_.normals.resize(first + count, Eigen::Vector3f::Zero());
    pools_.uvs.resize(first + count, Eigen::Vector2f::Zero());
    for (std::size_t i = 0; hasNormals_ && i < count; ++i)
        pools_.normals[first + i] =
            Vec3(normals->number(i, 0), normals->number(i, 1), normals->number(i, 2)).cast<float>();
    for (std::size_t i = 0; hasUvs_ && i < count; ++i) // v counts downward there, upward here
        pools_.uvs[first + i] = Eigen::Vector2d(uvs->number(i, 0), 1 - uvs->number(i, 1)).cast<float>();
    return Index(first);
}

std::vector<Index> GltfReader::indicesOf(const tinygltf::Primitive& primitive, Index first) const {
    const std::size_t vertices = pools_.positions.size() - first;
    std::vector<Index> indices;
    if (primitive.indices < 0) {
        indices.resize(vertices);
        for (Index i = 0; i < vertices; ++i)
            indices[i] = first + i;
        return indices;
    }
    const GltfAccessor accessor(source_, model_, primitive.indices, 1);
    if (!accessor.isUnsigned())
        source_.fail("has indices that are not unsigned whole numbers; re-export the file");
    indices.reserve(accessor.size());
    for (std::size_t i = 0; i < accessor.size(); ++i) {
        const std::uint32_t vertex = accessor.integer(i);
        if (vertex >= vertices)
            source_.fail("index " + std::to_string(i) + " refers to vertex " + std::to_string(vertex) +
                         ", but only " + std::to_string(vertices) +
                         " are defined (from 0); re-export the file");
        indices.push_back(first + vertex);
    }
    return indices;
}

/// What is left over at the end of a list that its mode cannot use is ignored, as glTF demands.
void GltfReader::addElements(SoupBuilder& builder, int mode, const std::vector<Index>& v, Index surface) {
    const std::size_t n = v.size();
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        demandGoingOn(meter_, done_ += 3);
        builder.add(std::array{corner(v[a]), corner(v[b]), corner(v[c])}, surface);
    };
    const auto segment = [&](std::size_t a, std::size_t b) {
        builder.addSegment(corner(v[a]), corner(v[b]), surface);
    };
    switch (mode) {
    case TINYGLTF_MODE_POINTS:
        for (Index vertex : v)
            builder.addPoint(corner(vertex), surface);
        break;
    case TINYGLTF_MODE_LINE:
        for (std::size_t i = 0; i + 1 < n; i += 2)
            segment(i, i + 1);
        break;
    case TINYGLTF_MODE_LINE_LOOP:
    case TINYGLTF_MODE_LINE_STRIP:
        for (std::size_t i = 0; i + 1 < n; ++i)
            segment(i, i + 1);
        if (mode == TINYGLTF_MODE_LINE_LOOP && n > 2) segment(n - 1, 0);
        break;
    case TINYGLTF_MODE_TRIANGLE_STRIP:
        for (std::size_t i = 0; i + 2 < n; ++i)
            triangle(i, i + 1 + i % 2, i + 2 - i % 2);
        break;
    case TINYGLTF_MODE_TRIANGLE_FAN:
        for (std::size_t i = 1; i + 1 < n; ++i)
            triangle(0, i, i + 1);
        break;
    case TINYGLTF_MODE_TRIANGLES:
    case -1:
        for (std::size_t i = 0; i + 2 < n; i += 3)
            triangle(i, i + 1, i + 2);
        break;
    default:
        source_.fail("a primitive has the unknown mode " + std::to_string(mode) + "; re-export the file");
    }
}

Index GltfReader::surfaceFor(int material, RawMesh& raw) {
    const bool known = material >= 0 && std::size_t(material) < model_.materials.size();
    const auto [place, isNew] = surfaceOf_.try_emplace(known ? material : -1, Index(raw.surfaces.size()));
    if (!isNew) return place->second;
    Surface surface = namedSurface("surface");
    if (known) {
        const tinygltf::Material& m = model_.materials[std::size_t(material)];
        surface.name = m.name.empty() ? "material " + std::to_string(material) : m.name;
        const std::vector<double>& base = m.pbrMetallicRoughness.baseColorFactor;
        for (std::size_t i = 0; i < 3 && i < base.size(); ++i)
            if (std::isfinite(base[i])) surface.colour[int(i)] = float(std::clamp(base[i], 0.0, 1.0));
    }
    raw.surfaces.push_back(std::move(surface));
    return place->second;
}

} // namespace

LoadedScene readGltf(const Source& source, const Progress& progress) {
    return GltfReader(source, progress).read();
}

} // namespace tactum
