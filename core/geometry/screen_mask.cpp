#include "core/geometry/screen_mask.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tactum {

namespace {

/// A disc of this radius always has the middle of the pixel in it that it lies in.
constexpr double kOwnPixel = 0.71;

bool allFinite(std::span<const ScreenMask::Point> points) {
    return std::ranges::all_of(points, [](const ScreenMask::Point& p) { return p.allFinite(); });
}

/// Squared, from a point to a segment.
double apartSquared(const ScreenMask::Point& p, const ScreenMask::Point& a, const ScreenMask::Point& b) {
    const ScreenMask::Point along = b - a;
    const double length = along.squaredNorm();
    const double part = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
    return (p - a - part * along).squaredNorm();
}

} // namespace

ScreenMask::ScreenMask(int width, int height)
    : width_(width), height_(height), top_(height), bottom_(-1),
      bits_(std::size_t(width) * std::size_t(height)) {}

/// Pixels whose middles lie from `from` up to `to`.
void ScreenMask::addRow(int y, double from, double to) {
    const int first = int(std::ceil(std::clamp(from - 0.5, 0.0, double(width_))));
    const int last = int(std::ceil(std::clamp(to - 0.5, 0.0, double(width_))));
    if (first >= last) return;
    std::fill_n(bits_.begin() + std::ptrdiff_t(y) * width_ + first, last - first, std::uint8_t(1));
    top_ = std::min(top_, y);
    bottom_ = std::max(bottom_, y);
}

// A row at a time: where the line crosses it, and how often it has been gone round by then.
void ScreenMask::addPolygon(std::span<const Point> corners) {
    if (corners.size() < 3 || !allFinite(corners)) return;
    std::vector<std::pair<double, int>> crossings;
    for (int y = 0; y < height_; ++y) {
        const double middle = y + 0.5;
        crossings.clear();
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
            if ((a.y() <= middle) == (b.y() <= middle)) continue;
            const double part = (middle - a.y()) / (b.y() - a.y());
            crossings.emplace_back(a.x() + part * (b.x() - a.x()), a.y() < b.y() ? 1 : -1);
        }
        std::ranges::sort(crossings);
        int round = 0;
        for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
            round += crossings[i].second;
            if (round != 0) addRow(y, crossings[i].first, crossings[i + 1].first);
        }
    }
}

void ScreenMask::addStroke(const Point& from, const Point& to, double radius) {
    const Point ends[] = {from, to};
    if (!allFinite(ends) || !std::isfinite(radius)) return;
    const double reach = std::max(radius, kOwnPixel);
    const auto clamped = [](double value, int most) { return int(std::clamp(value, 0.0, double(most))); };
    const Point low = from.cwiseMin(to).array() - reach, high = from.cwiseMax(to).array() + reach;
    const int left = clamped(std::floor(low.x()), width_), right = clamped(std::ceil(high.x()), width_);
    for (int y = clamped(std::floor(low.y()), height_); y < clamped(std::ceil(high.y()), height_); ++y)
        for (int x = left; x < right; ++x)
            if (apartSquared({x + 0.5, y + 0.5}, from, to) <= reach * reach) addRow(y, x, x + 1);
}

} // namespace tactum
