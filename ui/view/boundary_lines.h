// Thin lines where one surface of an object ends and another begins. Private to this folder.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include "core/scene/scene.h"
#include "ui/base/theme.h"
#include "ui/view/aside.h"
#include "ui/view/model_mapper.h"

namespace tactum {

/// An edge between triangles of different surfaces.
struct BoundaryEdge {
    std::array<Index, 2> ends;     ///< positions of the soup
    std::array<Index, 2> surfaces; ///< on its sides, the first two of them
};

/// Edges of positions that they share, each once; none where there is one surface. Thread: any but real time.
std::vector<BoundaryEdge> boundaryEdges(const TriangleSoup& soup);

/// One actor for all objects, whose few vertices the processor puts where their objects are. Edges of large
/// meshes are found aside; until then there are none. Thread: ui.
class BoundaryLines {
public:
    explicit BoundaryLines(vtkRenderer& renderer);

    void setTheme(const Theme& theme);
    void setShown(bool shown) { shown_ = shown; }
    void setScene(const Scene& scene);
    bool pending() const;
    /// Shows what was found since; true if anything was.
    bool takeFinished();
    /// Before each picture: where the objects are, nothing for one that is not seen.
    void place(const std::function<std::optional<Pose>(ObjectId)>& placeOf);
    /// How many edges are drawn.
    std::size_t count() const { return shown_ ? drawn_ : 0; }

private:
    struct Object {
        std::shared_ptr<const TriangleSoup> soup;
        std::vector<bool> visible; ///< each surface
        std::vector<BoundaryEdge> edges;
        std::unique_ptr<Aside<std::vector<BoundaryEdge>>> work; ///< null: they are found
        std::optional<Pose> drawn;                              ///< X_WB
    };
    static void find(Object& object);
    void draw();

    std::map<ObjectId, Object> objects_; ///< that have such edges
    vtkNew<ModelMapper> mapper_;
    vtkNew<vtkActor> actor_;
    std::size_t drawn_ = 0;
    bool shown_ = true, stale_ = false;
};

} // namespace tactum
