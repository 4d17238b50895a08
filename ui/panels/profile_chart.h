// The height of the layers along the last stroke, as a chart.
#pragma once

#include <optional>

#include "ui/panels/layer_profile.h"
#include "ui/widgets/chart.h"

namespace tactum {

/// Over the way in millimetres; the mouse reads it. Thread: ui.
class ProfileChart : public Chart {
    Q_OBJECT
public:
    explicit ProfileChart(QWidget* parent = nullptr);

    void display(LayerProfile profile);
    /// Why there is no profile, and how to get one.
    void displayNone(const QString& why);
    const LayerProfile& profile() const { return profile_; }
    QSize sizeHint() const override { return {150, 130}; }
    QSize minimumSizeHint() const override { return {110, 110}; }

protected:
    QColor background() const override { return theme().field; }
    bool any() const override { return profile_.any(); }
    void paintChart(QPainter& painter) const override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    void paintAxis(QPainter& painter, double low, double high) const;
    void paintLine(QPainter& painter, double low, double high) const;
    void paintCursor(QPainter& painter) const;

    LayerProfile profile_;
    std::optional<double> cursor_; ///< x of the mouse
};

} // namespace tactum
