// What the finger, and the pen that is drawn at it, cast onto the model. Private to this folder.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include "ui/view/view_camera.h"

class vtkRenderer;

namespace tactum {

/// What casts: a ball, and from its middle a rod. World frame, m.
struct TouchCaster {
    Vec3 middle = Vec3::Zero();
    double radius = 0;                    ///< of the ball
    Vec3 end = Vec3::Zero();              ///< of the rod
    std::optional<double> rodRadius = {}; ///< nothing: there is no rod
};

/// Where a ray meets something within `reach`, m: the distance, m; nothing: there it is clear.
using Drop = std::function<std::optional<double>(const Ray& ray, double reach)>;

/// A shadow as a sheet that lies on what it falls on.
struct ShadowSheet {
    std::vector<Vec3> points;
    std::vector<double> dark; ///< of each point, 0 (no shadow) to kDarkest
    std::vector<std::array<int, 4>> cells;

    static constexpr double kDarkest = 0.55;
};

/// Dark where the light's way is barred, softer and fainter the farther it falls. There is no cell that would
/// bridge a step. `toLight`: of unit length; `pixel`: m. Thread: any that `drop` may be called on.
ShadowSheet shadowSheet(const TouchCaster& caster, const Vec3& toLight, double pixel, const Drop& drop);

/// Draws one. Thread: ui.
class TouchShadow {
public:
    explicit TouchShadow(vtkRenderer& renderer);
    ~TouchShadow();

    /// From the view's key light.
    void place(const TouchCaster& caster, const ViewCamera& camera, double pixel, const Drop& drop);
    void hide() { actor_->SetVisibility(false); }

private:
    vtkRenderer& renderer_;
    vtkNew<vtkPolyData> sheet_;
    vtkNew<vtkActor> actor_;
};

} // namespace tactum
