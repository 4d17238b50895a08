// The view divided into panes: where each of them is, and where it looks from. Private to this folder.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <QRect>

#include "ui/view/view_camera.h"
#include "ui/view/view_split.h"

namespace tactum {

/// One picture of the view. Logical pixels; those of its camera begin at its upper left corner.
struct ViewPane {
    ViewCamera camera;   ///< its size is that of the pane
    bool fitted = false; ///< it has been, in the size that it has
    QRect place;         ///< in the view

    QPointF inside(QPointF at) const { return at - place.topLeft(); }
};

/// The person's own view, and those from the front, the right and above. A view that is not divided has one
/// pane, the own one; those that are not shown keep their cameras. The active pane is what the mouse and the
/// keys act upon: the one under the pointer while that is over the view, else the one last used.
/// Thread: ui.
class ViewPanes {
public:
    static constexpr std::size_t kOwn = 0, kFront = 1, kRight = 2, kTop = 3, kCount = 4;
    static constexpr int kGap = 2; ///< between panes, logical pixels

    ViewPanes();

    /// Where a pane looks from at first; nothing of it depends on the scene.
    static ViewCamera planned(std::size_t number);
    /// All look from there again, but for the projection of the own one.
    void plan();
    /// What is framed: points of the world frame, m.
    void setSpanning(std::vector<Vec3> points_W) { spanning_ = std::move(points_W); }
    std::span<const Vec3> spanning() const { return spanning_; }

    ViewSplit split() const { return split_; }
    void setSplit(ViewSplit split);
    bool isDivided() const { return split_ != ViewSplit::One; }
    /// Parts of the width and the height that are left of and above what divides them.
    QPointF division() const { return division_; }
    void setDivision(QPointF parts);
    /// In a pane of another size the scene fills as much of the picture: what was seen whole is seen whole,
    /// whoever has turned or moved it, and in the size from before it is as it was.
    void layOut(QSize view);
    /// Draws one without vanishing points, or with them. What was seen whole fills as much of the picture;
    /// else what is at the focus keeps its size. Of the own one it is a choice that plan() keeps.
    void setParallel(std::size_t number, bool parallel);

    /// Those that are seen, from left to right and from above.
    std::span<const std::size_t> shown() const { return shown_; }
    ViewPane& operator[](std::size_t number) { return panes_[number]; }
    const ViewPane& operator[](std::size_t number) const { return panes_[number]; }
    std::array<ViewPane, kCount>& all() { return panes_; }

    std::size_t active() const { return active_; }
    std::size_t used() const { return used_; }
    /// Of the view; the nearest where none is.
    std::size_t at(QPointF place) const;
    /// The pointer is there: true if another pane is active now.
    bool pointAt(QPointF place);
    /// The pointer has left the view; likewise.
    bool pointNowhere();
    /// Something was done in the active one.
    void use() { used_ = active_; }

    /// Which of the lines between panes are under a place: the one that goes down, the one that goes across.
    Qt::Orientations linesAt(QPointF place) const;
    /// Leads lines to a place.
    void lead(Qt::Orientations lines, QPointF place);
    /// Makes what they divide equal again.
    void even(Qt::Orientations lines);

private:
    void resize(ViewPane& pane) const;

    ViewSplit split_ = ViewSplit::One;
    QPointF division_{0.5, 0.5};
    QSize view_;
    std::vector<Vec3> spanning_;
    bool ownParallel_ = false;
    std::array<ViewPane, kCount> panes_;
    std::vector<std::size_t> shown_{kOwn};
    std::size_t active_ = kOwn, used_ = kOwn;
};

} // namespace tactum
