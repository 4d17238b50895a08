// Many small bodies in one actor, for a picture costs more by its actors than by their triangles. Private to
// this folder.
#pragma once

#include <vector>

#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "core/base/vec.h"
#include "ui/view/display_mesh.h"
#include "ui/view/model_mapper.h"

class vtkActor;
class vtkRenderer;

namespace tactum {

/// One surface of a small body, and how it looks now.
struct CrowdPart {
    std::vector<float> positions, normals; ///< x, y, z of each vertex; metre, body frame
    DisplaySurface cells;                  ///< in the numbers of these vertices
    Eigen::Vector3f colour = Eigen::Vector3f::Ones(), glow = Eigen::Vector3f::Zero(); ///< linear
    float gloss = 0.4F;                                                               ///< 0 chalk, 1 glaze
    bool visible = false;
    int first = 0; ///< its first vertex among those of all
};

/// What one surface of a mesh is made of, with vertices of its own.
CrowdPart crowdPartOf(const DisplayMesh& mesh, const DisplaySurface& surface);

/// The processor puts the vertices where their bodies are, and each has its body's colour. Thread: ui.
class Crowd {
public:
    explicit Crowd(vtkRenderer& renderer);

    /// All that belong to it; they are the caller's. Each has to be placed and painted then.
    void setParts(std::vector<CrowdPart*> parts);
    void place(const CrowdPart& part, const Pose& X_WB);
    void paint(const CrowdPart& part);
    void setWireframe(bool on);
    /// After parts appeared or disappeared.
    void showVisible();
    /// Some of its parts as an actor to outline; it follows their places.
    vtkSmartPointer<vtkActor> outlineOf(const std::vector<const CrowdPart*>& parts) const;

private:
    vtkSmartPointer<vtkPolyData> cellsOf(const std::vector<const CrowdPart*>& parts) const;

    std::vector<CrowdPart*> parts_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkFloatArray> positions_, normals_, colours_, glows_, gloss_; ///< of every vertex
    vtkNew<ModelMapper> mapper_;
    vtkNew<vtkActor> actor_;
};

} // namespace tactum
