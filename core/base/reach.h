// What an author chooses for hands that reach beyond their device's workspace.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tactum {

enum class ReachMode : std::uint8_t {
    Position, ///< the finger follows the hand, and nothing else moves it
    Rate,     ///< beyond the shell the workspace goes where the hand pulls, and the border is felt
    Drift     ///< while the hand moves, the workspace goes slowly to where it works
};
inline constexpr std::size_t kReachModes = 3;

/// Of Reach::shell. Unit: m.
inline constexpr double kMinShell = 0.005, kMaxShell = 0.5, kUsualShell = 0.03;

/// What the author of a scene chooses.
struct Reach {
    ReachMode mode = ReachMode::Position;
    double shell = kUsualShell; ///< m about the device's centre, in the hand's measure

    bool operator==(const Reach&) const = default;
};

} // namespace tactum
