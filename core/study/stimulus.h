// What is felt in an interval, as a scene.
#pragma once

#include "core/scene/scene.h"
#include "core/study/trial_order.h"

namespace tactum {

/// The condition with the value of the staircase where the rule says. A copy is cheap: geometry is shared.
Scene sceneOf(const Scene& condition, const StaircaseRule& rule, const Stimulus& stimulus);

/// Whether the staircase changes anything there. Errors: one sentence with the remedy. Thread: any but real
/// time.
Result<void> checkStaircase(const Scene& condition, const StaircaseRule& rule);

/// Whether the finger may stay on a surface while one becomes the other: they differ in nothing but how their
/// surfaces feel.
bool sameShapes(const Scene& a, const Scene& b);

} // namespace tactum
