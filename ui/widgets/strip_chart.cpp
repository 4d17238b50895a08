#include "ui/widgets/strip_chart.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QWheelEvent>

#include "ui/base/chart_axis.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr double kLeft = 52, kTop = 22, kRight = 16, kBottom = 6, kTimeBelow = 16; // logical pixels

/// One strip while it is drawn.
class Strip {
public:
    Strip(QPainter& painter, const QRectF& box, const StripKind& kind, const TouchHistory& history,
          const StripTime& time, double limit)
        : painter_(painter), box_(box), area_(stripArea(box, time)), kind_(kind), history_(history),
          time_(time), limit_(kind.hasLimit ? limit : 0) {
        const auto& samples = history.samples();
        first_ = std::ranges::lower_bound(samples, history.end() - time.span, {}, &TouchSample::t);
        fit();
    }

    void draw() {
        painter_.fillRect(box_, theme().panel);
        grid();
        if (time_.axis) times();
        painter_.save();
        painter_.setClipRect(area_.adjusted(-1, -2, 1, 2));
        if (limitShown()) limitLine();
        for (const StripLine& line : kind_.lines)
            curve(line);
        cursor();
        painter_.restore();
        legend();
    }

private:
    using Row = std::deque<TouchSample>::const_iterator;

    double x(double t) const { return area_.right() - (history_.end() - t) / time_.span * area_.width(); }
    double y(double shown) const {
        return area_.bottom() - (shown - axis_.low) / (axis_.high - axis_.low) * area_.height();
    }
    double shown(const TouchSample& s, const StripLine& line) const { return kind_.factor * s.*line.value; }
    bool limitShown() const { return limit_ > 0 && limit_ <= axis_.high; }

    void fit() {
        double low = 0, high = kind_.least.value_or(0);
        for (Row s = first_; s != history_.samples().end(); ++s)
            for (const StripLine& line : kind_.lines) {
                if (line.inContact && !s->touching) continue;
                low = std::min(low, shown(*s, line));
                high = std::max(high, shown(*s, line));
            }
        // Near the limit the axis reaches beyond it, so that the distance to it can be seen.
        if (limit_ > 0 && high > 0.6 * limit_) high = std::max(high, 1.02 * limit_);
        axis_ = axisFor(low, high, stripLines(area_));
    }

    void grid() {
        for (double n = std::ceil(axis_.low / axis_.step - 1e-9); n * axis_.step <= axis_.high * (1 + 1e-9);
             ++n) {
            const double value = n * axis_.step;
            drawGridLine(painter_, area_, y(value), tickText(value, axis_.step));
        }
    }

    void times() {
        const double step = tickStep(time_.span, 8);
        painter_.setPen(theme().textDimmed);
        for (double n = 0; n * step <= time_.span * (1 + 1e-9); ++n) {
            const double at = x(history_.end() - n * step);
            painter_.drawLine(QPointF(at, area_.bottom()), QPointF(at, area_.bottom() + 3));
            const QString label =
                n == 0 ? QObject::tr("now")
                       : QStringLiteral("\u2212") + tickText(n * step, step) + QStringLiteral(" s");
            painter_.drawText(QRectF(at - 40, area_.bottom() + 3, n == 0 ? 40 + kRight : 80, 14),
                              n == 0 ? Qt::AlignRight | Qt::AlignTop : Qt::AlignHCenter | Qt::AlignTop,
                              label);
        }
    }

    void limitLine() {
        painter_.setPen(QPen(theme().fault, 1.25, Qt::DashLine));
        painter_.drawLine(QPointF(area_.left(), y(limit_)), QPointF(area_.right(), y(limit_)));
    }

    QPen penOf(const StripLine& line, bool slips) const {
        switch (line.style) {
        case StripLine::Style::Friction:
            return slips ? QPen(theme().slip, 2.5) : QPen(theme().stick, 1.5);
        case StripLine::Style::Limit:
            return QPen(theme().*line.colour, 1.25, Qt::DashLine);
        case StripLine::Style::Filled:
            return QPen(theme().*line.colour, 1.75);
        case StripLine::Style::Plain:
            break;
        }
        return QPen(theme().*line.colour, 1.5);
    }

    void stroke(const StripLine& line, const QPolygonF& points, bool slips) {
        if (points.size() < 2) return;
        if (line.style == StripLine::Style::Filled) {
            QPolygonF filled = points;
            filled << QPointF(points.back().x(), y(0)) << QPointF(points.front().x(), y(0));
            QColor shade = theme().*line.colour;
            shade.setAlphaF(0.12f);
            painter_.setPen(Qt::NoPen);
            painter_.setBrush(shade);
            painter_.drawPolygon(filled);
        }
        QPen pen = penOf(line, slips);
        pen.setJoinStyle(Qt::RoundJoin);
        painter_.setBrush(Qt::NoBrush);
        painter_.setPen(pen);
        painter_.drawPolyline(points);
    }

    /// A column of pixels shows the least and the largest of its ticks, so that no peak is lost.
    void curve(const StripLine& line) {
        QPolygonF points;
        bool slips = false;
        const Row end = history_.samples().end();
        for (Row s = first_; s != end;) {
            const double column = std::floor(x(s->t));
            double low = 1e300, high = -1e300, last = 0;
            bool there = false, slipping = false;
            for (; s != end && x(s->t) < column + 1; ++s) {
                if (line.inContact && !s->touching) continue;
                there = true;
                slipping = slipping || s->slipping;
                last = shown(*s, line);
                low = std::min(low, last);
                high = std::max(high, last);
            }
            if (!there || (line.style == StripLine::Style::Friction && slipping != slips)) {
                // A change of colour begins where the other ended; a gap begins anew.
                const QPolygonF before = std::exchange(points, {});
                stroke(line, before, slips);
                if (there && !before.empty()) points << before.back();
                slips = slipping;
            }
            if (!there) continue;
            if (std::abs(y(high) - y(low)) > 1.5) points << QPointF(column, y(last == high ? low : high));
            points << QPointF(column + 0.5, y(last));
        }
        stroke(line, points, slips);
    }

    const TouchSample* pointedAt() const {
        if (!time_.cursor) return nullptr;
        const TouchSample* s = history_.at(*time_.cursor);
        return s && s->t >= history_.end() - time_.span ? s : nullptr;
    }

    void cursor() {
        const TouchSample* s = pointedAt();
        if (!s) return;
        painter_.setPen(QPen(theme().text, 1));
        const double middle = std::floor(x(s->t)) + 0.5; // of a column: one line, not half of two
        painter_.drawLine(QPointF(middle, area_.top()), QPointF(middle, area_.bottom()));
        for (const StripLine& line : kind_.lines) {
            if (line.inContact && !s->touching) continue;
            painter_.setPen(QPen(theme().panel, 1));
            painter_.setBrush(penOf(line, s->slipping).color());
            painter_.drawEllipse(QPointF(x(s->t), y(shown(*s, line))), 3, 3);
        }
    }

    /// Title and unit, then each line's name; with what it is at the cursor.
    void legend() {
        const TouchSample* s = pointedAt();
        double at = area_.left();
        const auto word = [&](const QString& text, const QColor& colour) {
            painter_.setPen(colour);
            painter_.drawText(QPointF(at, box_.top() + 15), text);
            at += painter_.fontMetrics().horizontalAdvance(text);
        };
        const auto mark = [&](const QPen& pen) {
            painter_.setPen(pen);
            painter_.drawLine(QPointF(at, box_.top() + 11), QPointF(at + 14, box_.top() + 11));
            at += 19;
        };
        word(kind_.unit.isEmpty() ? kind_.title : QStringLiteral("%1, %2").arg(kind_.title, kind_.unit),
             theme().text);
        at += 2 * kRhythm;
        const auto value = [&](const StripLine& line) {
            if (!s || (line.inContact && !s->touching)) return QString();
            return QStringLiteral(" ") + numberText(shown(*s, line), kind_.decimals);
        };
        for (const StripLine& line : kind_.lines) {
            if (line.style == StripLine::Style::Friction) {
                mark(penOf(line, false));
                word(QObject::tr("%1: sticking").arg(line.name), theme().textDimmed);
                at += 6;
                mark(penOf(line, true));
                word(QObject::tr("slipping"), theme().textDimmed);
                word(value(line), theme().text);
            } else {
                mark(penOf(line, false));
                word(line.name, theme().textDimmed);
                word(value(line), theme().text);
            }
            at += 2 * kRhythm;
        }
        if (limit_ <= 0) return;
        mark(QPen(theme().fault, 1.25, Qt::DashLine));
        word(limitShown() ? QObject::tr("device limit %1").arg(numberText(limit_, 1))
                          : QObject::tr("device limit %1, above \u2191").arg(numberText(limit_, 1)),
             theme().textDimmed);
    }

    QPainter& painter_;
    QRectF box_, area_;
    const StripKind& kind_;
    const TouchHistory& history_;
    const StripTime& time_;
    double limit_;
    Row first_;
    StripAxis axis_;
};

} // namespace

StripAxis axisFor(double low, double high, int most) {
    low = std::min(low, 0.0);
    high = std::max(high, 0.0);
    if (high - low <= 0) high = 1;
    const double reach = 1.06 * (high - low);
    StripAxis axis;
    axis.step = tickStep(reach, most);
    axis.low = low < 0 ? axis.step * std::floor(low / axis.step) : 0;
    axis.high = std::max(axis.step, high + 0.06 * (high - low));
    return axis;
}

int stripLines(const QRectF& area) {
    return std::clamp(int(area.height() / 20), 1, 5);
}

QRectF stripArea(const QRectF& box, const StripTime& time) {
    return box.adjusted(kLeft, kTop, -kRight, -(kBottom + (time.axis ? kTimeBelow : 0)));
}

void paintStrip(QPainter& painter, const QRectF& box, const StripKind& kind, const TouchHistory& history,
                const StripTime& time, double limit) {
    painter.setRenderHint(QPainter::Antialiasing);
    Strip(painter, box, kind, history, time, limit).draw();
}

StripChart::StripChart(StripKind kind, const TouchHistory& history, QWidget* parent)
    : Chart(QStringLiteral("strip-") + QString::fromLatin1(kind.id), tr("%1 over time").arg(kind.title), {},
            parent),
      kind_(std::move(kind)), history_(history) {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void StripChart::show(const StripTime& time, double limit) {
    time_ = time;
    limit_ = limit;
    update();
}

void StripChart::paintChart(QPainter& painter) const {
    paintStrip(painter, rect(), kind_, history_, time_, limit_);
}

void StripChart::mouseMoveEvent(QMouseEvent* event) {
    const QRectF area = stripArea(rect(), time_);
    const double part = (area.right() - event->position().x()) / area.width();
    emit pointed(part >= 0 && part <= 1 ? std::optional(history_.end() - part * time_.span) : std::nullopt);
}

void StripChart::leaveEvent(QEvent* event) {
    emit pointed(std::nullopt);
    QWidget::leaveEvent(event);
}

void StripChart::wheelEvent(QWheelEvent* event) {
    emit zoomed(std::pow(0.8, event->angleDelta().y() / 120.0));
    event->accept();
}

} // namespace tactum
