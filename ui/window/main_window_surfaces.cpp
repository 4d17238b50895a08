// What is done with the feel of the selected surfaces as a whole, and with their normals.
#include <algorithm>

#include "ui/widgets/notice_bar.h"
#include "ui/window/main_window.h"

namespace tactum {

void MainWindow::connectSurfaces() {
    connect(&actions_["copy-feel"], &QAction::triggered, this, [this] {
        const auto active = document_.selection();
        if (!active) return;
        copied_ = Feel{*document_.surface(*active), document_.scene().find(active->object)->geometry};
        notice_->showNote(tr("The feel of %1 is copied; Ctrl+V gives it to the selected surfaces.")
                              .arg(QString::fromStdString(copied_->surface.name)));
    });
    connect(&actions_["paste-feel"], &QAction::triggered, this, [this] {
        if (!copied_) return notice_->showNote(tr("Copy the feel of a surface first (Ctrl+C)."));
        document_.setFeel(document_.selected(), *copied_, tr("Paste the feel onto %1"));
    });
    connect(&actions_["same-feel"], &QAction::triggered, this, [this] {
        const auto active = document_.selection();
        if (!active) return;
        const Feel like{*document_.surface(*active), document_.scene().find(active->object)->geometry};
        SurfaceRefs others = document_.selected();
        others.pop_back();
        document_.setFeel(others, like, tr("Same feel as %1").arg(QString::fromStdString(like.surface.name)));
    });
    connect(&actions_["normals-smooth"], &QAction::triggered, this, [this] {
        setShading(tr("Smooth normals of %1"), [](Shading& each) {
            each.on = true;
            each.normals = NormalSource::Computed;
        });
    });
    connect(&actions_["normals-file"], &QAction::triggered, this, [this] {
        setShading(tr("Normals of the file for %1"), [](Shading& each) {
            each.on = true;
            each.normals = NormalSource::File;
        });
    });
    connect(&actions_["normals-flat"], &QAction::triggered, this,
            [this] { setShading(tr("Flat normals of %1"), [](Shading& each) { each.on = false; }); });
    connect(&actions_["normals-flip"], &QAction::triggered, this, &MainWindow::turnOverSelected);
    connect(&actions_["normals-agree"], &QAction::triggered, this,
            [this] { repairSelected(tr("Agree on fronts"), agreeOnFronts); });
    connect(&actions_["normals-weld"], &QAction::triggered, this,
            [this] { repairSelected(tr("Weld vertices"), weldVertices); });
}

void MainWindow::setShading(const QString& text, const std::function<void(Shading&)>& change) {
    document_.editSurfaces(document_.selected(), SceneChange::What::Shading, text,
                           [&](Surface& each) { change(each.shading); });
}

/// Triangles of locked surfaces stay.
void MainWindow::turnOverSelected() {
    const auto active = document_.selection();
    if (!active) return;
    const FaceSelection& chosen = document_.selectedFaces();
    std::vector<Index> surfaces;
    for (const SurfaceRef ref : document_.selected())
        if (ref.object == active->object) surfaces.push_back(ref.surface);
    document_.changeObject(active->object, tr("Turn over"),
                           [faces = chosen.object == active->object ? chosen.faces : TriangleSet(),
                            surfaces](const SceneObject& object, const Progress&) -> Result<SceneObject> {
                               const TriangleSoup& soup = *object.geometry;
                               TriangleSet turned;
                               const auto add = [&](Index face) {
                                   if (!object.surfaces[soup.surfaceOf[face]].locked) turned.push_back(face);
                               };
                               if (faces.empty())
                                   for (Index face = 0; face < Index(soup.triangles.size()); ++face) {
                                       if (std::ranges::find(surfaces, soup.surfaceOf[face]) !=
                                           surfaces.end())
                                           add(face);
                                   }
                               else
                                   std::ranges::for_each(faces, add);
                               if (turned.empty())
                                   return inputError("What is selected is locked; unlock it first (L).");
                               return withGeometry(object, turnOver(object.geometry, turned).soup);
                           });
}

void MainWindow::repairSelected(const QString& text,
                                Result<Repaired> (*how)(const SharedSoup&, const Progress&)) {
    const auto active = document_.selection();
    if (!active) return;
    auto said = std::make_shared<std::string>();
    document_.changeObject(
        active->object, text,
        [how, said](const SceneObject& object, const Progress& progress) -> Result<SceneObject> {
            if (std::ranges::any_of(object.surfaces, &Surface::locked))
                return inputError(object.name + " has a locked surface. Unlock it first.");
            const Result<Repaired> repaired = how(object.geometry, progress);
            if (!repaired) return tl::unexpected(repaired.error());
            *said = repaired->done;
            return withGeometry(object, repaired->soup);
        },
        [this, said] { notice_->showNote(QString::fromStdString(*said) + u'.'); });
}

} // namespace tactum
