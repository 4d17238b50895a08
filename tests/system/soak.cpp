// The running engine under load for as long as one likes: edits at 60 Hz, another model every two seconds, a
// hand that never rests. Says how many servo ticks were missed, how many of them the machine took, and how
// many page faults the loops had after a warm-up. Exit 1 when a miss or a fault was our own.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "core/haptics/compile.h"
#include "core/runtime/local_engine.h"
#include "core/safety/inhibit_words.h"
#include "tests/support/guarded_hand.h"
#include "tests/support/hand.h"
#include "tests/support/page_faults.h"

using namespace tactum;
using namespace tactum::test;

namespace {

constexpr double kWarmUp = 5, kFrame = 1.0 / 60, kSwap = 2; // s

/// Hills of 10 cm by 10 cm with about so many triangles.
Soup hills(double triangles, double phase) {
    const int cells = std::max(1, int(std::sqrt(triangles / 2)));
    return heightField(0.05, cells, [phase](double x, double y) {
        return 0.004 * std::sin(300 * x + phase) * std::sin(270 * y) +
               0.0005 * std::sin(4000 * x) * std::sin(3000 * y);
    });
}

struct Soak {
    explicit Soak(double triangles) : engine(std::make_unique<GuardedHand>(target)) {
        for (std::size_t i = 0; i < scenes.size(); ++i)
            scenes[i] = sceneOf(hills(triangles, double(i)), rough(0.4, 0.3, 0.5));
        show(0);
    }
    void show(std::size_t which) {
        worlds[which] = compile(scenes[which], worlds[which].get()).value();
        engine.publish(worlds[which]);
    }
    /// One frame of what a person and a window do.
    void frame(int count) {
        const double t = kFrame * count;
        target->write({.position = {0.035 * std::sin(1.3 * t), 0.035 * std::sin(1.7 * t),
                                    -0.002 + 0.004 * std::sin(5 * t)}});
        const std::size_t which = std::size_t(t / kSwap) % 2;
        scenes[which].objects[0].surfaces[0].material.stiffness = 800 + 300 * std::sin(t);
        show(which);
        engine.poll();
        const InhibitReason why = engine.servo().inhibit;
        if (isFault(why) && engine.armed()) std::printf("%.1f s: %s\n", t, inhibitWords(why).brief);
        engine.setArmed(!isFault(why));
        for (TracePoint point; engine.popTrace(point);)
            continue;
    }

    std::shared_ptr<HandTarget> target = std::make_shared<HandTarget>();
    std::array<Scene, 2> scenes;
    std::array<std::shared_ptr<const World>, 2> worlds;
    LocalEngine engine;
};

} // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 30;
    const double triangles = argc > 2 ? std::atof(argv[2]) : 1e5;
    Soak soak(triangles);
    if (const auto started = soak.engine.start(); !started) {
        std::fprintf(stderr, "soak: %s\n", started.error().text.c_str());
        return 3;
    }
    std::printf("%s\n", soak.engine.priorityNote().c_str());
    ServoTelemetry begin;
    auto begun = std::chrono::steady_clock::now();
    long servoFaults = 0, proxyFaults = 0, touching = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int count = 0; kFrame * count < kWarmUp + seconds; ++count) {
        soak.frame(count);
        touching += soak.engine.proxy().output.contacts > 0;
        if (count == int(kWarmUp / kFrame)) {
            begin = soak.engine.servo();
            begun = std::chrono::steady_clock::now();
            servoFaults = pageFaultsOf("tactum-servo").value();
            proxyFaults = pageFaultsOf("tactum-proxy").value();
        }
        std::this_thread::sleep_until(start + std::chrono::duration<double>(kFrame * (count + 1)));
    }
    servoFaults = pageFaultsOf("tactum-servo").value() - servoFaults;
    proxyFaults = pageFaultsOf("tactum-proxy").value() - proxyFaults;
    const ServoTelemetry& end = soak.engine.servo();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begun;
    const ProxyTelemetry& proxy = soak.engine.proxy();
    const auto own = (end.misses - begin.misses) - (end.machineMisses - begin.machineMisses);
    std::printf(
        "%llu servo ticks in %.1f s, %llu missed, of which the machine took %llu; page faults %ld servo, %ld "
        "proxy\n",
        static_cast<unsigned long long>(end.ticks - begin.ticks), took.count(),
        static_cast<unsigned long long>(end.misses - begin.misses),
        static_cast<unsigned long long>(end.machineMisses - begin.machineMisses), servoFaults, proxyFaults);
    std::printf("proxy %.0f Hz, %.1f us mean; fidelity lowered %llu times; faults of the guard %llu; "
                "touching in %ld frames\n",
                proxy.rate, proxy.updateMicros, static_cast<unsigned long long>(proxy.stepsDown),
                static_cast<unsigned long long>(end.faults), touching);
    std::printf(
        "deviation of the servo's period: 50 %% below %.0f us, 99 %% below %.0f us, 99.9 %% below %.0f us\n",
        end.periods.quantile(0.5), end.periods.quantile(0.99), end.periods.quantile(0.999));
    return own > 0 || servoFaults > 0 || proxyFaults > 0;
}
