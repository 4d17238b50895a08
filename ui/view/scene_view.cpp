#include "ui/view/scene_view.h"

#include <cmath>
#include <numbers>

#include <QPainter>

#include <vtkRenderWindow.h>
#include <vtkRendererCollection.h>

#include "ui/view/axes_gizmo.h"
#include "ui/view/scene_view_impl.h"
#include "ui/view/studio_light.h"
#include "ui/view/view_labels.h"
#include "ui/view/vtk_camera.h"

namespace tactum {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kOutlinePixels = 2.6;

void addLayer(vtkRenderWindow& window, vtkRenderer& renderer, vtkCamera* camera) {
    const int layer = window.GetRenderers()->GetNumberOfItems();
    window.SetNumberOfLayers(layer + 1);
    renderer.SetLayer(layer);
    renderer.SetActiveCamera(camera);
    window.AddRenderer(&renderer);
}

void setBackground(vtkRenderer& renderer, const Theme& theme) {
    renderer.GradientBackgroundOn();
    renderer.SetBackground(theme.skyBottom.redF(), theme.skyBottom.greenF(), theme.skyBottom.blueF());
    renderer.SetBackground2(theme.skyTop.redF(), theme.skyTop.greenF(), theme.skyTop.blueF());
}

} // namespace

SceneView::Impl::Impl(SceneView& owner) : view(owner), model(*solid), overlay(*solid, *ghost) {
    vtkNew<vtkCamera> shared;
    for (vtkRenderer* renderer : {solid.Get(), outline.Get(), ghost.Get()})
        addLayer(view.renderWindow(), *renderer, shared);
    outline->SetPass(outlinePass);
    outline->SetPreserveColorBuffer(false); // the mask starts empty; the picture beneath is not cleared
    outline->SetBackgroundAlpha(0);
    camera.fieldOfView = 30 * kDegree;
    camera.yaw = 30 * kDegree;
    camera.pitch = 22 * kDegree;
    applyTheme();
}

void SceneView::Impl::applyTheme() {
    setBackground(*solid, theme());
    outlinePass->setColour(theme().accent);
    overlay.setTheme(theme());
}

/// Holds all that is shown, with as much depth resolution as that allows.
void SceneView::Impl::setClippingRange() {
    Bounds box = picker.bounds();
    if (touch) box.add(touch->finger);
    if (touch) box.add(touch->proxy);
    if (box.empty()) return;
    const double middle = camera.depth(box.centre()), reach = 0.6 * box.diagonal() + 4 * proxyRadius;
    const double far = std::max(middle + reach, 1e-6);
    solid->GetActiveCamera()->SetClippingRange(std::max(middle - reach, 2e-3 * far), far);
}

void SceneView::Impl::refreshSelection() {
    vtkActor* actor = selection ? model.actorOf(*selection) : nullptr;
    outline->RemoveAllViewProps();
    outlined = nullptr;
    if (!actor) return;
    vtkNew<vtkActor> copy;
    copy->SetMapper(actor->GetMapper());
    copy->SetUserMatrix(actor->GetUserMatrix());
    useNoLight(*copy);
    outline->AddActor(copy);
    outlined = actor;
}

SceneView::SceneView(QWidget* parent) : VtkWidget(parent), impl_(std::make_unique<Impl>(*this)) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    impl_->glideTimer.setInterval(8);
    connect(&impl_->glideTimer, &QTimer::timeout, this, [this] {
        if (!impl_->hand.advance(1e-3 * double(impl_->glideClock.restart()))) return impl_->glideTimer.stop();
        impl_->goalMoved();
    });
    impl_->meshTimer.setInterval(50);
    connect(&impl_->meshTimer, &QTimer::timeout, this, [this] {
        if (impl_->model.takeFinished()) changed();
        if (!impl_->model.pending()) impl_->meshTimer.stop();
    });
}

// VTK's objects must go while the window and its context are still there.
SceneView::~SceneView() {
    makeCurrent();
    for (vtkRenderer* renderer : {impl_->ghost.Get(), impl_->outline.Get(), impl_->solid.Get()})
        renderWindow().RemoveRenderer(renderer);
    impl_.reset();
    doneCurrent();
}

void SceneView::setScene(const Scene& scene) {
    impl_->setHovered(std::nullopt);
    impl_->model.setScene(scene);
    impl_->picker.setScene(scene);
    impl_->hand.setSceneSize(impl_->picker.bounds().diagonal());
    if (impl_->model.pending()) impl_->meshTimer.start();
    impl_->refreshSelection();
    setProxyRadius(scene.proxyRadius);
    if (!impl_->fitted && impl_->picker.bounds().diagonal() > 0) fit();
    changed();
}

void SceneView::setSelection(std::optional<SurfaceRef> surface) {
    impl_->selection = surface;
    impl_->refreshSelection();
    changed();
}

void SceneView::setTool(ViewTool tool) {
    impl_->letGo();
    impl_->tool = tool;
}

void SceneView::setHaptics(const ProxyTelemetry& proxy, const ServoTelemetry& servo, double forceLimit,
                           bool armed) {
    const TouchState next = touchState(proxy, servo, forceLimit, armed);
    if (impl_->touch && impl_->touch->sameAs(next)) return;
    impl_->touch = next;
    impl_->overlay.setVisible(impl_->showsTouch());
    changed();
}

void SceneView::setProxyRadius(double metres) {
    impl_->proxyRadius = metres;
    changed();
}

void SceneView::fit() {
    impl_->camera.size = size();
    impl_->camera.fit(impl_->picker.bounds());
    impl_->fitted = isVisible() && impl_->picker.bounds().diagonal() > 0; // else again once the size is known
    changed();
}

void SceneView::showStandardView(StandardView standard) {
    struct Angles {
        double yaw, pitch;
    };
    static constexpr std::array<Angles, 4> kAngles{{{0, 0}, {90, 0}, {0, 90}, {45, 35.264}}};
    const Angles& angles = kAngles[std::size_t(standard)];
    impl_->camera.yaw = angles.yaw * kDegree;
    impl_->camera.pitch = angles.pitch * kDegree;
    fit();
}

void SceneView::setOverlayVisible(bool visible) {
    impl_->overlayVisible = visible;
    impl_->overlay.setVisible(impl_->showsTouch());
    changed();
}

void SceneView::setTheme(bool dark) {
    impl_->dark = dark;
    impl_->applyTheme();
    changed();
}

Vec3 SceneView::handGoal() const {
    return impl_->hand.goal();
}

void SceneView::setHandGoal(const Vec3& p_W) {
    impl_->hand.setGoal(p_W);
}

QImage SceneView::grabPicture() {
    return grabSmooth();
}

void SceneView::prepareFrame() {
    impl_->camera.size = size();
    if (!impl_->fitted && impl_->picker.bounds().diagonal() > 0) {
        impl_->camera.fit(impl_->picker.bounds());
        impl_->fitted = true;
    }
    applyCamera(impl_->camera, *impl_->solid->GetActiveCamera());
    impl_->setClippingRange();
    impl_->outlinePass->setWidth(float(kOutlinePixels * devicePixelRatioF()));
    if (impl_->touch) impl_->overlay.update(*impl_->touch, impl_->camera, impl_->proxyRadius);
}

void SceneView::paintOver() {
    QPainter painter(this);
    painter.setFont(font());
    drawAxes(painter, impl_->camera, impl_->theme());
    if (impl_->showsTouch()) drawTouchLabels(painter, *impl_->touch, impl_->camera, impl_->theme());
}

} // namespace tactum
