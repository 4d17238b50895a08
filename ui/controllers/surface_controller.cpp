#include "ui/controllers/surface_controller.h"

#include <algorithm>

#include <QColorDialog>

#include "ui/base/screen_colour.h"
#include "ui/panels/inspector.h"
#include "ui/widgets/notice_bar.h"
#include "ui/widgets/swatch.h"

namespace tactum {

SurfaceController::SurfaceController(const Workbench& bench, Inspector& inspector)
    : QObject(&bench.window), bench_(bench) {
    bench.on("surface-colour", this, [this] { chooseColour(); });
    connect(&inspector, &Inspector::colourAsked, this, &SurfaceController::chooseColour);
    bench.on("copy-feel", this, [this] { copyFeel(); });
    bench.on("paste-feel", this, [this] {
        if (!copied_) return bench_.notice.showNote(tr("Copy the feel of a surface first (Ctrl+C)."));
        bench_.document.setFeel(bench_.document.selected(), *copied_, tr("Paste the feel onto %1"));
    });
    bench.on("same-feel", this, [this] {
        const auto active = bench_.document.selection();
        if (!active) return;
        const Feel like{*bench_.document.surface(*active),
                        bench_.document.scene().find(active->object)->geometry};
        SurfaceRefs others = bench_.document.selected();
        others.pop_back();
        bench_.document.setFeel(others, like,
                                tr("Same feel as %1").arg(QString::fromStdString(like.surface.name)));
    });
    bench.on("normals-smooth", this, [this] {
        setShading(tr("Smooth normals of %1"), [](Shading& each) {
            each.on = true;
            each.normals = NormalSource::Computed;
        });
    });
    bench.on("normals-file", this, [this] {
        setShading(tr("Normals of the file for %1"), [](Shading& each) {
            each.on = true;
            each.normals = NormalSource::File;
        });
    });
    bench.on("normals-flat", this,
             [this] { setShading(tr("Flat normals of %1"), [](Shading& each) { each.on = false; }); });
    bench.on("normals-flip", this, [this] { turnOverSelected(); });
    bench.on("normals-agree", this, [this] { repairSelected(tr("Agree on fronts"), agreeOnFronts); });
    bench.on("normals-weld", this, [this] { repairSelected(tr("Weld vertices"), weldVertices); });
}

void SurfaceController::copyFeel() {
    const auto active = bench_.document.selection();
    if (!active) return;
    copied_ = Feel{*bench_.document.surface(*active), bench_.document.scene().find(active->object)->geometry};
    bench_.notice.showNote(tr("The feel of %1 is copied; Ctrl+V gives it to the selected surfaces.")
                               .arg(QString::fromStdString(copied_->surface.name)));
}

void SurfaceController::chooseColour() {
    const SurfaceRefs chosen = bench_.document.selected();
    const auto isOpen = [&](SurfaceRef ref) { return !bench_.document.surface(ref)->locked; };
    const auto first = std::ranges::find_if(chosen, isOpen);
    if (first == chosen.end())
        return bench_.notice.showNote(chosen.empty()
                                          ? tr("Select a surface first.")
                                          : tr("What is selected is locked; unlock it first (L)."));
    auto* dialog = new QColorDialog(screenColour(bench_.document.surface(*first)->colour), &bench_.window);
    dialog->setOption(QColorDialog::DontUseNativeDialog);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Colour"));
    const Gesture gesture = bench_.document.beginTrial();
    connect(dialog, &QColorDialog::currentColorChanged, this, [this, chosen, gesture](const QColor& colour) {
        bench_.document.editSurfaces(
            chosen, SceneChange::What::Material, tr("Colour of %1"),
            [&](Surface& each) { each.colour = linearColour(colour); }, gesture);
    });
    connect(dialog, &QDialog::finished, this,
            [this, gesture](int result) { bench_.document.endTrial(gesture, result != QDialog::Accepted); });
    dialog->open();
}

void SurfaceController::setShading(const QString& text, const std::function<void(Shading&)>& change) {
    bench_.document.editSurfaces(bench_.document.selected(), SceneChange::What::Shading, text,
                                 [&](Surface& each) { change(each.shading); });
}

/// Triangles of locked surfaces stay.
void SurfaceController::turnOverSelected() {
    const auto active = bench_.document.selection();
    if (!active) return;
    const FaceSelection& chosen = bench_.document.selectedFaces();
    std::vector<Index> surfaces;
    for (const SurfaceRef ref : bench_.document.selected())
        if (ref.object == active->object) surfaces.push_back(ref.surface);
    bench_.document.changeObject(
        active->object, tr("Turn over"),
        [faces = chosen.object == active->object ? chosen.faces : TriangleSet(),
         surfaces](const SceneObject& object, const Progress&) -> Result<SceneObject> {
            const TriangleSoup& soup = *object.geometry;
            TriangleSet turned;
            const auto add = [&](Index face) {
                if (!object.surfaces[soup.surfaceOf[face]].locked) turned.push_back(face);
            };
            if (faces.empty())
                for (Index face = 0; face < Index(soup.triangles.size()); ++face) {
                    if (std::ranges::find(surfaces, soup.surfaceOf[face]) != surfaces.end()) add(face);
                }
            else
                std::ranges::for_each(faces, add);
            if (turned.empty()) return inputError("What is selected is locked; unlock it first (L).");
            return withGeometry(object, turnOver(object.geometry, turned).soup);
        });
}

void SurfaceController::repairSelected(const QString& text,
                                       Result<Repaired> (*how)(const SharedSoup&, const Progress&)) {
    const auto active = bench_.document.selection();
    if (!active) return;
    auto said = std::make_shared<std::string>();
    bench_.document.changeObject(
        active->object, text,
        [how, said](const SceneObject& object, const Progress& progress) -> Result<SceneObject> {
            if (std::ranges::any_of(object.surfaces, &Surface::locked))
                return inputError(object.name + " has a locked surface. Unlock it first.");
            const Result<Repaired> repaired = how(object.geometry, progress);
            if (!repaired) return tl::unexpected(repaired.error());
            *said = repaired->done;
            return withGeometry(object, repaired->soup);
        },
        [this, said] { bench_.notice.showNote(QString::fromStdString(*said) + u'.'); });
}

} // namespace tactum
