// The normals that are felt, as needles on the model. Private to this folder.
#pragma once

#include <map>
#include <memory>

#include <QString>

#include <vtkActor.h>
#include <vtkNew.h>

#include "ui/base/theme.h"
#include "ui/view/aside.h"
#include "ui/view/felt_normals.h"

class vtkRenderer;

namespace tactum {

/// Thread: ui.
class NormalGlyphs {
public:
    explicit NormalGlyphs(vtkRenderer& renderer) : renderer_(renderer) {}
    ~NormalGlyphs() { clear(); }

    void ask(std::shared_ptr<const World> world, double length);
    void clear();
    bool pending() const { return work_.pending(); }
    bool takeFinished();
    void setTheme(const Theme& theme);
    void setWidth(double devicePixels);
    void place(ObjectId object, vtkMatrix4x4* matrix);

    bool shown() const { return !actors_.empty(); }
    /// Whether what is felt is what is drawn.
    QString legend() const;

private:
    vtkRenderer& renderer_;
    Aside<NormalNeedles> work_;
    std::map<ObjectId, vtkNew<vtkActor>> actors_;
    NormalNeedles about_; ///< without its meshes
    QColor colour_ = kDarkTheme.contact;
    double width_ = 1.5;
};

} // namespace tactum
