#include "core/safety/model_in_device.h"

namespace tactum {

LocalContactModel inDevice(const LocalContactModel& model_W, const DeviceFrame& frame) noexcept {
    LocalContactModel model = model_W;
    model.proxy = frame.pointInDevice(model_W.proxy);
    model.velocity = frame.wayInDevice(model_W.velocity);
    model.stiffness *= frame.scale;
    model.damping *= frame.scale;
    for (int i = 0; i < model.planes; ++i) {
        ConstraintPlane& plane = model.plane[std::size_t(i)];
        plane = {frame.turnedBack(plane.normal), plane.offset / frame.scale};
    }
    return model;
}

void lookAround(AroundHand& around, const LocalContactModel& model_W) noexcept {
    static_assert(kMaxModelPlanes <= int(kMaxWalls));
    around.walls = model_W.valid ? std::size_t(model_W.planes) : 0;
    for (std::size_t i = 0; i < around.walls; ++i) {
        const ConstraintPlane& plane = model_W.plane[i];
        around.wall[i] = {plane.normal, plane.offset + plane.normal.dot(model_W.proxy)};
    }
}

} // namespace tactum
