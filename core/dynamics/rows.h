// What is not smooth: contacts with friction and bounces, hard limits, dry friction, and springs too stiff
// for the step. Each is a row of one constraint with bounds on its impulse, solved together by projected
// Gauss-Seidel (D. Stewart, Rigid-Body Dynamics with Friction and Impact, SIAM Review 2000). For this folder.
#pragma once

#include <vector>

#include "core/dynamics/articulation.h"
#include "core/dynamics/contacts.h"
#include "core/dynamics/loops.h"

namespace tactum {

/// Thread: one at a time; all but the constructor real time.
class Rows {
public:
    explicit Rows(const Mechanism& mechanism);

    /// Finds what may act in a step of `dt` from a place that articulation and loops know. Springs that the
    /// smooth part leaves to the rows are those of springIsRow(). `early`: what will be met within the step
    /// counts as met.
    void gather(Articulation& articulation, const Loops& loops, const Coordinates& q, double dt,
                bool early) noexcept;
    bool empty() const noexcept { return count_ == 0; }
    /// Whether a spring or damper is among them.
    bool holdSprings() const noexcept;
    /// Ends every approach to what is reached, bounces included. Whether there was one.
    bool stopApproaches(Coordinates& v) noexcept;
    /// The forces that, held for the step, keep all bounds at its end: those of single coordinates are added
    /// to `along`, the others are kept for addHeld(). Adds what they do to the acceleration.
    void solve(const Coordinates& v, double dt, Coordinates& along, Coordinates& acceleration) noexcept;

    /// The forces on links that solve() found, at their places now.
    void addHeld(Articulation& articulation) const noexcept;
    void letGo() noexcept;

    /// What springs, dry friction and limits among the rows do along the coordinate of a link, N or N m;
    /// after solve().
    double forceAlong(int link, double dt) const noexcept;

    /// At what part of a step bodies meet that do not touch yet, 1 for none.
    double firstTouch(double dt) const noexcept;
    /// At what part of the step a limit that was not reached is passed, 1 for none. The articulation knows
    /// the places at the end.
    double firstCrossing(const Articulation& end, const Coordinates& q, double dt) const noexcept;
    /// How the velocities would have to be for a second to take back what went beyond its limit, or into
    /// another body. Whether anything did.
    bool correction(double dt, Coordinates& shift) noexcept;

    /// Springs that are too stiff for a step of dt to be smooth are rows from now on, in its parts too: what
    /// they move may be lighter than at the start.
    void chooseSprings(double dt) noexcept { longest_ = dt; }
    bool springIsRow(std::size_t spring) const noexcept;
    /// Of a spring in accelerations: kg or kg m^2.
    double inertiaOf(Articulation& articulation, const Coordinate& of) noexcept;

    /// The next gather() starts from nothing.
    void forget() noexcept { contacts_.forget(); }

    /// Contacts that there was no room for, since the beginning.
    std::uint64_t leftOut() const noexcept { return contacts_.leftOut(); }

private:
    enum class Kind : std::uint8_t { Spring, DryFriction, Limit, Contact, Rub };

    /// What a row moves of one island.
    struct Side {
        int island = -1;       ///< -1: nothing
        std::size_t first = 0; ///< of its numbers in jacobian_ and change_
    };
    struct Row {
        Kind kind = Kind::Spring;
        std::array<Side, 2> sides;
        double target = 0, low = 0, high = 0, compliance = 0, yield = 0, impulse = 0;
        double turning = 0;  ///< m/s or rad/s: the part of its rate that comes only of where it points
        double depth = 0;    ///< beyond a limit or inside of a body, m or rad
        int contact = -1;    ///< of contacts_, of a Contact; the two Rubs come after it
        double friction = 0; ///< of a Contact
        double bounce = 0;   ///< of a Contact, for what approaches faster than
        double falls = 0;    ///< m/s
        bool struck = false; ///< by the blow that is worked out
        double after = 0;    ///< m/s: how fast it may be after that
        std::array<int, 2> links{-1,
                                 -1}; ///< what it acts on, and how for an impulse of 1: about their frames
        std::array<Vec6, 2> wrenches{Vec6::Zero(), Vec6::Zero()};
        int link = -1;    ///< whose coordinate it is along, if it is along one
        double sense = 1; ///< in which of the two ways
        bool isPlace() const { return kind == Kind::Limit || kind == Kind::Contact; }
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
    Row* addRow(Kind kind, Articulation& articulation, const Loops& loops, const Place& a, const Place& b,
                const Wrench& onA, const Wrench& onB, double sense) noexcept;
    Row* addRow(Kind kind, Articulation& articulation, const Loops& loops, const Coordinate& of,
                const Wrench& along, double sense) noexcept;
    double addSide(Side& side, int linkA, int linkB, Articulation& articulation, const Loops& loops,
                   const Wrench& onA, const Wrench& onB, double sense) noexcept;
    void gatherContacts(Articulation& articulation, const Loops& loops, double dt, bool early) noexcept;
    void gatherContact(int index, Articulation& articulation, const Loops& loops, double dt) noexcept;
    /// Along what a limit holds in the middle of a step, and what that way is more than it is now.
    struct Middle {
        Wrench along;
        /// m/s or rad/s: of its rate the part that comes only of where it points; and what frames that turn
        /// add to it in the whole step.
        double turning = 0, drift = 0;
    };
    Middle middleOf(const Articulation& articulation, const Coordinate& of, const Reading& now,
                    double dt) const noexcept;
    void gatherLimits(Articulation& articulation, const Loops& loops, const Coordinates& q,
                      double dt) noexcept;
    void gatherSprings(Articulation& articulation, const Loops& loops, const Coordinates& q,
                       double dt) noexcept;
    double velocityOf(const Row& row, const Coordinates& v) const noexcept;
    void push(const Row& row, double impulse, Coordinates& v) const noexcept;
    double relaxRow(std::size_t i, Coordinates& v) noexcept;
    double relaxRubs(std::size_t contact, Coordinates& v) noexcept;
    void relax(Coordinates& v, bool placesOnly) noexcept;
    double approachOf(const Row& row, const Coordinates& v) const noexcept;
    bool beginBlow(const Coordinates& v) noexcept;
    void strike(Coordinates& v) noexcept;
    void keepForces(double dt) noexcept;
    void hold(const Row& row, double dt, Coordinates& along) noexcept;

    const Mechanism& mechanism_;
    Contacts contacts_;
    std::vector<Row> rows_;
    std::size_t count_ = 0, numbers_ = 0;
    std::vector<double> jacobian_, change_;
    std::vector<Gap> gaps_;        ///< two for each limit: of its minimum and of its maximum
    std::vector<double> softness_; ///< of each spring at the start: 1 / inertia
    std::vector<Vec3> ways_;       ///< the directions of Rubs, by row
    Coordinates end_;
    std::vector<Vec6> held_; ///< N m and N on each link, about its frame, along the axes of the world
    bool holds_ = false;     ///< there is one
    double longest_ = 0;     ///< s: the step that springs are rows for
};

} // namespace tactum
