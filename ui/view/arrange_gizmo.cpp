#include "ui/view/arrange_gizmo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

namespace tactum {
namespace {

using enum ArrangeHandle;

constexpr double kAmountEdge = 4; ///< pixels, that the numbers keep from the edge of the picture
constexpr double kArrow = 92, kArrowGap = 16, kTurnRing = 66, kOuter = 116; // pixels
constexpr double kPlaneNear = 24, kPlaneFar = 42;
constexpr double kFine = 0.1;
constexpr qsizetype kMostTyped = 12; // keys
constexpr double kOneDegree = std::numbers::pi / 180;
// Even steps, and those of fine ways.
constexpr double kMoveStep = 5e-3, kFineMove = 5e-4;
constexpr double kTurnStep = 15 * kOneDegree, kFineTurn = kOneDegree;
constexpr double kScaleStep = 0.1, kFineScale = 0.01;

bool movesAlong(ArrangeHandle handle) {
    return handle >= MoveX && handle <= MoveZ;
}
bool movesIn(ArrangeHandle handle) {
    return handle >= MoveYZ && handle <= MoveXY;
}
bool turnsAbout(ArrangeHandle handle) {
    return handle >= TurnX && handle <= TurnZ;
}
bool turns(ArrangeHandle handle) {
    return handle >= TurnX && handle <= Turn;
}
/// Of a plane its normal.
int axisOf(ArrangeHandle handle) {
    return movesAlong(handle)   ? int(handle) - int(MoveX)
           : movesIn(handle)    ? int(handle) - int(MoveYZ)
           : turnsAbout(handle) ? int(handle) - int(TurnX)
                                : 0;
}

/// With a decimal point, and no minus before zeros.
QString numberOf(double value, int decimals) {
    return QString::number(std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value, 'f', decimals);
}

double rounded(double value, double step) {
    return step * std::round(value / step);
}

QPointF onOuter(double degrees) {
    return kOuter * QPointF(std::cos(degrees * kOneDegree), -std::sin(degrees * kOneDegree));
}

Vec3 inFrame(const Pose& frame, int normal, double u, double v) {
    Vec3 p = Vec3::Zero();
    p[(normal + 1) % 3] = u, p[(normal + 2) % 3] = v;
    return frame.apply(p);
}

QPolygonF planeSquare(const Pose& frame, int normal, const ViewCamera& camera) {
    const double pixel = camera.pixelSize(frame.translation), near = kPlaneNear * pixel,
                 far = kPlaneFar * pixel;
    return onScreen({inFrame(frame, normal, near, near), inFrame(frame, normal, far, near),
                     inFrame(frame, normal, far, far), inFrame(frame, normal, near, far)},
                    camera);
}

QPolygonF outerRing(QPointF centre) {
    QPolygonF circle;
    for (int degrees = 0; degrees <= 360; degrees += 5)
        circle << centre + onOuter(degrees);
    return circle;
}

/// Beside what is moved, but whole in a picture of that size.
void drawAmount(QPainter& painter, QPointF at, const QSizeF& picture, const QString& words,
                const Theme& theme) {
    const QFontMetricsF metrics(painter.font());
    const QSizeF size(metrics.horizontalAdvance(words) + 14, metrics.height() + 6);
    const auto within = [](double from, double length, double room) {
        return std::max(kAmountEdge, std::min(from, room - length - kAmountEdge));
    };
    const QRectF box(QPointF(within(at.x(), size.width(), picture.width()),
                             within(at.y(), size.height(), picture.height())),
                     size);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.label);
    painter.drawRoundedRect(box, 0.5 * box.height(), 0.5 * box.height());
    painter.setPen(theme.labelText);
    painter.drawText(box, Qt::AlignCenter, words);
}

} // namespace

std::optional<QPointF> ArrangeGizmo::placeOf(ArrangeHandle handle, const ViewCamera& camera) const {
    if (!shown_) return std::nullopt;
    const Pose& frame = *shown_;
    const auto centre = camera.project(frame.translation);
    if (!centre) return std::nullopt;
    const double pixel = camera.pixelSize(frame.translation);
    const int i = axisOf(handle);
    if (movesAlong(handle)) return camera.project(frame.apply(kArrow * pixel * Vec3::Unit(i)));
    const double middle = 0.5 * (kPlaneNear + kPlaneFar) * pixel;
    if (movesIn(handle)) return camera.project(inFrame(frame, i, middle, middle));
    const double part = std::sqrt(0.5) * kTurnRing * pixel;
    if (turnsAbout(handle)) return camera.project(inFrame(frame, i, part, part));
    if (handle == Scale) return *centre + onOuter(45);
    if (handle == Turn) return *centre + onOuter(135);
    return centre;
}

ArrangeGizmo::Shapes ArrangeGizmo::shapes(const ViewCamera& camera) const {
    const Pose& frame = *shown_;
    Shapes all;
    const auto centre = camera.project(frame.translation);
    if (!centre) return all;
    const double pixel = camera.pixelSize(frame.translation);
    all.push_back({Scale, {placeOf(Scale, camera), {}, {}}});
    all.push_back({Move, {centre, {}, {}}});
    for (const auto handle : {MoveX, MoveY, MoveZ}) {
        const Vec3 axis = pixel * Vec3::Unit(axisOf(handle));
        all.push_back({handle,
                       {placeOf(handle, camera),
                        onScreen({frame.apply(kArrowGap * axis), frame.apply(kArrow * axis)}, camera),
                        {}}});
    }
    for (const auto handle : {TurnX, TurnY, TurnZ})
        all.push_back({handle, {{}, onScreen(ring(frame, axisOf(handle), kTurnRing * pixel), camera), {}}});
    all.push_back({Turn, {{}, outerRing(*centre), {}}});
    for (const auto handle : {MoveYZ, MoveZX, MoveXY})
        all.push_back({handle, {{}, {}, planeSquare(frame, axisOf(handle), camera)}});
    return all;
}

bool ArrangeGizmo::take(QPointF cursor, const ViewCamera& camera) {
    free_ = false;
    led_ = cursor;
    typed_.clear();
    return HandlesOf::take(cursor, camera);
}

void ArrangeGizmo::grabFree(ArrangeHandle handle, QPointF cursor) {
    free_ = true;
    led_ = cursor;
    typed_.clear();
    grab(handle, cursor);
}

void ArrangeGizmo::keepTo(int axis) {
    if (!held_ || held_->handle == Scale) return;
    held_->handle = ArrangeHandle(int(turns(held_->handle) ? TurnX : MoveX) + axis);
}

void ArrangeGizmo::lead(QPointF step, bool fine) {
    led_ += (fine ? kFine : 1) * step;
}

bool ArrangeGizmo::type(int key) {
    const bool isDigit = key >= Qt::Key_0 && key <= Qt::Key_9;
    const bool isPoint = key == Qt::Key_Period || key == Qt::Key_Comma;
    if (key == Qt::Key_Backspace)
        typed_.chop(1);
    else if (key == Qt::Key_Minus)
        typed_ = typed_.startsWith(u'-') ? typed_.sliced(1) : u'-' + typed_;
    else if (isDigit && typed_.size() < kMostTyped)
        typed_ += QString::number(key - Qt::Key_0);
    else if (isPoint && !typed_.contains(u'.'))
        typed_ += u'.';
    return isDigit || isPoint || key == Qt::Key_Backspace || key == Qt::Key_Minus;
}

bool ArrangeGizmo::mayMove(int axis) const {
    const ArrangeHandle handle = held_->handle;
    return movesAlong(handle) ? axis == axisOf(handle) : !movesIn(handle) || axis != axisOf(handle);
}

std::optional<double> ArrangeGizmo::number() const {
    bool isNumber = false;
    const double number = typed_.toDouble(&isNumber);
    if (!isNumber || (held_->handle == Scale && number <= 0)) return std::nullopt;
    return number;
}

Arrangement ArrangeGizmo::typed(const ViewCamera& camera) const {
    Arrangement by;
    by.about = held_->value.translation;
    const auto number = this->number();
    if (!number) return by;
    if (held_->handle == Scale)
        by.scale = *number;
    else if (turns(held_->handle))
        by.turn = Quat(Eigen::AngleAxisd(*number * kOneDegree, turnAxis(camera)));
    else
        by.move = 1e-3 * *number * held_->value.rotate(Vec3::Unit(mayMove(0) ? 0 : mayMove(1) ? 1 : 2));
    return by;
}

Vec3 ArrangeGizmo::draggedMove(const ViewCamera& camera) const {
    const Pose& frame = held_->value;
    const int i = axisOf(held_->handle);
    const Vec3 axis = frame.rotate(Vec3::Unit(i));
    if (held_->handle == Move) return camera.dragVector(frame.translation, led_ - held_->from);
    if (movesAlong(held_->handle))
        return draggedAlong(frame.translation, axis, held_->from, led_, camera) * axis;
    return draggedIn(frame.translation, axis, held_->from, led_, camera);
}

/// Of what turns freely about the line of sight: toward the eye.
Vec3 ArrangeGizmo::turnAxis(const ViewCamera& camera) const {
    return held_->handle == Turn ? Vec3(-camera.forward())
                                 : held_->value.rotate(Vec3::Unit(axisOf(held_->handle)));
}

double ArrangeGizmo::draggedTurn(const ViewCamera& camera) const {
    const Pose& frame = held_->value;
    if (!free_ && held_->handle != Turn)
        return draggedAbout(frame, axisOf(held_->handle), kTurnRing * camera.pixelSize(frame.translation),
                            held_->from, led_, camera);
    const double angle = draggedRound(frame.translation, held_->from, led_, camera);
    return turnAxis(camera).dot(camera.forward()) > 0 ? -angle : angle;
}

Arrangement ArrangeGizmo::dragged(const ViewCamera& camera, bool snapped, bool fine) const {
    Arrangement by;
    if (!held_) return by;
    if (!typed_.isEmpty()) return typed(camera);
    const Pose& frame = held_->value;
    by.about = frame.translation;
    if (held_->handle == Scale) {
        by.scale = draggedOut(frame.translation, held_->from, led_, camera);
        const double step = fine ? kFineScale : kScaleStep;
        if (snapped) by.scale = std::max(rounded(by.scale, step), step);
    } else if (turns(held_->handle)) {
        double angle = draggedTurn(camera);
        if (snapped) angle = rounded(angle, fine ? kFineTurn : kTurnStep);
        if (angle != 0) by.turn = Quat(Eigen::AngleAxisd(angle, turnAxis(camera)));
    } else {
        Vec3 way = frame.rotateInverse(draggedMove(camera));
        const double step = fine ? kFineMove : kMoveStep;
        if (snapped) way = way.unaryExpr([step](double x) { return rounded(x, step); });
        by.move = frame.rotate(way);
    }
    return by;
}

QString ArrangeGizmo::words(const Arrangement& now, const ViewCamera& camera) const {
    const auto told = [this](double value, int decimals) {
        return typed_.isEmpty() ? numberOf(value, decimals) : number() ? typed_ : typed_ + u'?';
    };
    if (held_->handle == Scale) return QStringLiteral("\u00d7 ") + told(now.scale, 3);
    if (turns(held_->handle)) {
        const Eigen::AngleAxisd turn(now.turn);
        const double angle = turn.axis().dot(turnAxis(camera)) < 0 ? -turn.angle() : turn.angle();
        return told(angle / kOneDegree, 1) + QStringLiteral("\u00b0");
    }
    const Vec3 way = held_->value.rotateInverse(now.move);
    QStringList parts;
    for (int i = 0; i < 3; ++i)
        if (mayMove(i) && (typed_.isEmpty() || parts.isEmpty()))
            parts << QStringLiteral("xyz").sliced(i, 1) + u' ' + told(1e3 * way[i], 2);
    return parts.join(QStringLiteral(", ")) + QStringLiteral(" mm");
}

void ArrangeGizmo::draw(QPainter& painter, const ViewCamera& camera, const Theme& theme, QPointF cursor,
                        const std::optional<Arrangement>& now) const {
    if (!shown_) return;
    const auto centre = camera.project(shown_->translation);
    if (!centre) return;
    const auto under = lit(cursor, camera);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    for (const auto& [handle, shape] : shapes(camera)) {
        const bool ofAxis = movesAlong(handle) || movesIn(handle) || turnsAbout(handle);
        QColor colour = ofAxis ? axisColour(theme, axisOf(handle)) : theme.text;
        if (turns(handle)) colour.setAlphaF(0.6f);
        if (under == handle) colour = theme.accent;
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(colour,
                            under == handle ? 3
                            : turns(handle) ? 1.6
                                            : 2.6,
                            Qt::SolidLine, Qt::RoundCap));
        painter.drawPolyline(shape.line);
        QColor fill = colour;
        fill.setAlphaF(0.35f);
        painter.setBrush(fill);
        painter.setPen(QPen(colour, 1));
        painter.drawPolygon(shape.area);
        if (!shape.dot) continue;
        painter.setBrush(colour);
        painter.setPen(QPen(theme.label, 1));
        if (handle == Scale)
            painter.drawRect(QRectF(*shape.dot - QPointF(5, 5), QSizeF(10, 10)));
        else
            painter.drawEllipse(*shape.dot, 5.0, 5.0);
    }
    if (held_ && now)
        drawAmount(painter, *centre + QPointF(kOuter + 8, -10), camera.size, words(*now, camera), theme);
    painter.restore();
}

} // namespace tactum
