#include "ui/panels/flat_swatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "core/surface/texture_stack.h"
#include "ui/base/numbers.h"
#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr std::array<double, 6> kSides{1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3}; // m
constexpr int kFirstSide = 3, kSide = 112, kCaption = 18;

/// "30 mm", "1 mm".
QString sideText(double metres) {
    return numberText(1e3 * metres, 0) + QStringLiteral(" mm");
}

} // namespace

QString layerValueText(TextureTarget target, double value) {
    if (!std::isfinite(value)) return QStringLiteral("-");
    if (target == TextureTarget::Height)
        return numberText(1e6 * value, std::abs(value) < 1e-5 ? 1 : 0) + QStringLiteral(" \u00b5m");
    return QStringLiteral("\u00d7 ") + numberText(value, 2);
}

FlatSwatch::FlatSwatch(QWidget* parent) : QWidget(parent), size_(kFirstSide) {
    setObjectName(QStringLiteral("flat-swatch"));
    setAccessibleName(tr("The layers on flat ground"));
    setToolTip(
        tr("The layers on a piece of flat ground, lit from the upper left, with details as far as they can "
           "be seen. What is painted counts as painted everywhere. The wheel shows more or less ground."));
    setMouseTracking(true);
    setFixedSize(sizeHint());
    connect(&job_, &BackgroundJob::finished, this, [this] {
        if (std::exchange(again_, false)) compute();
    });
}

QSize FlatSwatch::sizeHint() const {
    return {kSide, kSide + kCaption};
}

QRectF FlatSwatch::area() const {
    return QRectF(0, 0, kSide, kSide);
}

void FlatSwatch::display(const TextureLayers& layers, TextureTarget target,
                         std::shared_ptr<const TriangleSoup> soup, Index surface) {
    Shown next{layers, target, std::move(soup), surface};
    if (next == shown_) return;
    shown_ = std::move(next);
    compute();
}

// What is under way is finished first: under a drag that never rests the picture would never come.
void FlatSwatch::compute() {
    if (job_.running()) {
        again_ = true;
        return;
    }
    FlatWish wish{int(kSide * devicePixelRatioF()), kSides[std::size_t(size_)], shown_.target, 0};
    job_.start([this, shown = shown_, wish](const Progress& progress) mutable -> BackgroundJob::Delivery {
        const auto asks = [](const TextureLayer& layer) {
            return usesUvs(layer.pattern) || (layer.mask && usesUvs(*layer.mask));
        };
        if (shown.soup && std::ranges::any_of(shown.layers, asks))
            wish.metresPerUv = metresPerUvOf(*shown.soup, shown.surface);
        auto ground = std::make_shared<FlatGround>(flatGround(shown.layers, wish, progress));
        return [this, ground] {
            if (ground->values.empty()) return; // cancelled: the next one is on its way
            ground_ = std::move(*ground);
            update();
        };
    });
}

QString FlatSwatch::readingAt(QPointF place) const {
    const double x = place.x() / kSide, y = place.y() / kSide;
    if (ground_.values.empty() || x < 0 || y < 0 || x >= 1 || y >= 1) return {};
    const auto millimetres = [&](double part) {
        return numberText(1e3 * part * ground_.side, ground_.side < 0.02 ? 2 : 1);
    };
    return QStringLiteral("%1 at %2, %3 mm")
        .arg(layerValueText(ground_.target, ground_.at(x, y)), millimetres(x), millimetres(1 - y));
}

void FlatSwatch::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (ground_.values.empty())
        painter.fillRect(area(), theme().field);
    else
        painter.drawImage(area(), ground_.picture);
    painter.setPen(theme().border);
    painter.drawRect(area().adjusted(0.5, 0.5, -0.5, -0.5));
    painter.setFont(figureFont(-1));
    painter.setPen(theme().textDimmed);
    const QRectF caption(0, kSide + 2, kSide, kCaption - 2);
    if (cursor_ && !ground_.values.empty() && area().contains(*cursor_)) {
        painter.drawText(
            caption, Qt::AlignLeft | Qt::AlignVCenter,
            layerValueText(ground_.target, ground_.at(cursor_->x() / kSide, cursor_->y() / kSide)));
        return;
    }
    // As long as the ground that is seen.
    const double y = caption.center().y();
    const QString text = sideText(kSides[std::size_t(size_)]);
    const double half = 0.5 * painter.fontMetrics().horizontalAdvance(text) + 4;
    painter.drawText(caption, Qt::AlignCenter, text);
    for (const double end : {0.5, kSide - 0.5})
        painter.drawLine(QPointF(end, y - 3), QPointF(end, y + 3));
    painter.drawLine(QPointF(0.5, y), QPointF(0.5 * kSide - half, y));
    painter.drawLine(QPointF(0.5 * kSide + half, y), QPointF(kSide - 0.5, y));
}

void FlatSwatch::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->position();
    update();
}

void FlatSwatch::leaveEvent(QEvent*) {
    cursor_.reset();
    update();
}

void FlatSwatch::wheelEvent(QWheelEvent* event) {
    const int steps = event->angleDelta().y() > 0 ? -1 : 1;
    const int next = std::clamp(size_ + steps, 0, int(kSides.size()) - 1);
    event->accept();
    if (next == size_) return;
    size_ = next;
    compute();
    update();
}

} // namespace tactum
