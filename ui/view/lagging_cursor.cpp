#include "ui/view/lagging_cursor.h"

#include <algorithm>
#include <cmath>

namespace tactum {

double LaggingCursor::ratio(QPointF step, QPointF push) {
    const double length = std::hypot(step.x(), step.y());
    if (length == 0) return 1;
    return std::clamp(1 + QPointF::dotProduct(push, step) / length / kHalt, kLeast, kMost);
}

QPointF LaggingCursor::follow(QPointF mouse, QPointF push) {
    const QPointF step = mouse - mouse_;
    mouse_ = mouse;
    return at_ += ratio(step, push) * step;
}

} // namespace tactum
