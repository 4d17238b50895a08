#include "ui/widgets/value_slider.h"

#include <algorithm>
#include <cmath>

#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/base/style.h"

namespace tactum {

namespace {

constexpr int kPositions = 10000;
constexpr double kSliderHandle = 6; // radius, pixels

double roundedTo(double value, double unit) {
    return std::round(value / unit) * unit;
}

/// Two significant figures, e.g. 846 -> 850.
double twoFigures(double value) {
    return roundedTo(value, std::pow(10.0, std::floor(std::log10(value)) - 1));
}

} // namespace

ValueScale::ValueScale(const Parameter& parameter)
    : minimum_(parameter.minimum), maximum_(parameter.maximum), step_(parameter.step),
      logarithmic_(minimum_ > 0 && maximum_ / minimum_ >= 1000) {}

double ValueScale::fraction(double value) const {
    const double v = std::clamp(value, minimum_, maximum_);
    if (logarithmic_) return std::log(v / minimum_) / std::log(maximum_ / minimum_);
    return (v - minimum_) / (maximum_ - minimum_);
}

double ValueScale::value(double fraction) const {
    const double f = std::clamp(fraction, 0.0, 1.0);
    const double raw =
        logarithmic_ ? minimum_ * std::pow(maximum_ / minimum_, f) : minimum_ + f * (maximum_ - minimum_);
    return std::clamp(logarithmic_ ? twoFigures(raw) : roundedTo(raw, step_), minimum_, maximum_);
}

ValueSlider::ValueSlider(const Parameter& parameter, QWidget* parent)
    : QSlider(Qt::Horizontal, parent), scale_(parameter), initial_(parameter.initial) {
    setRange(0, kPositions);
    setSingleStep(kPositions / 100);
    setPageStep(kPositions / 20);
    setFocusPolicy(Qt::StrongFocus);
}

double ValueSlider::current() const {
    return scale_.value(double(value()) / kPositions);
}

void ValueSlider::display(double value) {
    if (isSliderDown()) return; // the hand on the handle knows better than a rounded echo
    const QSignalBlocker quiet(this);
    setValue(int(std::lround(scale_.fraction(value) * kPositions)));
    update();
}

void ValueSlider::setCeiling(std::optional<double> value) {
    ceiling_ = value;
    update();
}

QSize ValueSlider::sizeHint() const {
    return {120, 2 * kRhythm + 4};
}

QRectF ValueSlider::groove() const {
    return {kSliderHandle, 0.5 * height() - 4, width() - 2 * kSliderHandle, 4};
}

double ValueSlider::xOf(double fraction) const {
    return groove().left() + fraction * groove().width();
}

void ValueSlider::tick(QPainter& painter, double value, const QColor& colour) const {
    const double x = xOf(scale_.fraction(value));
    painter.setPen(QPen(colour, 1.5));
    painter.drawLine(QPointF(x, groove().bottom() + 4), QPointF(x, groove().bottom() + 8));
}

void ValueSlider::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF bar = groove();
    const double x = xOf(double(sliderPosition()) / kPositions);
    const QColor full = isEnabled() ? theme().accent : theme().border;
    tick(painter, initial_, theme().textDimmed);
    if (ceiling_) tick(painter, *ceiling_, theme().fault);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().border);
    painter.drawRoundedRect(bar, 2, 2);
    painter.setBrush(full);
    painter.drawRoundedRect(QRectF(bar.topLeft(), QPointF(x, bar.bottom())), 2, 2);
    painter.setBrush(isEnabled() ? theme().text : theme().textDimmed);
    if (hasFocus()) painter.setPen(QPen(theme().accent, 2));
    painter.drawEllipse(QPointF(x, bar.center().y()), kSliderHandle - 1, kSliderHandle - 1);
}

void ValueSlider::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) return event->ignore();
    lastX_ = event->position().x();
    const bool onHandle = std::abs(lastX_ - xOf(double(value()) / kPositions)) <= kSliderHandle + 2;
    setSliderDown(true);
    exact_ = value();
    if (!onHandle) exact_ = kPositions * std::clamp((lastX_ - groove().left()) / groove().width(), 0.0, 1.0);
    setSliderPosition(int(exact_));
}

void ValueSlider::mouseMoveEvent(QMouseEvent* event) {
    if (!isSliderDown()) return event->ignore();
    const double x = event->position().x();
    const double fine = event->modifiers() & Qt::ShiftModifier ? 0.1 : 1;
    exact_ =
        std::clamp(exact_ + fine * kPositions * (x - lastX_) / groove().width(), 0.0, double(kPositions));
    lastX_ = x;
    const bool coarse = event->modifiers() & Qt::ControlModifier;
    setSliderPosition(int(coarse ? roundedTo(exact_, kPositions / 20.0) : exact_));
}

// QSlider lets go only of a handle that it took itself.
void ValueSlider::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) setSliderDown(false);
}

void ValueSlider::wheelEvent(QWheelEvent* event) {
    const int notches = event->angleDelta().y() / 120;
    if (notches) emit notched(notches);
    event->accept();
}

} // namespace tactum
