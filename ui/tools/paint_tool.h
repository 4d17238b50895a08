// The brush in the view: strokes over the model become edits of what is painted there.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include <QObject>

#include "ui/base/background_job.h"
#include "ui/document/document.h"
#include "ui/tools/brush_stroke.h"
#include "ui/tools/paint_goal.h"
#include "ui/view/scene_view.h"

namespace tactum {

/// A stroke paints the surface on which it begins and, if that one is selected, all selected ones of its
/// object; locked ones stay. It is worked out on a worker while it goes on, and is one step of the history.
/// Ctrl swaps adding and subtracting, Shift smooths. Thread: ui.
class PaintTool : public QObject {
    Q_OBJECT
public:
    PaintTool(Document& document, SceneView& view, QObject* parent = nullptr);

    /// Whether the brush is the tool that is on: what is painted then lies over the model.
    void setActive(bool active);
    const Brush& brush() const { return brush_; }
    /// Numbers are brought into their ranges.
    void setBrush(const Brush& brush);
    PaintGoal goal() const { return goal_; }
    void setGoal(PaintGoal goal);
    /// The layer of the active surface that is chosen; nothing: the topmost.
    void setLayer(std::optional<int> layer);
    /// Whether strokes are still being worked out.
    bool working() const { return !strokes_.empty(); }

signals:
    void brushChanged();
    /// One line: why nothing is painted, or nothing of it felt, and what to do.
    void refused(const QString& sentence);

private:
    struct Stroke {
        SurfaceRefs surfaces; ///< of one object
        Brush brush;
        PaintGoal goal;
        std::vector<PaintStep> steps;      ///< not worked out yet
        std::vector<PaintPlace> places;    ///< one for each surface, once begun
        std::shared_ptr<BrushStroke> work; ///< null: not begun
        std::vector<Surface> seen;         ///< the surfaces as this stroke left them
        Gesture gesture = 0;               ///< 0: not begun
        bool ended = false;
    };

    void follow(StrokeStep step, const std::optional<PickHit>& hit, Qt::KeyboardModifiers modifiers);
    void beginStroke(const PickHit& hit, Qt::KeyboardModifiers modifiers);
    void addStep(const std::optional<PickHit>& hit);
    void giveUp();
    void goOn();
    bool start(Stroke& stroke);
    bool stillThere(const Stroke& stroke) const;
    void write(Stroke& stroke, const std::vector<BrushStroke::Part>& parts);
    std::optional<int> layerFor(SurfaceRef ref) const;
    std::shared_ptr<PaintGround> groundOf(ObjectId object);
    void show();
    void showRing();

    Document& document_;
    SceneView& view_;
    Brush brush_;
    PaintGoal goal_ = PaintGoal::Height;
    std::optional<int> layer_;
    bool active_ = false;
    std::optional<ObjectId> shown_; ///< the object whose paint is shown
    std::deque<Stroke> strokes_;    ///< the first is being worked out
    std::vector<std::shared_ptr<PaintGround>> grounds_;
    BackgroundJob job_;
};

} // namespace tactum
