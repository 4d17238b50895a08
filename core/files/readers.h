// The reader of each format, and what they share. For this folder only: others call loadScene().
#pragma once

#include "core/files/load_scene.h"
#include "core/files/source.h"
#include "core/geometry/mesh_health.h"
#include "core/geometry/soup_builder.h"

namespace tactum {

/// One reader: the scene of a file. Throws ReadFault at the first fault.
LoadedScene readObj(const Source& source, const Progress& progress);
LoadedScene readPly(const Source& source, const Progress& progress);
LoadedScene readStl(const Source& source, const Progress& progress);
LoadedScene readOff(const Source& source, const Progress& progress);
LoadedScene readGltf(const Source& source, const Progress& progress); ///< glb as well
LoadedScene readBundle(const Source& source, const Progress& progress);
LoadedScene readX3d(const Source& source, const Progress& progress);
LoadedScene read3mf(const Source& source, const Progress& progress);
LoadedScene readAssimp(const Source& source, const Progress& progress); ///< 3ds, fbx and dae

/// Adds an object: makes its soup fit for touching, and says in the findings what was done or is doubtful.
/// Surface names and the object's are made printable. Throws ReadFault when cancelled.
void addObject(LoadedScene& loaded, std::string name, const BuildReport& report, TriangleSoup soup,
               std::vector<Surface> surfaces, const Progress& progress);

/// What a file may show before anything of it is built: a few lines can ask for any number of copies.
inline constexpr std::size_t kMaxShownMeshes = 30'000;
inline constexpr std::uint64_t kMaxShownTriangles = std::uint64_t(1) << 26;
inline constexpr std::size_t kMaxCorners = 100'000; ///< of one face
/// Throws ReadFault where there is more.
void demandBounded(const Source& source, std::size_t meshes, std::uint64_t triangles);
/// What is wrong with a coordinate of a place, behind what it is of, and the remedy; empty when it is fine.
std::string complaintOfPlace(const Vec3& p);
/// For a face as a sentence of its own; empty when it is fine.
std::string complaintOfCorners(std::size_t corners);

/// What is said of a file with vertices alone.
Finding noteOfCloud(std::size_t points);

/// A surface with the initial material.
Surface namedSurface(std::string name);
/// The name for an object that has none: that of the file without its ending.
std::string stemOf(const Source& source);

} // namespace tactum
