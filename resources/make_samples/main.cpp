// Writes the sample scenes, a picture of each, a moving one of how it is touched, what its finger must feel,
// and the teapot as a bare mesh: make-samples FOLDER; those whose bodies move go into its folder "moving".
// resources/scenes holds what this program writes; a test compares them.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "core/bundle/preview.h"
#include "core/files/gltf/write_gltf.h"
#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "resources/make_samples/moving_picture.h"
#include "resources/make_samples/samples.h"

namespace tactum::samples {

std::vector<Sample> allSamples() {
    return {{"teapot", teapot()},
            {"friction-ladder", frictionLadder()},
            {"viscosity-ladder", viscosityLadder()},
            {"stiffness-ladder", stiffnessLadder()},
            {"texture-wall", textureWall()},
            {"layered-leather", layeredLeather()},
            {"relief-coin", reliefCoin()},
            {"thin-wall-maze", thinWallMaze()},
            {"blind-box", blindBox()},
            {"windmill", windmill()},
            {"crank", crank()},
            {"turntable", turntable()},
            {"rocket-car", rocketCar()},
            {"roller-coaster", rollerCoaster()},
            {"cabinet", cabinet()},
            {"keyboard", keyboard()},
            {"kettle", kettle()},
            {"micro-sensor", microSensor()},
            {"ball-table", ballTable()},
            {"dominoes", dominoes()},
            {"bell", bell()},
            {"marionette", marionette()}};
}

} // namespace tactum::samples

namespace {

bool write(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream out(file, std::ios::binary);
    out << bytes;
    return out.flush().good();
}

/// What the finger of a scene must feel, in columns that are called as in the forces.csv of a bundle: no path
/// of a finger. To a tenth of a micronewton.
std::string forcesOf(const tactum::Scene& scene) {
    std::vector<tactum::FingerPoint> forces;
    if (const auto world = tactum::compile(scene))
        for (const tactum::TouchRow& row : tactum::replay(**world, *scene.finger))
            forces.push_back({row.t, (row.force * 1e7).array().round() / 1e7 + 0.0});
    const std::string rows = tactum::fingerCsv(forces);
    return "t_s,force_x_N,force_y_N,force_z_N" + rows.substr(rows.find('\n'));
}

bool noted(const tactum::samples::Sample& sample, const tactum::Result<void>& result) {
    if (!result) std::cerr << "make-samples: " << sample.name << ": " << result.error().text << "\n";
    return result.has_value();
}

/// The scene, its pictures and its forces.
bool write(const std::filesystem::path& folder, const tactum::samples::Sample& sample) {
    const auto glb = tactum::glbOf(sample.scene);
    if (!glb) return noted(sample, tl::unexpected(glb.error()));
    return write(folder / (sample.name + ".glb"), *glb) &&
           write(folder / (sample.name + ".png"), tactum::previewOf(sample.scene, 320, 240)) &&
           write(folder / (sample.name + ".csv"), forcesOf(sample.scene)) &&
           noted(sample, tactum::samples::writeMovingPicture(sample.scene, folder / (sample.name + ".gif")));
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: make-samples FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    bool good = tactum::samples::writeTeapotFiles(folder);
    std::error_code fault;
    std::filesystem::create_directories(folder / "moving", fault);
    for (const tactum::samples::Sample& sample : tactum::samples::allSamples())
        good = good && write(sample.scene.mechanics.bodies.empty() ? folder : folder / "moving", sample);
    if (good) return 0;
    std::cerr << "make-samples: cannot write into " << folder
              << "; check the folder and the space on its disk\n";
    return 3;
}
