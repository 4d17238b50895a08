// Plays the finger path of a bundle through Tactum's haptics and compares what it feels with what it must
// feel:
//
//     play-bundle teapot.zip
//
// This is all that a renderer needs of the library: a scene, a World compiled from it, and one step for each
// position of the finger.
#include <algorithm>
#include <cstdio>

#include <core/bundle/bundle.h>
#include <core/haptics/compile.h>
#include <core/haptics/haptic_step.h>

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: play-bundle BUNDLE.zip\n");
        return 2;
    }
    const auto bundle = tactum::openBundle(argv[1]);
    if (!bundle) {
        std::fprintf(stderr, "%s\n", bundle.error().text.c_str());
        return 1;
    }
    const auto world = tactum::compile(bundle->scene);
    if (!world) {
        std::fprintf(stderr, "%s\n", world.error().text.c_str());
        return 1;
    }

    // Everything that changes while a scene is touched. A step takes microseconds: it belongs into a loop of
    // 1 kHz.
    tactum::SimState state;
    tactum::FingerPoint before = bundle->finger.front(); // s, m in the world frame
    before.t -= 1e-3;
    state.time = before.t;              // bodies that move by themselves are where that time puts them
    double largest = 0, difference = 0; // N
    for (std::size_t i = 0; i < bundle->finger.size(); ++i) {
        const tactum::FingerPoint& finger = bundle->finger[i];
        const double dt = finger.t - before.t;
        tactum::HapticInput input;
        input.finger = finger.position;
        input.fingerVelocity = (finger.position - before.position) / dt;
        const tactum::HapticOutput felt = tactum::hapticStep(**world, state, input, dt);
        largest = std::max(largest, felt.force.norm());
        difference = std::max(difference, (felt.force - bundle->forces[i]).norm());
        before = finger;
    }

    std::printf("%zu steps, largest force %.6g N, largest difference from the expected force %.3g N\n",
                bundle->finger.size(), largest, difference);
    return difference <= 1e-6 ? 0 : 1;
}
