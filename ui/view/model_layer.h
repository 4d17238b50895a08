// The objects of a scene as VTK actors. Private to this folder.
#pragma once

#include <atomic>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper.h>
#include <vtkSmartPointer.h>

#include "core/scene/scene.h"
#include "core/scene/surface_ref.h"
#include "ui/theme.h"
#include "ui/view/display_mesh.h"

class vtkRenderer;

namespace tactum {

/// One actor for each surface; those of an object share their vertices. Thread: ui.
class ModelLayer {
public:
    explicit ModelLayer(vtkRenderer& renderer) : renderer_(renderer) {}

    /// Keeps what was made of geometry that is still there, and drops the rest.
    void setScene(const Scene& scene);
    /// Puts bodies that move by themselves where they are at a time in s; true if there is any that it moved.
    bool moveTo(double time);
    /// The box of all bodies that move, where they are. World frame.
    Bounds movingBounds() const;
    void setHighlight(std::optional<SurfaceRef> surface, const QColor& glow);
    /// Normals of large meshes come from another thread; shows those that are finished. True if any was.
    bool takeFinished();
    bool pending() const;
    /// Waits for them.
    void finish();

    /// The actor of a surface, if it exists and is visible.
    vtkActor* actorOf(const SurfaceRef& surface) const;

private:
    struct Part {
        vtkNew<vtkPolyDataMapper> mapper;
        vtkNew<vtkActor> actor;
    };
    struct Model {
        ~Model() { cancelled = true; } // the future's destructor waits

        std::shared_ptr<const TriangleSoup> soup;
        std::vector<std::unique_ptr<Part>> parts;
        std::atomic<bool> cancelled = false;
        std::future<DisplayMesh> smooth;         ///< valid while it is being made
        std::vector<std::array<int, 3>> corners; ///< of what is shown
        bool visible = true;
        Pose rest; ///< X_WB at the time 0
        std::shared_ptr<const Motion> motion;
    };

    std::unique_ptr<Model> build(const SceneObject& object);
    void resize(Model& model, std::size_t surfaces);
    void regroup(Model& model, const SceneObject& object);
    void show(Model& model, DisplayMesh mesh);
    static void show(Model& model, vtkPoints* points, vtkDataArray* normals);
    void update(Model& model, const SceneObject& object);
    void place(Model& model);
    void drop(Model& model);
    void drop(Part& part);

    vtkRenderer& renderer_;
    std::map<ObjectId, std::unique_ptr<Model>> models_;
    vtkActor* highlighted_ = nullptr;
    double time_ = 0; ///< s, of the bodies that move
};

} // namespace tactum
