// Two programs in one, as the real one is: with "serve" the process of the device, with "push" a program that
// pushes through such a process until it is killed.
#include <cstring>

#include "device/remote/remote_device.h"
#include "device/remote/serve_device.h"
#include "tests/device/remote/served_device.h"

using namespace tactum;
using namespace tactum::test;

namespace {

int serve(Served& served, const char* way) {
    if (std::strcmp(way, "unknown") == 0)
        return refuseToServe({Error::Kind::Input, "There is no such device."}, kServeDescriptor);
    served.server = getpid();
    const auto device = std::strcmp(way, "framed") == 0 ? std::make_unique<FramedDevice>(served, way)
                                                        : std::make_unique<ServedDevice>(served, way);
    const int code = serveDevice(*device, kServeDescriptor);
    served.ended = true;
    return code;
}

/// Holds the program's sockets after its death, as a forked device watchdog does.
void leaveAHolder(const Served& served) {
    if (fork() != 0) return;
    while (kill(served.server, 0) == 0)
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    _exit(0);
}

int push(const Served& served, const char* file, const char* way) {
    auto device = makeRemoteDevice("/proc/self/exe", {"serve", file, ""});
    if (!device || !(*device)->open()) return 3;
    if (std::strcmp(way, "held") == 0) leaveAHolder(served);
    while (true) {
        (*device)->exchange({{0, 0, 2}}, 1e-3);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
}

} // namespace

// The sanitizers ask for their options by these names: signals have their way.
extern "C" const char* __asan_default_options() {
    return "handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_abort=0";
}
extern "C" const char* __tsan_default_options() {
    return "handle_segv=0:handle_sigbus=0:handle_sigfpe=0:handle_abort=0";
}

int main(int argc, char** argv) {
    Served* served = argc == 4 ? mapServed(argv[2]) : nullptr;
    if (!served) return 2;
    return std::strcmp(argv[1], "serve") == 0 ? serve(*served, argv[3]) : push(*served, argv[2], argv[3]);
}
