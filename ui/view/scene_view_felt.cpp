#include <vtkActorCollection.h>

#include "ui/view/scene_view_impl.h"

namespace tactum {

namespace {
constexpr int kFadeMilliseconds = 100; // between two pictures of a trail that fades while nothing moves
} // namespace

void SceneView::setFelt(const FeltOptions& options) {
    impl_->overlay.setMarks(options.normals, options.planes);
    impl_->overlay.setStylus(options.stylus);
    impl_->showLoupe(options.loupe);
    if (impl_->touch) impl_->felt.setPlace(impl_->touch->proxy);
    impl_->felt.setOptions(options);
    impl_->ground.setShown(options.ground, !options.wireframe); // one sees through what would cast it
    impl_->boundaries.setShown(options.boundaries && options.bumps == 0 && !options.wireframe);
    impl_->model.setWireframe(options.wireframe);
    if (impl_->felt.pending()) impl_->meshTimer.start();
    changed();
}

const FeltOptions& SceneView::felt() const {
    return impl_->felt.options();
}

void SceneView::setWorld(std::shared_ptr<const World> world) {
    if (impl_->touch) impl_->felt.setPlace(impl_->touch->proxy);
    if (world != impl_->world) {
        impl_->bodies = BodyPlaces(world.get());
        const std::span<const PlacedObject> moved = impl_->bodies.at({});
        impl_->model.putNoOthers(moved);
        impl_->picker.putNoOthers(moved);
    }
    impl_->world = world;
    impl_->felt.setWorld(std::move(world));
    if (impl_->felt.pending()) impl_->meshTimer.start();
    changed();
}

std::optional<BodyReading> SceneView::readingOf(const ProxyTelemetry& proxy, BodyId body) {
    if (body == kWorldBody) return std::nullopt;
    return impl_->bodies.readingOf(proxy.bodies, body, proxy.output, proxy.coupling);
}

void SceneView::addTrail(std::span<const TracePoint> points, const HapticOutput& touch) {
    impl_->felt.addTrail(points, touch);
}

void SceneView::clearTrail() {
    impl_->felt.clearTrail();
}

bool SceneView::makesFelt() const {
    return impl_->felt.pending() || impl_->ground.pending() || impl_->occlusion.pending();
}

int SceneView::actorCount() const {
    return impl_->stage.solid->GetActors()->GetNumberOfItems() +
           impl_->stage.touch->GetActors()->GetNumberOfItems() +
           impl_->stage.ghost->GetActors()->GetNumberOfItems();
}

int SceneView::modelPictures() const {
    return impl_->stage.solid->drawn();
}

void SceneView::forgetPicture() {
    impl_->stage.forgetPicture();
    changed();
}

void SceneView::fadeOn() {
    if (!impl_->felt.fades()) return;
    if (impl_->fadeClock.isValid() && impl_->fadeClock.elapsed() < kFadeMilliseconds) return;
    impl_->fadeClock.start();
    changed();
}

} // namespace tactum
