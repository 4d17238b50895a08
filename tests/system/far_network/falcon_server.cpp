// The haptic server with an emulated Falcon, and a hand that leads its grip around a ball of 20 mm about the
// origin, in and out: falcon-server HOST:PORT CREDENTIALS, until SIGTERM.
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <iostream>
#include <thread>

#include "core/base/host_port.h"
#include "core/protocol/server.h"
#include "core/session/stage.h"
#include "tests/device/falcon/falcon_bench.h"

namespace {

using namespace tactum;

/// Where the hand wants to be at `t` s: all around, between 14 and 24 mm from the middle.
Vec3 wanted(double t) {
    const double turn = 2.1 * t, rise = 0.8 * t;
    const Vec3 direction(std::cos(turn) * std::cos(rise), std::sin(rise), std::sin(turn) * std::cos(rise));
    return (0.019 + 0.005 * std::sin(5 * t)) * direction;
}

void lead(test::EmulatedFalcon& device, const std::atomic<bool>& ended) {
    using Clock = std::chrono::steady_clock;
    for (const auto begin = Clock::now(); !ended; std::this_thread::sleep_for(std::chrono::milliseconds(2)))
        device.leadGrip(wanted(std::chrono::duration<double>(Clock::now() - begin).count()));
}

/// As the registry makes it: a hand is pushed, so that a watchdog stands by.
std::unique_ptr<HapticDevice> ready(const test::FalconBench& bench) {
    bench.device->startFirmware(true);
    DeviceInfo profile = test::FalconBench::profile();
    profile.real = true;
    FalconSettings settings;
    settings.firmware = bench.firmware();
    return std::make_unique<Falcon>(bench.place(), profile, settings);
}

int fail(const std::string& why) {
    std::cerr << "falcon-server: " << why << '\n';
    return 1;
}

} // namespace

int main(int argc, char** argv) {
    const auto at = argc == 3 ? hostPortOf(argv[1]) : std::nullopt;
    if (!at) return fail("wants HOST:PORT CREDENTIALS");
    sigset_t ends;
    sigemptyset(&ends);
    sigaddset(&ends, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &ends, nullptr);
    const test::FalconBench bench;
    Stage stage(ready(bench), nullptr, Scene{});
    if (const auto started = stage.start(); !started) return fail(started.error().text);
    ServerSettings settings;
    settings.host = at->host;
    settings.port = at->port;
    auto credentials = loadCredentials(argv[2]);
    if (!credentials) return fail(credentials.error().text);
    settings.credentials = std::move(*credentials);
    const auto server = Server::start(stage, std::move(settings));
    if (!server) return fail(server.error().text);
    std::atomic<bool> ended{false};
    std::thread hand([&] { lead(*bench.device, ended); });
    std::cout << "listening on " << at->host << ':' << (*server)->port() << std::endl;
    int signal = 0;
    sigwait(&ends, &signal);
    ended = true;
    hand.join();
    std::cout << bench.device->torqueCommands() << " commands with a torque" << std::endl;
    return bench.device->overdriven() ? fail("a motor was asked for more than it bears") : 0;
}
