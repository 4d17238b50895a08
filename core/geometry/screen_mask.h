// Pixels of a view that are chosen: a box, what a line goes round, discs along the way of a brush.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace tactum {

/// A bit for each pixel; x to the right, y down, the upper left corner of the first pixel at (0, 0). What is
/// added may lie outside, as far as it likes; numbers that are not finite add nothing. Thread: any but real
/// time.
class ScreenMask {
public:
    using Point = Eigen::Vector2d; ///< pixels

    /// Empty. Nothing negative.
    ScreenMask(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }
    bool has(int x, int y) const { return bits_[std::size_t(y) * std::size_t(width_) + std::size_t(x)]; }
    bool empty() const { return top_ > bottom_; }
    /// The first and the last row with a chosen pixel; of an empty mask the first is behind the last.
    int top() const { return top_; }
    int bottom() const { return bottom_; }

    /// Every pixel whose middle the closed line goes round, be it more than once.
    void addPolygon(std::span<const Point> corners);
    /// Every pixel whose middle a disc goes over on its way, at least those that the way begins and ends in.
    void addStroke(const Point& from, const Point& to, double radius);

private:
    void addRow(int y, double from, double to);

    int width_, height_, top_, bottom_;
    std::vector<std::uint8_t> bits_;
};

} // namespace tactum
