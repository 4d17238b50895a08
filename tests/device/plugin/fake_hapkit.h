// A Hapkit behind a pseudo-terminal: docs/examples/driver/hapkit/hapkit.ino itself, compiled for this
// machine, on an Arduino that is none, with the arm and the motor of a Hapkit 3.0 at its pins. There is one
// at a time.
//
// The sensor tells the pulley's angle over half a turn and begins anew then; the motor's torque grows with
// the square of its duty (sources: in the sketch). That this is wrong itself would be shown by a Hapkit that
// pushes otherwise.
#pragma once

#include <atomic>

#include "core/base/vec.h"
#include "tests/device/serial/board_port.h"

namespace tactum::test {

class FakeHapkit {
public:
    /// Plugged in, its handle upright; its port is found by the driver through HAPKIT.
    FakeHapkit();
    ~FakeHapkit();
    FakeHapkit(const FakeHapkit&) = delete;
    FakeHapkit& operator=(const FakeHapkit&) = delete;

    void hold(double x); ///< m, of the handle, which goes there as fast as a hand
    Vec3 pushed() const; ///< N, frame D

    void unplug();
    void plug();
    void say(std::string_view bytes) const; ///< to the host, in between

private:
    void step();

    BoardPort port_{"HAPKIT", "hapkit"};
    std::atomic<double> wanted_{0};
};

} // namespace tactum::test
