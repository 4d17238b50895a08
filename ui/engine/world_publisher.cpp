#include "ui/engine/world_publisher.h"

#include <utility>

#include "core/haptics/compile.h"

namespace tactum {

WorldPublisher::WorldPublisher(Document& document, Engine& engine, QObject* parent)
    : QObject(parent), document_(document), engine_(engine) {
    connect(&document_, &Document::changed, this, &WorldPublisher::follow);
    connect(&job_, &BackgroundJob::progressed, this, &WorldPublisher::progressed);
}

void WorldPublisher::follow(const SceneChange& change) {
    if (trial_) return; // all of it is compiled when the trial ends
    if (change.takesTime())
        compileShapes(world_);
    else if (change.touchesFeel())
        compileFeel();
}

void WorldPublisher::setSolo(const std::optional<SoloLayer>& solo) {
    if (solo == solo_) return;
    solo_ = solo;
    follow({SceneChange::What::Layers});
}

void WorldPublisher::setTrial(std::shared_ptr<const Scene> trial) {
    if (trial == trial_) return;
    const bool another = trial_ && trial; // of one shape, contacts last from the one to the other
    if (!trial_) own_ = world_;
    trial_ = std::move(trial);
    compileShapes(another ? world_ : trial_ ? nullptr : std::exchange(own_, nullptr));
}

/// The scene as it is to be felt: a copy, for the document keeps which layers are on.
Scene WorldPublisher::felt() const {
    if (trial_) return *trial_;
    Scene scene = document_.scene();
    SceneObject* object = solo_ ? scene.find(solo_->surface.object) : nullptr;
    if (object && solo_->surface.surface < object->surfaces.size()) {
        TextureLayers& layers = object->surfaces[solo_->surface.surface].layers;
        layers = alone(std::move(layers), solo_->layer);
    }
    return scene;
}

void WorldPublisher::compileShapes(std::shared_ptr<const World> previous) {
    compileOnWorker(felt(), std::move(previous), Shapes::New);
}

/// Materials and layers: whatever comes while the worker is busy is caught up, so that a long stroke is felt
/// while it is painted.
void WorldPublisher::compileFeel() {
    feelChanged_ = job_.running();
    if (feelChanged_) return;
    Scene scene = felt();
    if (world_ && paintTakesTime(scene, *world_))
        return compileOnWorker(std::move(scene), world_, Shapes::AsBefore);
    auto compiled = compile(scene, world_.get());
    if (!compiled) return emit failed(QString::fromStdString(compiled.error().text));
    publish(std::move(*compiled));
}

/// A copy of the scene is cheap: geometry is shared. The worker holds the World it reuses, too.
void WorldPublisher::compileOnWorker(Scene scene, std::shared_ptr<const World> previous, Shapes shapes) {
    feelChanged_ = false;
    job_.start([this, scene = std::move(scene), previous = std::move(previous),
                shapes](const Progress& progress) -> BackgroundJob::Delivery {
        auto compiled = compile(scene, previous.get(), progress);
        if (!compiled && progress.isCancelled()) return [] {}; // a newer compilation is on its way
        if (!compiled)
            return [this, text = compiled.error().text] { emit failed(QString::fromStdString(text)); };
        return [this, world = std::move(*compiled), shapes] {
            publish(world);
            if (feelChanged_) compileFeel();
            if (shapes == Shapes::New) emit shapesPublished();
        };
    });
}

void WorldPublisher::publish(std::shared_ptr<const World> world) {
    world_ = world;
    engine_.publish(std::move(world));
    emit published();
}

} // namespace tactum
