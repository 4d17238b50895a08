// The window and its texture layers: commands, the mapping in the view, pictures that are dropped.
#include "ui/document/layer_edits.h"
#include "ui/panels/layer_panel.h"
#include "ui/showing/playback.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"
#include "ui/window/main_window.h"

namespace tactum {

namespace {

constexpr std::pair<const char*, TextureSource> kSources[] = {{"layer-noise", TextureSource::Noise},
                                                              {"layer-grooves", TextureSource::Grooves},
                                                              {"layer-dots", TextureSource::Dots},
                                                              {"layer-weave", TextureSource::Weave},
                                                              {"layer-painted", TextureSource::Painted}};

} // namespace

void MainWindow::connectLayers() {
    LayerPanel* panel = docks_.layers;
    panel->addButtons(actions_);
    const auto on = [this](const char* id, auto act) {
        connect(&actions_[id], &QAction::triggered, this, act);
    };
    const auto onCurrent = [&](const char* id, auto act) {
        on(id, [panel, act] {
            if (const auto layer = panel->currentLayer()) act(*layer);
        });
    };
    for (const auto& [id, source] : kSources)
        on(id, [panel, source = source] { panel->add(source); });
    on("layer-image", [panel] { panel->askForImage(); });
    on("layer-duplicate", [panel] { panel->duplicate(); });
    on("layer-remove", [panel] { panel->remove(); });
    onCurrent("layer-up", [panel](int layer) { panel->moveLayer(layer, layer + 1); });
    onCurrent("layer-down", [panel](int layer) { panel->moveLayer(layer, layer - 1); });
    onCurrent("layer-show", [panel](int layer) { panel->toggleShown(layer); });
    onCurrent("layer-solo", [panel](int layer) { panel->toggleSolo(layer); });
    connect(panel, &LayerPanel::failed, notice_, &NoticeBar::showError);
    connect(panel, &LayerPanel::noted, notice_, &NoticeBar::showNote);
    connect(panel, &LayerPanel::readProgressed, this, [this](double fraction, double secondsLeft) {
        notice_->showProgress(tr("Reading the picture"), fraction, secondsLeft, false);
    });
    connect(panel, &LayerPanel::readEnded, notice_, &NoticeBar::endProgress);
    connect(panel, &LayerPanel::soloChanged, &publisher_, &WorldPublisher::setSolo);
    connect(panel, &LayerPanel::displayed, this, &MainWindow::showLayerCommands);
    connect(&publisher_, &WorldPublisher::published, this,
            [this, panel] { panel->setWorld(publisher_.world()); });
    connectMapping();
    showLayerCommands();
}

void MainWindow::connectMapping() {
    connect(&actions_["mapping"], &QAction::toggled, this, &MainWindow::showMapping);
    connect(view_, &SceneView::mappingAsked, this, [this] {
        QAction& mapping = actions_["mapping"];
        if (mapping.isEnabled()) return mapping.toggle();
        notice_->showNote(whyNot(QStringLiteral("mapping")));
    });
    const auto gesture = std::make_shared<Gesture>(0);
    connect(view_, &SceneView::mappingGrabbed, this, [this, gesture] { *gesture = document_.beginTrial(); });
    connect(view_, &SceneView::mappingDragged, this,
            [this, gesture](const MappingFrame& frame) { docks_.layers->setMappingFrame(frame, *gesture); });
    connect(view_, &SceneView::handlesLeft, this,
            [this, gesture](bool givenUp) { document_.endTrial(*gesture, givenUp); });
}

void MainWindow::showLayerCommands() {
    const LayerPanel& panel = *docks_.layers;
    const bool edits = panel.canEdit();
    const auto current = panel.currentLayer();
    const auto selection = document_.selection();
    const int count = selection && current ? int(document_.surface(*selection)->layers.size()) : 0;
    for (const auto& [id, source] : kSources)
        actions_[id].setEnabled(edits);
    actions_["layer-image"].setEnabled(edits);
    for (const char* id : {"layer-duplicate", "layer-remove", "layer-show", "layer-solo"})
        actions_[id].setEnabled(edits && current);
    actions_["layer-up"].setEnabled(edits && current && *current + 1 < count);
    actions_["layer-down"].setEnabled(edits && current && *current > 0);
    actions_["layer-solo"].setChecked(current && panel.solo() && panel.solo()->layer == *current);
    actions_["mapping"].setEnabled(panel.mappingFrame().has_value());
    showMapping();
}

// A layer without a frame hides the handles; another one with a frame brings them back.
void MainWindow::showMapping() {
    view_->setMapping(actions_["mapping"].isChecked() ? docks_.layers->mappingFrame() : std::nullopt);
}

void MainWindow::dropPicture(const QString& file, QPointF place) {
    view_->endLight();
    if (document_.empty() || playback_->active())
        return notice_->showNote(tr("A picture becomes a layer of a surface: open a model first, and drop it "
                                    "there."));
    LayerPanel* panel = docks_.layers;
    if (panel->isVisible() && panel->rect().contains(panel->mapFrom(this, place).toPoint())) {
        if (document_.selected().empty())
            return notice_->showNote(tr("Select a surface first, or drop the picture on the model."));
        return panel->addImage(document_.selected(), file);
    }
    const QPointF inView = view_->mapFrom(this, place);
    const auto hit = view_->rect().contains(inView.toPoint()) ? view_->light(inView) : std::nullopt;
    view_->endLight();
    if (!hit)
        return notice_->showNote(tr(
            "Drop a picture on a surface of the model, or on the Layers panel for the selected surfaces."));
    document_.select(hit->surface);
    panel->addImage(hit->surface, file);
}

} // namespace tactum
