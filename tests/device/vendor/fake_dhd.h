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
    std::atomic<int> devices{1};
    std::atomic<int> reset{1};       ///< calibrated
    std::atomic<int> openError{0};   ///< dhdOpenID fails with it
    std::atomic<int> sendError{0};   ///< so do all commands
    std::atomic<int> readError{0};   ///< and all readings
    std::atomic<int> success{0};     ///< what calls return that go well: 0, 1 or 2
    std::atomic<int> calibrateAt{0}; ///< that many looks at the status make it calibrated

    // What was done to it.
    std::array<std::atomic<double>, 3> motors{}; ///< hold until the next command
    std::atomic<double> strongest{0}, torque{0};
    std::atomic<int> notFinite{0};
    std::atomic<bool> force{false};
    std::atomic<int> opened{0}, closed{0}, stopped{0}, looks{0}, watchdog{0}, misuses{0};
    std::atomic<long> commands{0};
};

using FakeDhdGetter = FakeDhd& (*)();

} // namespace tactum::test
