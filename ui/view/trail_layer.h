// Where the proxy was in the last seconds. Private to this folder.
#pragma once

#include <deque>
#include <span>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include "core/haptics/haptic_step.h"
#include "core/runtime/trace_point.h"
#include "ui/base/theme.h"

class vtkRenderer;

namespace tactum {

/// A line that fades: violet where the contact slipped, with yellow beads where it stuck, grey in free
/// motion. Thread: ui.
class TrailLayer {
public:
    static constexpr double kSpan = 4; ///< s

    TrailLayer(vtkRenderer& solid, vtkRenderer& ghost);
    ~TrailLayer();

    void setTheme(const Theme& theme) { theme_ = &theme; }
    void setVisible(bool visible);
    /// Points closer than this to the last are not kept. Unit: m.
    void setSpacing(double metres) { spacing_ = metres; }
    /// `touch` is of the last of the points.
    void add(std::span<const TracePoint> points, const HapticOutput& touch);
    void clear();
    /// Draws it as it is now; `ratio` of device to logical pixels.
    void update(double ratio);
    /// Whether there is something that still fades.
    bool fades() const { return visible_ && places_.size() > 1; }

private:
    enum class Kind { Free, Slip, Stick };
    struct Place {
        Vec3 at;
        double t;
        Kind kind;
        double rested = 0; ///< s, that it stuck here
    };

    vtkRenderer &solid_, &ghost_;
    const Theme* theme_ = &kDarkTheme;
    std::deque<Place> places_;
    vtkNew<vtkPolyData> data_;
    vtkNew<vtkPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_, dimmed_;
    double spacing_ = 1e-4;
    double now_ = 0; ///< s
    bool visible_ = false;
};

} // namespace tactum
