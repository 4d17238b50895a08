#include "ui/view/view_stage.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>

#include "ui/view/model_mapper.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr double kStageDegree = std::numbers::pi / 180;

void addLayer(vtkRenderWindow& window, vtkRenderer& renderer) {
    const int layer = window.GetRenderers()->GetNumberOfItems();
    window.SetNumberOfLayers(layer + 1);
    renderer.SetLayer(layer);
    window.AddRenderer(&renderer);
}

} // namespace

ViewCamera defaultCamera() {
    ViewCamera camera;
    camera.fieldOfView = 30 * kStageDegree;
    camera.yaw = 30 * kStageDegree;
    camera.pitch = 22 * kStageDegree;
    return camera;
}

ViewStage::ViewStage(vtkRenderWindow& window) : window_(window) {
    const std::initializer_list<vtkRenderer*> layers{solid, chosen, touch, outline_, ghost};
    for (vtkRenderer* renderer : layers)
        addLayer(window, *renderer);
    setCameras(1);
    lookThrough(0);
    chosen->setBeneath(*solid);
    for (vtkRenderer* renderer : {static_cast<vtkRenderer*>(chosen), touch.Get()})
        renderer->SetPreserveDepthBuffer(true); // the model hides what is behind it
    outline_->SetPass(outlinePass_);
    outline_->SetPreserveColorBuffer(false); // the mask starts empty; the picture beneath is not cleared
    outline_->SetBackgroundAlpha(0);
}

ViewStage::~ViewStage() {
    const std::initializer_list<vtkRenderer*> layers{ghost, outline_, touch, chosen, solid};
    for (vtkRenderer* renderer : layers)
        window_.RemoveRenderer(renderer);
}

void ViewStage::setBackground(const Theme& theme) {
    solid->GradientBackgroundOn();
    solid->SetBackground(theme.skyBottom.redF(), theme.skyBottom.greenF(), theme.skyBottom.blueF());
    solid->SetBackground2(theme.skyTop.redF(), theme.skyTop.greenF(), theme.skyTop.blueF());
    outlinePass_->setColour(theme.accent);
}

void ViewStage::forgetPicture() {
    solid->forget();
    chosen->forget();
    outlinePass_->forget();
}

void ViewStage::setOutlined(const Outlined& actors) {
    outline_->RemoveAllViewProps();
    Outlined copies;
    for (std::size_t i = 0; i < actors.size(); ++i)
        for (const vtkSmartPointer<vtkActor>& actor : actors[i]) {
            auto copy = vtkSmartPointer<vtkActor>::New();
            copy->SetMapper(actor->GetMapper());
            copy->SetUserMatrix(actor->GetUserMatrix());
            useNoLight(*copy);
            outline_->AddActor(copy);
            copies[i].push_back(copy);
        }
    outlinePass_->setOutlined(std::move(copies));
}

// The list of planes has a time of its own, which is the mappers' as well; that of a plane is not.
void ViewStage::setSection(const std::optional<SectionPlane>& plane) {
    section_->RemoveAllItems();
    if (!plane) return;
    const Vec3 kept = -plane->normal();
    plane_->SetOrigin(plane->frame.translation.data());
    plane_->SetNormal(kept.data());
    section_->AddItem(plane_);
}

void ViewStage::cutOpen(vtkRenderer& renderer) {
    vtkActorCollection* actors = renderer.GetActors();
    vtkCollectionSimpleIterator it;
    for (actors->InitTraversal(it); vtkActor* actor = actors->GetNextActor(it);)
        if (auto* mapper = ModelMapper::SafeDownCast(actor->GetMapper()))
            mapper->SetClippingPlanes(section_.Get());
}

void ViewStage::setCameras(std::size_t count) {
    for (std::size_t i = count; i < cameras_.size(); ++i) {
        solid->forget(*cameras_[i]);
        chosen->forget(*cameras_[i]);
        outlinePass_->forget(*cameras_[i], &window_);
    }
    if (count < cameras_.size()) lookThrough(0);
    const std::size_t before = cameras_.size();
    cameras_.resize(count);
    for (std::size_t i = before; i < count; ++i)
        cameras_[i] = vtkSmartPointer<vtkCamera>::New();
}

void ViewStage::lookThrough(std::size_t which) {
    for (vtkRenderer* renderer : std::initializer_list<vtkRenderer*>{solid, chosen, touch, outline_, ghost})
        renderer->SetActiveCamera(cameras_[which]);
}

void ViewStage::look(const ViewCamera& camera, const Bounds& shown, std::size_t which) {
    lookThrough(which);
    for (vtkRenderer* renderer :
         std::initializer_list<vtkRenderer*>{solid, chosen, touch, outline_}) // their layers may be new
        cutOpen(*renderer);
    aim(*solid->GetActiveCamera(), camera, shown);
}

void aim(vtkCamera& to, const ViewCamera& camera, const Bounds& shown) {
    to.SetFocalPoint(camera.focus.data());
    to.SetPosition(camera.eye().data());
    to.SetViewUp(camera.up().data());
    to.SetViewAngle(camera.fieldOfView / kStageDegree);
    to.SetParallelProjection(camera.parallel);
    to.SetParallelScale(std::tan(0.5 * camera.fieldOfView) * camera.distance);
    if (shown.empty()) return;
    const double middle = camera.depth(shown.centre()), reach = 0.6 * shown.diagonal() + 1e-6;
    const double far = std::max(middle + reach, 1e-6);
    to.SetClippingRange(std::max(middle - reach, 2e-3 * far), far);
}

} // namespace tactum
