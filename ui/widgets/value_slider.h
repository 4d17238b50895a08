// A slider for a parameter: logarithmic where the range asks for it, with ticks at the values that matter.
#pragma once

#include <optional>

#include <QSlider>

#include "core/surface/parameter.h"

namespace tactum {

/// Where a value lies between the ends of its range, 0 to 1, and back. Ranges over three decades and more
/// are logarithmic. Values come back rounded to what a person would type.
class ValueScale {
public:
    explicit ValueScale(const Parameter& parameter);
    double fraction(double value) const;
    double value(double fraction) const;

private:
    double minimum_, maximum_, step_;
    bool logarithmic_;
};

/// Dragging with Shift is ten times finer, with Ctrl it snaps to twentieths of the range.
class ValueSlider : public QSlider {
    Q_OBJECT
public:
    explicit ValueSlider(const Parameter& parameter, QWidget* parent = nullptr);

    double current() const;
    /// Shows a value without telling anybody.
    void display(double value);
    /// A red tick, e.g. what the device can do; nothing when empty.
    void setCeiling(std::optional<double> value);
    QSize sizeHint() const override;

signals:
    /// The wheel asks for so many steps of the parameter.
    void notched(int steps);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    QRectF groove() const;
    double xOf(double fraction) const;
    void tick(QPainter& painter, double value, const QColor& colour) const;

    ValueScale scale_;
    double initial_;
    std::optional<double> ceiling_;
    double lastX_ = 0;
    double exact_ = 0; ///< position before rounding, so that fine drags add up
};

} // namespace tactum
