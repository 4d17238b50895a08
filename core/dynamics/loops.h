// Loops of joints: the multipliers that keep them closed, exact, within every evaluation. For this folder.
#pragma once

#include <vector>

#include "core/dynamics/articulation.h"

namespace tactum {

/// How fast a gap that rounding and the integrator leave is closed, 1/s (Baumgarte 1972).
inline constexpr double kClosing = 100;

/// Rows of one island in one piece each. Thread: one at a time; all but the constructor real time.
class Loops {
public:
    explicit Loops(const Mechanism& mechanism);

    bool empty() const noexcept { return mechanism_.loops.empty(); }
    /// After Articulation::factor(): what the locks move and how hard they are to move.
    void factor(Articulation& articulation) noexcept;
    /// After accelerate(): adds what the locks do, so that their gaps stay closed.
    void correct(const Articulation& articulation, Coordinates& acceleration) noexcept;
    /// Takes out of a change of an island's velocities what would open its locks.
    void project(const Island& island, double* change) const noexcept;
    /// The same for velocities, which need not have kept the locks.
    void projectAll(Coordinates& velocities) const noexcept;
    /// How the velocities would have to be for a second to close all gaps, with the least motion.
    void closing(Coordinates& shift) const noexcept;
    /// The largest gap, m or rad, of the last factor().
    double largestGap() const noexcept { return gap_; }

private:
    struct Frames {
        Pose a, b; ///< of the world
    };
    struct Row {
        Measured now;
        Frames frames;
        bool framesAsBefore = false; ///< those of the row before it, of the same island
        std::size_t first = 0;       ///< of its numbers in jacobian_ and change_
        bool holds = true;           ///< the rows before it do not already hold it
        double free = 0;             ///< its part of the factor if nothing else held the bodies
    };

    void solve(const Island& island, double* rhs) const noexcept;
    /// Adds what the multipliers do that make the rows of an island change by what is in rhs_.
    void addAnswer(const Island& island, double* to) const noexcept;
    double& factorAt(const Island& island, int row, int column) noexcept;
    double factorAt(const Island& island, int row, int column) const noexcept;

    const Mechanism& mechanism_;
    std::vector<Row> rows_;
    std::vector<double> jacobian_, change_; ///< J and M^-1 J^T
    std::vector<std::size_t> factorFirst_;  ///< of each island
    std::vector<double> factor_;            ///< Cholesky's, of J M^-1 J^T
    mutable std::vector<double> rhs_;
    double gap_ = 0;
};

} // namespace tactum
