// The update stage on surfaces that feel otherwise than their facets: shaded or textured (sections 3, 4.3).
#pragma once

#include <array>
#include <optional>
#include <span>

#include "core/base/inplace_vector.h"
#include "core/proxy/proxy.h"
#include "core/proxy/surface_under.h"

namespace tactum {

/// The smallest feature of a texture passes by in so many steps. Of waves as short nothing is left, for the
/// steps would show them as others; from eight times of it on all is. At a rate f frequencies up to f / 20
/// are whole, of a formula half is left of f / 7, of a picture of f / 5, and none of f / 2.5.
inline constexpr double kStepsToAFeature = 2.5;
/// Features of a texture below this part of the proxy's radius are not felt at any speed.
inline constexpr double kFinestFeature = 0.05;

/// What the update stage works on. World frame, SI.
struct FeltContacts {
    std::span<const Obstacle> obstacles;
    const StepMotions& movers;
    std::span<Contact> contacts;
    double radius = 0;
    Vec3 finger = Vec3::Zero();
    double smallestFeature = 0;  ///< of the texture, m
    Vec3 passing = Vec3::Zero(); ///< which way the smallest that is not too fast passes, m
};

/// Whether any of the contacts is on a surface with shading or texture. Thread: real time.
bool isFelt(std::span<const Obstacle> obstacles, std::span<const Contact> contacts) noexcept;

/// Both passes of section 3, at one place after the other within a step: what all contacts of a proxy feel
/// like there. Where the proxy goes to where it was looked last, nothing is looked at again. Thread: real
/// time.
class FeltPasses {
public:
    FeltPasses() noexcept {} // not defaulted, or room that is not used would be filled with zeros

    /// Where the proxy would go without friction, relative to where it is: zero exactly where the finger is
    /// held by a force along the felt normals. The multipliers are those of the contacts' true planes, in
    /// their order. Writes them into the contacts, with the materials that are felt, and lists the felt
    /// planes that push. Two minimisations and one sample of the texture for each contact.
    NearestPoint update(ProxyState& state, const FeltContacts& on) noexcept;

    /// What friction does to a slide.
    struct Hold {
        double back = 0;     ///< what it holds back of the wish at the beginning, m
        double lag = 0;      ///< of the viscosity there, s
        double followed = 1; ///< how much of what changes on the way it lets the slide follow: followedPart()
    };

    /// How much of `slide` leads on, after `drop`, of what update() just wished: the felt normal, the depth
    /// and the friction change on the way, and beyond the place where the wish turns back, or where friction
    /// holds what is left of it, the proxy would swing to and fro. `settled`: nothing is looked for that is
    /// shorter than this, m. At most 1, or 2 with `mayExtend`, where the wish is seen to reach farther. At
    /// most ten updates.
    double reach(const ProxyState& state, const FeltContacts& on, const Vec3& drop, const Vec3& slide,
                 const Hold& hold, double settled, bool mayExtend) noexcept;

    /// Leads the motion from `from` that reach() looked along on, without friction, to where the proxy comes
    /// to rest. Whether it is known to: then it would wish no farther there than `settled`, m, as far as the
    /// secants of the places tell that were looked at. At most four updates.
    bool comeToRest(const FeltContacts& on, const Vec3& from, Vec3& motion, double settled) noexcept;

    /// Whether the contacts are those that were looked at last; then they get what was found there, as by
    /// update().
    bool settleAsLooked(ProxyState& state, const FeltContacts& on) noexcept;

private:
    /// Of a contact that was looked at.
    struct Looked {
        std::uint32_t body = 0;
        Index triangle = 0;
        bool isBeyond = false; ///< it would touch another one there, or the place lies beside its face
        bool isFelt = false;   ///< look() was there: what it rubs with is what its layers say
    };

    const NearestPoint& at(const Vec3& centre, Look where) noexcept;
    void clear() noexcept;
    bool hasLookedAt(std::span<const Contact> contacts) const noexcept;
    void settle(ProxyState& state) const noexcept;
    double locate(std::size_t i, Look where) noexcept;
    void look(std::size_t i) noexcept;
    void rub(std::size_t i) noexcept;
    Fineness finenessOn(const Pose& pose) const noexcept;
    std::optional<Vec3> feltAlone(std::size_t i) const noexcept;
    void add(std::size_t owner, const Vec3& normal) noexcept;
    bool isAboveAll(const Vec3& u) noexcept;
    int theOnlyPlane() const noexcept;
    bool endsKnown(const Vec3& u) noexcept;
    bool lookIntoCorner(const Vec3& u, double touching) noexcept;
    bool alongOneNormal(const Vec3& u) noexcept;
    bool goesOnOverAnother(const Vec3& u) noexcept;
    bool alongTheFeltNormal(const Vec3& u, std::size_t j, std::size_t i) noexcept;
    bool alongBothNormals(const Vec3& u) noexcept;
    std::array<std::size_t, 2> bothPlanes() const noexcept;
    bool isFree(const Vec3& x) noexcept;
    void pushAlongTrueNormals() noexcept;
    void secondPass(const Vec3& subgoal) noexcept;
    bool projectBack(const Vec3& subgoal) noexcept;
    // felt_slide.cpp
    /// What is wished at a place, m.
    struct Wish {
        Vec3 place = Vec3::Zero();
        Vec3 way = Vec3::Zero();
    };
    /// Where a wish leads, relative to where it was looked last, and what would be left of it there, m.
    struct Rest {
        Vec3 way = Vec3::Zero();
        double leaves = 0;
    };
    Rest rest() noexcept;
    std::optional<Vec3> root() const noexcept;
    void lookOn(const Vec3& place) noexcept;
    double held(const Vec3& way) const noexcept;
    double lag() const noexcept;

    const FeltContacts* on_ = nullptr;
    Vec3 centre_ = Vec3::Zero();
    Vec3 way_ = Vec3::Zero();                  ///< of the slide that it looked along last
    double leads_ = 1;                         ///< how many times its wish leads on along that, by the secant
    InplaceVector<Wish, 2> before_;            ///< where else it looked on this slide
    InplaceVector<Looked, kMaxPlanes> looked_; ///< all contacts, as at the last look
    InplaceVector<ConstraintPlane, kMaxPlanes> true_, felt_;
    InplaceVector<Foot, kMaxPlanes> foot_; ///< of each contact, where it would touch there
    InplaceVector<Material, kMaxPlanes> material_;
    InplaceVector<std::uint8_t, kMaxPlanes> owner_; ///< of each felt plane: its contact
    NearestPoint pushing_;                          ///< of pass 1
    NearestPoint result_;                           ///< of both: the multipliers are the contacts'
};

/// FeltPasses::update() alone. Thread: real time.
NearestPoint updateFelt(ProxyState& state, const FeltContacts& on) noexcept;

} // namespace tactum
