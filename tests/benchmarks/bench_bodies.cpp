// What a haptic step costs among many bodies: bench-bodies [turns]. Boxes of 12 triangles stand in a square,
// and a finger goes to and fro over a hundred of them in the middle, however many there are, 2 mm below their
// tops.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>

#include "core/haptics/compile.h"
#include "core/haptics/replay.h"
#include "tests/benchmarks/one_core.h"
#include "tests/support/hand.h"
#include "tests/support/movers.h"
#include "tests/support/two_hands.h"

using namespace tactum;
using namespace tactum::bench;
using namespace tactum::test;

namespace {

constexpr double kBox = 8e-3, kPitch = 10e-3, kSpeed = 0.15;
constexpr int kRows = 10000;

/// `side` x `side` boxes; of those that move every tenth goes up and down by half a millimetre.
Scene boxes(int side, bool moving) {
    Scene scene;
    scene.proxyRadius = 1e-3;
    const Soup soup = cube(kBox / 2);
    const SharedMotion up = swinging({0, 0, 5e-4}, 2);
    for (int i = 0; i < side * side; ++i) {
        const Vec3 at((i % side - 0.5 * side) * kPitch, (i / side - 0.5 * side) * kPitch, -kBox / 2);
        scene.add(bodyOf(soup, frictionless(), moving && i % 10 == 0 ? up : nullptr, {Quat::Identity(), at}));
    }
    return scene;
}

FingerPath toAndFro() {
    FingerPath path;
    const double step = kSpeed * kMillisecond, half = 0.045;
    Vec3 at(-half, -half, -2e-3);
    double sense = 1;
    for (int i = 0; i < kRows; ++i) {
        path.push_back({i * kMillisecond, i < 20 ? Vec3(at + Vec3(0, 0, 4e-3)) : at});
        at.x() += sense * step;
        at.y() += 0.02 * step;
        if (std::abs(at.x()) > half) sense = at.x() > 0 ? -1 : 1;
    }
    return path;
}

/// The step after a body in the corner was moved, in which the proxy looks anew where it is; median, us.
double afterAnEdit(const World& before, Scene scene, int turns) {
    std::vector<double> took;
    for (int turn = 0; turn < turns; ++turn) {
        Hand hand(compile(scene, &before).value());
        const Vec3 finger(0, 0, 0);
        hand.to(finger);
        scene.objects[0].pose.translation.z() += 1e-3;
        hand.take(compile(scene, &hand.world()).value());
        const auto begin = std::chrono::steady_clock::now();
        hand.to(finger);
        took.push_back(
            std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    }
    std::ranges::sort(took);
    return took[took.size() / 2];
}

void measure(int side, bool moving, int turns) {
    const Scene scene = boxes(side, moving);
    const auto world = compile(scene);
    if (!world) std::exit((std::fprintf(stderr, "%s\n", world.error().text.c_str()), 1));
    const OneCore pinned;
    const FingerPath path = toAndFro();
    std::vector<double> fastest(path.size(), 1e9);
    std::size_t touching = 0;
    for (int turn = 0; turn < turns; ++turn) {
        const TouchTrace rows = replay(**world, path);
        for (std::size_t i = 0; i < rows.size(); ++i)
            fastest[i] = std::min(fastest[i], 1e-3 * double(rows[i].updateNs));
        touching =
            std::size_t(std::ranges::count_if(rows, [](const TouchRow& row) { return row.contacts > 0; }));
    }
    double sum = 0;
    for (const double us : fastest)
        sum += us;
    std::ranges::sort(fastest);
    const auto at = [&](double part) { return fastest[std::size_t(part * double(fastest.size() - 1))]; };
    std::printf("| %d | %s | %.2f | %.2f | %.1f | %.1f | %.0f |\n", side * side,
                moving ? "every tenth" : "none", sum / double(fastest.size()), at(0.5), at(0.999),
                afterAnEdit(**world, scene, turns), 100.0 * double(touching) / double(kRows));
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const int turns = argc > 1 ? std::max(1, std::atoi(argv[1])) : 5;
    std::printf(
        "| bodies | of which move | mean us | median us | p99.9 us | after an edit us | touching %% |\n"
        "| --: | :-- | --: | --: | --: | --: | --: |\n");
    for (const bool moving : {false, true})
        for (const int side : {10, 32, 100})
            measure(side, moving, turns);
}
