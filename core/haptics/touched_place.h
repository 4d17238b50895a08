// What a step touched, in a few numbers that go along with its local contact model.
#pragma once

#include <cstdint>

#include "core/haptics/haptic_step.h"

namespace tactum {

/// What friction does at a contact.
enum class ContactFriction : std::uint8_t {
    None,  ///< nothing is touched
    Stick, ///< it holds
    Slip,
    Smooth ///< there is no friction that could hold
};
inline constexpr std::size_t kContactFrictions = 4;

struct TouchedPlace {
    int contacts = 0;    ///< how many planes push
    ObjectId object = 0; ///< of the contact that pushes most; 0: nothing is touched
    Index surface = 0;   ///< index into the object's surfaces
    ContactFriction friction = ContactFriction::None;

    bool operator==(const TouchedPlace&) const = default;
};

/// `world`: in which the step was. Thread: real time.
TouchedPlace touchedPlace(const HapticOutput& output, const World& world) noexcept;

} // namespace tactum
