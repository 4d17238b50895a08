#include "ui/panels/profile_chart.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>

#include "ui/base/numbers.h"
#include "ui/base/style.h"
#include "ui/panels/flat_swatch.h"

namespace tactum {

namespace {

constexpr double kMinHeight = 1e-6, kMinFactor = 0.01; // ends of the axis of what is flat

} // namespace

ProfileChart::ProfileChart(QWidget* parent)
    : Chart(QStringLiteral("layer-profile"), tr("The layers along the last stroke"), {2, 18, 2, 18}, parent) {
    setToolTip(tr("What the layers are along the last stroke of the finger over this surface"));
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ProfileChart::display(LayerProfile profile) {
    profile_ = std::move(profile);
    setHint({});
}

void ProfileChart::displayNone(const QString& why) {
    profile_ = {};
    setHint(why);
}

void ProfileChart::paintChart(QPainter& painter) const {
    double low = 1e300, high = -1e300;
    for (const double value : profile_.values) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    const double least = profile_.target == TextureTarget::Height ? kMinHeight : kMinFactor;
    if (high - low < least) {
        const double middle = 0.5 * (low + high);
        low = middle - 0.5 * least;
        high = middle + 0.5 * least;
    }
    paintAxis(painter, low, high);
    paintLine(painter, low, high);
    if (cursor_) paintCursor(painter);
}

void ProfileChart::paintAxis(QPainter& painter, double low, double high) const {
    const QRectF place = area();
    painter.setPen(theme().plotGrid);
    for (const double y : {place.top(), place.bottom()})
        painter.drawLine(QPointF(place.left(), y), QPointF(place.right(), y));
    if (cursor_) return;
    painter.setPen(theme().textDimmed);
    painter.drawText(QRectF(place.left() + 2, 1, place.width() - 4, 16), Qt::AlignLeft | Qt::AlignVCenter,
                     layerValueText(profile_.target, high));
    const QRectF below(place.left() + 2, place.bottom() + 1, place.width() - 4, 16);
    painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, layerValueText(profile_.target, low));
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, lengthText(profile_.length));
}

void ProfileChart::paintLine(QPainter& painter, double low, double high) const {
    const QRectF place = area();
    painter.setPen(QPen(theme().accent, 1.5));
    QPolygonF line;
    const auto flush = [&] {
        if (line.size() > 1) painter.drawPolyline(line);
        line.clear();
    };
    for (std::size_t i = 0; i < profile_.values.size(); ++i) {
        const double value = profile_.values[i];
        if (!std::isfinite(value)) {
            flush();
            continue;
        }
        line << QPointF(place.left() + place.width() * double(i) / double(profile_.values.size() - 1),
                        place.bottom() - place.height() * (value - low) / (high - low));
    }
    flush();
}

void ProfileChart::paintCursor(QPainter& painter) const {
    const QRectF place = area();
    const double part = std::clamp((*cursor_ - place.left()) / place.width(), 0.0, 1.0);
    const auto i = std::size_t(std::lround(part * double(profile_.values.size() - 1)));
    const double x = place.left() + part * place.width();
    painter.setPen(theme().textDimmed);
    painter.drawLine(QPointF(x, place.top()), QPointF(x, place.bottom()));
    painter.setPen(theme().text);
    painter.drawText(
        QRectF(place.left() + 2, 1, place.width() - 4, 16), Qt::AlignLeft | Qt::AlignVCenter,
        tr("%1 at %2")
            .arg(layerValueText(profile_.target, profile_.values[i]), lengthText(profile_.wayOf(i))));
}

void ProfileChart::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->position().x();
    update();
}

void ProfileChart::leaveEvent(QEvent*) {
    cursor_.reset();
    update();
}

} // namespace tactum
