// The ground beneath the model: its shadow and a grid of millimetres. Private to this folder.
#pragma once

#include <optional>
#include <vector>

#include <vtkNew.h>
#include <vtkOpenGLActor.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include "ui/base/theme.h"
#include "ui/view/aside.h"
#include "ui/view/contact_shadow.h"
#include "ui/view/view_camera.h"

namespace tactum {

/// One textured square and lines, seen from above alone. Shadows are made aside; until then the ones from
/// before stay. There is no ground under a scene that is as good as flat and lies in it, and a grid
/// about the origin for an empty one. Thread: ui.
class GroundLayer {
public:
    explicit GroundLayer(vtkRenderer& renderer);

    void setTheme(const Theme& theme);
    /// The grid, and the shadow on it.
    void setShown(bool shown, bool shadow = true);
    /// What stands on it. Of what moves the shadow is left out until it `rests`.
    void setCasters(std::vector<ShadowCaster> casters, bool rest);
    bool pending() const { return work_.pending(); }
    /// Shows what was made since; true if anything was.
    bool takeFinished();
    /// The box of what a camera sees of it; empty: nothing, as from below, or in parallel from the side,
    /// where its lines would be one. World frame.
    Bounds bounds(const ViewCamera& camera) const;
    /// Between two lines that it sees, m; 0: there is none.
    double step(const ViewCamera& camera) const { return isSeen(camera) ? step_ : 0; }

private:
    struct Wish {
        std::vector<ShadowCaster> casters;
        bool standing = false;
        bool operator==(const Wish&) const = default;
    };
    /// Asked by each picture for itself: one that looks from below must not change what others show.
    class Sheet : public vtkOpenGLActor {
    public:
        static Sheet* New();
        vtkTypeMacro(Sheet, vtkOpenGLActor)

            int RenderTranslucentPolygonalGeometry(vtkViewport* viewport) override;
    };

    bool isSeen(const ViewCamera& camera) const;
    void start();
    void show();
    void showSheets();
    void layOut();
    void drawGrid();

    Aside<std::optional<GroundShadow>> work_;
    Wish wanted_;
    std::optional<Wish> started_;
    GroundShadow ground_;
    vtkNew<vtkPolyDataMapper> shadowMapper_, gridMapper_;
    vtkNew<Sheet> shadow_, grid_;
    const Theme* theme_ = nullptr;
    double step_ = 0;
    bool shown_ = true, shadowShown_ = true;
};

/// The power of ten of a metre that makes 4 to 40 lines of an extent, m.
double gridStep(double extent);

} // namespace tactum
