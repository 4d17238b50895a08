// Makes every edit felt: compiles the scene and hands the World to the engine.
#pragma once

#include <memory>
#include <optional>

#include <QObject>

#include "core/haptics/world.h"
#include "core/runtime/engine.h"
#include "ui/base/background_job.h"
#include "ui/document/document.h"
#include "ui/document/layer_edits.h"

namespace tactum {

/// Thread: ui. A change of materials compiles at once, in microseconds, because every hierarchy is reused; a
/// change of shapes, and what is painted on a large mesh, on a worker. Edits that come while it works are
/// caught up when it is done.
class WorldPublisher : public QObject {
    Q_OBJECT
public:
    WorldPublisher(Document& document, Engine& engine, QObject* parent = nullptr);

    bool working() const { return job_.running(); }
    /// The other layers of the surface are not felt, whatever the scene says; nothing: the scene is felt as
    /// it is.
    void setSolo(const std::optional<SoloLayer>& solo);
    /// This scene is felt instead of the document's; a null pointer: the document's again, of which nothing
    /// that was built is built anew. What one trial shares with the one before it is not built anew either.
    void setTrial(std::shared_ptr<const Scene> trial);
    bool trying() const { return trial_ != nullptr; }
    /// What is felt, or will be when it is compiled: the trial, or the document's.
    const Scene& scene() const { return trial_ ? *trial_ : document_.scene(); }
    /// The newest World that the engine was given; nullptr before the first.
    const std::shared_ptr<const World>& world() const { return world_; }

signals:
    void progressed(double fraction, double secondsLeft);
    /// The engine has a World that differs from the one before.
    void published();
    /// The engine has a World with other shapes than before.
    void shapesPublished();
    /// The scene cannot be felt, and the one before it still is. One line for the person.
    void failed(const QString& sentence);

private:
    void follow(const SceneChange& change);
    Scene felt() const;
    void compileShapes(std::shared_ptr<const World> previous);
    void compileFeel();
    enum class Shapes { New, AsBefore };
    void compileOnWorker(Scene scene, std::shared_ptr<const World> previous, Shapes shapes);
    void publish(std::shared_ptr<const World> world);

    Document& document_;
    Engine& engine_;
    std::shared_ptr<const World> world_;
    std::shared_ptr<const Scene> trial_;
    std::shared_ptr<const World> own_; ///< of the document, while something else is felt
    std::optional<SoloLayer> solo_;
    BackgroundJob job_;
    bool feelChanged_ = false; ///< while the worker was compiling an older copy
};

} // namespace tactum
