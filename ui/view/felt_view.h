// All that the view shows of how things feel, in one place. Private to this folder.
#pragma once

#include <span>

#include <QStringList>

#include "core/runtime/channels.h"
#include "ui/view/felt_options.h"
#include "ui/view/felt_surfaces.h"
#include "ui/view/friction_cone.h"
#include "ui/view/normal_glyphs.h"
#include "ui/view/sphere_layer.h"
#include "ui/view/trail_layer.h"
#include "ui/view/view_stage.h"

class QPainter;

namespace tactum {

/// Thread: ui. What takes long is made aside: takeFinished() shows it.
class FeltView {
public:
    FeltView(ViewStage& stage, ModelLayer& model);

    void setTheme(const Theme& theme);
    void setOptions(const FeltOptions& options);
    const FeltOptions& options() const { return options_; }
    /// What is felt now; null: nothing.
    void setWorld(std::shared_ptr<const World> world);
    /// Where the touch is: of a level with too many spheres, those around it are shown.
    void setPlace(const Vec3& p_W) { place_ = p_W; }
    void addTrail(std::span<const TracePoint> points, const HapticOutput& touch) {
        trail_.add(points, touch);
    }
    void clearTrail() { trail_.clear(); }
    /// Whether the picture changes although nothing moves.
    bool fades() const { return trail_.fades(); }

    bool pending() const { return spheres_.pending() || normals_.pending() || surfaces_.pending(); }
    bool takeFinished();

    /// Places everything for a frame. `pixel`: a device pixel of the finest of its pictures, m.
    void update(double pixel, double ratio);
    /// What is drawn for one of the pictures. `touch` is null where none is shown.
    void lookFrom(const ViewCamera& camera, const TouchState* touch);
    /// What a surface of this mesh is drawn as now; null: as itself.
    std::shared_ptr<const FeltMesh> shapeOf(ObjectId object, const TriangleSoup* soup, Index surface) {
        return surfaces_.shapeOf(object, soup, surface);
    }
    /// Legends and the scale bar, in logical pixels.
    void drawLegends(QPainter& painter, const QSizeF& view, const Theme& theme) const;

private:
    QStringList legends() const;
    /// Gives how far down they reach.
    double drawWords(QPainter& painter, const QSizeF& view, const Theme& theme) const;
    void askSpheres();
    void askNormals();

    ViewStage& stage_;
    ModelLayer& model_;
    FeltOptions options_;
    std::shared_ptr<const World> world_;
    double diagonal_ = 0; ///< m, of the scene
    Vec3 place_ = Vec3::Zero();
    FrictionCone cone_;
    TrailLayer trail_;
    SphereLayer spheres_;
    NormalGlyphs normals_;
    FeltSurfaces surfaces_;
};

} // namespace tactum
