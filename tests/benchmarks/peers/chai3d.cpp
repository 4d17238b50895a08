// The finger proxy of CHAI3D 3.3 on the meshes and fingers of our benchmark, measured as bench_haptics
// measures ours. Not built by this project; docs/performance.md says how.
//
// chai3d FOLDER/NAME [--paced]: reads NAME.ply (binary, as `bench_haptics --write` makes it) or NAME.obj, and
// NAME.csv; prints one line of JSON. --paced: one update a millisecond, as bench-pace does it.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <sched.h>
#include <unistd.h>

#include "chai3d.h"

namespace {

constexpr double kRadius = 1e-3, kStiffness = 1000;
constexpr int kRepetitions = 5, kPacedRepetitions = 2;
constexpr std::size_t kPacedRows = 4000;

struct Mesh {
    std::vector<std::array<double, 3>> positions;
    std::vector<std::array<int, 3>> triangles;
};

Mesh readObj(std::ifstream& in) {
    Mesh mesh;
    for (std::string line, word; std::getline(in, line);) {
        std::istringstream words(line);
        words >> word;
        if (word == "v") {
            auto& p = mesh.positions.emplace_back();
            words >> p[0] >> p[1] >> p[2];
        } else if (word == "f") {
            std::vector<int> corners;
            while (words >> word)
                corners.push_back(std::stoi(word) - 1);
            for (std::size_t i = 2; i < corners.size(); ++i)
                mesh.triangles.push_back({corners[0], corners[i - 1], corners[i]});
        }
    }
    return mesh;
}

Mesh readPly(std::ifstream& in) {
    Mesh mesh;
    for (std::string line; std::getline(in, line) && line != "end_header";) {
        if (line.rfind("element vertex", 0) == 0) mesh.positions.resize(std::stoul(line.substr(15)));
        if (line.rfind("element face", 0) == 0) mesh.triangles.resize(std::stoul(line.substr(13)));
    }
    for (auto& p : mesh.positions) {
        float v[3];
        in.read(reinterpret_cast<char*>(v), sizeof v);
        p = {v[0], v[1], v[2]};
    }
    for (auto& t : mesh.triangles) {
        in.ignore(1); // how many corners
        in.read(reinterpret_cast<char*>(t.data()), sizeof t);
    }
    return mesh;
}

Mesh read(const std::string& base) {
    if (std::ifstream obj(base + ".obj"); obj) return readObj(obj);
    std::ifstream ply(base + ".ply", std::ios::binary);
    return readPly(ply);
}

std::vector<chai3d::cVector3d> fingerOf(const std::string& base) {
    std::vector<chai3d::cVector3d> finger;
    std::ifstream in(base + ".csv");
    std::string line;
    for (std::getline(in, line); std::getline(in, line);) {
        double t, x, y, z;
        if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &t, &x, &y, &z) == 4) finger.emplace_back(x, y, z);
    }
    return finger;
}

void useTheLastCore() {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(sysconf(_SC_NPROCESSORS_ONLN) - 1, &set);
    sched_setaffinity(0, sizeof set, &set);
}

chai3d::cWorld* worldOf(const Mesh& mesh) {
    auto* world = new chai3d::cWorld();
    auto* body = new chai3d::cMesh();
    world->addChild(body);
    for (const auto& p : mesh.positions)
        body->newVertex(p[0], p[1], p[2]);
    for (const auto& t : mesh.triangles)
        body->newTriangle(unsigned(t[0]), unsigned(t[1]), unsigned(t[2]));
    body->setUseCulling(false);
    body->m_material->setStiffness(kStiffness);
    body->createAABBCollisionDetector(kRadius);
    world->computeGlobalPositions(true);
    return world;
}

// Each row at its fastest, us.
std::vector<double> replay(chai3d::cWorld* world, const std::vector<chai3d::cVector3d>& finger, bool paced) {
    std::vector<double> best(finger.size(), 1e300);
    for (int repetition = 0; repetition < (paced ? kPacedRepetitions : kRepetitions); ++repetition) {
        chai3d::cAlgorithmFingerProxy proxy;
        proxy.setProxyRadius(kRadius);
        proxy.initialize(world, finger.front());
        auto due = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < finger.size(); ++i) {
            if (paced) std::this_thread::sleep_until(due += std::chrono::milliseconds(1));
            const auto from = std::chrono::steady_clock::now();
            proxy.computeForces(finger[i], chai3d::cVector3d(0, 0, 0));
            const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - from;
            best[i] = std::min(best[i], took.count());
        }
    }
    return best;
}

} // namespace

int main(int argc, char** argv) {
    const bool paced = argc == 3 && argv[2] == std::string("--paced");
    if (argc != 2 && !paced) return std::fputs("chai3d FOLDER/NAME [--paced]\n", stderr), 2;
    useTheLastCore();
    const std::string base = argv[1];
    const Mesh mesh = read(base);
    auto finger = fingerOf(base);
    if (paced && finger.size() > kPacedRows) finger.resize(kPacedRows);
    if (mesh.triangles.empty() || finger.empty())
        return std::fprintf(stderr, "%s: no mesh or no finger\n", argv[1]), 1;
    std::vector<double> times = replay(worldOf(mesh), finger, paced);
    double sum = 0;
    for (const double t : times)
        sum += t;
    std::sort(times.begin(), times.end());
    const auto at = [&](double part) {
        return times[std::min(times.size() - 1, std::size_t(part * double(times.size())))];
    };
    std::printf(
        "{\"mesh\": \"%s\", \"triangles\": %zu, \"mean_us\": %.2f, \"median_us\": %.2f, \"p999_us\": %.1f, "
        "\"max_us\": %.1f}\n",
        base.substr(base.rfind('/') + 1).c_str(), mesh.triangles.size(), sum / double(times.size()), at(0.5),
        at(0.999), times.back());
}
