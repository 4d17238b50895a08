// Loops as people have them: every shipped profile, as its driver says it, in some hand.
#pragma once

#include <cmath>
#include <string_view>

#include "device/profile.h"
#include "tests/physics/profiles.h"

namespace tactum::test {

/// A device of a shipped profile. No profile tells its mass.
struct Connected {
    std::string_view key;
    double mass; ///< kg, assumed
};

inline constexpr Connected kPremiumConnected{"phantom-premium-1.5", 0.075}, kOmegaConnected{"omega", 0.2},
    kTouchConnected{"touch", 0.05}, kFalconConnected{"falcon", 0.15};
inline constexpr std::array kConnected{kPremiumConnected,
                                       kOmegaConnected,
                                       kTouchConnected,
                                       kFalconConnected,
                                       Connected{"touch-x", 0.06},
                                       Connected{"phantom-omni", 0.05},
                                       Connected{"phantom", 0.075},
                                       Connected{"phantom-premium-3.0", 0.15},
                                       Connected{"delta", 0.25},
                                       Connected{"sigma", 0.3},
                                       Connected{"lambda", 0.3},
                                       Connected{"inverse3", 0.1},
                                       Connected{"wooden-haptics", 0.1},
                                       Connected{"polhem", 0.15}};

/// As the driver says it, who knows of a light pinch alone.
inline DeviceInfo connectedInfo(const Connected& device) {
    return profileOf(device.key, {}).value().info;
}

inline Bench benchOf(const Connected& device, const HandProfile& hand) {
    const DeviceInfo info = connectedInfo(device);
    return {{device.key.data(), device.mass, info.damping, info.dryFriction, info.positionResolution,
             info.maxForce, info.amplifierLag},
            hand,
            {.rate = info.rate, .delay = int(std::ceil(info.delay))}};
}

} // namespace tactum::test
