// Where the objects are that forces move, for who looks at them from outside of the loops.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/haptics/haptic_step.h"
#include "core/haptics/world.h"

namespace tactum {

struct PlacedObject {
    ObjectId object = 0;
    Pose pose; ///< X_WB
};

/// At which of its rests a joint with detents is nearest, counted from JointDrive::position.
struct AtDetent {
    ObjectId object = 0; ///< that the joint moves
    int detent = 0;

    bool operator==(const AtDetent&) const = default;
};

/// Of one World; its own memory, so that the loop's is left alone. Thread: one, any but real time.
class BodyPlaces {
public:
    /// `world` may be null: nothing moves.
    explicit BodyPlaces(const World* world = nullptr);

    /// Until the next call. A state of other bodies shows them where they begin.
    std::span<const PlacedObject> at(const BodiesState& state);
    /// Of each joint of one freedom that has detents, always in the same order, as at() was last told.
    std::span<const AtDetent> detents() const { return atDetents_; }
    /// While the finger touches as it is told, and the hand gets `given`. Nothing for what no force moves.
    std::optional<BodyReading> readingOf(const BodiesState& state, BodyId body,
                                         const HapticOutput& touch = {}, const Coupling& given = {});

private:
    struct Detents {
        BodyId body = 0;
        double spacing = 0, position = 0; ///< m or rad
    };

    std::unique_ptr<MovingBodies> bodies_;
    std::vector<PlacedObject> places_;
    std::vector<Detents> detents_;
    std::vector<AtDetent> atDetents_; ///< as many
    std::vector<int> driven_;         ///< Mover::driven by the index of World::bodies; -1: no force moves it
};

} // namespace tactum
