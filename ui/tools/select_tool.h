// Selecting in the view: what a click takes, and what grows from it.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <QObject>

#include "core/geometry/face_graph.h"
#include "core/surface/parameter.h"
#include "ui/base/background_job.h"
#include "ui/document/selection.h"
#include "ui/view/scene_picker.h"

namespace tactum {

class Document;

inline constexpr Parameter kSelectAngle{
    "select-angle",
    "Angle",
    "rad",
    0,
    3.141592653589793,
    0.08726646259971647,
    0.6981317007977318,
    3,
    "Edges that bend by more end a smooth region; normals farther apart are not similar."};

/// Shift adds, Ctrl takes back.
SelectMode selectModeOf(Qt::KeyboardModifiers modifiers);

/// What a click takes.
enum class SelectReach { Surface, Material, Colour, Connected, Smooth, Similar, Facing, Triangle };

/// Whether it takes whole surfaces, else triangles of one object.
constexpr bool takesSurfaces(SelectReach reach) {
    return reach <= SelectReach::Colour;
}

/// Neighbours of a mesh are found on a worker the first time that a region of it is asked for; what was asked
/// last is done then. Thread: ui.
class SelectTool : public QObject {
    Q_OBJECT
public:
    explicit SelectTool(Document& document, QObject* parent = nullptr);

    void setReach(SelectReach reach) { reach_ = reach; }
    SelectReach reach() const { return reach_; }
    /// rad.
    void setAngle(double angle) { angle_ = kSelectAngle.clamped(angle); }
    bool working() const { return job_.running(); }

    /// A click in the view; nothing is hit beside the model.
    void take(const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers);
    void takeAll();
    void takeNothing();
    void takeLikeActive();
    void takeColourOfActive();
    void grow();
    void shrink();
    void invert();

signals:
    void progressed(double fraction, double secondsLeft);
    void finished();

private:
    using Use = std::function<void(const FaceGraph&)>;
    void withGraphOf(ObjectId object, Use use);
    void takeAlike(const std::vector<SurfaceRef>& alike, SurfaceRef active, SelectMode mode);
    void takeRegion(const PickHit& hit, SelectMode mode);
    TriangleSet regionAt(const FaceGraph& graph, Index triangle) const;

    Document& document_;
    SelectReach reach_ = SelectReach::Surface;
    double angle_ = kSelectAngle.initial;
    std::vector<std::shared_ptr<const FaceGraph>> graphs_; ///< of the meshes that were asked for
    BackgroundJob job_;
};

} // namespace tactum
