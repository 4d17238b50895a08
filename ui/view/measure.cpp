#include "ui/view/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <QFontMetricsF>
#include <QPainter>

#include "ui/base/numbers.h"
#include "ui/view/handles.h"
#include "ui/view/smooth_image.h"

namespace tactum {

namespace {

constexpr Parameter kMeasuredLength{"measured", "", "m", 0, 1e6, 1e-3, 0, 5, ""};
constexpr double kFinest = 1e-4;                  // m: of less two digits more are shown
constexpr double kCornerNear = 10, kEdgeNear = 6; // pixels
constexpr double kArc = 34, kMeasureRim = 8, kLabelGap = 8;

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

QString angleText(double radians) {
    return numberText(radians * 180 / std::numbers::pi, 1) + QStringLiteral("\u00b0");
}

/// The point of a segment that a ray passes nearest to.
Vec3 nearestOn(const Vec3& a, const Vec3& b, const Ray& ray) {
    const double length = (b - a).norm();
    if (!(length > 0)) return a;
    const Vec3 along = (b - a) / length;
    return a + std::clamp(alongLine(a, along, ray).value_or(0), 0.0, length) * along;
}

struct Words {
    QPointF at, away;  ///< they are beside that place, in this direction of unit length
    QStringList lines; ///< the first is bold
    QRectF box{};      ///< where they are
};

QRectF boxBeside(const Words& words, const QFont& font) {
    QFont bold = font;
    bold.setBold(true);
    const QFontMetricsF metrics(bold);
    double width = 0;
    for (const QString& line : words.lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    QRectF box(0, 0, std::ceil(width) + 18, std::ceil(metrics.height()) * double(words.lines.size()) + 8);
    const double reach = std::abs(words.away.x()) * box.width() + std::abs(words.away.y()) * box.height();
    box.moveCenter(words.at + (kLabelGap + 0.5 * reach) * words.away);
    return box;
}

/// Whole inside of the view, where that is large enough.
QRectF inside(QRectF box, const QRectF& view) {
    box.moveLeft(std::max(view.left(), std::min(box.left(), view.right() - box.width())));
    box.moveTop(std::max(view.top(), std::min(box.top(), view.bottom() - box.height())));
    return box;
}

/// The nearest place that nothing covers; where there is none, the box as it is.
QRectF uncovered(const QRectF& box, const QRectF& view, const std::vector<QRectF>& covers) {
    const QRectF wanted = inside(box, view);
    const auto isFree = [&](const QRectF& place) {
        return std::ranges::none_of(covers, [&](const QRectF& cover) { return cover.intersects(place); });
    };
    std::vector<QRectF> places{wanted};
    for (const QRectF& cover : covers)
        for (const QPointF& corner : {QPointF(wanted.left(), cover.bottom() + kLabelGap),
                                      QPointF(wanted.left(), cover.top() - kLabelGap - wanted.height()),
                                      QPointF(cover.right() + kLabelGap, wanted.top()),
                                      QPointF(cover.left() - kLabelGap - wanted.width(), wanted.top())})
            places.push_back(inside(QRectF(corner, wanted.size()), view));
    const auto offOf = [&](const QRectF& place) {
        return isFree(place) ? lengthOf(place.topLeft() - wanted.topLeft()) : 1e9;
    };
    return *std::ranges::min_element(places, {}, offOf);
}

void drawWords(QPainter& painter, const Words& words, const Theme& theme) {
    const QRectF& box = words.box;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.label);
    painter.drawRoundedRect(box, kMeasureRim, kMeasureRim);
    painter.setPen(theme.labelText);
    QRectF line = box.adjusted(0, 4, 0, -4);
    line.setHeight(line.height() / double(words.lines.size()));
    QFont font = painter.font();
    for (const QString& text : words.lines) {
        font.setBold(text == words.lines.front());
        painter.setFont(font);
        painter.drawText(line, Qt::AlignCenter, text);
        line.translate(0, line.height());
    }
    font.setBold(false);
    painter.setFont(font);
}

/// From the first leg to the second about their corner.
QPolygonF arcOf(std::span<const Vec3> corner, const ViewCamera& camera) {
    const Vec3 a = corner[0] - corner[1], b = corner[2] - corner[1];
    const double angle = angleBetween(a, b);
    if (!(a.norm() > 0) || !(b.norm() > 0) || !(std::sin(angle) > 0)) return {};
    const double radius = std::min({kArc * camera.pixelSize(corner[1]), 0.5 * a.norm(), 0.5 * b.norm()});
    const Vec3 axis = a.cross(b).normalized();
    std::vector<Vec3> points;
    for (int i = 0; i <= 24; ++i)
        points.push_back(corner[1] + radius * (Eigen::AngleAxisd(angle * i / 24, axis) * a.normalized()));
    return onScreen(points, camera);
}

/// Across a line, to its upper side.
QPointF acrossOf(const QPolygonF& line) {
    const QPointF along = line[1] - line[0];
    const double length = std::max(lengthOf(along), 1e-6);
    const QPointF across(along.y() / length, -along.x() / length);
    return across.y() > 0 ? -across : across;
}

class MeasurePicture {
public:
    MeasurePicture(std::span<const Vec3> points, const ViewCamera& camera) {
        for (const Vec3& p : points)
            if (const auto seen = camera.project(p)) dots << *seen;
        for (std::size_t i = 1; i < points.size(); ++i)
            lines.push_back(onScreen({points[i - 1], points[i]}, camera));
        const auto numbers = numbersOf(points);
        if (numbers && !lines.front().isEmpty())
            words.push_back({.at = lines.front().boundingRect().center(),
                             .away = acrossOf(lines.front()),
                             .lines = linesOf(*numbers)});
        if (points.size() < 3) return;
        arc = arcOf(points, camera);
        if (const auto corner = camera.project(points[1]); corner && !arc.isEmpty()) {
            const QPointF out = arc[arc.size() / 2] - *corner;
            words.push_back({.at = arc[arc.size() / 2],
                             .away = out / std::max(lengthOf(out), 1e-6),
                             .lines = {angleText(*numbers->angle)}});
        }
    }

    /// Before they are drawn. Words of what is beside the view stay there.
    void placeWords(const QFont& font, const QRectF& view, const QRegion& covered) {
        std::vector<QRectF> covers(covered.begin(), covered.end());
        for (Words& each : words) {
            each.box = boxBeside(each, font);
            if (view.contains(each.at)) each.box = uncovered(each.box, view, covers);
            covers.push_back(each.box);
        }
    }

    QRectF box() const {
        if (dots.isEmpty()) return {}; // all of it is behind the eye
        // A rectangle without an area is no part of another one: each has its rim first.
        const auto about = [](const QPolygonF& drawn) {
            return drawn.boundingRect().adjusted(-kMeasureRim, -kMeasureRim, kMeasureRim, kMeasureRim);
        };
        QRectF all = about(dots);
        for (const QPolygonF& line : lines)
            all |= about(line);
        if (!arc.isEmpty()) all |= about(arc);
        for (const Words& each : words)
            all |= each.box;
        return all;
    }

    void draw(QPainter& painter, const Theme& theme, bool lastIsNext) const {
        for (const bool ground : {true, false}) {
            QPen pen(ground ? theme.label : theme.accent, ground ? 5 : 2, Qt::SolidLine, Qt::RoundCap);
            painter.setBrush(Qt::NoBrush);
            for (std::size_t i = 0; i < lines.size(); ++i) {
                pen.setStyle(lastIsNext && !ground && i + 1 == lines.size() ? Qt::DashLine : Qt::SolidLine);
                painter.setPen(pen);
                painter.drawPolyline(lines[i]);
            }
            pen.setStyle(Qt::SolidLine);
            painter.setPen(pen);
            painter.drawPolyline(arc);
        }
        painter.setPen(QPen(theme.label, 2));
        for (qsizetype i = 0; i < dots.size(); ++i) {
            const bool isNext = lastIsNext && i + 1 == dots.size();
            painter.setBrush(isNext ? QBrush(theme.labelText) : QBrush(theme.accent));
            painter.drawEllipse(dots[i], 5, 5);
        }
        for (const Words& each : words)
            drawWords(painter, each, theme);
    }

    std::vector<QRectF> boxes() const {
        std::vector<QRectF> all;
        for (const Words& each : words)
            all.push_back(each.box);
        return all;
    }

private:
    static QStringList linesOf(const MeasuredNumbers& numbers) {
        const auto part = [&](const char* name, int axis) {
            return QStringLiteral("%1 %2").arg(QLatin1String(name), measuredText(numbers.way[axis]));
        };
        return {measuredText(numbers.way.norm()), part("dx", 0) + QStringLiteral("   ") + part("dy", 1) +
                                                      QStringLiteral("   ") + part("dz", 2)};
    }

    QPolygonF dots, arc;
    std::vector<QPolygonF> lines;
    std::vector<Words> words;
};

} // namespace

std::optional<MeasuredNumbers> numbersOf(std::span<const Vec3> points) {
    if (points.size() < 2) return std::nullopt;
    MeasuredNumbers numbers{points[1] - points[0], std::nullopt};
    if (points.size() > 2) numbers.angle = angleBetween(points[0] - points[1], points[2] - points[1]);
    return numbers;
}

QString measuredText(double metres) {
    const DisplayUnit unit = displayUnit(kMeasuredLength);
    const bool fine = metres != 0 && std::abs(metres) < kFinest;
    return numberText(unit.factor * metres, unit.decimals + (fine ? 2 : 0)) + u' ' + unit.name;
}

QString measuredLines(const MeasuredNumbers& numbers) {
    QStringList lines{QObject::tr("Distance %1").arg(measuredText(numbers.way.norm()))};
    for (const auto& [name, axis] : {std::pair("dx", 0), {"dy", 1}, {"dz", 2}})
        lines << QStringLiteral("%1 %2").arg(QLatin1String(name), measuredText(numbers.way[axis]));
    if (numbers.angle) lines << QObject::tr("Angle %1").arg(angleText(*numbers.angle));
    return lines.join(u'\n');
}

Vec3 snappedTo(const TriangleSoup& soup, Index triangle, const Pose& pose, const Vec3& hit, QPointF cursor,
               const ViewCamera& camera, const std::optional<SectionPlane>& section) {
    std::array<Vec3, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = pose.apply(soup.positions[soup.triangles[triangle][i]]);
    Vec3 best = hit;
    double least = kCornerNear;
    const auto offer = [&](const Vec3& p) {
        const auto seen = camera.project(p);
        if (!seen || lengthOf(*seen - cursor) >= least || (section && section->height(p) > 0)) return;
        least = lengthOf(*seen - cursor);
        best = p;
    };
    for (const Vec3& corner : corners)
        offer(corner);
    if (least < kCornerNear) return best;
    least = kEdgeNear;
    for (std::size_t i = 0; i < 3; ++i)
        offer(nearestOn(corners[i], corners[(i + 1) % 3], camera.ray(cursor)));
    return best;
}

std::vector<QRectF> measureBoxes(std::span<const Vec3> points, const ViewCamera& camera, const QFont& font,
                                 const QRegion& covered) {
    MeasurePicture picture(points, camera);
    picture.placeWords(font, QRectF({0, 0}, camera.size), covered);
    return picture.boxes();
}

void drawMeasure(QPainter& painter, std::span<const Vec3> points, const std::optional<Vec3>& next,
                 const ViewCamera& camera, const Theme& theme, const QRegion& covered) {
    std::vector<Vec3> all(points.begin(), points.end());
    if (next && all.size() < 3) all.push_back(*next);
    if (all.empty()) return;
    const QRectF view({0, 0}, camera.size);
    MeasurePicture picture(all, camera);
    picture.placeWords(painter.font(), view, covered);
    const QRect box = (picture.box() & view).toAlignedRect();
    if (box.isEmpty()) return;
    drawSmoothly(painter, box, [&](QPainter& inner) {
        inner.translate(-box.topLeft());
        picture.draw(inner, theme, next && points.size() < 3);
    });
}

} // namespace tactum
