// What is measured: the meshes of a folder, mostly each with its finger, and generated ones in many sizes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/scene/finger_path.h"
#include "core/scene/scene.h"
#include "tests/benchmarks/shapes.h"

namespace CLI {
class App;
}

namespace tactum::bench {

/// Which meshes; the same options in every benchmark.
struct Selection {
    std::filesystem::path folder;  ///< of meshes; empty for none
    bool fingers = true;           ///< of the folder each NAME.obj with a NAME.csv; else all of .obj and .ply
    std::string only;              ///< part of a mesh's name
    std::size_t largest = 1200000; ///< triangles of a generated mesh

    void addOptions(CLI::App& app);
    bool isWanted(const std::string& name) const { return name.find(only) != std::string::npos; }
};

struct Subject {
    std::string name;
    std::filesystem::path file;          ///< empty for a generated one
    std::optional<GeneratedShape> shape; ///< empty for a file
};
std::vector<Subject> subjectsOf(const Selection& selection);

/// A mesh in the scene in which it is measured: proxy of 1 mm, 1000 N/m, smooth.
struct Opened {
    Scene scene;
    std::vector<FingerPoint> finger;
    double loadSeconds = 0; ///< of the mesh's file; 0 for one that was made in memory
};
/// Through a file, also for a generated mesh: opening one is measured too.
Result<Opened> open(const Subject& subject);
/// Without a file where there is none.
Result<Opened> openQuickly(const Subject& subject);
/// The triangles alone, scaled to a diagonal of 0.2 m about the origin. No finger is asked for.
Result<TriangleSoup> meshOf(const Subject& subject);
/// The whole scene as one soup of one surface, in the world frame.
TriangleSoup soupOf(const Scene& scene);

/// Writes each generated mesh as NAME.ply with its finger NAME.csv, so that other programs can be measured on
/// the same. Returns what could not be written.
std::vector<std::filesystem::path> writeSubjects(const Selection& selection,
                                                 const std::filesystem::path& folder);

} // namespace tactum::bench
