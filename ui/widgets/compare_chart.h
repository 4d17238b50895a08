// The force of two touches of one stroke, laid over each other.
#pragma once

#include <memory>
#include <vector>

#include <QWidget>

#include "core/haptics/replay.h"

namespace tactum {

/// A dashed and grey, B solid; what lies between them is filled. Thread: ui.
class CompareChart : public QWidget {
    Q_OBJECT
public:
    explicit CompareChart(QWidget* parent = nullptr);

    /// Both null: nothing is shown but `hint`.
    void show(std::shared_ptr<const TouchTrace> a, std::shared_ptr<const TouchTrace> b);
    void setHint(const QString& hint);
    QSize sizeHint() const override { return {360, 150}; }
    QSize minimumSizeHint() const override { return {160, 80}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// The largest force of each column of pixels.
    std::vector<double> columnsOf(const TouchTrace& rows, int count) const;
    QRectF area() const;
    void paintAxes(QPainter& painter, double top, double step, double seconds) const;
    void paintLegend(QPainter& painter) const;

    std::shared_ptr<const TouchTrace> a_, b_;
    QString hint_;
};

} // namespace tactum
