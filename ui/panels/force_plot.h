// The force of the last seconds as a strip chart.
#pragma once

#include <deque>
#include <vector>

#include <QWidget>

#include "core/runtime/engine.h"

class QToolButton;

namespace tactum {

/// Magnitude of the force on the finger, and the part of it along the surface: coloured like sticking or
/// slipping. The axis fits what is shown; the device's limit is a line, or said to lie above. Thread: ui.
class ForcePlot : public QWidget {
    Q_OBJECT
public:
    explicit ForcePlot(QWidget* parent = nullptr);

    /// Takes what the servo loop recorded since the last frame.
    void take(Engine& engine);
    /// The same from a recording: `touch` is of the last of the points. limit in N.
    void take(const std::vector<TracePoint>& points, const HapticOutput& touch, double limit);
    /// Forgets what was; the time of what comes next may be any.
    void clear();
    bool paused() const { return paused_; }
    void setPaused(bool paused);
    QSize sizeHint() const override { return {480, 150}; }
    QSize minimumSizeHint() const override { return {240, 96}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override; ///< another theme

private:
    /// The largest of a few servo ticks: what one column of pixels can show.
    struct Sample {
        double t = 0;
        Vec3 proxy = Vec3::Zero(); ///< at its beginning
        double force = 0, tangential = 0;
        bool slipping = false, touching = false;
    };
    void add(const TracePoint& point, double tangential, bool touching);
    void addPauseButton();
    void refreshIcon();
    void fitAxis();
    QRectF area() const;
    QPointF at(double t, double newton) const;
    void paintGrid(QPainter& painter) const;
    void paintLimit(QPainter& painter) const;
    void paintForce(QPainter& painter) const;
    void paintTangential(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;

    QToolButton* pause_;
    std::vector<TracePoint> fresh_; ///< of this frame
    double tangential_ = 0;         ///< N, as the last frame saw it
    std::deque<Sample> samples_;
    Sample building_;
    int ticks_ = 0;    ///< in building_
    double limit_ = 1; ///< N, of the device
    double top_ = 1;   ///< N, end of the axis
    bool paused_ = false;
};

} // namespace tactum
