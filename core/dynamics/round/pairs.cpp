#include "core/dynamics/round/pairs.h"

#include <array>

namespace tactum {

namespace {

/// By Convex::Form, the lesser one first.
constexpr std::array<std::array<RoundPair*, 4>, 4> kPairs{{
    {nullptr, nullptr, nullptr, nullptr},
    {nullptr, ballAndBall, ballAndCapsule, ballAndCylinder},
    {nullptr, nullptr, capsuleAndCapsule, capsuleAndCylinder},
    {nullptr, nullptr, nullptr, cylinderAndCylinder},
}};

} // namespace

std::optional<TouchPoints> touchRound(const Convex& a, const Pose& a_W, const Convex& b, const Pose& b_W,
                                      double margin) noexcept {
    if (a.form > b.form) {
        const auto points = touchRound(b, b_W, a, a_W, margin);
        return points ? std::optional(reversed(*points)) : points;
    }
    RoundPair* const touch = kPairs[std::size_t(a.form)][std::size_t(b.form)];
    return touch ? touch(roundBodyOf(a, a_W), roundBodyOf(b, b_W), margin) : std::nullopt;
}

} // namespace tactum
