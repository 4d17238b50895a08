#include "core/files/gltf/gltf_mesh.h"

#include <cstring>
#include <optional>

#include "core/base/text.h"
#include "core/files/gltf/gltf_surface.h"
#include "core/files/readers.h"
#include "core/scene/selection_sets.h"

namespace tactum {

/// What our extension of a mesh holds beside the vertices that are drawn (drawn_mesh.h); empty where they say
/// all.
struct GltfMeshReader::Exact {
    bool ours = false;
    std::vector<int> materials;
    std::vector<Vec3> positions;
    std::vector<Index> copies, order;
    std::vector<Eigen::Vector2f> uvs;
};

namespace {

constexpr const char* kUnfit = " does not fit the mesh, which is read as other programs do";

std::string whereIsMesh(int mesh) {
    return "meshes[" + std::to_string(mesh) + "]." + kExtension;
}

/// About how many vertices and indices there are to read.
std::size_t elementsOf(const tinygltf::Model& model) {
    std::size_t count = 0;
    for (const tinygltf::Accessor& accessor : model.accessors)
        count += std::min(accessor.count, kMaxGltfTriangles);
    return count;
}

bool isPermutation(const std::vector<Index>& order) {
    std::vector<char> seen(order.size(), 0);
    for (const Index i : order)
        if (i >= order.size() || std::exchange(seen[i], 1)) return false;
    return true;
}

/// Whether these can be the positions that were drawn in single precision.
bool areNear(const std::vector<Vec3>& exact, const GltfAccessor& drawn) {
    constexpr double kSingle = 1e-6;
    double size = 0, apart = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const Vec3 p(drawn.number(i, 0), drawn.number(i, 1), drawn.number(i, 2));
        if (!isCoordinate(exact[i].x()) || !isCoordinate(exact[i].y()) || !isCoordinate(exact[i].z()))
            return false;
        size = std::max(size, exact[i].cwiseAbs().maxCoeff());
        apart = std::max(apart, (p - exact[i]).cwiseAbs().maxCoeff());
    }
    return apart <= kSingle * size;
}

template <class T> void reorder(std::vector<T>& values, const std::vector<Index>& order, std::size_t each) {
    if (values.empty()) return;
    std::vector<T> sorted(values.size());
    for (std::size_t drawn = 0; drawn < order.size(); ++drawn)
        for (std::size_t i = 0; i < each; ++i)
            sorted[order[drawn] * each + i] = values[drawn * each + i];
    values = std::move(sorted);
}

} // namespace

GltfMeshReader::GltfMeshReader(const Source& source, const GltfFile& file, const tinygltf::Model& model,
                               const Progress& progress)
    : source_(source), file_(file), model_(model), meter_(progress, elementsOf(model)) {}

void GltfMeshReader::countTriangles(std::size_t more) {
    triangles_ += more;
    if (triangles_ > kMaxGltfTriangles)
        source_.fail("has more than 67 million triangles with all its copies; split or simplify it");
}

RawMesh GltfMeshReader::read(int index) {
    RawMesh raw;
    pools_ = {};
    paints_.clear();
    paintsAreRight_ = true;
    shared_.clear();
    surfaceOf_.clear();
    const tinygltf::Mesh& mesh = model_.meshes[std::size_t(index)];
    Exact exact = exactOf(index, raw.complaints);
    exact_ = &exact;
    for (const int material : exact.materials)
        surfaceFor(material, raw);
    SoupBuilder builder(pools_);
    for (const tinygltf::Primitive& primitive : mesh.primitives)
        readPrimitive(primitive, raw, builder);
    if (!exact.order.empty() && exact.order.size() != builder.triangles()) {
        raw.complaints.push_back(whereIsMesh(index) + ".order" + kUnfit);
        exact.order.clear();
    }
    std::vector<Vec3> positions = std::move(pools_.positions);
    if (exact.ours) positions.resize(positions.size() - exact.copies.size());
    if (!exact.positions.empty()) positions = exact.positions;
    pools_.positions = positions; // missing normals are computed from them
    raw.soup = builder.finish(std::move(positions), raw.report);
    addPaints(raw);
    if (!paintsAreRight_)
        raw.complaints.push_back("what is painted on meshes[" + std::to_string(index) +
                                 "] is not a number from 0 to 1 for each vertex");
    if (exact.ours) raw.sets = setsOf(index, raw.soup.triangles.size(), raw.complaints);
    if (exact.order.empty()) return raw;
    reorder(raw.soup.triangles, exact.order, 1);
    reorder(raw.soup.surfaceOf, exact.order, 1);
    reorder(raw.soup.cornerNormals, exact.order, 3);
    reorder(raw.soup.cornerUvs, exact.order, 3);
    return raw;
}

template <class T>
std::vector<T> GltfMeshReader::rawView(const Json& object, const char* key, bool& fits) const {
    if (!object.contains(key)) return {};
    const int index = indexIn(object, key, model_.bufferViews.size());
    const tinygltf::BufferView* view = index < 0 ? nullptr : &model_.bufferViews[std::size_t(index)];
    if (!view || view->byteLength % sizeof(T) != 0) {
        fits = false;
        return {};
    }
    std::vector<T> values(view->byteLength / sizeof(T));
    std::memcpy(static_cast<void*>(values.data()),
                model_.buffers[std::size_t(view->buffer)].data.data() + view->byteOffset, view->byteLength);
    return values;
}

/// Another program may have changed the mesh and kept our extension: then it no longer fits, and does not
/// count.
GltfMeshReader::Exact GltfMeshReader::exactOf(int mesh, std::vector<std::string>& complaints) const {
    const Json* ours = extensionOf(file_.json["meshes"][std::size_t(mesh)]);
    const tinygltf::Mesh& drawn = model_.meshes[std::size_t(mesh)];
    if (!ours || drawn.primitives.empty()) return {};
    const std::string where = whereIsMesh(mesh);
    const auto position = drawn.primitives[0].attributes.find("POSITION");
    const bool alike = std::ranges::all_of(drawn.primitives, [&](const tinygltf::Primitive& primitive) {
        return primitive.attributes == drawn.primitives[0].attributes;
    });
    if (position == drawn.primitives[0].attributes.end() || !alike) {
        complaints.push_back(where + " is of other primitives than those of its mesh");
        return {};
    }
    const GltfAccessor vertices(source_, model_, position->second, 3);
    Exact exact;
    const std::size_t before = complaints.size();
    const auto take = [&](auto& values, const char* key, const auto& isRight) {
        bool fits = true;
        values = rawView<typename std::decay_t<decltype(values)>::value_type>(*ours, key, fits);
        if (!fits || !(values.empty() || isRight())) complaints.push_back(where + "." + key + kUnfit);
    };
    std::size_t positions = vertices.size();
    take(exact.copies, "copies", [&] {
        positions -= std::min(exact.copies.size(), positions);
        return std::ranges::all_of(exact.copies, [&](Index i) { return i < positions; });
    });
    take(exact.order, "order", [&] { return isPermutation(exact.order); });
    take(exact.uvs, "uvs", [&] { return exact.uvs.size() == vertices.size(); });
    take(exact.positions, "positions",
         [&] { return exact.positions.size() == positions && areNear(exact.positions, vertices); });
    if (complaints.size() > before) return {};
    exact.ours = true;
    exact.materials = surfacesIn(*ours, where, complaints);
    return exact;
}

/// Those that fit; of a mesh that has other triangles now, none.
std::vector<NamedTriangles> GltfMeshReader::setsOf(int mesh, std::size_t triangles,
                                                   std::vector<std::string>& complaints) const {
    const Json* all = extensionOf(file_.json["meshes"][std::size_t(mesh)]);
    const Json* ours = all ? member(*all, "sets") : nullptr;
    if (!ours) return {};
    const Json* parts = member(*ours, "parts");
    const Json* of = member(*ours, "of");
    const std::string unfit = !of || !of->is_number_integer() || !parts || !parts->is_array() ? " is damaged"
                              : *of != triangles         ? " is of a mesh of other triangles"
                              : parts->size() > kMaxSets ? " has more than " + counted(kMaxSets, "set")
                                                         : "";
    if (!unfit.empty()) complaints.push_back(whereIsMesh(mesh) + ".sets" + unfit);
    std::map<std::string, TriangleRanges> sets;
    std::size_t count = 0;
    const auto take = [&](const Json& part) {
        const Json* name = part.is_object() ? member(part, "name") : nullptr;
        if (!name || !name->is_string() || !part.contains("ranges")) return false;
        bool isWhole = true;
        auto ranges = rawView<TriangleRange>(part, "ranges", isWhole);
        const std::string shown = printable(name->get<std::string>(), kLongestName);
        if (!isWhole || trimmed(shown).empty() || ranges.empty() || !areTriangleRanges(ranges, triangles))
            return false;
        count += ranges.size();
        return count <= mostRanges(triangles) && sets.emplace(shown, std::move(ranges)).second;
    };
    std::size_t wrong = 0;
    for (const Json& part : unfit.empty() ? *parts : Json::array())
        wrong += !take(part);
    if (wrong > 0)
        complaints.push_back(whereIsMesh(mesh) + ".sets has " + counted(wrong, "set") +
                             " without a name of its own or that is no list of triangles");
    std::vector<NamedTriangles> rising;
    for (auto& [name, ranges] : sets)
        rising.push_back({name, std::move(ranges)});
    return rising;
}

std::vector<int> GltfMeshReader::surfacesIn(const Json& ours, const std::string& where,
                                            std::vector<std::string>& complaints) const {
    std::vector<int> materials;
    const Json* surfaces = member(ours, "surfaces");
    if (!surfaces) return materials;
    bool fits = surfaces->is_array();
    for (const Json& each : fits ? *surfaces : Json::array()) {
        const int material = indexIn(Json{{"i", each}}, "i", model_.materials.size());
        if (material < 0 || std::ranges::find(materials, material) != materials.end())
            fits = false;
        else
            materials.push_back(material);
    }
    if (!fits) complaints.push_back(where + ".surfaces is not a list of different materials of the file");
    return materials;
}

void GltfMeshReader::readPrimitive(const tinygltf::Primitive& primitive, RawMesh& raw, SoupBuilder& builder) {
    if (!primitive.attributes.count("POSITION")) return; // glTF: to be ignored
    const Vertices& vertices = verticesOf(primitive);
    const std::vector<Index> indices = indicesOf(primitive, vertices);
    countTriangles(indices.size());
    addElements(builder, primitive.mode, indices, vertices, surfaceFor(primitive.material, raw));
}

const GltfMeshReader::Vertices& GltfMeshReader::verticesOf(const tinygltf::Primitive& primitive) {
    const auto accessor = [&](const char* name) {
        const auto found = primitive.attributes.find(name);
        return found == primitive.attributes.end() ? -1 : found->second;
    };
    const auto [found, isNew] =
        shared_.try_emplace({accessor("POSITION"), accessor("NORMAL"), accessor("TEXCOORD_0")});
    if (isNew) found->second = readVertices(primitive);
    return found->second;
}

/// Appends the vertices of a primitive to the pools.
GltfMeshReader::Vertices GltfMeshReader::readVertices(const tinygltf::Primitive& primitive) {
    const auto attribute = [&](const char* name, std::size_t components) -> std::optional<GltfAccessor> {
        const auto found = primitive.attributes.find(name);
        if (found == primitive.attributes.end()) return std::nullopt;
        return GltfAccessor(source_, model_, found->second, components);
    };
    const auto positions = attribute("POSITION", 3);
    const auto normals = attribute("NORMAL", 3);
    const auto uvs = attribute("TEXCOORD_0", 2);
    const std::size_t first = pools_.positions.size(), count = positions->size();
    if (first + count > kMaxGltfTriangles)
        source_.fail("has more than 67 million vertices; split or simplify it");
    const Vertices vertices{Index(first), Index(count), normals && normals->size() >= count,
                            uvs && uvs->size() >= count};
    for (std::size_t i = 0; i < count; ++i) {
        demandGoingOn(meter_, ++done_);
        const Vec3 p(positions->number(i, 0), positions->number(i, 1), positions->number(i, 2));
        if (const std::string wrong = complaintOfPlace(p); !wrong.empty())
            source_.fail("coordinate of vertex " + std::to_string(i) + wrong);
        pools_.positions.push_back(p);
    }
    pools_.normals.resize(first + count, Eigen::Vector3f::Zero());
    pools_.uvs.resize(first + count, Eigen::Vector2f::Zero());
    for (std::size_t i = 0; vertices.normals && i < count; ++i)
        pools_.normals[first + i] =
            Vec3(normals->number(i, 0), normals->number(i, 1), normals->number(i, 2)).cast<float>();
    for (std::size_t i = 0; vertices.uvs && i < count; ++i) // v counts downward there, upward here
        pools_.uvs[first + i] = Eigen::Vector2d(uvs->number(i, 0), 1 - uvs->number(i, 1)).cast<float>();
    if (!exact_->uvs.empty()) pools_.uvs = exact_->uvs;
    readPaints(primitive, vertices);
    return vertices;
}

/// Another program may have changed the mesh; as long as it keeps the attributes, what is painted stays on
/// it.
void GltfMeshReader::readPaints(const tinygltf::Primitive& primitive, const Vertices& vertices) {
    for (const auto& [name, accessor] : primitive.attributes) {
        const int number = paintNumber(name);
        if (number < 0) continue;
        painted_ += vertices.count;
        const GltfAccessor values(source_, model_, accessor, 1);
        if (painted_ > kMaxPaintedValues || values.size() < vertices.count) {
            paintsAreRight_ = false;
            continue;
        }
        std::vector<float>& all = paints_[number];
        all.resize(vertices.first, 0);
        for (std::size_t i = 0; i < vertices.count; ++i) {
            const double value = values.number(i, 0);
            paintsAreRight_ &= value >= 0 && value <= 1;
            all.push_back(float(value));
        }
    }
}

/// Vertices without the attribute are not painted.
void GltfMeshReader::addPaints(RawMesh& raw) {
    for (auto& [number, values] : paints_) {
        values.resize(raw.soup.positions.size(), 0);
        raw.paints[number] = std::make_shared<const PaintedValues>(std::move(values));
    }
}

std::vector<Index> GltfMeshReader::indicesOf(const tinygltf::Primitive& primitive,
                                             const Vertices& vertices) const {
    std::vector<Index> indices;
    if (primitive.indices < 0) {
        indices.resize(vertices.count);
        for (Index i = 0; i < vertices.count; ++i)
            indices[i] = vertices.first + i;
        return indices;
    }
    const GltfAccessor accessor(source_, model_, primitive.indices, 1);
    if (!accessor.isUnsigned())
        source_.fail("has indices that are not unsigned whole numbers; re-export the file");
    indices.reserve(accessor.size());
    for (std::size_t i = 0; i < accessor.size(); ++i) {
        const std::uint32_t vertex = accessor.integer(i);
        if (vertex >= vertices.count)
            source_.fail("index " + std::to_string(i) + " refers to vertex " + std::to_string(vertex) +
                         ", but only " + std::to_string(vertices.count) +
                         " are defined (from 0); re-export the file");
        indices.push_back(vertices.first + vertex);
    }
    return indices;
}

Index GltfMeshReader::positionOf(Index vertex) const {
    if (!exact_->ours) return vertex;
    const std::size_t positions = pools_.positions.size() - exact_->copies.size();
    return vertex < positions ? vertex : exact_->copies[vertex - positions];
}

/// What is left over at the end of a list that its mode cannot use is ignored, as glTF demands.
void GltfMeshReader::addElements(SoupBuilder& builder, int mode, const std::vector<Index>& v,
                                 const Vertices& from, Index surface) {
    const std::size_t n = v.size();
    const auto corner = [&](std::size_t i) {
        return PolygonCorner{positionOf(v[i]), from.normals ? v[i] : kNone, from.uvs ? v[i] : kNone};
    };
    const auto triangle = [&](std::size_t a, std::size_t b, std::size_t c) {
        demandGoingOn(meter_, done_ += 3);
        builder.add(std::array{corner(a), corner(b), corner(c)}, surface);
    };
    const auto segment = [&](std::size_t a, std::size_t b) {
        builder.addSegment(corner(a), corner(b), surface);
    };
    switch (mode) {
    case TINYGLTF_MODE_POINTS:
        for (std::size_t i = 0; i < n; ++i)
            builder.addPoint(corner(i), surface);
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

/// The first of several surfaces that have one material.
Index GltfMeshReader::surfaceFor(int material, RawMesh& raw) {
    const bool known = material >= 0 && std::size_t(material) < model_.materials.size();
    const int of = known ? material : -1;
    const auto [place, isNew] = surfaceOf_.try_emplace(of, Index(raw.materials.size()));
    if (isNew) raw.materials.push_back(of);
    return place->second;
}

} // namespace tactum
