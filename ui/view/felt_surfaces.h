// The model's surfaces with their relief, in the colours of what they feel like, and with their bumps.
// Private to this folder.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include <QString>

#include "core/haptics/world.h"
#include "ui/view/aside.h"
#include "ui/view/felt_mesh.h"
#include "ui/view/model_layer.h"
#include "ui/view/scale_bar.h"

namespace tactum {

/// Dresses a model layer. Surfaces without texture change at once, the meshes of the others come from a
/// worker; until then they show what they showed. Thread: ui.
class FeltSurfaces {
public:
    explicit FeltSurfaces(ModelLayer& model) : model_(model) {}

    void set(std::shared_ptr<const World> world, const FeltOptions& options);
    /// How large a pixel is on the model, m > 0: what is finer is left out of the relief, in steps of an
    /// octave.
    void setPixel(double metres);
    bool pending() const { return work_.pending(); }
    bool takeFinished();

    const std::optional<FeltValue>& value() const { return wish_.value; }
    /// Of the colours; as long as surfaces are being made, of those that are known.
    const MapRange& range() const { return range_; }
    /// What a surface of this mesh is drawn as now; null: as itself.
    std::shared_ptr<const FeltMesh> shapeOf(ObjectId object, const TriangleSoup* soup, Index surface);
    /// What is exaggerated and what could not be drawn; empty when the surfaces look as they are.
    QString legend() const;

private:
    struct Made {
        ObjectId object = 0;
        std::shared_ptr<const TriangleSoup> soup;
        Index surface = 0;
        std::shared_ptr<const FeltMesh> mesh;
        vtkSmartPointer<vtkPolyData> drawn; ///< made of the mesh in the colours of
        MapRange range;
    };
    struct Result {
        FeltMeshWish wish;
        std::vector<Made> surfaces;
        std::map<const TriangleSoup*, std::shared_ptr<const CornerNormals>> normals;
    };
    static Result make(const World& world, const FeltMeshWish& wish, Result known, const Progress& progress);
    Made* madeOf(const WorldBody& body, Index surface);
    MapRange rangeNow(FeltValue value);
    void dress();
    std::shared_ptr<const Relief> relief(const WorldBody& body, Index surface);
    vtkPolyData* drawn(Made& made) const;
    vtkSmartPointer<vtkPolyData> polyData(const FeltMesh& mesh) const;

    ModelLayer& model_;
    std::shared_ptr<const World> world_;
    FeltMeshWish wish_;
    Result made_;
    Aside<Result> work_;
    MapRange range_;
    bool relief_ = true;
    double smallestFeature_ = 0; ///< m, of the relief
    /// Of the stack that each was made of.
    std::map<std::shared_ptr<const TextureStack>, std::shared_ptr<const Relief>> reliefs_;
};

} // namespace tactum
