#include "core/scene/finger_path.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/numbers.h"
#include "core/geometry/soup_builder.h"

namespace tactum {

bool isFingerPath(std::span<const FingerPoint> points) {
    double before = -std::numeric_limits<double>::infinity();
    for (const FingerPoint& point : points) {
        if (!std::isfinite(point.t) || !(point.t > before) ||
            !std::ranges::all_of(point.position, isCoordinate))
            return false;
        before = point.t;
    }
    return !points.empty();
}

std::string fingerCsv(std::span<const FingerPoint> points) {
    std::string text = "t,x,y,z\n";
    for (const FingerPoint& point : points) {
        appendNumber(text, point.t);
        for (const double value : point.position) {
            text += ',';
            appendNumber(text, value);
        }
        text += '\n';
    }
    return text;
}

} // namespace tactum
