// The force of two touches of one stroke, laid over each other.
#pragma once

#include <memory>
#include <vector>

#include "core/haptics/replay.h"
#include "ui/widgets/chart.h"

namespace tactum {

/// A dashed and grey, B solid; what lies between them is filled. Thread: ui.
class CompareChart : public Chart {
    Q_OBJECT
public:
    explicit CompareChart(QWidget* parent = nullptr);

    /// Both null: nothing is shown but the hint.
    void show(std::shared_ptr<const TouchTrace> a, std::shared_ptr<const TouchTrace> b);
    QSize sizeHint() const override { return {360, 150}; }
    QSize minimumSizeHint() const override { return {160, 80}; }

protected:
    bool any() const override { return a_ && b_ && a_->size() > 1 && b_->size() > 1; }
    void paintChart(QPainter& painter) const override;

private:
    /// The largest force of each column of pixels.
    std::vector<double> columnsOf(const TouchTrace& rows, int count) const;
    void paintAxes(QPainter& painter, double top, double step, double seconds) const;
    void paintLegend(QPainter& painter) const;

    std::shared_ptr<const TouchTrace> a_, b_;
};

} // namespace tactum
