// A device of known figures for the self-test: a mass that slides, with a person who does as asked.
#pragma once

#include <array>
#include <deque>
#include <random>
#include <set>

#include "core/self_test/trial_bench.h"

namespace tactum::test {

struct Plant {
    double mass = 0.15;                   ///< kg
    double damping = 0.8;                 ///< N s/m
    double friction = 0.2;                ///< N, dry
    int delay = 1;                        ///< ticks from reading to force
    double lag = 0;                       ///< s, of the amplifier
    double step = 5e-5;                   ///< m, of the encoders
    double noise = 0;                     ///< m
    double weight = 0;                    ///< N downwards, that nothing balances
    double motorGain = 1;                 ///< true newton to a commanded one
    std::array<int, 3> read{0, 1, 2};     ///< true axis of each reading
    std::array<double, 3> scale{1, 1, 1}; ///< of each true axis, signed
    double crossed = 0;                   ///< of y, in the first reading
    std::array<int, 3> push{0, 1, 2};     ///< true axis that each command pushes along
    std::array<double, 3> motor{1, 1, 1}; ///< sign, or 0
    double rate = 1000;                   ///< Hz, that it really keeps
    std::uint32_t stuckButtons = 0, deafButtons = 0;
};

/// Integrated in steps of 0.1 ms, along each axis by itself.
class PlantBench final : public TrialBench {
public:
    PlantBench(const Plant& plant, unsigned seed) : plant_(plant), random_(seed) {}

    Result<std::vector<TrialRow>> run(double seconds, double limit, const TrialForce& force) override;

    Plant plant_;
    Vec3 place = Vec3::Zero(), velocity = Vec3::Zero(); ///< true ones
    bool held = false;                                  ///< by the person
    double hung = 0;                                    ///< kg
    bool presses = false;
    double strongest = 0; ///< N, of all commands

private:
    Vec3 reading();
    void move(double seconds, const Vec3& push);
    Vec3 pushOf(const Vec3& command) const;

    std::mt19937 random_;
    Vec3 lagged_ = Vec3::Zero();
};

/// Does everything, but for what is in `leaves out`.
class PlantPerson final : public TrialPerson {
public:
    explicit PlantPerson(PlantBench& bench) : bench_(bench) {}

    bool does(TrialAsk what, const TrialWords& words) override;
    bool leaves() const override { return asked >= leavesAfter; }
    std::optional<double> mass(double) override { return hangs; }
    void hears(const TrialWords&) override {}
    void begins(TrialPart part) override { begun.push_back(part); }

    std::vector<TrialPart> begun;

    std::set<TrialAsk> leavesOut;
    std::optional<double> hangs = 0.05; ///< kg
    int asked = 0, leavesAfter = 1000;

private:
    PlantBench& bench_;
};

} // namespace tactum::test
