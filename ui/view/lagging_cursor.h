// A pointer that forces hold back or drive on: pseudo-haptic feedback, which the eye feels without a device.
#pragma once

#include <QPointF>

namespace tactum {

/// The ratio of what is seen to what the mouse does changes with the force along the way (Lecuyer et al.,
/// "Pseudo-haptic feedback", IEEE VR 2000, and "Feeling bumps and holes without a haptic interface", CHI
/// 2004). Pixels of the view. Thread: ui.
class LaggingCursor {
public:
    static constexpr double kHalt =
        1.5; ///< N against the way, that would hold it; kLeast goes on all the same
    static constexpr double kLeast = 0.2, kMost = 1.8;

    /// Seen for each pixel of the mouse. `push`: N, in the plane of the picture, right and down.
    static double ratio(QPointF step, QPointF push);

    /// Is where the mouse is.
    void begin(QPointF mouse) { at_ = mouse_ = mouse; }
    /// The mouse went on to here.
    QPointF follow(QPointF mouse, QPointF push);
    QPointF at() const { return at_; }

private:
    QPointF at_, mouse_;
};

} // namespace tactum
