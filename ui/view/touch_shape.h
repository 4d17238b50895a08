// Things of the overlay, drawn solid and as a ghost. Private to this folder.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include <QColor>

#include "core/base/vec.h"

class vtkAlgorithm;
class vtkRenderer;

namespace tactum {

/// A mesh in two renderers at one place. Thread: ui.
class TouchShape {
public:
    TouchShape(vtkRenderer& solid, vtkRenderer& ghost, vtkAlgorithm& source);
    ~TouchShape();

    void setColour(const QColor& colour, double opacity = 1);
    void setVisible(bool visible);
    /// Puts the source's origin to p, its Y along `axis` (unit length), and scales it across and along it.
    void place(const Vec3& p, const Vec3& axis, double across, double along);

private:
    vtkRenderer &inSolid_, &inGhost_;
    vtkNew<vtkPolyDataMapper> mapper_;
    vtkNew<vtkActor> solid_, ghost_;
};

/// A rod with a head. Sizes in m.
class TouchArrow {
public:
    TouchArrow(vtkRenderer& solid, vtkRenderer& ghost);

    void setColour(const QColor& colour, double opacity = 1);
    void setVisible(bool visible);
    void place(const Vec3& from, const Vec3& to, double shaftRadius, double headRadius, double headLength);

private:
    TouchShape shaft_, head_;
};

} // namespace tactum
