#include "ui/base/screen_colour.h"

#include <algorithm>
#include <cmath>

namespace tactum {

namespace {
constexpr float kCurve = 2.2f;
}

QColor screenColour(const Eigen::Vector3f& linear) {
    const auto shown = [](float c) { return std::pow(std::clamp(c, 0.f, 1.f), 1 / kCurve); };
    return QColor::fromRgbF(shown(linear.x()), shown(linear.y()), shown(linear.z()));
}

Eigen::Vector3f linearColour(const QColor& screen) {
    return {std::pow(screen.redF(), kCurve), std::pow(screen.greenF(), kCurve),
            std::pow(screen.blueF(), kCurve)};
}

} // namespace tactum
