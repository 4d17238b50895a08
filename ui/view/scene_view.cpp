#include "ui/view/scene_view.h"

#include <cmath>
#include <numbers>

#include <QOpenGLPaintDevice>
#include <QPainter>

#include "ui/view/axes_gizmo.h"
#include "ui/view/scene_view_impl.h"
#include "ui/view/view_labels.h"

namespace tactum {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kOutlinePixels = 2.6;
// A hand that holds still trembles by less than this.
constexpr double kUnseenPixels = 0.1;

} // namespace

SceneView::Impl::Impl(SceneView& owner)
    : view(owner), stage(owner.renderWindow()), model(*stage.solid), overlay(*stage.solid, *stage.ghost),
      felt(stage, model), camera(defaultCamera()) {
    applyTheme();
}

void SceneView::Impl::applyTheme() {
    stage.setBackground(theme());
    overlay.setTheme(theme());
    felt.setTheme(theme());
}

void SceneView::Impl::refreshSelection() {
    stage.setOutlined(selection ? model.actorOf(*selection) : nullptr);
}

Bounds SceneView::Impl::shown() const {
    Bounds box = picker.bounds();
    if (const Bounds moving = model.movingBounds(); !moving.empty()) {
        box.add(moving.low);
        box.add(moving.high);
    }
    if (!touch) return box;
    const Vec3 reach = Vec3::Constant(4 * proxyRadius);
    for (const Vec3& p : {touch->finger, touch->proxy}) {
        box.add(p - reach);
        box.add(p + reach);
    }
    return box;
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
        const bool model = impl_->model.takeFinished(), felt = impl_->felt.takeFinished();
        if (model || felt) changed();
        if (!impl_->model.pending() && !impl_->felt.pending()) impl_->meshTimer.stop();
    });
}

// VTK's objects must go while the window and its context are still there.
SceneView::~SceneView() {
    makeCurrent();
    impl_.reset();
    doneCurrent();
}

void SceneView::setScene(const Scene& scene) {
    impl_->model.setScene(scene);
    impl_->refreshHover();
    impl_->picker.setScene(scene);
    impl_->spanning = spanningPoints(scene);
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
    const bool moved = impl_->model.moveTo(proxy.time);
    // Against what is shown, so that slow motion adds up until it is seen.
    const double unseen = kUnseenPixels * impl_->camera.pixelSize(next.proxy);
    if (!moved && impl_->touch && impl_->touch->looksLike(next, unseen)) return fadeOn();
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
    impl_->camera.fit(impl_->spanning);
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
        impl_->camera.fit(impl_->spanning);
        impl_->fitted = true;
    }
    impl_->stage.look(impl_->camera, impl_->shown());
    impl_->stage.setOutlineWidth(kOutlinePixels * devicePixelRatioF());
    if (impl_->touch) impl_->overlay.update(*impl_->touch, impl_->camera, impl_->proxyRadius);
    impl_->felt.update(impl_->showsTouch() ? &*impl_->touch : nullptr, impl_->camera, devicePixelRatioF());
}

// Into the framebuffer that is bound: a painter on the widget would miss the picture when a window is
// grabbed.
void SceneView::paintOver() {
    QOpenGLPaintDevice device((QSizeF(size()) * devicePixelRatioF()).toSize());
    device.setDevicePixelRatio(devicePixelRatioF());
    QPainter painter(&device);
    painter.setFont(font());
    drawAxes(painter, impl_->camera, impl_->theme());
    impl_->felt.drawLegends(painter, size(), impl_->theme());
    if (impl_->showsTouch()) drawTouchLabels(painter, *impl_->touch, impl_->camera, impl_->theme());
}

} // namespace tactum
