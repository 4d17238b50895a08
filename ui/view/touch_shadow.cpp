#include "ui/view/touch_shadow.h"

#include <algorithm>
#include <cmath>

#include <vtkCellArray.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr int kAcross = 9;      ///< points from side to side
constexpr double kSoft = 2;     ///< radii of what casts, to where nothing of its shadow is left
constexpr double kFaint = 60;   ///< pixels, from which half of it is left
constexpr double kReach = 220;  ///< pixels, that it is looked for
constexpr double kSteepest = 3; ///< of a cell's side, that the light's way may change along it
constexpr double kLift = 0.6;   ///< pixels off the surface, which is drawn in the same depth

/// The plane across the light through the middle of what casts, and the rod as it is seen from the light.
struct LightFrame {
    LightFrame(const TouchCaster& caster, const Vec3& toLight) {
        const Vec3 rod = caster.rodRadius ? Vec3(caster.end - caster.middle) : Vec3::Zero();
        rise = rod.dot(toLight);
        const Vec3 flat = rod - rise * toLight;
        length = flat.norm();
        along = length > 0 ? Vec3(flat / length) : toLight.unitOrthogonal();
        across = toLight.cross(along);
    }
    /// The part of the rod's way at so far along it, 0 to 1.
    double part(double u) const { return length > 0 ? std::clamp(u / length, 0.0, 1.0) : 0; }

    Vec3 along, across;
    double length = 0, rise = 0; ///< m, of the rod: in the plane, and toward the light
};

/// 1 in the middle of what casts, 0 beyond its rim.
double within(double distance, double radius) {
    const double t = std::clamp(1 - distance / (kSoft * radius), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

double barred(const TouchCaster& caster, const LightFrame& frame, double u, double v) {
    const double ball = within(std::hypot(u, v), caster.radius);
    if (!caster.rodRadius) return ball;
    return std::max(ball, within(std::hypot(u - frame.length * frame.part(u), v), *caster.rodRadius));
}

/// What lies between it and the surface is seen.
class DepthlessMapper : public vtkOpenGLPolyDataMapper {
public:
    static DepthlessMapper* New();
    vtkTypeMacro(DepthlessMapper, vtkOpenGLPolyDataMapper)

        void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override {
        vtkOpenGLState& state = *static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow())->GetState();
        const vtkOpenGLState::ScopedglDepthMask kept(&state);
        state.vtkglDepthMask(GL_FALSE);
        Superclass::RenderPiece(renderer, actor);
    }
};
vtkStandardNewMacro(DepthlessMapper);

/// Lays a grid of the light's rays onto what they meet.
class Laying {
public:
    Laying(const TouchCaster& caster, const Vec3& toLight, double pixel, const Drop& drop)
        : caster_(caster), toLight_(toLight), frame_(caster, toLight), pixel_(pixel), drop_(drop) {
        const double rim = kSoft * std::max(caster.radius, caster.rodRadius.value_or(0));
        step_ = 2 * rim / (kAcross - 1);
        rim_ = rim;
        rows_ = kAcross + int(std::ceil(frame_.length / step_));
    }

    ShadowSheet sheet() {
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < kAcross; ++column)
                way_.push_back(lay(step_ * row - rim_, step_ * column - rim_));
        for (int row = 0; row + 1 < rows_; ++row)
            for (int column = 0; column + 1 < kAcross; ++column)
                join({index(row, column), index(row, column + 1), index(row + 1, column + 1),
                      index(row + 1, column)});
        for (const int corner : torn_)
            sheet_.dark[std::size_t(corner)] = 0; // it ends softly, and not in the teeth of cells
        return std::move(sheet_);
    }

private:
    static int index(int row, int column) { return row * kAcross + column; }

    /// The way of the light from what casts to what it falls on; nothing: no shadow is there. It starts a rim
    /// before, for part of the plane may lie inside the model.
    std::optional<double> lay(double u, double v) {
        const double bar = barred(caster_, frame_, u, v), height = frame_.rise * frame_.part(u);
        const Vec3 start = caster_.middle + u * frame_.along + v * frame_.across + (height + rim_) * toLight_;
        sheet_.points.push_back(start);
        sheet_.dark.push_back(0);
        const auto met = drop_({start, -toLight_}, rim_ + kReach * pixel_);
        if (!met) return std::nullopt;
        const double far = std::max(0.0, *met - rim_) / (kFaint * pixel_);
        sheet_.points.back() = start - *met * toLight_;
        sheet_.dark.back() = ShadowSheet::kDarkest * bar / (1 + far * far);
        return *met - height;
    }

    void join(const std::array<int, 4>& corners) {
        double least = HUGE_VAL, most = -HUGE_VAL, dark = 0;
        for (const int corner : corners) {
            const auto& way = way_[std::size_t(corner)];
            if (!way) return tear(corners);
            least = std::min(least, *way);
            most = std::max(most, *way);
            dark = std::max(dark, sheet_.dark[std::size_t(corner)]);
        }
        if (most - least > kSteepest * step_) return tear(corners);
        if (dark > 0) sheet_.cells.push_back(corners);
    }

    void tear(const std::array<int, 4>& corners) {
        torn_.insert(torn_.end(), corners.begin(), corners.end());
    }

    const TouchCaster& caster_;
    const Vec3 toLight_;
    const LightFrame frame_;
    const double pixel_;
    const Drop& drop_;
    double step_ = 0, rim_ = 0;
    int rows_ = 0;
    ShadowSheet sheet_;
    std::vector<std::optional<double>> way_;
    std::vector<int> torn_; ///< corners of cells that are not there
};

} // namespace

ShadowSheet shadowSheet(const TouchCaster& caster, const Vec3& toLight, double pixel, const Drop& drop) {
    return Laying(caster, toLight, pixel, drop).sheet();
}

TouchShadow::TouchShadow(vtkRenderer& renderer) : renderer_(renderer) {
    vtkNew<DepthlessMapper> mapper;
    mapper->SetInputData(sheet_);
    mapper->SetColorModeToDirectScalars();
    actor_->SetMapper(mapper);
    actor_->ForceOpaqueOn(); // blended in its place, before all that it lies under
    useNoLight(*actor_);
    hide();
    renderer_.AddActor(actor_);
}

TouchShadow::~TouchShadow() {
    renderer_.RemoveActor(actor_);
}

void TouchShadow::place(const TouchCaster& caster, const ViewCamera& camera, double pixel, const Drop& drop) {
    const ShadowSheet sheet = shadowSheet(caster, towardKeyLight(camera), pixel, drop);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(4);
    for (std::size_t i = 0; i < sheet.points.size(); ++i) {
        const Vec3 p = sheet.points[i] + kLift * pixel * (camera.eye() - sheet.points[i]).normalized();
        points->InsertNextPoint(p.data());
        colours->InsertNextTuple4(0, 0, 0, std::lround(255 * sheet.dark[i]));
    }
    vtkNew<vtkCellArray> cells;
    for (const auto& cell : sheet.cells) {
        cells->InsertNextCell(4);
        for (const int corner : cell)
            cells->InsertCellPoint(corner);
    }
    sheet_->SetPoints(points);
    sheet_->SetPolys(cells);
    sheet_->GetPointData()->SetScalars(colours);
    sheet_->Modified();
    actor_->SetVisibility(!sheet.cells.empty());
}

} // namespace tactum
