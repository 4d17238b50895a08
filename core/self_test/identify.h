// What a device is, from what it did: least squares over the ticks of an experiment.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/self_test/trial_bench.h"

namespace tactum {

/// A figure with what it may be off, one standard deviation or the bound of the method.
struct TrialFigure {
    double value = 0, error = 0;
};

/// How often a reading is a new one, from ticks and their times.
struct Pace {
    double rate = 0;              ///< Hz, of new readings
    double median = 0, worst = 0; ///< s, between two of them
};
Pace paceOf(std::span<const TrialRow> rows);

/// Of a handle that nobody holds: the deviation from a straight drift, m, the largest of the three axes.
double noiseOf(std::span<const TrialRow> rows);
/// The step between two readings that differ, m: the tenth of all that is smallest, for most of them are
/// several steps at once; 0 where nothing moved.
double resolutionOf(std::span<const TrialRow> rows);
/// The mean of the positions, m.
Vec3 middleOf(std::span<const TrialRow> rows);

/// What an axis is made of, by m a + b v + c sgn(v) + f0 = F(t - delay).
struct AxisDynamics {
    TrialFigure mass;       ///< kg
    TrialFigure damping;    ///< N s/m
    TrialFigure friction;   ///< N, dry
    TrialFigure delay;      ///< s, from the command to the force, the amplifier's lag with it
    double unexplained = 0; ///< ratio of the force that the model does not explain, rms
};
/// Along one axis of D that was shaken by known forces; nullopt where it hardly moved. Both sides of the
/// equation pass the same low pass, so that steps of the encoders do not drown the acceleration; the delay is
/// that of the smallest remainder. A command holds for a tick, and acts as if it came half a tick later: that
/// is taken off.
std::optional<AxisDynamics> dynamicsOf(std::span<const TrialRow> rows, int axis);

} // namespace tactum
