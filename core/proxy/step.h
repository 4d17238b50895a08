// One step of the proxy: rounds of update (section 2.2), friction (4) and move (2.1).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "core/base/inplace_vector.h"
#include "core/proxy/felt_planes.h"
#include "core/proxy/near_bodies.h"
#include "core/proxy/proxy.h"
#include "core/proxy/straddled_bodies.h"
#include "core/surface/friction.h"

namespace tactum {

// A contact that pushes is not given up while it is within this part of the radius.
inline constexpr double kHover = 0.1;
// A touch is kept while its gap is within this many skins; what is farther away is found by the sweep.
inline constexpr double kKeep = 2;
// Motion and change of the constraint planes below these parts of the radius count as rest; far from the
// origin what a double still tells apart.
inline constexpr double kRest = 1e-9;
inline constexpr double kTold = 4 * std::numeric_limits<double>::epsilon();

/// One step: the state it works on and what stays the same during it. World frame, SI. Thread: real time.
class Step {
public:
    Step(ProxyState& state, std::span<const Obstacle> obstacles, const StepMotions& movers, double radius,
         const Vec3& finger, double dt, const Vec3& start, int mostRounds, const NearBodies* near)
        : state_(state), obstacles_(obstacles), movers_(movers), radius_(radius),
          rest_(std::max(kRest * radius, kTold * start.norm())), finger_(finger), dt_(dt), timeLeft_(dt),
          fingerVelocity_((finger - state.finger) / dt), start_(start), mostRounds_(mostRounds), near_(near),
          oneSided_(near ? near->oneSided() : anyOneSided(obstacles)) {}

    ProxyReport run() noexcept;

private:
    using Planes = InplaceVector<ConstraintPlane, kMaxPlanes>;
    using Pushes = InplaceVector<Push, kMaxPlanes>;

    std::span<const Contact> contacts() const {
        return {state_.contacts.data(), std::size_t(state_.contactCount)};
    }
    std::span<Contact> contacts() { return {state_.contacts.data(), std::size_t(state_.contactCount)}; }

    // step_rounds.cpp
    void judge() noexcept;
    bool isAstray() noexcept;
    void returnToNearest() noexcept;
    void keepAsNearest(double distance) noexcept;
    void goBackToNearest() noexcept;
    bool isFarther(double distance) const noexcept;
    void shortenGuesses() noexcept;
    void takeBackGuess() noexcept;
    Planes planes() noexcept;
    bool round() noexcept;
    void comeOut() noexcept;
    void comeDown() noexcept;
    void moveTowardFirst(const Vec3& motion) noexcept;
    Vec3 unconstrainedByFriction() noexcept;
    NearestPoint updatePlain() noexcept;
    void countStillSteps() noexcept;
    bool refreshContacts(bool known = false) noexcept;
    void forgetInactive() noexcept;
    void finish() noexcept;

    // step_friction.cpp
    double lag() const noexcept;
    bool rubs() noexcept;
    double frictionAllows(const Vec3& way, double excess) noexcept;
    bool isHeld(const Pushes& pushing, const Vec3& way, double excess) noexcept;
    bool holdsOn(std::uint32_t body, Index triangle, const Vec3& place) noexcept;
    Vec3 towardTheCone(const Vec3& drop, const Vec3& along, double part) noexcept;
    static double heldBack(const Vec3& along, const Vec3& slide) noexcept;
    Vec3 leanOfTheFelt() noexcept;
    bool sticksAtRest() const noexcept;
    Pushes pushes() noexcept;
    std::optional<Vec3> feltAlone(const Contact& contact) noexcept;
    bool isViscous() noexcept;

    // step_felt.cpp
    FeltContacts feltContacts() noexcept;
    NearestPoint updateFelt() noexcept;
    Vec3 alongFelt(const Vec3& drop, Vec3 slide, double back, bool mayExtend) noexcept;
    double settled() const noexcept;
    Vec3 seat() noexcept;
    Vec3 seatOnFelt() noexcept;
    bool isSeated() noexcept;
    bool hovers() noexcept;
    double settlingStride() const noexcept;

    // step_curved.cpp
    Vec3 alongCurvature(const Vec3& flat, double excess) noexcept;
    bool isAllowed(const Vec3& motion) noexcept;
    static double bentPart(const Contact& contact, const Vec3& way) noexcept;
    Vec3 aroundAlone(const Contact& contact, const Vec3& flat) noexcept;
    Vec3 alongBoth(const Contact& a, const Contact& b, const Vec3& flat) noexcept;
    Vec3 farther(const Vec3& flat, const Vec3& way, double bend) noexcept;
    Vec3 withinReach(const Vec3& flat, const Vec3& curved) const noexcept;
    Vec3 guessed(const Vec3& flat, const Vec3& bent, std::span<const Contact* const> held) noexcept;

    // step_sweep.cpp
    SweepHit sweep(const Vec3& motion, std::uint32_t& body) noexcept;
    void sweepOne(std::uint32_t i, const Vec3& motion, SweepHit& first, std::uint32_t& body) noexcept;
    bool looksNear(const Obstacle& obstacle) const noexcept;
    void takeSoon(std::uint32_t i, const SweepHit& hit, const Vec3& end_B, SweepHit& first) noexcept;
    void goTo(const Vec3& place) noexcept;
    bool isFeltFrom(const Contact& contact, const Vec3& place_W) noexcept;
    bool isStillFelt(const Contact& contact) noexcept;
    bool meet(std::uint32_t body, Index triangle) noexcept;
    void foresee(std::uint32_t body, const SweepHit& hit) noexcept;
    void takeOver() noexcept;
    void handOver(const Contact& from, Contact& to) noexcept;
    void locate(Contact& contact) noexcept;

    ProxyState& state_;
    std::span<const Obstacle> obstacles_;
    const StepMotions& movers_;
    double radius_;
    double rest_; ///< m
    Vec3 finger_;
    double dt_;
    double timeLeft_;
    Vec3 fingerVelocity_;
    Vec3 start_;                       ///< where the proxy was, or where what it rides on took it
    Vec3 lastSlide_ = Vec3::Zero();    ///< the last one on a felt surface
    std::optional<FeltPasses> passes_; ///< what was last looked at there
    int mostRounds_;
    const NearBodies* near_; ///< null: look at every obstacle
    bool oneSided_;          ///< something is felt from one side alone
    int rounds_ = 0;
    bool squeezed_ = false;
    Vec3 nearest_; ///< the nearest place of this step that it was at
    InplaceVector<StraddledBody, kMaxStraddled> nearestStraddled_; ///< what the proxy was half through there
    double nearestDistance_ = std::numeric_limits<double>::infinity();
    double reach_ = std::numeric_limits<double>::infinity(); ///< how far a curved step may go, m
    double guess_ = 0;                      ///< how far the last one went beyond the plain step, m
    InplaceVector<Contact, 2> guessedFrom_; ///< what held the proxy where it began
    int vainRounds_ = 0;                    ///< since it began, none of them nearer
    bool guessed_ = false;                  ///< this round went along a curve
    bool felt_ = false;                     ///< some contact of this round is shaded or textured
    bool smooth_ = false;                   ///< no contact of this round rubs or is felt
    bool onTheEdge_ = false;                ///< of the cone of friction, where it was asked last
    int pushing_ = 0;                       ///< how many planes hold the proxy in this round
    std::uint32_t soonBody_ = 0;            ///< of the triangle that the last sweep ended near
    double soonGap_ = 0;                    ///< from there, m
};

} // namespace tactum
