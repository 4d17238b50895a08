#include "core/port/handle_limit.h"

#include <algorithm>
#include <cmath>

#include "core/port/force_limiter.h"

namespace tactum {

HandleCommand heldTo(const DeviceInfo& device, const HandleCommand& wanted) noexcept {
    ForceLimiter torque{.maxForce = device.maxTorque};
    const double pinch = std::clamp(wanted.pinch, -device.maxPinch, device.maxPinch);
    return {torque(wanted.torque), std::isfinite(wanted.pinch) ? pinch : 0};
}

} // namespace tactum
