#include "ui/view/scene_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ui/view/gl_window.h"
#include "ui/view/scene_view_impl.h"

namespace tactum {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kOutlinePixels = 2.6;
// Diagonals of the scene: what forces have moved farther than this is not drawn.
constexpr double kFarthestMoved = 10;
constexpr double kSectionRim = 0.36; // of the scene's diagonal: as wide as most scenes, seen at the home view
constexpr double kRoomAbout = 0.1;   // of the model's diagonal
constexpr int kMostDoublings = 12;   // what is 400 diagonals away may be cut off

/// The box with room about it until it holds the other one. In coarse steps, for the planes that clip the
/// picture follow it, and the model is drawn anew whenever they move.
Bounds grownAround(const Bounds& box, const Bounds& inside) {
    Vec3 room = Vec3::Constant(kRoomAbout * box.diagonal());
    const auto holds = [&] {
        return ((box.low - room).array() <= inside.low.array()).all() &&
               ((box.high + room).array() >= inside.high.array()).all();
    };
    for (int i = 0; i < kMostDoublings && !holds(); ++i)
        room *= 2;
    return {box.low - room, box.high + room};
}

std::size_t trianglesOf(const Scene& scene) {
    std::size_t count = 0;
    for (const SceneObject& object : scene.objects)
        count += object.geometry->triangles.size();
    return count;
}

} // namespace

SceneView::Impl::Impl(SceneView& owner)
    : view(owner), stage(owner.renderWindow()), occlusion(owner.renderWindow()), ground(*stage.solid),
      model(*stage.solid), boundaries(*stage.solid), faces(*stage.chosen), brushed(*stage.touch),
      paint(*stage.solid), marks(*stage.solid, *stage.ghost), overlay(*stage.touch, *stage.ghost),
      felt(stage, model) {
    applyTheme();
}

void SceneView::Impl::applyTheme() {
    stage.setBackground(theme());
    ground.setTheme(theme());
    boundaries.setTheme(theme());
    overlay.setTheme(theme(), mark.number);
    for (Beside& other : beside)
        other.overlay->setTheme(theme(), other.mark.number);
    if (loupe) loupe->picture.marks().setTheme(theme(), mark.number);
    faces.setTheme(theme());
    brushed.setTheme(theme());
    marks.setColour(theme().fault);
    felt.setTheme(theme());
}

void SceneView::Impl::refreshSelection() {
    stage.setOutlined(model.outlinesOf(selection));
}

PictureQuality SceneView::atRest() const {
    return impl_->stage.solid->budget().atRest(impl_->panes.shown().size());
}

void SceneView::setPictureLimits(const PictureLimits& limits) {
    impl_->stage.solid->budget().setLimits(limits);
    changed();
}

bool SceneView::makesMeshes() const {
    return impl_->model.pending() || impl_->boundaries.pending();
}

bool SceneView::drawsCoarse() const {
    return renderWindow().drawsCoarse();
}

// What is laid over triangles would lie beside coarser ones.
Coarse SceneView::Impl::coarseInMotion() const {
    const PictureBudget& budget = stage.solid->budget();
    if (budget.affordsMotion(panes.shown().size())) return Coarse::None;
    const bool bare = !faces.any() && paint.picture().parts.empty() && !marks.any();
    if (bare && budget.affordedSide(panes.shown().size()) < 1) return Coarse::Pixels;
    if (bare && model.hasCoarse()) return Coarse::Meshes;
    return budget.known() && model.hasRelief() ? Coarse::Relief : Coarse::None;
}

void SceneView::Impl::spareTime(PictureQuality quality) {
    PictureBudget& budget = stage.solid->budget();
    const bool smoothed = quality == PictureQuality::Smoothed;
    stage.ghost->setSmoothed(smoothed);
    if (smoothed && !budget.known()) stage.solid->forget(); // to see what it takes
}

double SceneView::Impl::extent() const {
    constexpr double kOfNothing = 0.2, kLeast = 1e-6; // m: that of the grid on empty ground
    return picker.bounds().empty() ? kOfNothing : std::max(picker.bounds().diagonal(), kLeast);
}

Bounds SceneView::Impl::shownTo(const ViewCamera& camera) const {
    Bounds box = picker.bounds();
    if (const Bounds below = ground.bounds(camera); !below.empty()) {
        box.add(below.low);
        box.add(below.high);
    }
    if (const Bounds moving = model.movingBounds(); !moving.empty() && !box.empty()) {
        // What has fallen farther takes none of the depth that the rest is drawn with.
        const Vec3 most = Vec3::Constant(kFarthestMoved * box.diagonal());
        const Vec3 low = box.low - most, high = box.high + most;
        box.add(moving.low.cwiseMax(low).cwiseMin(high));
        box.add(moving.high.cwiseMin(high).cwiseMax(low));
    }
    if (!touch) return box;
    Bounds about;
    const Vec3 reach = Vec3::Constant(4 * proxyRadius);
    const auto addTouch = [&](const TouchState& state) {
        for (const Vec3& p : {state.finger, state.proxy}) {
            about.add(p - reach);
            about.add(p + reach);
        }
        if (!(state.shell > 0)) return;
        about.add(state.centre - Vec3::Constant(state.shell));
        about.add(state.centre + Vec3::Constant(state.shell));
    };
    addTouch(*touch);
    for (const Beside& other : beside)
        addTouch(other.touch);
    return box.empty() ? about : grownAround(box, about);
}

SceneView::SceneView(QWidget* parent) : VtkWidget(parent), impl_(std::make_unique<Impl>(*this)) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(160, 120);
    impl_->glideTimer.setInterval(8);
    connect(&impl_->glideTimer, &QTimer::timeout, this, [this] { impl_->glide(); });
    impl_->flight.setDuration(350);
    impl_->flight.setStartValue(0.0);
    impl_->flight.setEndValue(1.0);
    impl_->flight.setEasingCurve(QEasingCurve::InOutCubic);
    connect(&impl_->flight, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& part) { impl_->fly(part.toDouble()); });
    impl_->meshTimer.setInterval(50);
    connect(&impl_->meshTimer, &QTimer::timeout, this, [this] {
        const bool model = impl_->model.takeFinished(), felt = impl_->felt.takeFinished(),
                   ground = impl_->ground.takeFinished(), lines = impl_->boundaries.takeFinished(),
                   occlusion = impl_->occlusion.takeFinished();
        if (occlusion) impl_->stage.forgetPicture();
        if (model || felt || ground || lines || occlusion) changed();
        if (!makesMeshes() && !makesFelt()) impl_->meshTimer.stop();
    });
    impl_->shadowTimer.setSingleShot(true);
    impl_->shadowTimer.setInterval(300); // from the last movement of a body on
    connect(&impl_->shadowTimer, &QTimer::timeout, this, [this] { impl_->castShadows(true); });
}

// VTK's objects must go while the window and its context are still there.
SceneView::~SceneView() {
    makeCurrent();
    impl_.reset();
    doneCurrent();
}

void SceneView::setScene(const Scene& scene) {
    impl_->model.setScene(scene);
    impl_->boundaries.setScene(scene);
    if (std::exchange(impl_->triangles, trianglesOf(scene)) != trianglesOf(scene))
        impl_->stage.solid->budget().forget();
    impl_->refreshHover();
    impl_->picker.setScene(scene);
    impl_->weedMeasure();
    setCasters(scene);
    impl_->panes.setSpanning(spanningPoints(scene));
    impl_->hand.setSceneSize(impl_->picker.bounds().diagonal());
    impl_->sectionHandles.setReach(kSectionRim * impl_->picker.bounds().diagonal());
    if (makesMeshes()) impl_->meshTimer.start();
    impl_->refreshSelection();
    setProxyRadius(scene.proxyRadius);
    if (!impl_->pane().fitted && impl_->picker.bounds().diagonal() > 0) fitAll();
    changed();
}

void SceneView::setLooks(const Scene& scene) {
    if (impl_->model.setLooks(scene)) changed();
}

void SceneView::setSelection(std::vector<SurfaceRef> surfaces) {
    impl_->selection = std::move(surfaces);
    impl_->refreshSelection();
    changed();
}

void SceneView::setSelectedFaces(ObjectId object, std::vector<Index> faces) {
    impl_->facesOf = object;
    impl_->faces.show(impl_->picker.soupOf(object), faces);
    changed();
}

void SceneView::setBrushedFaces(ObjectId object, const std::vector<Index>& faces) {
    impl_->brushedOf = object;
    impl_->brushed.show(impl_->picker.soupOf(object), faces);
    changed();
}

void SceneView::beginRegion(RegionShape shape) {
    impl_->letGo();
    impl_->regionNext = shape;
    setCursor(Qt::CrossCursor);
}

void SceneView::setSelectBrush(std::optional<double> radius) {
    if (!radius && impl_->drag == ViewDrag::Brush) impl_->endStroke(StrokeStep::Cancel);
    impl_->selectBrush = radius;
    changed();
}

void SceneView::setTool(ViewTool tool) {
    impl_->endStroke(StrokeStep::Cancel);
    impl_->letGo();
    if (tool != impl_->tool) impl_->regionNext.reset();
    impl_->tool = tool;
    impl_->brushAt.reset();
    impl_->measureNext.reset();
    changed();
}

void SceneView::setBrush(const BrushRing& ring) {
    impl_->brush = ring;
    changed();
}

void SceneView::setPainted(const PaintedPicture& picture) {
    impl_->paint.show(picture);
    changed();
}

void SceneView::setHaptics(const ProxyTelemetry& proxy, const ServoTelemetry& servo, double forceLimit,
                           bool armed) {
    const TouchState next = touchState(proxy, servo, forceLimit, armed);
    impl_->watchLoupe();
    const bool gone = impl_->model.moveTo(proxy.time);
    const std::span<const PlacedObject> places = impl_->bodies.at(proxy.bodies);
    const bool moved = impl_->model.put(places) || gone;
    if (moved) {
        if (!impl_->shadowTimer.isActive()) impl_->castShadows(false);
        impl_->shadowTimer.start();
    }
    impl_->picker.put(places);
    // Against what is shown, so that slow motion adds up until it is seen.
    const double unseen = kUnseenPixels * impl_->finestPixel(next.proxy);
    if (!moved && impl_->touch && impl_->touch->looksLike(next, unseen)) {
        impl_->liftAgain();
        return fadeOn();
    }
    impl_->touch = next;
    impl_->liftAgain();
    impl_->overlay.setVisible(impl_->showsTouch());
    changed();
}

void SceneView::setProxyRadius(double metres) {
    impl_->proxyRadius = metres;
    changed();
}

void SceneView::fit() {
    impl_->flight.stop();
    impl_->fit(impl_->pane());
    changed();
}

void SceneView::fitAll() {
    impl_->flight.stop();
    for (ViewPane& pane : impl_->panes.all())
        impl_->fit(pane);
    changed();
}

void SceneView::showStandardView(StandardView standard) {
    struct Angles {
        double yaw, pitch;
    };
    static constexpr std::array<Angles, 4> kAngles{{{0, 0}, {90, 0}, {0, 90}, {45, 35.264}}};
    const Angles& angles = kAngles[std::size_t(standard)];
    impl_->camera().yaw = angles.yaw * kDegree;
    impl_->camera().pitch = angles.pitch * kDegree;
    fit();
}

void SceneView::setManners(const CameraManners& manners) {
    impl_->manners = manners;
}

void SceneView::flyTo(const Vec3& centre_W, double radius, const Vec3& from_W) {
    constexpr double kMin = 0.02; // of the scene: nearer there is nothing left to know it by
    const double size = std::max(radius, kMin * impl_->picker.bounds().diagonal());
    impl_->panes.layOut(this->size());
    ViewCamera to = impl_->camera();
    to.fieldOfView = defaultCamera().fieldOfView;
    if (const Vec3 from = from_W.stableNormalized(); from != Vec3::Zero()) {
        to.yaw = std::atan2(from.x(), from.z());
        to.pitch = std::asin(std::clamp(from.y(), -1.0, 1.0));
    }
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
        corners.push_back(centre_W + size * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    to.fit(corners);
    flyTo(to);
}

void SceneView::flyTo(const ViewCamera& camera) {
    impl_->flying = impl_->panes.active();
    impl_->flownFrom = impl_->camera();
    impl_->flownTo = camera;
    impl_->camera().parallel = camera.parallel;
    emit projectionChanged();
    if (impl_->manners.flies) return impl_->flight.start();
    impl_->flight.stop();
    impl_->fly(1);
}

void SceneView::Impl::fly(double part) {
    const ViewCamera &from = flownFrom, &to = flownTo;
    ViewCamera& camera = panes[flying].camera;
    const double turn = std::remainder(to.yaw - from.yaw, 2 * std::numbers::pi);
    camera.focus = from.focus + part * (to.focus - from.focus);
    camera.distance = from.distance * std::pow(to.distance / from.distance, part);
    camera.yaw = std::remainder(from.yaw + part * turn, 2 * std::numbers::pi);
    camera.pitch = from.pitch + part * (to.pitch - from.pitch);
    camera.fieldOfView = from.fieldOfView + part * (to.fieldOfView - from.fieldOfView);
    view.changed();
}

void SceneView::setMarked(std::shared_ptr<const TriangleSoup> soup, const TriangleSet& triangles,
                          const Pose& pose) {
    impl_->marks.show(soup.get(), triangles, pose);
    changed();
}

bool SceneView::hasMarked() const {
    return impl_->marks.any();
}

void SceneView::setMapping(const std::optional<MappingFrame>& frame) {
    if (impl_->mapping.frame() == frame) return;
    impl_->mapping.show(frame);
    changed();
}

void SceneView::setJoint(const std::optional<JointMark>& mark) {
    if (impl_->joint.mark() == mark) return;
    impl_->joint.show(mark);
    changed();
}

void SceneView::setPath(const std::optional<PathMark>& mark) {
    if (impl_->path.mark() == mark) return;
    impl_->path.show(mark);
    changed();
}

const PathGizmo& SceneView::path() const {
    return impl_->path;
}

void SceneView::setArranging(const std::optional<Pose>& frame) {
    if (impl_->arranging.shown() == frame) return;
    impl_->arranging.show(frame);
    changed();
}

const ArrangeGizmo& SceneView::arranging() const {
    return impl_->arranging;
}

void SceneView::dropHandles() {
    if (impl_->drag == ViewDrag::Handles) impl_->letGo();
}

std::optional<Pose> SceneView::placeOf(ObjectId object) const {
    return impl_->model.placeOf(object);
}

void SceneView::setMass(const std::optional<MassMark>& mark) {
    if (impl_->mass == mark) return;
    impl_->mass = mark;
    changed();
}

void SceneView::setColliders(std::vector<ColliderMark> marks) {
    if (impl_->colliders == marks) return;
    impl_->colliders = std::move(marks);
    changed();
}

const std::vector<ColliderMark>& SceneView::colliders() const {
    return impl_->colliders;
}

const std::optional<MassMark>& SceneView::mass() const {
    return impl_->mass;
}

const JointGizmo& SceneView::joint() const {
    return impl_->joint;
}

const MappingGizmo& SceneView::mapping() const {
    return impl_->mapping;
}

std::optional<PickHit> SceneView::light(QPointF place) {
    const auto hit = impl_->pickAt(place, ScenePicker::Patience::Now);
    impl_->setHovered(hit ? std::optional(hit->surface) : std::nullopt);
    return hit;
}

void SceneView::endLight() {
    impl_->setHovered(std::nullopt);
}

void SceneView::moveCamera(double yaw, double pitch, double nearer) {
    impl_->flight.stop();
    ViewCamera& camera = impl_->camera();
    camera.yaw = std::remainder(camera.yaw + yaw, 2 * std::numbers::pi);
    camera.pitch = std::clamp(camera.pitch + pitch, -0.5 * std::numbers::pi, 0.5 * std::numbers::pi);
    const double size = impl_->extent();
    camera.distance = std::clamp(nearer * camera.distance, 0.01 * size, 50 * size);
    changed();
}

const ViewCamera& SceneView::camera() const {
    return impl_->camera();
}

void SceneView::setOverlayVisible(bool visible) {
    impl_->overlayVisible = visible;
    impl_->overlay.setVisible(impl_->showsTouch());
    for (auto& other : impl_->beside)
        other.overlay->setVisible(visible);
    changed();
}

void SceneView::setTouchScale(double scale) {
    impl_->touchScale = scale;
    impl_->overlay.setScale(scale);
    for (auto& other : impl_->beside)
        other.overlay->setScale(scale);
    changed();
}

void SceneView::setTheme(bool dark) {
    impl_->dark = dark;
    impl_->applyTheme();
    changed();
}

void SceneView::setTouched(const QString& name) {
    if (std::exchange(impl_->touchedName, name) == name) return;
    setAccessibleDescription(name);
    changed();
}

void SceneView::setFoot(int pixels) {
    impl_->foot = pixels;
    changed();
}

Vec3 SceneView::handGoal() const {
    return impl_->hand.goal();
}

void SceneView::setHandGoal(const Vec3& p_W) {
    impl_->hand.setGoal(p_W);
}

std::optional<SurfaceRef> SceneView::surfaceAt(QPointF at) const {
    const auto hit = impl_->pickAt(at, ScenePicker::Patience::Wait);
    return hit ? std::optional(hit->surface) : std::nullopt;
}

void SceneView::setDropTypes(const QStringList& types) {
    impl_->dropTypes = types;
    setAcceptDrops(!types.isEmpty());
}

QImage SceneView::grabPicture() {
    return grabSmooth();
}

QImage SceneView::grabWithoutHandles() {
    impl_->handlesDrawn = false;
    QImage picture = grabSmooth();
    impl_->handlesDrawn = true;
    return picture;
}

void SceneView::prepareFrame() {
    const double ratio = devicePixelRatioF();
    double finest = std::numeric_limits<double>::max();
    for (const std::size_t number : impl_->panes.shown()) {
        ViewPane& pane = impl_->panes[number];
        if (!pane.fitted && impl_->picker.bounds().diagonal() > 0) impl_->fit(pane);
        finest = std::min(finest, pane.camera.pixelSize(pane.camera.focus) / ratio);
    }
    impl_->spareTime(quality());
    impl_->stage.setOutlineWidth(kOutlinePixels * ratio);
    impl_->boundaries.place([this](ObjectId id) { return impl_->model.placeOf(id); });
    impl_->faces.place(impl_->model.matrixOf(impl_->facesOf));
    impl_->brushed.place(impl_->model.matrixOf(impl_->brushedOf));
    const PaintedPicture& painted = impl_->paint.picture();
    impl_->paint.lieOn([&](Index i) { return impl_->felt.shapeOf(painted.object, painted.soup.get(), i); });
    impl_->paint.place(impl_->model.matrixOf(painted.object));
    impl_->felt.update(finest, ratio);
}

// What has its size in pixels is placed anew for each of them; it is drawn at once.
void SceneView::preparePicture(std::size_t number) {
    const ViewCamera& camera = impl_->panes[impl_->panes.shown()[number]].camera;
    renderWindow().setCoarse(quality() == PictureQuality::Quick ? impl_->coarseInMotion() : Coarse::None,
                             impl_->stage.solid->budget().affordedSide(impl_->panes.shown().size()));
    impl_->stage.look(camera, impl_->shownTo(camera), number);
    if (impl_->touch) impl_->overlay.update(*impl_->touch, camera, impl_->proxyRadius, impl_->shadows());
    impl_->placeBeside(camera);
    impl_->felt.lookFrom(camera, impl_->showsTouch() ? &*impl_->touch : nullptr);
}

} // namespace tactum
