// The layers that every picture of a scene is made of, and the light they stand in. Private to this folder.
#pragma once

#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "core/geometry/triangle_soup.h"
#include "ui/base/theme.h"
#include "ui/view/kept_renderer.h"
#include "ui/view/outline_pass.h"
#include "ui/view/section_plane.h"
#include "ui/view/smoothed_renderer.h"
#include "ui/view/view_camera.h"

class vtkCamera;
class vtkRenderWindow;

namespace tactum {

/// Looks at the origin from the front, the right and above.
ViewCamera defaultCamera();

/// Sets VTK's camera, its clipping planes such that the box is held with as much depth as that allows.
void aim(vtkCamera& to, const ViewCamera& camera, const Bounds& shown);

/// Five renderers of a window, which look through one of several cameras in turn: the model and what is laid
/// over it, and what of it is selected, whose pictures are kept while they stay the same; what moves among it
/// when it is touched; outlines over both; and the dimmed copies of what may be inside it. Takes them out of
/// the window again. Thread: ui.
class ViewStage {
public:
    explicit ViewStage(vtkRenderWindow& window);
    ~ViewStage();
    ViewStage(const ViewStage&) = delete;
    ViewStage& operator=(const ViewStage&) = delete;

    /// The background and the outline's colour.
    void setBackground(const Theme& theme);
    void setOutlineWidth(double devicePixels) { outlinePass_->setWidth(float(devicePixels)); }
    /// The next picture is drawn as a whole.
    void forgetPicture();
    /// What a ModelMapper draws is cut open there; nothing: it is whole.
    void setSection(const std::optional<SectionPlane>& plane);
    /// Draws outlines around copies of these actors.
    void setOutlined(const Outlined& actors);
    /// How many cameras take turns, at first one. What is kept of those that go is given back; with the
    /// window's context current, if it has one.
    void setCameras(std::size_t count);
    /// All layers look through one of the cameras, which is aimed.
    void look(const ViewCamera& camera, const Bounds& shown, std::size_t which = 0);

    vtkNew<KeptRenderer> solid, chosen;
    vtkNew<vtkRenderer> touch;
    vtkNew<SmoothedRenderer> ghost;

private:
    void cutOpen(vtkRenderer& renderer);
    void lookThrough(std::size_t which);

    vtkRenderWindow& window_;
    std::vector<vtkSmartPointer<vtkCamera>> cameras_;
    vtkNew<vtkPlane> plane_;
    vtkNew<vtkPlaneCollection> section_; ///< empty: there is none
    vtkNew<vtkRenderer> outline_;
    vtkNew<OutlinePass> outlinePass_;
};

} // namespace tactum
