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

} // namespace tactum
