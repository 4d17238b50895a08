#include "ui/view/normal_glyphs.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QObject>

#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include "ui/view/model_mapper.h"
#include "ui/view/poly_arrays.h"
#include "ui/view/studio_light.h"

namespace tactum {

namespace {

constexpr double kSameLean = 1 * std::numbers::pi / 180;

} // namespace

void NormalGlyphs::ask(std::shared_ptr<const World> world, double length) {
    work_.start([world = std::move(world), length](const Progress& progress) {
        return normalNeedles(*world, length, progress);
    });
}

void NormalGlyphs::clear() {
    work_.forget();
    for (auto& [id, actor] : actors_)
        renderer_.RemoveActor(actor);
    actors_.clear();
}

bool NormalGlyphs::takeFinished() {
    auto made = work_.take();
    if (!made) return false;
    clear();
    for (const NeedleMesh& mesh : made->meshes) {
        std::vector<int> ends(mesh.positions.size() / 3);
        for (std::size_t i = 0; i < ends.size(); ++i)
            ends[i] = int(i);
        vtkNew<vtkPoints> points;
        points->SetData(vectorArray(mesh.positions));
        vtkNew<vtkPolyData> data;
        data->SetPoints(points);
        data->SetLines(cellArray(ends, 2));
        vtkNew<ModelMapper> mapper;
        mapper->SetInputData(data);
        auto& actor = actors_[mesh.object];
        actor->SetMapper(mapper);
        actor->PickableOff();
        useNoLight(*actor);
        actor->GetProperty()->SetColor(colour_.redF(), colour_.greenF(), colour_.blueF());
        actor->GetProperty()->SetLineWidth(float(width_));
        renderer_.AddActor(actor);
    }
    made->meshes.clear();
    about_ = std::move(*made);
    return true;
}

void NormalGlyphs::setTheme(const Theme& theme) {
    colour_ = theme.contact;
    for (auto& [id, actor] : actors_)
        actor->GetProperty()->SetColor(colour_.redF(), colour_.greenF(), colour_.blueF());
}

void NormalGlyphs::setWidth(double devicePixels) {
    width_ = devicePixels;
    for (auto& [id, actor] : actors_)
        actor->GetProperty()->SetLineWidth(float(width_));
}

void NormalGlyphs::place(ObjectId object, vtkMatrix4x4* matrix) {
    const auto found = actors_.find(object);
    if (found == actors_.end()) return;
    found->second->SetVisibility(matrix != nullptr);
    if (matrix) found->second->SetUserMatrix(matrix);
}

QString NormalGlyphs::legend() const {
    if (!shown()) return QObject::tr("Normals: being read");
    if (about_.mostLean <= kSameLean) return QObject::tr("Normals felt as drawn");
    const QString kind = !about_.shaded   ? QObject::tr("those of the facets")
                         : !about_.facets ? QObject::tr("those of force shading")
                                          : QObject::tr("of facets and of force shading");
    return QObject::tr("Normals felt: %1, up to %2\u00b0 from those drawn")
        .arg(kind)
        .arg(about_.mostLean * 180 / std::numbers::pi, 0, 'f', 0);
}

} // namespace tactum
