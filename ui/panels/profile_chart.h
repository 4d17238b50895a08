// The height of the layers along the last stroke, as a chart.
#pragma once

#include <optional>

#include <QWidget>

#include "ui/panels/layer_profile.h"

namespace tactum {

/// Over the way in millimetres; the mouse reads it. Thread: ui.
class ProfileChart : public QWidget {
    Q_OBJECT
public:
    explicit ProfileChart(QWidget* parent = nullptr);

    void display(LayerProfile profile);
    /// Instead of a profile: why there is none, and how to get one.
    void setHint(const QString& hint);
    const LayerProfile& profile() const { return profile_; }
    const QString& hint() const { return hint_; }
    QSize sizeHint() const override { return {150, 130}; }
    QSize minimumSizeHint() const override { return {110, 110}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRectF area() const;
    void paintAxis(QPainter& painter, double low, double high) const;
    void paintLine(QPainter& painter, double low, double high) const;
    void paintCursor(QPainter& painter) const;

    LayerProfile profile_;
    QString hint_;
    std::optional<double> cursor_; ///< x of the mouse
};

} // namespace tactum
