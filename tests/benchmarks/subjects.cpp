#include "tests/benchmarks/subjects.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>

#include <CLI/CLI.hpp>

#include "core/files/load_scene.h"
#include "core/files/read_finger_path.h"

namespace tactum::bench {

namespace {

namespace fs = std::filesystem;

constexpr double kStiffnessMeasured = 1000; // N/m

void makeSmooth(Scene& scene) {
    scene.proxyRadius = 1e-3;
    for (SceneObject& object : scene.objects)
        for (Surface& surface : object.surfaces) {
            surface.material = {};
            surface.material.stiffness = kStiffnessMeasured;
        }
}

Result<Opened> openFile(const fs::path& mesh, std::vector<FingerPoint> finger) {
    const auto begin = std::chrono::steady_clock::now();
    auto loaded = loadScene(mesh);
    if (!loaded) return tl::unexpected(loaded.error());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    makeSmooth(loaded->scene);
    return Opened{std::move(loaded->scene), std::move(finger), seconds};
}

Scene sceneOf(TriangleSoup soup) {
    Scene scene;
    SceneObject object;
    object.name = "object";
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    object.surfaces.resize(1);
    scene.add(std::move(object));
    makeSmooth(scene);
    return scene;
}

bool isMesh(const fs::path& file, bool withFinger) {
    if (withFinger) return file.extension() == ".obj" && fs::exists(fs::path(file).replace_extension(".csv"));
    return file.extension() == ".obj" || file.extension() == ".ply";
}

bool writeFinger(const std::vector<FingerPoint>& finger, const fs::path& file) {
    std::string text = "t,x,y,z\n";
    char row[128];
    for (const FingerPoint& p : finger) {
        std::snprintf(row, sizeof row, "%.3f,%.9f,%.9f,%.9f\n", p.t, p.position.x(), p.position.y(),
                      p.position.z());
        text += row;
    }
    std::ofstream out(file, std::ios::binary);
    out << text;
    return bool(out.flush());
}

} // namespace

void Selection::addOptions(CLI::App& app) {
    app.add_option("--folder", folder,
                   fingers ? "meshes NAME.obj, each with its finger NAME.csv" : "meshes NAME.obj or NAME.ply")
        ->check(CLI::ExistingDirectory)
        ->envname("TACTUM_BENCH_MESHES");
    app.add_option("--only", only, "only meshes with this in their name");
    app.add_option("--largest", largest, "most triangles of a generated mesh");
}

std::vector<Subject> subjectsOf(const Selection& selection) {
    std::vector<Subject> subjects;
    if (!selection.folder.empty())
        for (const auto& entry : fs::directory_iterator(selection.folder)) {
            const Subject subject{entry.path().stem().string(), entry.path(), {}};
            if (isMesh(entry.path(), selection.fingers) && selection.isWanted(subject.name))
                subjects.push_back(subject);
        }
    std::ranges::sort(subjects, {}, &Subject::name);
    for (const GeneratedShape& shape : generatedShapes()) {
        const Subject subject{shape.name(), {}, shape};
        if (shape.triangles() <= selection.largest && selection.isWanted(subject.name))
            subjects.push_back(subject);
    }
    return subjects;
}

Result<Opened> open(const Subject& subject) {
    if (!subject.shape) {
        auto finger = readFingerPath(fs::path(subject.file).replace_extension(".csv"));
        if (!finger) return tl::unexpected(finger.error());
        return openFile(subject.file, std::move(*finger));
    }
    const fs::path file = fs::temp_directory_path() / ("tactum-bench-" + subject.name + ".ply");
    if (!writePly(soupOf(*subject.shape), file))
        return machineError(file.string() + " cannot be written; make room there");
    auto opened = openFile(file, fingerOver(subject.shape->family));
    fs::remove(file);
    return opened;
}

Result<Opened> openQuickly(const Subject& subject) {
    if (!subject.shape) return open(subject);
    return Opened{sceneOf(soupOf(*subject.shape)), fingerOver(subject.shape->family), 0};
}

TriangleSoup soupOf(const Scene& scene) {
    TriangleSoup all;
    for (const SceneObject& object : scene.objects) {
        const Index first = Index(all.positions.size());
        for (const Vec3& p : object.geometry->positions)
            all.positions.push_back(object.pose.apply(p));
        for (const auto& t : object.geometry->triangles)
            all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
    all.surfaceOf.assign(all.triangles.size(), 0);
    return all;
}

Result<TriangleSoup> meshOf(const Subject& subject) {
    if (subject.shape) return soupOf(*subject.shape);
    auto loaded = loadScene(subject.file);
    if (!loaded) return tl::unexpected(loaded.error());
    fitDiagonal(loaded->scene, kHandDiagonal);
    return soupOf(loaded->scene);
}

std::vector<fs::path> writeSubjects(const Selection& selection, const fs::path& folder) {
    std::vector<fs::path> failed;
    for (const Subject& subject : subjectsOf(selection)) {
        if (!subject.shape) continue;
        const fs::path mesh = folder / (subject.name + ".ply"), finger = folder / (subject.name + ".csv");
        if (!writePly(soupOf(*subject.shape), mesh)) failed.push_back(mesh);
        if (!writeFinger(fingerOver(subject.shape->family), finger)) failed.push_back(finger);
    }
    return failed;
}

} // namespace tactum::bench
