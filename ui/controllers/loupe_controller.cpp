#include "ui/controllers/loupe_controller.h"

#include <algorithm>
#include <cmath>

#include <QSettings>

#include "ui/view/scene_view.h"
#include "ui/widgets/loupe.h"

namespace tactum {

namespace {

// Logical pixels.
constexpr int kFromEdge = 12, kBelowAxes = 112, kLeastSide = 96;
constexpr double kFree = 120;   ///< about the contact, where its words are
constexpr double kFarther = 40; ///< or it would go to and fro
constexpr double kTimesPerNotch = 0.5;

const auto kTimesKey = QStringLiteral("view/loupe-times");

double distanceTo(const QRectF& box, QPointF p) {
    return std::hypot(std::max({box.left() - p.x(), p.x() - box.right(), 0.0}),
                      std::max({box.top() - p.y(), p.y() - box.bottom(), 0.0}));
}

} // namespace

LoupeController::LoupeController(const Workbench& bench)
    : QObject(&bench.window), bench_(bench), body_(*bench.window.centralWidget()),
      times_(std::clamp(QSettings().value(kTimesKey, LoupeLook{}.times).toDouble(), kLeastTimes, kMostTimes)),
      side_(LoupeLook{}.side) {
    connect(&bench.view, &SceneView::loupeDrawn, this, &LoupeController::show);
    connect(&bench.view, &SceneView::loupeLeft, this, [this] {
        open_ = false;
        // Under the pointer it stays, or the wheel that is turned over it would come to the camera.
        if (loupe_ && !loupe_->underMouse()) loupe_->hide();
    });
    useLook();
}

void LoupeController::show(const QImage& picture, QPointF contact, const QString& pane) {
    open_ = true;
    if (!loupe_) {
        loupe_ = new Loupe(&body_);
        connect(loupe_, &Loupe::turned, this, &LoupeController::turn);
        connect(loupe_, &Loupe::left, this, [this] {
            if (!open_) loupe_->hide();
        });
        useLook();
    }
    loupe_->setPicture(picture, pane);
    place(contact);
}

QRect LoupeController::column(int side) const {
    const QRect view = bench_.view.rect();
    QRect free(view.width() - kFromEdge - side, kBelowAxes, side, view.height() - kFromEdge - kBelowAxes);
    for (const QWidget* each : body_.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (each == loupe_ || !each->isVisible() || each->isAncestorOf(&bench_.view)) continue;
        const QRect other(bench_.view.mapFrom(&body_, each->pos()), each->size());
        if (!other.intersects(QRect(free.left(), 0, side, view.height()))) continue;
        if (other.center().y() < view.center().y()) // the axes are below it, too
            free.setTop(std::max(free.top(), other.bottom() + kBelowAxes));
        else
            free.setBottom(other.top() - kFromEdge);
    }
    return free;
}

// Two of them have room one above the other, so that there is a place without the contact.
void LoupeController::place(QPointF contact) {
    const int half = (column(LoupeLook{}.side).height() - kFromEdge) / 2;
    const int side = std::clamp(half, kLeastSide, LoupeLook{}.side);
    const QRect free = column(side);
    const QRect high(free.topLeft(), QSize(side, side));
    const QRect low(QPoint(free.left(), free.bottom() + 1 - side), high.size());
    const double here = distanceTo(low_ ? low : high, contact);
    if (here < kFree && distanceTo(low_ ? high : low, contact) > here + kFarther) low_ = !low_;
    loupe_->setGeometry((low_ ? low : high).translated(bench_.view.mapTo(&body_, QPoint())));
    loupe_->setVisible(half >= kLeastSide && free.left() >= kFromEdge);
    if (std::exchange(side_, side) != side) useLook();
}

void LoupeController::turn(double notches) {
    times_ = std::clamp(times_ + kTimesPerNotch * notches, kLeastTimes, kMostTimes);
    QSettings().setValue(kTimesKey, times_);
    useLook();
}

void LoupeController::useLook() {
    bench_.view.setLoupe({side_, times_});
    if (loupe_) loupe_->setTimes(times_);
}

} // namespace tactum
