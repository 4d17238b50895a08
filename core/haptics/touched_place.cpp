#include "core/haptics/touched_place.h"

#include <algorithm>
#include <span>

namespace tactum {

TouchedPlace touchedPlace(const HapticOutput& output, const World& world) noexcept {
    const std::span known(output.contact.data(),
                          std::size_t(std::clamp(output.contacts, 0, kMaxModelPlanes)));
    if (known.empty()) return {};
    const ContactReport& most = *std::ranges::max_element(known, {}, &ContactReport::normalForce);
    if (most.body >= world.bodies.size()) return {};
    const ContactFriction held = most.slipping ? ContactFriction::Slip : ContactFriction::Stick;
    return {int(known.size()), world.bodies[most.body].object, most.surface,
            most.frictionless ? ContactFriction::Smooth : held};
}

} // namespace tactum
