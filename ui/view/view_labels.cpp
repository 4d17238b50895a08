#include "ui/view/view_labels.h"

#include <cmath>

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>
#include <QPainterPath>

#include "ui/base/hand_colours.h"
#include "ui/view/smooth_image.h"

namespace tactum {

namespace {

enum class Badge { Dot, Ring, Bar, Waves };

/// A stroke or a shape in front of a word: never the colour alone.
void drawBadge(QPainter& painter, const QRectF& box, Badge badge, const QColor& colour) {
    painter.setPen(QPen(colour, 2, Qt::SolidLine, Qt::RoundCap));
    painter.setBrush(badge == Badge::Dot ? QBrush(colour) : QBrush(Qt::NoBrush));
    const QPointF c = box.center();
    switch (badge) {
    case Badge::Dot:
        painter.drawEllipse(c, 3, 3);
        break;
    case Badge::Ring:
        painter.drawEllipse(c, 3.5, 3.5);
        break;
    case Badge::Bar:
        painter.drawLine(c - QPointF(0, 4), c + QPointF(0, 4));
        break;
    case Badge::Waves:
        for (double y : {-2.5, 2.5}) {
            QPainterPath wave(c + QPointF(-5, y));
            wave.cubicTo(c + QPointF(-2, y - 4), c + QPointF(2, y + 4), c + QPointF(5, y));
            painter.drawPath(wave);
        }
    }
}

constexpr double kMark = 18; // beside the word

QSizeF labelSize(const QFont& font, const QString& text) {
    const QFontMetricsF metrics(font);
    return {std::ceil(metrics.horizontalAdvance(text)) + kMark + 12, std::ceil(metrics.height()) + 6};
}

void drawLabel(QPainter& painter, const QSizeF& size, const QString& text, Badge badge, const QColor& colour,
               const Theme& theme) {
    const double height = size.height();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.label);
    painter.drawRoundedRect(QRectF({0, 0}, size), 0.5 * height, 0.5 * height);
    drawBadge(painter, QRectF(4, 0, kMark, height), badge, colour);
    painter.setPen(theme.labelText);
    painter.drawText(QRectF(kMark + 4, 0, size.width() - kMark - 4, height), Qt::AlignVCenter | Qt::AlignLeft,
                     text);
}

QString forceText(const TouchState& state) {
    QString text = QString::number(state.force.norm(), 'f', 2) + " N";
    if (!state.armed) return QObject::tr("%1 · forces off").arg(text);
    return state.atLimit() ? QObject::tr("%1 · limit").arg(text) : text;
}

/// Puts labels where they do not cover each other.
class LabelBoard {
public:
    LabelBoard(QPainter& painter, const Theme& theme, QSizeF view)
        : painter_(painter), theme_(theme), view_({0, 0}, view) {}

    /// Beside `anchor`, on the side that `away` points to; lower where another label is already.
    void put(QPointF anchor, QPointF away, const QString& text, Badge badge, const QColor& colour) {
        QRectF box({0, 0}, labelSize(painter_.font(), text));
        const double side = away.x() < 0 ? -1 : 1;
        box.moveCenter(anchor + QPointF(side * (0.5 * box.width() + 12), away.y() < 0 ? -6 : 6));
        for (const QRectF& other : taken_)
            if (box.intersects(other)) box.moveTop(other.bottom() + 3);
        if (!view_.contains(box)) return;
        taken_.push_back(box);
        drawSmoothly(painter_, box,
                     [&](QPainter& inner) { drawLabel(inner, box.size(), text, badge, colour, theme_); });
    }

private:
    QPainter& painter_;
    const Theme& theme_;
    QRectF view_;
    std::vector<QRectF> taken_;
};

void putForce(LabelBoard& board, const TouchState& state, QPointF proxy, const ViewCamera& camera,
              const Theme& theme, const HandColours& colours) {
    if (!state.pushes()) return;
    if (const auto tip = camera.project(arrowTip(state, camera)))
        board.put(*tip, *tip - proxy, forceText(state), Badge::Dot,
                  state.atLimit() ? theme.fault : colours.proxy);
}

} // namespace

void drawTouchLabels(QPainter& painter, const TouchState& state, const ViewCamera& camera, const Theme& theme,
                     const QString& touched, const HandName& hand) {
    const auto proxy = camera.project(state.proxy), finger = camera.project(state.finger);
    if (!proxy || !finger) return;
    LabelBoard board(painter, theme, camera.size);
    const QPointF apart = *finger - *proxy;
    const HandColours colours = handColours(theme, hand.number);
    putForce(board, state, *proxy, camera, theme, colours);
    const QPointF beside = *proxy - QPointF(26, 0), left(-1, 0);
    if (state.contacts > 0 && !state.contact[0].frictionless) {
        const bool slips = state.contact[0].slipping;
        const QString manner =
            slips ? QObject::tr("slip", "the contact") : QObject::tr("stick", "the contact");
        board.put(beside, left, touched.isEmpty() ? manner : touched + " \u00b7 " + manner,
                  slips ? Badge::Waves : Badge::Bar, slips ? theme.slip : theme.stick);
    } else if (state.contacts > 0 && !touched.isEmpty()) {
        board.put(beside, left, touched, Badge::Dot, theme.contact);
    }
    if (!hand.name.isEmpty())
        board.put(*finger, apart, hand.name, Badge::Ring, colours.finger);
    else if (std::hypot(apart.x(), apart.y()) > 26)
        board.put(*finger, apart, QObject::tr("finger"), Badge::Ring, colours.finger);
}

void drawHandLabels(QPainter& painter, const TouchState& state, const ViewCamera& camera, const Theme& theme,
                    const HandName& hand) {
    const auto proxy = camera.project(state.proxy), finger = camera.project(state.finger);
    if (!proxy || !finger) return;
    LabelBoard board(painter, theme, camera.size);
    const HandColours colours = handColours(theme, hand.number);
    putForce(board, state, *proxy, camera, theme, colours);
    board.put(*finger, *finger - *proxy, hand.name, Badge::Ring, colours.finger);
}

} // namespace tactum
