#include "core/safety/command_check.h"

#include "core/haptics/contact_model.h"

namespace tactum {

double suddenChange(const Vec3& command, const Vec3& expected, const Explanation& by) noexcept {
    return rise(command, expected) - by.stiffness * by.way - by.damping * by.speed;
}

} // namespace tactum
