#include "ui/view/felt_view.h"

#include <algorithm>

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>

#include "ui/view/smooth_image.h"

namespace tactum {

namespace {

constexpr double kNeedle = 0.015;      // of the scene's diagonal
constexpr double kTrailSpacing = 5e-4; // of it
constexpr double kNeedleWidth = 1.3;   // logical pixels
constexpr double kEdge = 12, kLineGap = 4, kPad = 8;

} // namespace

FeltView::FeltView(ViewStage& stage, ModelLayer& model)
    : stage_(stage), model_(model), cone_(*stage.touch, *stage.ghost), trail_(*stage.touch, *stage.ghost),
      spheres_(*stage.solid), normals_(*stage.solid), surfaces_(model) {}

void FeltView::setTheme(const Theme& theme) {
    cone_.setTheme(theme);
    trail_.setTheme(theme);
    spheres_.setTheme(theme);
    normals_.setTheme(theme);
}

void FeltView::setOptions(const FeltOptions& options) {
    const FeltOptions before = std::exchange(options_, options);
    if (spheres_.shown()) options_.sphereLevel = std::min(options.sphereLevel, spheres_.deepest());
    cone_.setVisible(options.cone);
    if (options.trail != before.trail) trail_.setVisible(options.trail);
    if (options.spheres != before.spheres || options_.sphereLevel != before.sphereLevel) askSpheres();
    if (options.feltNormals != before.feltNormals) askNormals();
    if (options.map != before.map || options.bumps != before.bumps || options.relief != before.relief)
        surfaces_.set(world_, options);
}

void FeltView::setWorld(std::shared_ptr<const World> world) {
    if (world == world_) return;
    const bool sameShape = world && world_ && world->shapeRevision == world_->shapeRevision;
    const auto normalsOf = [](const WorldBody& body) { return body.normals; };
    const bool sameNormals =
        sameShape && std::ranges::equal(world->bodies, world_->bodies, {}, normalsOf, normalsOf);
    world_ = std::move(world);
    if (!sameShape) {
        diagonal_ = world_ && world_->scene ? boundsOf(*world_->scene).diagonal() : 0;
        trail_.setSpacing(kTrailSpacing * diagonal_);
        trail_.clear();
        askSpheres();
    }
    if (!sameNormals) askNormals();
    surfaces_.set(world_, options_);
}

void FeltView::askSpheres() {
    if (world_ && options_.spheres)
        spheres_.ask(world_, options_.sphereLevel, place_);
    else
        spheres_.clear();
}

void FeltView::askNormals() {
    if (world_ && options_.feltNormals)
        normals_.ask(world_, kNeedle * diagonal_);
    else
        normals_.clear();
}

bool FeltView::takeFinished() {
    const bool spheres = spheres_.takeFinished(), normals = normals_.takeFinished();
    return surfaces_.takeFinished() || spheres || normals;
}

void FeltView::lookFrom(const ViewCamera& camera, const TouchState* touch) {
    cone_.setVisible(options_.cone && touch);
    if (touch) cone_.update(*touch, camera);
}

void FeltView::update(double pixel, double ratio) {
    trail_.update(ratio);
    normals_.setWidth(kNeedleWidth * ratio);
    surfaces_.setPixel(pixel);
    if (!world_) return;
    for (const WorldBody& body : world_->bodies) {
        vtkMatrix4x4* matrix = model_.matrixOf(body.object);
        spheres_.place(body.object, matrix);
        normals_.place(body.object, matrix);
    }
}

QStringList FeltView::legends() const {
    QStringList lines;
    if (!world_) return lines;
    if (options_.spheres) lines << spheres_.legend();
    if (options_.feltNormals) lines << normals_.legend();
    if (const QString words = surfaces_.legend(); !words.isEmpty()) lines << words;
    if (options_.trail)
        lines << QObject::tr("Trail of the last %1 s: line slipping, beads sticking").arg(TrailLayer::kSpan);
    return lines;
}

void FeltView::drawLegends(QPainter& painter, const QSizeF& view, const Theme& theme) const {
    const double taken = drawWords(painter, view, theme);
    if (options_.map && world_) drawScaleBar(painter, view, taken, *options_.map, surfaces_.range(), theme);
}

double FeltView::drawWords(QPainter& painter, const QSizeF& view, const Theme& theme) const {
    const QStringList lines = legends();
    if (lines.isEmpty()) return 0;
    const QFontMetricsF metrics(painter.font());
    double width = 0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    const double step = metrics.height() + kLineGap;
    width = std::min(width, view.width() - 2 * (kEdge + kPad));
    const QRectF box(kEdge, kEdge, width + 2 * kPad, step * double(lines.size()) - kLineGap + 2 * kPad);
    drawSmoothly(painter, box, [&](QPainter& inner) {
        inner.setPen(Qt::NoPen);
        inner.setBrush(theme.label);
        inner.drawRoundedRect(QRectF({0, 0}, box.size()), 6, 6);
        inner.setPen(theme.labelText);
        for (int i = 0; i < int(lines.size()); ++i)
            inner.drawText(QRectF(kPad, kPad + i * step, width, metrics.height()),
                           Qt::AlignLeft | Qt::AlignVCenter,
                           metrics.elidedText(lines[i], Qt::ElideRight, width));
    });
    return box.bottom();
}

} // namespace tactum
