// What a test sees and sets of the library that stands in for Force Dimension's own. Metre, newton, their
// axes.
#pragma once

#include <array>
#include <atomic>

namespace tactum::test {

struct FakeDhd {
    // What the device does.
    std::array<std::atomic<double>, 3> position{}, velocity{};
    std::atomic<unsigned> buttons{0};
    std::atomic<bool> wrist{false}, gripper{false};
    std::array<std::atomic<double>, 9> rows{}; ///< of the handle's frame
    std::atomic<double> gap{0};                ///< m
    std::atomic<int> handleError{0};           ///< neither of them can be read
    std::atomic<int> devices{1};
    std::atomic<bool> resetMode{false}; ///< waits for its calibration
    std::atomic<bool> supported{true};  ///< by the robotics library
    std::atomic<int> openError{0};      ///< dhdOpenID fails with it
    std::atomic<int> sendError{0};      ///< so do all commands
    std::atomic<int> readError{0};      ///< and all readings
    std::atomic<int> statusError{0};    ///< and looks at the status
    std::atomic<int> watchdogError{0};  ///< the firmware knows no watchdog
    std::atomic<int> moveError{0};      ///< it cannot calibrate itself
    std::atomic<int> success{0};        ///< what calls return that go well: 0, 1 or 2
    std::atomic<int> calibrateAt{0};    ///< that many looks at the status make it calibrated
    std::atomic<bool> fillsCause{true}; ///< the status has the number of the cause
    std::atomic<double> silent{0};      ///< ms since the last command: the device's own clock

    /// Its firmware takes the forces away. Causes as DHD_FORCEOFF_ has them: 1 button, 2 velocity, 3
    /// watchdog, 4 software, 6 dead man.
    void takeForces(int why) {
        force = false;
        forceOffCause = why;
        for (auto& motor : motors)
            motor = 0;
    }
    /// The device's time goes on without a command.
    void standStill(double milliseconds) {
        silent = silent + milliseconds;
        if (force && watchdog > 0 && silent >= 0.125 * watchdog) takeForces(3);
    }

    // What was done to it.
    std::array<std::atomic<double>, 3> motors{}; ///< hold until the next command
    std::atomic<double> strongest{0}, torque{0};
    std::array<std::atomic<double>, 4> handle{}; ///< the last torque, N m, and force of the gripper, N
    std::atomic<int> notFinite{0};
    std::atomic<bool> force{false}, expert{false}, regulating{false};
    std::atomic<int> forceOffCause{0};
    std::atomic<int> opened{0}, closed{0}, stopped{0}, looks{0}, watchdog{0}, misuses{0}, moved{0};
    std::atomic<int> enabled{0};        ///< how often forces were switched on
    std::atomic<double> enabledWith{0}; ///< N, the most that was commanded when they were
    std::array<std::atomic<double>, 3> commanded{};
    std::atomic<long> commands{0};
};

using FakeDhdGetter = FakeDhd& (*)();

} // namespace tactum::test
