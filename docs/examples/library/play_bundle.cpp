// Plays the finger path of a bundle through Tactum's haptics and compares what it feels with what it must
// feel:
//
//     play_bundle teapot.tactum
//
// This is all that a renderer needs of the library: a scene, a World made of it, and one step for each
// position of the finger.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include <tactum/scene.h>
#include <tactum/world.h>

namespace {

double length(const tactum::Vec3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

int play(const char* file) {
    const tactum::Bundle bundle = tactum::openBundle(file);
    tactum::World world(bundle.scene);
    double before = bundle.finger.front().t - 1e-3; // s
    world.restart(before);              // bodies that move by themselves are where that time puts them
    double largest = 0, difference = 0; // N
    for (std::size_t i = 0; i < bundle.finger.size(); ++i) {
        const tactum::FingerPoint& finger = bundle.finger[i];
        const tactum::Vec3 force = world.step(finger.position, finger.t - before).force;
        const tactum::Vec3& expected = bundle.forces[i];
        largest = std::max(largest, length(force));
        difference =
            std::max(difference, length({force.x - expected.x, force.y - expected.y, force.z - expected.z}));
        before = finger.t;
    }
    std::printf("%zu steps, largest force %.6g N, largest difference from the expected force %.3g N\n",
                bundle.finger.size(), largest, difference);
    return difference <= 1e-12 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: play_bundle BUNDLE.tactum\n");
        return 2;
    }
    try {
        return play(argv[1]);
    } catch (const tactum::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
