#include "ui/view/trail_layer.h"

#include <algorithm>
#include <array>

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr double kLine = 2.5, kBead = 8; // logical pixels
constexpr double kBeadTime = 0.08;       // s at one place are a bead
constexpr double kGap = 0.1;             // s without a tick, or a jump, part the line
constexpr std::size_t kMaxPlaces = 4000;

} // namespace

TrailLayer::TrailLayer(vtkRenderer& solid, vtkRenderer& ghost) : solid_(solid), ghost_(ghost) {
    mapper_->SetInputData(data_);
    mapper_->SetScalarModeToUsePointData();
    for (vtkActor* actor : {actor_.Get(), dimmed_.Get()}) {
        actor->SetMapper(mapper_);
        actor->ForceOpaqueOn(); // blended in place, as the rest of the touch
        actor->PickableOff();
        useNoLight(*actor);
        actor->GetProperty()->RenderPointsAsSpheresOn();
    }
    dimmed_->GetProperty()->SetOpacity(0.35);
    solid_.AddActor(actor_);
    ghost_.AddActor(dimmed_);
    setVisible(false);
}

TrailLayer::~TrailLayer() {
    solid_.RemoveActor(actor_);
    ghost_.RemoveActor(dimmed_);
}

void TrailLayer::setVisible(bool visible) {
    visible_ = visible;
    actor_->SetVisibility(visible);
    dimmed_->SetVisibility(visible);
    if (!visible) clear();
}

void TrailLayer::clear() {
    places_.clear();
}

void TrailLayer::add(std::span<const TracePoint> points, const HapticOutput& touch) {
    if (!visible_) return;
    bool slips = false, rubs = false;
    for (int i = 0; i < std::clamp(touch.contacts, 0, kMaxModelPlanes); ++i) {
        const ContactReport& contact = touch.contact[std::size_t(i)];
        slips = slips || contact.slipping || contact.frictionless;
        rubs = rubs || !contact.frictionless;
    }
    for (const TracePoint& point : points) {
        now_ = point.t;
        const Kind kind = !point.touching ? Kind::Free : slips || !rubs ? Kind::Slip : Kind::Stick;
        if (!places_.empty()) {
            Place& last = places_.back();
            if (point.t < last.t || point.t - last.t - last.rested > kGap) places_.clear();
        }
        if (!places_.empty() && (places_.back().at - point.proxy).norm() < spacing_) {
            places_.back().rested = point.t - places_.back().t;
            if (kind == Kind::Stick) places_.back().kind = kind;
            continue;
        }
        places_.push_back({point.proxy, point.t, kind});
    }
    while (!places_.empty() &&
           (places_.size() > kMaxPlaces || now_ - places_.front().t - places_.front().rested > kSpan))
        places_.pop_front();
}

void TrailLayer::update(double ratio) {
    if (!visible_) return;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkUnsignedCharArray> colours;
    colours->SetNumberOfComponents(4);
    const auto put = [&](const Place& place, const QColor& colour) {
        const double fade = std::clamp(1 - (now_ - place.t - place.rested) / kSpan, 0.0, 1.0);
        const std::array<unsigned char, 4> rgba{(unsigned char)(colour.red()),
                                                (unsigned char)(colour.green()),
                                                (unsigned char)(colour.blue()), (unsigned char)(255 * fade)};
        colours->InsertNextTypedTuple(rgba.data());
        return points->InsertNextPoint(place.at.data());
    };
    vtkNew<vtkCellArray> path, beads;
    if (places_.size() > 1) path->InsertNextCell(int(places_.size()));
    for (const Place& place : places_) {
        const vtkIdType at = put(place, place.kind == Kind::Free ? theme_->textDimmed : theme_->slip);
        if (places_.size() > 1) path->InsertCellPoint(at);
    }
    // A bead has a point of its own: colours belong to points.
    for (const Place& place : places_) {
        if (place.kind != Kind::Stick || place.rested < kBeadTime) continue;
        const vtkIdType at = put(place, theme_->stick);
        beads->InsertNextCell(1, &at);
    }
    data_->Initialize();
    data_->SetPoints(points);
    data_->SetLines(path);
    data_->SetVerts(beads);
    data_->GetPointData()->SetScalars(colours);
    for (vtkActor* actor : {actor_.Get(), dimmed_.Get()}) {
        actor->GetProperty()->SetLineWidth(float(kLine * ratio));
        actor->GetProperty()->SetPointSize(float(kBead * ratio));
    }
}

} // namespace tactum
