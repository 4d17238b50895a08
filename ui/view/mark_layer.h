// Triangles that something is said about, drawn by their edges. Private to this folder.
#pragma once

#include <QColor>

#include <vtkActor.h>
#include <vtkNew.h>

#include "core/geometry/triangle_set.h"

class vtkRenderer;

namespace tactum {

/// In front as they are, and dimmed through what hides them. Thread: ui.
class MarkLayer {
public:
    MarkLayer(vtkRenderer& solid, vtkRenderer& ghost);
    ~MarkLayer();
    MarkLayer(const MarkLayer&) = delete;
    MarkLayer& operator=(const MarkLayer&) = delete;

    /// X_WB. Null or no triangles: nothing.
    void show(const TriangleSoup* soup, const TriangleSet& triangles, const Pose& pose);
    void setColour(const QColor& colour);
    bool any() const { return any_; }

private:
    vtkRenderer &solid_, &ghost_;
    vtkNew<vtkActor> front_, behind_;
    bool any_ = false;
};

} // namespace tactum
