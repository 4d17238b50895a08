// Selecting by drawing over the view: a box, a lasso, a brush.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>
#include <QPolygonF>
#include <QRectF>

#include "core/geometry/seen_triangles.h"
#include "core/surface/parameter.h"
#include "ui/base/background_job.h"
#include "ui/document/selection.h"
#include "ui/view/scene_view.h"

namespace tactum {

class Document;

/// Box and lasso take what is seen in them, or, through the model, whatever lies there; the brush takes what
/// is seen. What is seen is found on a worker and kept until the picture is another one. Thread: ui.
class RegionSelect : public QObject {
    Q_OBJECT
public:
    RegionSelect(Document& document, SceneView& view, QObject* parent);

    /// Surfaces are taken, else triangles of one object: of the one that has selected triangles where they
    /// are added to or taken from, else of the active one, else of the one with most of them there.
    void setTakesSurfaces(bool surfaces) { surfaces_ = surfaces; }
    void setThrough(bool through) { through_ = through; }
    /// Of the brush, logical pixels.
    double brushRadius() const { return radius_; }
    void scaleBrush(double factor);
    bool working() const { return job_.running(); }

    // In logical pixels of the view.
    void takeBox(const QRectF& box, SelectMode mode);
    void takeLasso(const QPolygonF& line, SelectMode mode);
    /// A stroke; `mode` is that of its first step. Triangles that it goes over are shown while it does so and
    /// selected when it ends, surfaces at once; given up, the selection is as before.
    void brush(StrokeStep step, QPointF from, QPointF to, SelectMode mode);

signals:
    void progressed(double fraction, double secondsLeft);
    void finished();

private:
    /// What is before the eye, and whose it is.
    struct Sight {
        std::vector<BodyInView> bodies;
        std::vector<ObjectId> objects;
    };
    /// Triangles of each body of a sight.
    using Taken = std::vector<TriangleSet>;
    using Seen = std::shared_ptr<const SeenTriangles>;
    struct Stroke {
        SelectMode mode = SelectMode::Replace;
        SurfaceRefs surfaces; ///< as they were selected before
        FaceSelection faces;
        ScreenMask waiting; ///< gone over, and not looked at yet
        Sight sight;
        Seen seen;                        ///< null: it is still looked for
        std::vector<TriangleMarks> taken; ///< of each body
        std::optional<std::size_t> body;  ///< whose triangles it takes, once it has met one
        bool ended = false;
    };

    Sight sight() const;
    ScreenMask emptyMask() const;
    void take(const ScreenMask& mask, const std::optional<QRectF>& box, SelectMode mode);
    /// Calls `use` when it is known what is seen.
    void whenSeen(const Sight& sight, std::function<void(const Seen&)> use);
    void choose(const Sight& sight, const Taken& taken, SelectMode mode);
    SurfaceRefs surfacesOf(const Sight& sight, const Taken& taken) const;
    std::optional<std::size_t> bodyOf(const Sight& sight, const Taken& taken, SelectMode mode) const;
    bool stillThere(const Sight& sight) const;
    void brushOn();
    void showStroke();
    void endStroke();
    void giveUp();

    Document& document_;
    SceneView& view_;
    bool surfaces_ = true, through_ = true;
    double radius_ = 24;
    Seen seen_; ///< what was looked at last
    std::optional<Stroke> stroke_;
    BackgroundJob job_;
};

} // namespace tactum
