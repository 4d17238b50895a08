// The way of the proxy along the model from touch to lift.
#pragma once

#include <span>
#include <vector>

#include "core/runtime/trace_point.h"

namespace tactum {

struct StrokePoint {
    Vec3 proxy_W = Vec3::Zero(); ///< m
    double time = 0;             ///< s, of the bodies that move by themselves
};

/// Watches the ticks of the servo for strokes and keeps the last one that is over. Thread: ui.
class LastStroke {
public:
    /// Taps that are shorter are no strokes. m
    static constexpr double kShortest = 1e-3;

    /// The ticks since the last call. True when a stroke has just ended.
    bool add(std::span<const TracePoint> points, double bodiesTime);
    void clear() { *this = {}; }
    const std::vector<StrokePoint>& points() const { return last_; }

private:
    void begin();
    bool end();

    std::vector<StrokePoint> now_, last_;
    bool touching_ = false;
    double touchedAt_ = 0; ///< s, of the trace
    double length_ = 0;    ///< m, of now_
};

} // namespace tactum
