#include "ui/view/ground_layer.h"

#include <cmath>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include "ui/view/studio_light.h"

namespace tactum {

vtkStandardNewMacro(GroundLayer::Sheet);

namespace {

/// A scene lower than this part of its width is a plate in the ground.
constexpr double kFlat = 0.03;
constexpr double kEmptySide = 0.2; ///< m: of the ground of an empty scene, as large as what is built by hand
constexpr double kReach = 1.1;     ///< of the grid about its middle, in sides of the shadow's square
constexpr double kSlant = 1e-3;    ///< of parallel rays: less is from the side
constexpr int kPieces = 24;        ///< of a line, between which it fades
constexpr double kLine = 26, kTenthLine = 60; ///< opacity in the middle, of 255

/// Where there is nothing yet, about the origin.
GroundShadow emptyGround() {
    GroundShadow ground;
    ground.side = kEmptySide;
    ground.corner = {-0.5 * kEmptySide, 0, -0.5 * kEmptySide};
    return ground;
}

vtkSmartPointer<vtkTexture> textureOf(const GroundShadow& ground) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(ground.texels, ground.texels, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
    for (const std::uint8_t dark : ground.dark) {
        std::fill_n(texel, 3, static_cast<unsigned char>(0));
        texel[3] = dark;
        texel += 4;
    }
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(image);
    texture->InterpolateOn();
    texture->SetColorModeToDirectScalars();
    return texture;
}

vtkSmartPointer<vtkPolyData> squareOf(const GroundShadow& ground) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> places;
    places->SetNumberOfComponents(2);
    for (const auto& [u, v] : {std::pair{0, 0}, {0, 1}, {1, 1}, {1, 0}}) {
        points->InsertNextPoint(ground.corner.x() + u * ground.side, ground.corner.y(),
                                ground.corner.z() + v * ground.side);
        places->InsertNextTuple2(u, v);
    }
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell({0, 1, 2, 3});
    auto square = vtkSmartPointer<vtkPolyData>::New();
    square->SetPoints(points);
    square->SetPolys(cells);
    square->GetPointData()->SetTCoords(places);
    return square;
}

/// Lines along x and z through whole steps of the world, which fade away from the middle.
class GridLines {
public:
    GridLines(const Vec3& middle, double reach, const QColor& colour)
        : middle_(middle), reach_(reach), colour_(colour) {
        colours_->SetNumberOfComponents(4);
    }

    void add(double step) {
        for (int across = 0; across < 2; ++across) {
            const double centre = middle_[across == 0 ? 0 : 2];
            const auto first = std::llround(std::ceil((centre - reach_) / step));
            for (long long i = first; double(i) * step <= centre + reach_; ++i)
                addLine(across == 0, double(i) * step, i % 10 == 0 ? kTenthLine : kLine);
        }
    }

    vtkSmartPointer<vtkPolyData> take() {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        data->SetLines(cells_);
        data->GetPointData()->SetScalars(colours_);
        return data;
    }

private:
    void addLine(bool alongZ, double at, double opacity) {
        const double aside = at - middle_[alongZ ? 0 : 2];
        const double half = std::sqrt(std::max(0.0, reach_ * reach_ - aside * aside));
        cells_->InsertNextCell(kPieces + 1);
        for (int i = 0; i <= kPieces; ++i) {
            const double along = half * (2.0 * i / kPieces - 1);
            const Vec3 p = middle_ + (alongZ ? Vec3(aside, 0, along) : Vec3(along, 0, aside));
            cells_->InsertCellPoint(points_->InsertNextPoint(p.data()));
            const double far = (aside * aside + along * along) / (reach_ * reach_);
            colours_->InsertNextTuple4(colour_.red(), colour_.green(), colour_.blue(),
                                       opacity * std::pow(std::max(0.0, 1 - far), 2));
        }
    }

    Vec3 middle_;
    double reach_;
    QColor colour_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> cells_;
    vtkNew<vtkUnsignedCharArray> colours_;
};

/// By an eye so high over it, m, that looks down by so much.
bool isSeenFrom(double over, double down, bool parallel) {
    return over > 0 && (!parallel || down > kSlant);
}

void lieOnTheGround(vtkActor& actor, vtkPolyDataMapper& mapper, vtkRenderer& renderer) {
    actor.SetMapper(&mapper);
    actor.PickableOff();
    actor.ForceTranslucentOn(); // writes no depth: the finger is seen beneath it
    useNoLight(actor);
    actor.VisibilityOff();
    renderer.AddActor(&actor);
}

} // namespace

double gridStep(double extent) {
    return std::pow(10.0, std::floor(std::log10(0.25 * extent)));
}

GroundLayer::GroundLayer(vtkRenderer& renderer) {
    lieOnTheGround(*shadow_, *shadowMapper_, renderer);
    lieOnTheGround(*grid_, *gridMapper_, renderer);
}

void GroundLayer::setTheme(const Theme& theme) {
    theme_ = &theme;
    if (step_ > 0) drawGrid();
}

void GroundLayer::setCasters(std::vector<ShadowCaster> casters, bool rest) {
    wanted_ = {std::move(casters), !rest};
    if (!work_.pending()) start();
}

void GroundLayer::start() {
    if (wanted_ == started_) return;
    started_ = wanted_;
    work_.start([wish = wanted_](const Progress& progress) {
        return shadowOf(wish.casters, wish.standing, progress);
    });
}

bool GroundLayer::takeFinished() {
    const auto made = work_.take();
    if (!made) return false;
    if (*made) ground_ = std::move(**made);
    show();
    start();
    return true;
}

void GroundLayer::show() {
    const Bounds& box = ground_.casters;
    if (box.empty()) ground_ = emptyGround();
    const bool flat = !box.empty() && box.high.y() - box.low.y() <= kFlat * ground_.side;
    step_ = flat ? 0 : gridStep(ground_.side);
    if (step_ > 0) layOut();
    showSheets();
}

void GroundLayer::layOut() {
    drawGrid();
    if (ground_.texels == 0) return;
    shadowMapper_->SetInputData(squareOf(ground_));
    shadow_->SetTexture(textureOf(ground_));
}

void GroundLayer::drawGrid() {
    const Vec3 middle = ground_.corner + Vec3(0.5 * ground_.side, 0, 0.5 * ground_.side);
    GridLines lines(middle, kReach * ground_.side, theme_->text);
    lines.add(step_);
    gridMapper_->SetInputData(lines.take());
}

void GroundLayer::setShown(bool shown, bool shadow) {
    shown_ = shown;
    shadowShown_ = shadow;
    showSheets();
}

void GroundLayer::showSheets() {
    grid_->SetVisibility(shown_ && step_ > 0);
    shadow_->SetVisibility(grid_->GetVisibility() && shadowShown_ && ground_.texels > 0);
}

int GroundLayer::Sheet::RenderTranslucentPolygonalGeometry(vtkViewport* viewport) {
    auto& camera = *vtkRenderer::SafeDownCast(viewport)->GetActiveCamera();
    const double down = -camera.GetDirectionOfProjection()[1],
                 over = camera.GetPosition()[1] - GetBounds()[2];
    if (!isSeenFrom(over, down, camera.GetParallelProjection())) return 0;
    return Superclass::RenderTranslucentPolygonalGeometry(viewport);
}

bool GroundLayer::isSeen(const ViewCamera& camera) const {
    const double over = camera.eye().y() - ground_.corner.y();
    return shown_ && step_ > 0 && isSeenFrom(over, -camera.forward().y(), camera.parallel);
}

Bounds GroundLayer::bounds(const ViewCamera& camera) const {
    Bounds box;
    if (!isSeen(camera)) return box;
    const Vec3 middle = ground_.corner + Vec3(0.5 * ground_.side, 0, 0.5 * ground_.side);
    const Vec3 reach = kReach * ground_.side * Vec3(1, 0, 1);
    box.add(middle - reach);
    box.add(middle + reach);
    return box;
}

} // namespace tactum
