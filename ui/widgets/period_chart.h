// How regular the servo's ticks are, as bars over the deviation of their period.
#pragma once

#include "core/runtime/period_histogram.h"
#include "ui/widgets/chart.h"

namespace tactum {

/// Both axes are logarithmic: one tick in ten thousand can be seen beside all the others. What came more than
/// a period late is red, and right of a dashed line. Hover tells the figures of a bar.
class PeriodChart : public Chart {
    Q_OBJECT
public:
    explicit PeriodChart(QWidget* parent = nullptr);

    /// `period` in microseconds.
    void setPeriods(const PeriodHistogram& periods, double period);
    /// The figures of one bar: "20 to 50 us: 1234 ticks, 1.2 %".
    QString figuresOf(std::size_t bin) const;
    QSize sizeHint() const override { return {160, 88}; }
    QSize minimumSizeHint() const override { return {140, 72}; }

protected:
    QColor background() const override { return Qt::transparent; }
    void paintChart(QPainter& painter) const override;
    bool event(QEvent* event) override; ///< the tooltip of the bar under the cursor

private:
    double edge(std::size_t bin) const; ///< x of its left edge
    double share(std::size_t bin) const;
    void paintGrid(QPainter& painter) const;
    void paintBars(QPainter& painter) const;
    void paintPeriod(QPainter& painter) const;

    PeriodHistogram periods_;
    double all_ = 0;
    double period_ = 1000;
};

} // namespace tactum
