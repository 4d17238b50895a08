#include "ui/view/sphere_layer.h"

#include <algorithm>

#include <QObject>

#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

void SphereLayer::ask(std::shared_ptr<const World> world, int level, const Vec3& near_W) {
    asked_ = level;
    work_.start([world = std::move(world), level, near_W](const Progress& progress) {
        return sphereLevel(*world, level, near_W, progress);
    });
}

void SphereLayer::clear() {
    work_.forget();
    for (auto& [id, actor] : actors_)
        renderer_.RemoveActor(actor);
    actors_.clear();
}

bool SphereLayer::takeFinished() {
    const auto made = work_.take();
    if (!made) return false;
    clear();
    level_ = std::min(asked_, made->deepest);
    deepest_ = made->deepest;
    all_ = made->all;
    drawn_ = made->drawn;
    for (const SphereMesh& mesh : made->meshes) {
        vtkNew<vtkPoints> points;
        points->SetData(vectorArray(mesh.positions));
        vtkNew<vtkPolyData> data;
        data->SetPoints(points);
        data->GetPointData()->SetNormals(vectorArray(mesh.normals));
        data->SetPolys(cellArray(mesh.triangles, 3));
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(data);
        auto& actor = actors_[mesh.object];
        actor->SetMapper(mapper);
        useBubbleLight(*actor);
        setScreenColour(*actor, colour_);
        renderer_.AddActor(actor);
    }
    return true;
}

void SphereLayer::setTheme(const Theme& theme) {
    colour_ = theme.accent;
    for (auto& [id, actor] : actors_)
        setScreenColour(*actor, colour_);
}

void SphereLayer::place(ObjectId object, vtkMatrix4x4* matrix) {
    const auto found = actors_.find(object);
    if (found == actors_.end()) return;
    found->second->SetVisibility(matrix != nullptr);
    if (matrix) found->second->SetUserMatrix(matrix);
}

QString SphereLayer::legend() const {
    if (!shown()) return QObject::tr("Spheres: being read");
    const QString count =
        drawn_ < all_ ? QObject::tr("the %1 nearest of %2").arg(drawn_).arg(all_) : QString::number(all_);
    return QObject::tr("Spheres at level %1 of %2: %3 (+ and -)").arg(level_).arg(deepest_).arg(count);
}

} // namespace tactum
