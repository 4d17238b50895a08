// What is left out, step by step, when the proxy loop cannot keep up with the servo.
#pragma once

#include <cstdint>

namespace tactum {

/// Each level leaves out what the one before did, and one thing more.
enum class Fidelity : std::uint8_t {
    Full,
    NoTexture,
    NoShading,
    PlaneOnly, ///< few rounds a step: the proxy comes after, the servo goes on with the plane that it has
};

inline constexpr Fidelity kMinFidelity = Fidelity::PlaneOnly;

/// Chooses the fidelity from how long the steps take. Down at once when a twentieth of a second of steps took
/// longer than there was time; up again when they leave half of the time unused, after a wait that doubles
/// each time the better level turns out to be too much, or when they just fit for much longer: what was too
/// much may have been another program. Thread: real time.
class DegradationController {
public:
    /// `budget` in s: what a step may take in the mean.
    explicit DegradationController(double budget) noexcept : budget_(budget) {}

    /// After each step: `now` in s, never falling; `took` in s. Returns the fidelity of the next step.
    Fidelity operator()(double now, double took) noexcept;

    Fidelity fidelity() const noexcept { return fidelity_; }
    std::uint64_t stepsDown() const noexcept { return stepsDown_; }

private:
    void stepDown(double now) noexcept;
    void stepUp(double now) noexcept;

    double budget_;
    Fidelity fidelity_ = Fidelity::Full;
    std::uint64_t stepsDown_ = 0;
    double windowBegan_ = -1, sum_ = 0;
    int count_ = 0;
    double calmSince_ = 0, wait_ = 0.5;
    double fitsSince_ = 0, longWait_ = 16;
    double raisedAt_ = -1e9;
};

} // namespace tactum
