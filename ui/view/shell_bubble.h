// The shell of rate control: a ball about the device's workspace, clear but for its rim. Private to this
// folder.
#pragma once

#include <QColor>

#include <vtkActor.h>
#include <vtkNew.h>

#include "core/base/vec.h"

class vtkRenderer;

namespace tactum {

/// Thread: ui.
class ShellBubble {
public:
    explicit ShellBubble(vtkRenderer& renderer);
    ~ShellBubble();

    void setColour(const QColor& colour);
    /// World frame, m.
    void place(const Vec3& centre, double radius);

private:
    vtkRenderer& renderer_;
    vtkNew<vtkActor> actor_;
};

} // namespace tactum
