// The touch of the last seconds as strips: force, friction, lag, energy, rates.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <QWidget>

#include "core/runtime/channels.h"
#include "ui/widgets/strip_chart.h"
#include "ui/widgets/touch_history.h"

class QAction;
class QLabel;
class QToolBar;
class QToolButton;
class QVBoxLayout;

namespace tactum {

/// A button for each strip says whether it is shown (in a narrow plot the last of them stand in a menu); the
/// mouse reads all of them at one time, the wheel shortens or lengthens the time. Which are shown is
/// remembered. Thread: ui.
class ForcePlot : public QWidget {
    Q_OBJECT
public:
    explicit ForcePlot(QWidget* parent = nullptr);

    /// What the servo loop did since the last frame. `touch` is of the last of the points; limit in N, of the
    /// device; proxyRate in Hz. `body`: the selected one, in the last frame. `touched`: the name of the
    /// surface that is touched; empty for none.
    void take(const std::vector<TracePoint>& points, const HapticOutput& touch, double limit,
              double proxyRate = 0, const std::optional<BodyReading>& body = {}, const QString& touched = {});
    /// Forgets what was; the time of what comes next may be any.
    void clear();
    bool paused() const { return paused_; }
    void setPaused(bool paused);

    const TouchHistory& history() const { return history_; }
    double span() const { return time_.span; } ///< s
    void setSpan(double seconds);
    bool isShown(const QString& id) const;
    void setShown(const QString& id, bool shown);

    /// The strips that are shown, without buttons. `pixels`: of the picture; `scale`: of them to a logical
    /// one.
    QImage picture(QSize pixels, double scale) const;
    /// Writes what is seen: .csv the numbers of every tick, .png and .svg the picture of the shown strips.
    /// Errors: a sentence.
    Result<void> exportTo(const QString& file) const;

    QSize sizeHint() const override { return {480, 176}; }

signals:
    void exportRequested();

protected:
    void changeEvent(QEvent* event) override; ///< another theme

private:
    QLayout* makeBar();
    QAction* addSwitch(QToolBar& bar, StripChart& chart);
    void refresh();
    void refreshIcons();
    void offer(const std::optional<BodyReading>& body);
    std::vector<StripChart*> shown() const;
    void paintShown(QPainter& painter, const QSize& size) const;

    TouchHistory history_;
    StripTime time_;
    double limit_ = 1; ///< N, of the device
    bool paused_ = false;
    std::array<bool, 4> offered_{true}; ///< by StripKind::Of
    std::vector<StripChart*> charts_;
    std::vector<QAction*> switches_; ///< of the charts, in their order
    QLabel* caption_;
    QToolButton *export_, *pause_;
};

} // namespace tactum
