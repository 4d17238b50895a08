// The ground beneath the model: its shadow and a grid of millimetres. Private to this folder.
#pragma once

#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include "ui/base/theme.h"
#include "ui/view/aside.h"
#include "ui/view/contact_shadow.h"

namespace tactum {

/// One textured square and lines, seen from above alone. Shadows are made aside; until then the ones from
/// before stay. There is no ground under a scene that is as good as flat and lies in it. Thread: ui.
class GroundLayer {
public:
    explicit GroundLayer(vtkRenderer& renderer);

    void setTheme(const Theme& theme);
    void setShown(bool shown) { shown_ = shown; }
    /// What stands on it. Of what moves the shadow is left out until it `rests`.
    void setCasters(std::vector<ShadowCaster> casters, bool rest);
    bool pending() const { return work_.pending(); }
    /// Shows what was made since; true if anything was.
    bool takeFinished();
    /// Before each picture: whether it is there for an eye at this place.
    void see(const Vec3& eye_W);
    /// The box of what is drawn; empty: nothing is. World frame.
    Bounds bounds() const;
    /// Between two lines, m; 0: there is none.
    double step() const { return seen_ ? step_ : 0; }

private:
    struct Wish {
        std::vector<ShadowCaster> casters;
        bool standing = false;
        bool operator==(const Wish&) const = default;
    };
    void start();
    void show();
    void drawGrid();

    Aside<std::optional<GroundShadow>> work_;
    Wish wanted_, started_;
    GroundShadow ground_;
    vtkNew<vtkPolyDataMapper> shadowMapper_, gridMapper_;
    vtkNew<vtkActor> shadow_, grid_;
    const Theme* theme_ = nullptr;
    double step_ = 0;
    bool shown_ = true, seen_ = false;
};

/// The power of ten of a metre that makes 4 to 40 lines of an extent, m.
double gridStep(double extent);

} // namespace tactum
