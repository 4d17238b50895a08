// The whole engine: both loops with all of their safety on a device, here the simulated hand, and an edit
// that is felt while the hand presses.
//
//     whole_engine [DEVICE]        an id that `tactum devices` lists
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include <tactum/engine.h>
#include <tactum/scene.h>

namespace {

// A table in the plane y = 0.
tactum::Scene table() {
    const std::vector<tactum::Vec3> corners{{-0.1, 0, -0.1}, {0.1, 0, -0.1}, {0.1, 0, 0.1}, {-0.1, 0, 0.1}};
    const std::vector<tactum::Triangle> triangles{{0, 2, 1}, {0, 3, 2}};
    tactum::Scene scene;
    scene.addMesh(corners, triangles, {}, "table").set("stiffness", 200);
    return scene;
}

// As a program does once a frame, until what is wanted holds; false after ten seconds without.
template <class Wanted> bool showUntil(tactum::Engine& engine, const char* what, Wanted wanted) {
    for (int frame = 0; frame < 600; ++frame) {
        const tactum::EngineState state = engine.state();
        if (wanted(state)) {
            std::printf("%s: finger %.2f mm, proxy %.2f mm, force %.2f N\n", what, 1e3 * state.finger.y,
                        1e3 * state.proxy.y, state.force.y);
            return true;
        }
        if (state.fault) std::printf("%s\n", state.why);
        std::this_thread::sleep_for(std::chrono::microseconds(16667));
    }
    return false;
}

int run(const char* device) {
    tactum::Scene scene = table();
    tactum::Engine engine(device);
    engine.publish(scene);
    engine.open();
    std::printf("%s, at most %.1f N. %s\n", engine.deviceName().c_str(), engine.maxForce(),
                engine.priority().c_str());
    engine.arm();
    engine.leadHand({0, -0.01, 0}, 0.3); // a real device is led by a hand
    double deep = 0;
    const bool pressed = showUntil(engine, "pressed", [&](const tactum::EngineState& state) {
        deep = state.finger.y;
        return state.gain == 1 && state.force.y > 0.5;
    });
    scene.set("stiffness", 600); // three times as stiff, without a jump: the proxy stays
    engine.publish(scene);
    const bool stiffer = showUntil(
        engine, "stiffer", [&](const tactum::EngineState& state) { return state.finger.y > deep + 5e-4; });
    engine.close();
    return pressed && stiffer ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run(argc > 1 ? argv[1] : "simulated");
    } catch (const tactum::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
