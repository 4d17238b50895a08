#include "ui/view/touch_picture.h"

#include <algorithm>
#include <cmath>

#include <QImage>
#include <QPainter>

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "ui/base/theme.h"
#include "ui/view/axes_gizmo.h"
#include "ui/view/model_layer.h"
#include "ui/view/offscreen_window.h"
#include "ui/view/path_layer.h"
#include "ui/view/scene_picker.h"
#include "ui/view/trace_plot.h"
#include "ui/view/view_stage.h"

namespace tactum {

namespace {

constexpr double kPlotShare = 0.3; ///< of the picture's height
constexpr double kMinPitch = 0.2, kMaxPitch = 0.6;
constexpr int kLegendLines = 3;

/// Looks against the mean force, so that the touched side faces the reader.
void faceTouch(ViewCamera& camera, const TouchTrace& rows) {
    Vec3 sum = Vec3::Zero();
    for (const TouchRow& row : rows)
        sum += row.force;
    if (!(sum.norm() > 0)) return;
    const Vec3 d = sum.normalized();
    if (std::hypot(d.x(), d.z()) > 0.2) camera.yaw = std::atan2(d.x(), d.z()) + 0.35;
    camera.pitch = std::clamp(std::asin(d.y()), kMinPitch, kMaxPitch);
}

Bounds boundsOfTouch(const Scene& scene, const TouchTrace& rows) {
    Bounds box = boundsOf(scene);
    for (const TouchRow& row : rows) {
        box.add(row.proxy);
        box.add(row.finger);
    }
    return box;
}

ViewCamera cameraFor(const Scene& scene, const TouchTrace& rows, QSize pixels) {
    ViewCamera camera = defaultCamera();
    camera.size = pixels;
    faceTouch(camera, rows);
    std::vector<Vec3> points = spanningPoints(scene);
    for (const TouchRow& row : rows)
        points.push_back(row.proxy);
    camera.fit(points);
    return camera;
}

/// Every height layer, as fine as a pixel in the middle of the picture.
std::map<ObjectId, std::vector<SurfaceDress>> reliefsOf(const Scene& scene, const ViewCamera& camera) {
    std::map<ObjectId, std::vector<SurfaceDress>> dresses;
    for (const SceneObject& object : scene.objects)
        for (Index s = 0; s < Index(object.surfaces.size()); ++s) {
            const auto stack = compileTextures(object.surfaces[s].layers, object.geometry, s);
            dresses[object.id].push_back({.relief = reliefOf(stack, camera.pixelSize(camera.focus))});
        }
    return dresses;
}

QImage drawScene(OffscreenWindow& offscreen, const Scene& scene, const TouchTrace& rows,
                 const ViewCamera& camera, const Theme& theme) {
    ViewStage stage(offscreen.window());
    stage.setBackground(theme);
    ModelLayer model(*stage.solid);
    model.setScene(scene);
    model.finish();
    model.setDresses(reliefsOf(scene, camera));
    const PathLayer paths(*stage.solid, *stage.ghost, rows, camera, theme);
    stage.look(camera, boundsOfTouch(scene, rows));
    return offscreen.render(camera.size.toSize());
}

void drawLegend(QPainter& painter, const Theme& theme, const TouchTrace& rows) {
    const auto most = std::max_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) {
        return a.force.squaredNorm() < b.force.squaredNorm();
    });
    const std::array<std::pair<QColor, QString>, kLegendLines> lines{
        {{theme.finger, "finger"},
         {theme.proxy, "proxy, on the surface"},
         {theme.proxy, "force, longest arrow " + QString::number(most->force.norm(), 'f', 2) + " N"}}};
    const double line = 1.6 * painter.fontMetrics().height();
    for (int i = 0; i < kLegendLines; ++i) {
        const double y = line * (i + 1);
        painter.setPen(QPen(lines[i].first, i == 2 ? 2 : 4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(line, y), QPointF(2.2 * line, y));
        if (i == 2)
            painter.drawPolyline(
                QPolygonF{{2.2 * line - 6, y - 5}, {2.2 * line, y}, {2.2 * line - 6, y + 5}});
        painter.setPen(theme.text);
        painter.drawText(QRectF(2.6 * line, y - line, 40 * line, 2 * line), Qt::AlignVCenter,
                         lines[i].second);
    }
}

QImage compose(const QImage& scene, const ViewCamera& camera, const TouchTrace& rows, QSize size,
               const Theme& theme) {
    QImage picture(size, QImage::Format_RGB32);
    picture.fill(theme.panel);
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    QFont font = painter.font();
    font.setPixelSize(std::clamp(size.height() / 58, 10, 40));
    painter.setFont(font);
    painter.drawImage(0, 0, scene);
    drawAxes(painter, camera, theme);
    drawLegend(painter, theme, rows);
    drawForcePlot(painter, QRectF(0, scene.height(), size.width(), size.height() - scene.height()), rows,
                  theme);
    return picture;
}

} // namespace

Result<void> writeTouchPicture(const Scene& scene, const TouchTrace& rows, const std::filesystem::path& png,
                               QSize size) {
    if (rows.empty()) return inputError("the replay has no rows: give a finger path with at least one point");
    size = size.expandedTo({320, 240});
    const Theme& theme = kLightTheme;
    const ViewCamera camera = cameraFor(scene, rows, {size.width(), int((1 - kPlotShare) * size.height())});
    OffscreenWindow offscreen;
    if (!offscreen.isValid())
        return machineError(
            "no OpenGL 3.2 to draw the picture with: install libgl1-mesa-dri, or use a display "
            "that has it (xvfb-run)");
    const QImage view = drawScene(offscreen, scene, rows, camera, theme);
    if (!compose(view, camera, rows, size, theme).save(QString::fromStdString(png.string()), "PNG"))
        return machineError(png.string() +
                            ": the picture could not be written; is the folder there and writable?");
    return {};
}

} // namespace tactum
