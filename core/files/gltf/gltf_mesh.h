// The meshes of a glTF file as triangle soups.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/files/gltf/gltf_model.h"
#include "core/geometry/soup_builder.h"
#include "core/scene/scene.h"
#include "core/surface/painted_values.h"

namespace tactum {

/// A mesh of the file as it is before any transform.
struct RawMesh {
    TriangleSoup soup;
    std::vector<int> materials; ///< of each surface; -1 for none
    std::vector<NamedTriangles> sets;
    /// What is painted on it, by the numbers of the attributes; as many values as positions.
    std::map<int, std::shared_ptr<const PaintedValues>> paints;
    BuildReport report;
    std::vector<std::string> complaints; ///< a sentence for each thing in our extension that does not fit
};

/// A small file can name one mesh very often.
inline constexpr std::size_t kMaxGltfTriangles = std::size_t(1) << 26;

/// Thread: any but real time.
class GltfMeshReader {
public:
    GltfMeshReader(const Source& source, const GltfFile& file, const tinygltf::Model& model,
                   const Progress& progress);

    /// Primitives of one material are one surface; those that share their vertices share them in the soup
    /// too. Where our extension holds what single precision and drawing lose, the soup is exactly the one
    /// that was written. Throws ReadFault.
    RawMesh read(int mesh);
    /// Counts triangles of a mesh that is there once more. Throws ReadFault when they are too many.
    void countTriangles(std::size_t more);

private:
    struct Vertices {
        Index first = 0, count = 0;
        bool normals = false, uvs = false;
    };
    struct Exact;

    Exact exactOf(int mesh, std::vector<std::string>& complaints) const;
    std::vector<NamedTriangles> setsOf(int mesh, std::size_t triangles,
                                       std::vector<std::string>& complaints) const;
    std::vector<int> surfacesIn(const Json& ours, const std::string& where,
                                std::vector<std::string>& complaints) const;
    /// Of a kind that is not T: empty, and `fits` becomes false.
    template <class T> std::vector<T> rawView(const Json& object, const char* key, bool& fits) const;
    void readPrimitive(const tinygltf::Primitive& primitive, RawMesh& raw, SoupBuilder& builder);
    const Vertices& verticesOf(const tinygltf::Primitive& primitive);
    Vertices readVertices(const tinygltf::Primitive& primitive);
    std::vector<Index> indicesOf(const tinygltf::Primitive& primitive, const Vertices& vertices) const;
    void addElements(SoupBuilder& builder, int mode, const std::vector<Index>& indices, const Vertices& from,
                     Index surface);
    void readPaints(const tinygltf::Primitive& primitive, const Vertices& vertices);
    void addPaints(RawMesh& raw);
    Index positionOf(Index vertex) const;
    Index surfaceFor(int material, RawMesh& raw);

    const Source& source_;
    const GltfFile& file_;
    const tinygltf::Model& model_;
    ProgressMeter meter_;
    std::size_t done_ = 0, triangles_ = 0, painted_ = 0;
    // Of the mesh being read.
    VertexPools pools_;
    std::map<int, std::vector<float>> paints_; ///< by number, for each vertex in the pools
    bool paintsAreRight_ = true;
    std::map<std::array<int, 3>, Vertices> shared_; ///< by accessors of positions, normals and coordinates
    std::map<int, Index> surfaceOf_;
    const Exact* exact_ = nullptr;
};

} // namespace tactum
