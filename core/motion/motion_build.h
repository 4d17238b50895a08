// Making motions and saying what they amount to: for readers and validation.
#pragma once

#include "core/motion/motion.h"

namespace tactum {

/// Puts a motion together from tracks whose times do not fall and whose vectors fit each other. Brings
/// rotations to unit length and finds where the motion jumps: at the keys of a step, at two keys of one time,
/// and at the end when it does not close. A step that a fast motion could make as well counts too: what is
/// small enough to be swept is for the proxy to say. Thread: any but real time.
Motion makeMotion(Track<Vec3> translation, Track<QuatCoefficients> rotation, double duration);

/// The motion with its lengths multiplied, for a scene that is scaled. Thread: any but real time.
Motion scaled(Motion motion, double factor);

/// Speed in m/s that no point of the body within `reach` metres of its origin exceeds while the motion does
/// not jump; between the keys of a cubic it is sampled. Thread: any but real time.
double topSpeed(const Motion& motion, double reach);

} // namespace tactum
