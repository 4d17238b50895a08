// What a device says of itself may lower a limit of its profile, never raise one.
#pragma once

namespace tactum {

/// `said`: 0, negative or no number where it does not know. Thread: any.
inline void lowerTo(double& limit, double said) noexcept {
    if (said > 0 && said < limit) limit = said;
}

} // namespace tactum
