// What a person has decided about a device: where its workspace lies, and what its buttons do.
#pragma once

#include <cstdint>

#include <QString>

#include "core/port/haptic_device.h"
#include "core/port/workspace.h"
#include "core/surface/parameter.h"

namespace tactum {

inline constexpr Parameter kWorkspaceScale{
    "workspace-scale",
    "Scale",
    "",
    kMinScale,
    kMaxScale,
    0.1,
    1,
    3,
    "Metres of the scene to a metre of the handle: 2 lets a small device reach twice as far, 0.1 feels what "
    "is fine. A spring of the scene feels stiffer by as much, so the stiffness ceiling falls by it."};

struct DeviceSettings {
    Workspace workspace;
    std::uint32_t stopButton = 0; ///< as in StopSwitch
    bool grasped = false;         ///< as in Engine::setGrasped()

    bool operator==(const DeviceSettings&) const = default;
};

/// As they were when no device of that id was known; what was remembered and cannot be is left out.
DeviceSettings rememberedSettings(const QString& deviceId);
void rememberSettings(const QString& deviceId, const DeviceSettings& settings);

/// How far a handle reaches from its centre, m; what is usual where the device does not know it.
double usualRadius(const DeviceInfo& device);

/// The mapping in which the world's axis `which` is the device's `axis`: where another world axis had that
/// one, it gets what this one had, so that every mapping that can be chosen is possible.
AxisMap withAxis(AxisMap axes, std::size_t which, int axis);

} // namespace tactum
