// A program that presses a finger into a plate and then dies in the way that its caller asks for.
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "core/haptics/compile.h"
#include "core/runtime/local_engine.h"
#include "tests/support/hand.h"
#include "tests/system/watched_device.h"

using namespace tactum;
using namespace tactum::test;

namespace {

[[gnu::noinline]] int overflow(int depth) {
    volatile char room[4096] = {};
    room[depth % 4096] = char(depth);
    return depth > 1'000'000'000 ? room[0] : overflow(depth + 1) + room[1];
}

/// On a machine that is late again and again the guard takes the force away, and on one that stood still the
/// proxy begins anew where the finger is, in the plate: a patient person arms, and comes from above, once
/// more.
void pressAgain(Engine& engine, Motors& motors) {
    engine.poll();
    engine.setArmed(!isFault(engine.servo().inhibit));
    const bool above = engine.proxy().updates > 10 && engine.proxy().output.proxy.z() > 0;
    motors.down = above;
    if (!above && engine.servo().finger.z() > 2e-3) engine.restartProxy();
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

void die(std::string_view way, Engine& engine, Motors& motors) {
    motors.diesAt = monotonicNanoseconds();
    if (way == "segv") *static_cast<volatile int*>(nullptr) = 1;
    if (way == "abort") std::abort();
    if (way == "throw") throw std::runtime_error("nobody catches this");
    if (way == "exit") std::_Exit(0); // no destructor, no signal
    if (way == "stack") std::exit(overflow(0));
    // Else somebody else sees to it.
    while (true)
        pressAgain(engine, motors);
}

/// What a sanitizer is told, which would catch the signals and exit: here they have their way.
constexpr const char* kSignalsHaveTheirWay = "handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_abort=0";

} // namespace

// The sanitizers ask for their options by these names.
extern "C" const char* __asan_default_options() {
    return kSignalsHaveTheirWay;
}
extern "C" const char* __tsan_default_options() {
    return kSignalsHaveTheirWay;
}
extern "C" const char* __ubsan_default_options() {
    return kSignalsHaveTheirWay;
}

int main(int argc, char** argv) {
    Motors* motors = argc == 3 ? mapMotors(argv[1]) : nullptr;
    if (!motors) return 2;
    LocalEngine engine(std::make_unique<WatchedDevice>(*motors, -0.002));
    engine.publish(worldOf(sheet(0.1), frictionless(), 1e-3));
    if (!engine.start()) return 3;
    while (motors->push < 1)
        pressAgain(engine, *motors);
    die(argv[2], engine, *motors);
}
