// A transformed up-down staircase: which level comes next, and the threshold in the end. Pure.
#pragma once

#include <optional>
#include <vector>

#include "core/study/design.h"

namespace tactum {

/// A mean over reversals, in the unit of the level.
struct Threshold {
    double mean = 0;
    double error = 0; ///< standard error of the mean; 0 for one reversal
    int reversals = 0;
};

class Staircase {
public:
    explicit Staircase(const StaircaseRule& rule) : rule_(rule), level_(rule.start) {}

    /// Of the trial that is due.
    double level() const { return level_; }
    /// Takes its answer; true when the direction turned, which is a reversal at the level of this trial.
    bool answer(bool correct);
    bool done() const { return int(reversals_.size()) >= rule_.reversals || trials_ >= rule_.trials; }

    const std::vector<double>& reversals() const { return reversals_; } ///< their levels
    /// Of the last reversals that the rule uses, or as many as there are; none before the first.
    std::optional<Threshold> threshold() const;

private:
    void move(int direction);

    StaircaseRule rule_;
    double level_;
    int right_ = 0;     ///< in a row, since the level moved
    int direction_ = 0; ///< of the last move: -1 down, 1 up
    int trials_ = 0;
    std::vector<double> reversals_;
};

} // namespace tactum
