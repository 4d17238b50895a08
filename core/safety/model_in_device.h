// A local contact model as the hand meets it.
#pragma once

#include "core/haptics/contact_model.h"
#include "core/port/device_frame.h"
#include "core/port/reach_tracker.h"

namespace tactum {

/// The same surroundings in frame D, with the stiffness and damping that they have there: a scale of the
/// workspace changes both. Thread: real time.
LocalContactModel inDevice(const LocalContactModel& model_W, const DeviceFrame& frame) noexcept;

/// What a hand touches, for the workspace that moves by itself. World frame. Thread: real time.
void lookAround(AroundHand& around, const LocalContactModel& model_W) noexcept;

} // namespace tactum
