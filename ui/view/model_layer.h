// The objects of a scene as VTK actors. Private to this folder.
#pragma once

#include <array>
#include <atomic>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "core/haptics/body_places.h"
#include "core/scene/scene.h"
#include "core/scene/surface_ref.h"
#include "ui/base/theme.h"
#include "ui/view/coarse_mesh.h"
#include "ui/view/crowd.h"
#include "ui/view/display_mesh.h"
#include "ui/view/model_mapper.h"
#include "ui/view/outline_pass.h"
#include "ui/view/relief_shader.h"

class vtkRenderer;

namespace tactum {

/// What a surface shows instead of its own look.
struct SurfaceDress {
    vtkSmartPointer<vtkPolyData> mesh = nullptr; ///< null: its own; with scalars it is drawn in their colours
    std::optional<QColor> colour = {};           ///< as on the screen; empty: its own
    std::shared_ptr<const Relief> relief = nullptr; ///< on its own mesh; null: none
};

/// One actor for each surface of a large body, whose surfaces share their vertices; one for all small bodies
/// together, but for surfaces that are dressed in a mesh or a relief. Thread: ui.
class ModelLayer {
public:
    explicit ModelLayer(vtkRenderer& renderer) : renderer_(renderer), crowd_(renderer) {}

    /// Keeps what was made of geometry that is still there, and drops the rest.
    void setScene(const Scene& scene);
    /// Puts bodies that move by themselves where they are at a time in s; true if there is any that it moved.
    bool moveTo(double time);
    /// Puts objects to where forces have moved them; true if any that is visible was elsewhere. Others stay
    /// where they are.
    bool put(std::span<const PlacedObject> places);
    /// All others are where the scene has them.
    void putNoOthers(std::span<const PlacedObject> places);
    /// The box of all bodies that move, where they are. World frame.
    Bounds movingBounds() const;
    /// Colours and gloss of its surfaces, whose shapes are those of the last setScene(). True if any differs.
    bool setLooks(const Scene& scene);
    void setWireframe(bool on);
    void setHighlight(std::optional<SurfaceRef> surface, const QColor& glow);
    /// Normals of large meshes come from another thread; shows those that are finished. True if any was.
    bool takeFinished();
    bool pending() const;
    /// Whether there are coarser meshes for what moves.
    bool hasCoarse() const;
    /// Whether a relief is drawn.
    bool hasRelief() const;
    /// Waits for them.
    void finish();

    /// Dresses these surfaces, and all others in their own look. Stays through new scenes while the geometry
    /// of an object does.
    void setDresses(std::map<ObjectId, std::vector<SurfaceDress>> dresses);

    /// Whether a surface exists and is visible.
    bool shows(const SurfaceRef& surface) const;
    /// Actors that cover those of the surfaces that are visible, an outline for each object. Until the next
    /// scene.
    Outlined outlinesOf(const std::vector<SurfaceRef>& surfaces) const;
    /// X_WB of an object where it is now; null when it is hidden or unknown.
    vtkMatrix4x4* matrixOf(ObjectId object) const;
    /// The same; nothing where there is no matrix.
    std::optional<Pose> placeOf(ObjectId object) const;

private:
    struct Part {
        CrowdPart crowd;                       ///< of a small body
        vtkSmartPointer<vtkActor> actor;       ///< null as long as the crowd shows it
        vtkSmartPointer<ModelMapper> mapper;   ///< of the actor
        vtkSmartPointer<vtkPolyData> own;      ///< what it looks like undressed; null in a small body
        vtkSmartPointer<vtkPolyData> coarse;   ///< that in fewer triangles; null: there is none
        bool smooth = false;                   ///< own has normals
        vtkSmartPointer<vtkPolyData> cornered; ///< the same with corners of its own for each triangle
        ReliefShader relief;                   ///< of the actor
        bool visible = true;
        Eigen::Vector3f colour = Eigen::Vector3f::Ones();
        float gloss = 0;              ///< by its friction: 0 chalk, 1 glaze
        std::array<double, 3> glow{}; ///< of its dress: what it shines by itself
    };
    /// What a worker makes of a large mesh.
    struct Made {
        DisplayMesh mesh;
        CoarseMesh coarse;
    };
    struct Model {
        ~Model() { cancelled = true; } // the future's destructor waits

        std::shared_ptr<const TriangleSoup> soup;
        std::vector<std::unique_ptr<Part>> parts;
        std::atomic<bool> cancelled = false;
        std::future<Made> made;                  ///< valid while it is being made
        std::vector<std::array<int, 3>> corners; ///< of what is shown
        CoarseMesh coarse;                       ///< the same in fewer triangles, or empty
        bool visible = true;
        bool small = false;          ///< in the crowd
        Bounds box;                  ///< body frame
        Pose rest;                   ///< X_WB at the time 0
        vtkNew<vtkMatrix4x4> matrix; ///< X_WB now
        std::shared_ptr<const Motion> motion;
        std::optional<Pose> put; ///< X_WB, where forces have moved it
    };

    std::unique_ptr<Model> build(const SceneObject& object);
    void resize(Model& model, std::size_t surfaces);
    void regroup(Model& model, const SceneObject& object);
    void show(Model& model, DisplayMesh mesh);
    static void show(Model& model, vtkPoints* points, vtkDataArray* normals);
    void take(ObjectId id, Model& model);
    void update(Model& model, const SceneObject& object);
    Pose poseOf(const Model& model) const;
    void place(Model& model);
    void drop(Model& model);
    void drop(Part& part);
    void giveActor(const Model& model, Part& part);
    void gather();
    void showCrowd();
    void dress(ObjectId id, Model& model);
    void dress(const Model& model, std::size_t surface, const SurfaceDress& dress);
    /// What a surface without a mesh of its dress is drawn as under its relief.
    vtkPolyData* reliefMesh(const Model& model, Part& part, std::size_t surface, const Relief& relief);
    void dressInCrowd(Part& part, const SurfaceDress& dress, bool visible);
    void dressAlone(const Model& model, std::size_t surface, const SurfaceDress& dress);
    const Part* visiblePart(const SurfaceRef& surface) const;
    void glow(bool on);

    vtkRenderer& renderer_;
    bool wireframe_ = false;
    ReliefTiles tiles_;
    Crowd crowd_;
    bool crowdStale_ = false;  ///< other parts are in it
    bool hidingStale_ = false; ///< some of them appeared or disappeared
    std::map<ObjectId, std::unique_ptr<Model>> models_;
    std::map<ObjectId, std::vector<SurfaceDress>> dresses_;
    std::optional<SurfaceRef> highlight_;
    QColor glow_;
    double time_ = 0; ///< s, of the bodies that move
};

} // namespace tactum
