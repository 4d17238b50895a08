// What is not smooth: hard limits, dry friction, and springs too stiff for the step. Each is a row of one
// constraint with bounds on its impulse, solved together by projected Gauss-Seidel. For this folder.
#pragma once

#include <vector>

#include "core/dynamics/articulation.h"
#include "core/dynamics/loops.h"

namespace tactum {

/// Thread: one at a time; all but the constructor real time.
class Rows {
public:
    explicit Rows(const Mechanism& mechanism);

    /// Finds what may act in a step of `dt` from a place that articulation and loops know. Springs that the
    /// smooth part leaves to the rows are those of springIsRow().
    void gather(Articulation& articulation, const Loops& loops, const Coordinates& q, double dt) noexcept;
    bool empty() const noexcept { return count_ == 0; }
    /// Ends every approach to a limit that is reached. Whether there was one.
    bool stopApproaches(Coordinates& v) noexcept;
    /// The forces along the coordinates that, held for the step, keep all bounds at its end; adds what they
    /// do to the acceleration.
    void solve(const Coordinates& v, double dt, Coordinates& along, Coordinates& acceleration) noexcept;

    /// At what part of the step a limit that was not reached is passed, 1 for none. The articulation knows
    /// the places at the end.
    double firstCrossing(const Articulation& end, const Coordinates& q, double dt) const noexcept;
    /// How the velocities would have to be for a second to take back what went beyond its limit. Whether
    /// anything did.
    bool correction(double dt, Coordinates& shift) noexcept;

    /// Springs that are too stiff for a step of dt to be smooth; `inertia` says how much each moves.
    bool springIsRow(std::size_t spring, double dt) const noexcept;
    /// Of a spring in accelerations: kg or kg m^2.
    double inertiaOf(Articulation& articulation, const Coordinate& of) noexcept;

private:
    struct Row {
        std::size_t first = 0; ///< of its numbers in jacobian_ and change_
        int island = 0;
        double target = 0, low = 0, high = 0, compliance = 0, yield = 0, impulse = 0;
        double depth = 0;     ///< beyond a limit, m or rad
        bool isLimit = false; ///< of place: it ends approaches
    };
    struct Reading {
        double value = 0;
        Wrench along;
        double rate = 0;
    };
    struct Gap {
        double gap = 0, rate = 0;
        bool reached = false;
    };

    Reading read(const Articulation& articulation, const Coordinate& of, const Coordinates& q) const noexcept;
    int islandOf(const Coordinate& of) const noexcept;
    Row* addRow(Articulation& articulation, const Loops& loops, const Coordinate& of, const Wrench& along,
                double sense) noexcept;
    void gatherLimits(Articulation& articulation, const Loops& loops, const Coordinates& q) noexcept;
    void gatherSprings(Articulation& articulation, const Loops& loops, const Coordinates& q,
                       double dt) noexcept;
    double velocityOf(const Row& row, const Coordinates& v) const noexcept;
    void push(const Row& row, double impulse, Coordinates& v) const noexcept;
    template <class Which> void relax(Coordinates& v, Which&& which) noexcept;

    const Mechanism& mechanism_;
    std::vector<Row> rows_;
    std::size_t count_ = 0, numbers_ = 0;
    std::vector<double> jacobian_, change_;
    std::vector<Gap> gaps_;        ///< two for each limit: of its minimum and of its maximum
    std::vector<double> softness_; ///< of each spring at the start: 1 / inertia
    Coordinates end_;
};

} // namespace tactum
