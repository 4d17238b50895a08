// What was painted on surfaces, laid over the model in colours. Private to this folder.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include "ui/view/felt_mesh.h"
#include "ui/view/painted_picture.h"

class vtkMatrix4x4;
class vtkRenderer;

namespace tactum {

/// Values are coloured like those of a colour map, and clear where nothing is painted. Thread: ui.
class PaintLayer {
public:
    explicit PaintLayer(vtkRenderer& renderer);
    ~PaintLayer();
    PaintLayer(const PaintLayer&) = delete;
    PaintLayer& operator=(const PaintLayer&) = delete;

    /// What stays of the shape is kept: of new values on the same surface nothing but the colours is made.
    void show(const PaintedPicture& picture);
    /// On what each surface lies, before each frame: where it is drawn in another shape, the paint has that
    /// too.
    void lieOn(const std::function<std::shared_ptr<const FeltMesh>(Index surface)>& shapeOf);
    /// Where the object is; null: nowhere.
    void place(vtkMatrix4x4* matrix);
    const PaintedPicture& picture() const { return picture_; }

private:
    struct Part;
    void showPart(std::size_t i, const PaintedPart& part, bool sameShape);

    vtkRenderer& renderer_;
    PaintedPicture picture_;
    vtkNew<vtkPoints> points_; ///< of the soup
    std::vector<std::unique_ptr<Part>> parts_;
};

} // namespace tactum
