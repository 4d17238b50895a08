// A loop of one's own: a mass on a spring that a person leads, in contact with a scene, at 1 kHz of its own
// time; and another thread that changes the scene meanwhile.
//
//     own_loop teapot.glb
//
// step() neither allocates, locks nor waits: it may be called by a real-time thread.
#include <atomic>
#include <cstdio>
#include <thread>

#include <tactum/scene.h>
#include <tactum/world.h>

namespace {

constexpr double kDt = 1e-3;                             // s
constexpr double kMass = 0.1, kGrip = 250, kDamping = 8; // kg, N/m, N s/m: of the hand

// One axis of it: led to `goal`, pushed by `force`.
void move(double& at, double& velocity, double goal, double force) {
    velocity += kDt / kMass * (kGrip * (goal - at) - kDamping * velocity + force);
    at += kDt * velocity;
}

int run(const char* file) {
    tactum::Scene scene = tactum::Scene::open(file, {.fit = 0.2});
    scene.set("static-friction", 0.4);
    tactum::World world(scene);

    std::atomic<bool> ends{false};
    std::thread editor([&] { // the author: each edit is compiled here, and felt from one of the next steps on
        for (int i = 0; i < 20 && !ends; ++i) {
            scene.set("stiffness", 300 + 20 * i);
            world.update(scene);
        }
    });

    tactum::Vec3 at{0, 0.15, 0}, velocity;
    tactum::Step step;
    int touching = 0;
    for (int i = 0; i < 2000; ++i) {
        const double goal = 0.15 - 0.15 * i / 2000; // m: down into whatever stands at the origin
        step = world.step(at, kDt);
        touching += step.contacts > 0;
        move(at.x, velocity.x, 0, step.force.x);
        move(at.y, velocity.y, goal, step.force.y);
        move(at.z, velocity.z, 0, step.force.z);
    }
    ends = true;
    editor.join();
    std::printf("%d of 2000 steps touched; at the end the finger is at %.1f mm, the proxy at %.1f mm, the "
                "force %.2f N\n",
                touching, 1e3 * step.finger.y, 1e3 * step.proxy.y, step.force.y);
    return touching > 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: own_loop SCENE\n");
        return 2;
    }
    try {
        return run(argv[1]);
    } catch (const tactum::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
