// Writes scenes as X3D for other programs to read: make-x3d FOLDER COUNT [SCENE ...]. COUNT random scenes,
// and those of the files. docs/testing.md says how to use it.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/files/load_scene.h"
#include "core/files/x3d/write_x3d.h"
#include "tests/core/files/x3d_scenes.h"

using namespace tactum;

namespace {

void write(const std::filesystem::path& file, const std::string& bytes) {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << bytes;
}

void writeAll(const std::filesystem::path& folder, const Scene& scene) {
    const X3dExport written = x3dOf(scene);
    write(folder / "scene.x3d", written.scene);
    write(folder / "deviceinfo.x3d", written.device);
    for (const X3dImage& image : written.images)
        write(folder / image.name, image.bytes);
    write(folder / "report.md", reportMarkdown(written.losses));
    write(folder / "report.json", reportJson(written.losses));
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    const std::filesystem::path folder = argv[1];
    const int count = std::atoi(argv[2]);
    for (int i = 0; i < count; ++i) {
        test::Rng rng{std::uint64_t(i)};
        writeAll(folder / ("random-" + std::to_string(i)), test::randomHapticScene(rng));
    }
    for (int i = 3; i < argc; ++i) {
        const auto loaded = loadScene(argv[i]);
        if (!loaded) {
            std::cerr << loaded.error().text << '\n';
            return 1;
        }
        writeAll(folder / std::filesystem::path(argv[i]).stem(), loaded->scene);
    }
}
