// What one haptic step gives: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <tactum/export.h>
#include <tactum/vec.h>

namespace tactum::library {

/// One touched place. World frame, SI.
struct Contact {
    Vec3 point;                ///< on the surface
    Vec3 normal;               ///< out of the surface toward the proxy, of length 1
    double normalForce = 0;    ///< N
    std::uint32_t object = 0;  ///< Object::id()
    std::uint32_t surface = 0; ///< its place among those of the object
    bool slipping = false;     ///< else it sticks, or has no friction
    bool frictionless = false;

    bool operator==(const Contact&) const = default;
};

/// More planes than these never push at once.
inline constexpr std::size_t kMostContacts = 4;

/// World frame, SI.
struct Step {
    double time = 0; ///< s, at its end
    Vec3 finger;
    Vec3 proxy; ///< which stays outside
    Vec3 force; ///< N on the finger, before any device's limit
    std::uint32_t contacts = 0;
    std::array<Contact, kMostContacts> contact{};

    std::span<const Contact> touched() const noexcept {
        return std::span(contact).first(contacts < kMostContacts ? contacts : kMostContacts);
    }
    bool operator==(const Step&) const = default;
};

} // namespace tactum::library
