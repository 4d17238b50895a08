// The spheres of the collision hierarchy at one level, as bubbles around the model. Private to this folder.
#pragma once

#include <map>
#include <memory>

#include <QString>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>

#include "ui/base/theme.h"
#include "ui/view/aside.h"
#include "ui/view/sphere_mesh.h"

class vtkRenderer;

namespace tactum {

/// Thread: ui.
class SphereLayer {
public:
    explicit SphereLayer(vtkRenderer& renderer) : renderer_(renderer) {}
    ~SphereLayer() { clear(); }

    /// Begins to make the spheres; what was drawn stays until they are there.
    void ask(std::shared_ptr<const World> world, int level, const Vec3& near_W);
    void clear();
    bool pending() const { return work_.pending(); }
    /// True when they have come.
    bool takeFinished();
    void setTheme(const Theme& theme);
    /// Where an object is; a null matrix hides its spheres.
    void place(ObjectId object, vtkMatrix4x4* matrix);

    bool shown() const { return !actors_.empty(); }
    int deepest() const { return deepest_; } ///< of what is shown
    /// "Spheres: level 2 of 4, 487".
    QString legend() const;

private:
    vtkRenderer& renderer_;
    Aside<SphereLevel> work_;
    std::map<ObjectId, vtkNew<vtkActor>> actors_;
    QColor colour_ = kDarkTheme.accent;
    int asked_ = 0, level_ = 0, deepest_ = 0;
    std::size_t all_ = 0, drawn_ = 0;
};

} // namespace tactum
