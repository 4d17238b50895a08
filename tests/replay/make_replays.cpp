// Writes the recordings of this folder anew: make-replays FOLDER.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "core/recording/recording_file.h"
#include "tests/core/recording/hand_made_run.h"
#include "tests/realtime/bumpy_scene.h"

using namespace tactum;

namespace {

/// Few bumps, in the reach of wanderingFinger(), with everything that a surface can have. Nothing in it needs
/// a sine or an exponential, which not every C library rounds alike.
Scene fewBumps() {
    constexpr int kSide = 12;
    TriangleSoup soup;
    unsigned random = 1;
    for (int i = 0; i <= kSide; ++i)
        for (int k = 0; k <= kSide; ++k) {
            random = random * 1664525u + 1013904223u;
            const double height = kBumpHeight * (double(random >> 16) / 65536 - 0.5);
            soup.positions.push_back({2 * kBumpyHalfWidth * (double(i) / kSide - 0.5),
                                      2 * kBumpyHalfWidth * (double(k) / kSide - 0.5), height});
        }
    for (Index i = 0; i < kSide; ++i)
        for (Index k = 0; k < kSide; ++k) {
            const Index a = i * (kSide + 1) + k, b = a + kSide + 1;
            soup.triangles.insert(soup.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
            soup.surfaceOf.insert(soup.surfaceOf.end(), {k < kSide / 2 ? 0u : 1u, k < kSide / 2 ? 0u : 1u});
        }
    Scene scene;
    SceneObject object;
    object.name = "few bumps";
    object.geometry = std::make_shared<const TriangleSoup>(std::move(soup));
    object.surfaces.resize(2);
    object.surfaces[0].name = "rough";
    object.surfaces[0].material = {600, 1, 0.5, 0.3, 1};
    object.surfaces[1].name = "round";
    object.surfaces[1].material = {900, 0, 0.2, 0.15, 0};
    object.surfaces[1].shading.on = true;
    scene.add(std::move(object));
    return scene;
}

} // namespace

int main(int argc, char** argv) {
    const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
    const std::filesystem::path file = folder / ("few-bumps." + std::string(kRecordingEnding));
    const std::string bytes =
        recordingBytes({handMadeRun(400, fewBumps()), "a stroke over few bumps, rough and round", {}});
    std::ofstream out(file, std::ios::binary);
    out.write(bytes.data(), std::streamsize(bytes.size()));
    out.close();
    std::printf("%s %zu bytes\n", file.c_str(), bytes.size());
    return out ? 0 : 3;
}
