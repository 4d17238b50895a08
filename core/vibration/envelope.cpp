#include "core/vibration/envelope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tactum {
namespace {

constexpr double kWindow = 0.04;  // s
constexpr double kNothing = 1e-9; // N

} // namespace

std::vector<EnvelopePoint> envelopeOf(const Vibration& vibration) {
    const auto count = std::ptrdiff_t(vibration.force.size());
    const auto step = std::ptrdiff_t(kEnvelopeStep * vibration.rate);
    const auto reach = std::ptrdiff_t(kWindow * vibration.rate / 2);
    const auto at = [&](std::ptrdiff_t i) { return vibration.force[std::size_t(i)]; };
    std::vector<EnvelopePoint> points;
    for (std::ptrdiff_t centre = 0; centre < count; centre += step) {
        double weights = 0, power = 0, ofChange = 0;
        for (std::ptrdiff_t i = std::max(centre - reach, std::ptrdiff_t(1));
             i <= std::min(centre + reach, count - 2); ++i) {
            const double weight = 1 + std::cos(std::numbers::pi * double(i - centre) / double(reach + 1));
            const double change = (at(i + 1) - at(i - 1)) / 2;
            weights += weight;
            power += weight * at(i) * at(i);
            ofChange += weight * change * change;
        }
        EnvelopePoint point{double(centre) / vibration.rate, 0, points.empty() ? 0 : points.back().frequency};
        if (weights > 0) point.amplitude = std::sqrt(2 * power / weights);
        if (point.amplitude > kNothing) // a sine's change over two samples is the sine of its step
            point.frequency = std::asin(std::min(1.0, std::sqrt(ofChange / power))) * vibration.rate /
                              (2 * std::numbers::pi);
        points.push_back(point);
    }
    return points;
}

} // namespace tactum
