#include "core/bundle/sample_stroke.h"

#include <cmath>
#include <numbers>

#include "core/haptics/replay.h"

namespace tactum {
namespace {

constexpr double kTick = 1e-3; // s

/// Straight down from above the box to below it, in a second.
std::vector<FingerPoint> plumbLine(const Bounds& box, double radius) {
    std::vector<FingerPoint> path;
    const Vec3 from(box.centre().x(), box.high.y() + 4 * radius, box.centre().z());
    const double way = box.high.y() - box.low.y() + 5 * radius;
    for (int i = 0; i < 1000; ++i)
        path.push_back({i * kTick, from - Vec3(0, way * i / 1000.0, 0)});
    return path;
}

/// Between two places with a smooth start and end.
Vec3 eased(const Vec3& from, const Vec3& to, double part) {
    return from + 0.5 * (1 - std::cos(std::numbers::pi * part)) * (to - from);
}

} // namespace

std::vector<FingerPoint> sampleStroke(const World& world) {
    const Bounds box = boundsOf(*world.scene);
    if (box.empty()) return {};
    const std::vector<FingerPoint> line = plumbLine(box, world.proxyRadius);
    Vec3 touched = line.back().position;
    for (const TouchRow& row : replay(world, line))
        if (row.contacts > 0) {
            touched = row.finger;
            break;
        }
    const double size = box.diagonal(), circle = size / 16, depth = 0.01 * size;
    const Vec3 above = line.front().position, pressed = touched - Vec3(0, depth, 0);
    std::vector<FingerPoint> path;
    for (int i = 0; i <= 4000; ++i) {
        const double t = i * kTick;
        Vec3 p = pressed;
        if (t < 1)
            p = eased(above, pressed, t);
        else if (t < 3) {
            const double turn =
                std::numbers::pi * (1 - std::cos(std::numbers::pi * (t - 1) / 2)); // from 0 to 2 pi
            p += circle * Vec3(1 - std::cos(turn), 0, std::sin(turn));
        } else
            p = eased(pressed, above, t - 3);
        path.push_back({t, p});
    }
    return path;
}

} // namespace tactum
