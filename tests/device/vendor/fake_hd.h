// What a test sees and sets of the library that stands in for 3D Systems' own.
#pragma once

#include <array>
#include <atomic>

namespace tactum::test {

struct FakeHd {
    // What the device does.
    std::array<std::atomic<double>, 3> position{}, velocity{}; ///< mm, mm/s
    std::array<std::atomic<double>, 16> transform{};           ///< by columns, mm
    std::atomic<int> buttons{0};
    std::atomic<double> maxForce{3.3}, maxStiffness{0.42}; ///< N, N/mm
    std::atomic<int> calibrationStyle{4};                  ///< inkwell
    std::atomic<unsigned> calibration{0x5000};             ///< what hdCheckCalibration says
    std::atomic<unsigned> initError{0};                    ///< hdInitDevice fails with it
    std::atomic<unsigned> frameError{0};                   ///< every frame leaves it behind
    std::atomic<bool> frozen{false};                       ///< the scheduler makes no more ticks

    // What was done to it.
    std::array<std::atomic<double>, 3> motors{}; ///< N: hold until the next frame, as real ones do
    std::atomic<double> strongest{0};            ///< N, of any command
    std::atomic<int> notFinite{0};               ///< commands that were no numbers
    std::atomic<int> misuses{0};                 ///< calls on the wrong thread or outside a frame
    std::atomic<int> calibrated{0};              ///< calls of hdUpdateCalibration
    std::atomic<int> opened{0}, closed{0};
    std::atomic<bool> output{false};
    std::atomic<long> frames{0};
    std::array<char, 64> name{}; ///< that was asked for; "(default)" for none
};

/// The symbol with which a test takes hold of it.
using FakeHdGetter = FakeHd& (*)();

} // namespace tactum::test
