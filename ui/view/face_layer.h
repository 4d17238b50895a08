// The selected triangles, laid over the model. Private to this folder.
#pragma once

#include <memory>
#include <span>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include "core/geometry/triangle_soup.h"
#include "ui/base/theme.h"
#include "ui/view/model_mapper.h"

class vtkMatrix4x4;
class vtkRenderer;

namespace tactum {

/// Thread: ui. Some 20 ms for a million triangles.
class FaceLayer {
public:
    explicit FaceLayer(vtkRenderer& renderer);

    /// Null or no faces: nothing.
    void show(std::shared_ptr<const TriangleSoup> soup, std::span<const Index> faces);
    /// Where the object is; null: nowhere.
    void place(vtkMatrix4x4* matrix);
    bool any() const { return actor_->GetVisibility(); }
    void setTheme(const Theme& theme);

private:
    vtkNew<ModelMapper> mapper_;
    vtkNew<vtkActor> actor_;
    vtkNew<vtkPoints> points_; ///< of soup_
    std::shared_ptr<const TriangleSoup> soup_;
};

} // namespace tactum
