#include "core/report/force_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "core/report/html.h"

namespace tactum {

namespace {

constexpr double kLeft = 52, kRight = 16, kTop = 34, kBottom = 44; // pixels around the curves
constexpr std::size_t kColumns = 700;                              // of the curves: steps in one are one

/// 1, 2 or 5 times a power of ten, so that some five of them fill a range.
double stepOf(double range) {
    const double raw = range / 5, power = std::pow(10, std::floor(std::log10(raw)));
    const double part = raw / power;
    return power * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
}

std::string pixels(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%d.%d", int(value), int(10 * (value - int(value))));
    return text;
}

/// From time and force to the drawing.
struct Frame {
    double begin, length, most; ///< s, s, N

    double x(double t) const { return kLeft + (kChartWidth - kLeft - kRight) * (t - begin) / length; }
    double y(double force) const {
        return kChartHeight - kBottom - (kChartHeight - kTop - kBottom) * force / most;
    }
};

Frame frameOf(const TouchTrace& rows) {
    double most = 0;
    for (const TouchRow& row : rows)
        most = std::max(most, row.force.norm());
    if (!(most > 0)) most = 1;
    const double length = rows.back().t - rows.front().t;
    return {rows.front().t, length > 0 ? length : 1, 1.08 * most};
}

std::string label(double x, double y, const char* anchor, const std::string& words) {
    return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" text-anchor=\"" + anchor + "\">" + words +
           "</text>\n";
}

std::string line(double x1, double y1, double x2, double y2, const char* look) {
    return "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) + "\" y2=\"" +
           pixels(y2) + "\" " + look + "/>\n";
}

constexpr const char *kGrid = "stroke=\"#d0d4da\"", *kForce = "stroke=\"#b35900\" stroke-width=\"2\"",
                     *kAlong = "stroke=\"#5b3aa8\" stroke-width=\"1.5\" stroke-dasharray=\"6 3\"";

std::string grid(const Frame& frame) {
    std::string text;
    const double right = kChartWidth - kRight, bottom = kChartHeight - kBottom;
    const double forces = stepOf(frame.most), times = stepOf(frame.length);
    for (int i = 0; i * forces <= frame.most; ++i) {
        const double y = frame.y(i * forces);
        text += line(kLeft, y, right, y, kGrid) + label(kLeft - 8, y + 4, "end", readable(i * forces));
    }
    for (int i = 0; i * times <= frame.length * (1 + 1e-9); ++i) {
        const double x = frame.x(frame.begin + i * times);
        text += line(x, kTop, x, bottom, kGrid) + label(x, bottom + 18, "middle", readable(i * times));
    }
    return text + label(0.5 * (kLeft + right), bottom + 36, "middle", "time, s");
}

std::string legend() {
    return label(8, 20, "start", "N") + line(kLeft, 16, kLeft + 30, 16, kForce) +
           label(kLeft + 36, 20, "start", "force") + line(kLeft + 110, 16, kLeft + 140, 16, kAlong) +
           label(kLeft + 146, 20, "start", "along the surface");
}

/// Of what lies within one column the largest: a short blow is not lost.
std::string curve(const TouchTrace& rows, const Frame& frame,
                  const std::function<double(const TouchRow&)>& valueOf, const char* look) {
    std::string points;
    const std::size_t each = std::max<std::size_t>(1, rows.size() / kColumns);
    for (std::size_t i = 0; i < rows.size(); i += each) {
        const auto end = rows.begin() + std::ptrdiff_t(std::min(i + each, rows.size()));
        double most = 0;
        for (auto row = rows.begin() + std::ptrdiff_t(i); row != end; ++row)
            most = std::max(most, valueOf(*row));
        points += pixels(frame.x(rows[i].t)) + "," + pixels(frame.y(most)) + " ";
    }
    return "<polyline points=\"" + points + "\" fill=\"none\" " + look + "/>\n";
}

} // namespace

std::string forceChart(const TouchTrace& rows) {
    const Frame frame = frameOf(rows);
    const std::string width = std::to_string(kChartWidth), height = std::to_string(kChartHeight);
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
           "\" viewBox=\"0 0 " + width + " " + height + "\" font-family=\"sans-serif\" font-size=\"13\">\n" +
           "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n" + grid(frame) +
           curve(
               rows, frame, [](const TouchRow& row) { return row.force.norm(); }, kForce) +
           curve(
               rows, frame, [](const TouchRow& row) { return row.tangential; }, kAlong) +
           legend() + "</svg>\n";
}

} // namespace tactum
