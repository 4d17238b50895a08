// One quantity of the touch over time, as a strip.
#pragma once

#include <optional>
#include <vector>

#include "ui/base/theme.h"
#include "ui/widgets/chart.h"
#include "ui/widgets/touch_history.h"

namespace tactum {

/// A line of a strip.
struct StripLine {
    QString name;
    double TouchSample::*value;
    QColor Theme::*colour;
    enum class Style {
        Plain,
        Filled,
        Friction, ///< in the colours of stick and slip; slipping is thicker as well
        Limit     ///< dashed
    } style = Style::Plain;
    bool inContact = false; ///< only where something is touched
};

/// What a strip shows. Values are shown times `factor`.
struct StripKind {
    /// What there must be for it to be offered.
    enum class Of { Touch, Turning, Sliding, Body };

    const char* id;
    QString title, unit;
    double factor = 1;
    int decimals = 2; ///< of what the cursor reads
    std::vector<StripLine> lines;
    std::optional<double> least = {}; ///< the axis never ends below it, in what is shown
    bool hasLimit = false;            ///< the device's force limit belongs to it
    Of of = Of::Touch;
};

/// The part of time that all strips of a plot show, and where the mouse is in it.
struct StripTime {
    double span = 6; ///< s
    std::optional<double> cursor;
    bool axis = true; ///< whether the strip writes the time beneath
};

/// Where a range of numbers is drawn, with a step between lines that is 1, 2 or 5 times a power of ten.
struct StripAxis {
    double low = 0, high = 1, step = 0.25;
};
/// Holds both ends and 0; a little more than `high`, so that a line is not on the edge.
StripAxis axisFor(double low, double high, int most);

/// Draws one strip into a box: also for files. `limit` in N.
void paintStrip(QPainter& painter, const QRectF& box, const StripKind& kind, const TouchHistory& history,
                const StripTime& time, double limit);
/// How many lines an area has room for.
int stripLines(const QRectF& area);
/// Where in a box the curves are.
QRectF stripArea(const QRectF& box, const StripTime& time);

/// Thread: ui.
class StripChart : public Chart {
    Q_OBJECT
public:
    StripChart(StripKind kind, const TouchHistory& history, QWidget* parent = nullptr);

    const StripKind& kind() const { return kind_; }
    void show(const StripTime& time, double limit);
    QSize sizeHint() const override { return {480, 132}; }
    QSize minimumSizeHint() const override { return {240, 60}; }

signals:
    /// The mouse points at a time; or left.
    void pointed(std::optional<double> t);
    /// The wheel asks for `factor` times the span.
    void zoomed(double factor);

protected:
    QColor background() const override { return Qt::transparent; } // that of a strip, for files as well
    void paintChart(QPainter& painter) const override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    StripKind kind_;
    const TouchHistory& history_;
    StripTime time_;
    double limit_ = 1;
};

} // namespace tactum
