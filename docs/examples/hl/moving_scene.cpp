// A scene that the application moves, frame by frame: a lift under a resting finger. moving_scene HOST:PORT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "frames.h"

int main(int argc, char** argv) {
    if (argc != 2) return std::puts("moving_scene HOST:PORT"), 2;
    hl::Context context(argv[1], "moving scene");
    if (!context.open()) return ended(false, "no server");
    const hl::List plate = hl::newList();
    hl::begin(hl::Quads);
    hl::normal(0, 1, 0);
    hl::vertex(-0.05, 0, -0.05), hl::vertex(-0.05, 0, 0.05), hl::vertex(0.05, 0, 0.05),
        hl::vertex(0.05, 0, -0.05);
    hl::end();
    hl::endList();
    hl::material(hl::Stiffness, 500);
    hl::proxyRadius(2e-3);
    hl::leadHand(0, 0.02, 0);
    // Not before the finger is above: a plate that comes to be around it may be felt from below.
    if (!run(5, [](double) { return hl::state().finger[1] > 0.015; }))
        return ended(false, "the hand did not come");
    double lowest = 1, highest = -1;
    bool pressed = false;
    const bool done = run(30, [&](double time) {
        const double height = 5e-3 * std::sin(2 * std::numbers::pi * 0.5 * time);
        hl::beginFrame();
        hl::pushMatrix();
        hl::translate(0, height, 0);
        hl::callList(plate);
        hl::popMatrix();
        if (!hl::endFrame()) return true;
        if (!pressed && time > 0.5) pressed = hl::arm(true) && hl::leadHand(0, -0.02, 0);
        const hl::State state = hl::state();
        if (!pressed || state.contacts == 0 || state.gain < 1) return false;
        lowest = std::min(lowest, state.proxy[1]);
        highest = std::max(highest, state.proxy[1]);
        return highest - lowest > 8e-3; // nearly all of its way
    });
    std::printf("the proxy rode from %.1f to %.1f mm\n", 1e3 * lowest, 1e3 * highest);
    return ended(done && highest - lowest > 8e-3, "moving scene");
}
