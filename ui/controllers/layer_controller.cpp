#include "ui/controllers/layer_controller.h"

#include <QDockWidget>
#include <QMainWindow>

#include "ui/controllers/command_reasons.h"
#include "ui/controllers/docks.h"
#include "ui/document/document.h"
#include "ui/document/layer_edits.h"
#include "ui/engine/world_publisher.h"
#include "ui/panels/layer_panel.h"
#include "ui/showing/playback.h"
#include "ui/view/scene_view.h"
#include "ui/widgets/notice_bar.h"

namespace tactum {

namespace {

constexpr std::pair<const char*, TextureSource> kSources[] = {{"layer-noise", TextureSource::Noise},
                                                              {"layer-grooves", TextureSource::Grooves},
                                                              {"layer-dots", TextureSource::Dots},
                                                              {"layer-weave", TextureSource::Weave},
                                                              {"layer-painted", TextureSource::Painted}};

} // namespace

LayerController::LayerController(const Workbench& bench, LayerPanel& panel)
    : QObject(&bench.window), bench_(bench), panel_(panel) {
    panel.addButtons(bench.actions);
    connectCommands();
    connect(&panel, &LayerPanel::failed, &bench.notice, &NoticeBar::showError);
    connect(&panel, &LayerPanel::noted, &bench.notice, &NoticeBar::showNote);
    connect(&panel, &LayerPanel::readProgressed, this, [this](double fraction, double secondsLeft) {
        bench_.notice.showProgress(tr("Reading the picture"), fraction, secondsLeft, false);
    });
    connect(&panel, &LayerPanel::readEnded, &bench.notice, &NoticeBar::endProgress);
    connect(&panel, &LayerPanel::soloChanged, &bench.publisher, &WorldPublisher::setSolo);
    connect(&panel, &LayerPanel::displayed, this, &LayerController::showCommands);
    connect(&bench.publisher, &WorldPublisher::published, this,
            [this] { panel_.setWorld(bench_.publisher.world()); });
    connectMapping();
    showCommands();
}

void LayerController::connectCommands() {
    const auto onCurrent = [&](const char* id, auto act) {
        bench_.on(id, this, [this, act] {
            if (const auto layer = panel_.currentLayer()) act(*layer);
        });
    };
    for (const auto& [id, source] : kSources)
        bench_.on(id, this, [this, source = source] { panel_.add(source); });
    bench_.on("layer-image", this, [this] { panel_.askForImage(); });
    bench_.on("layer-duplicate", this, [this] { panel_.duplicate(); });
    bench_.on("layer-remove", this, [this] { panel_.remove(); });
    onCurrent("layer-up", [this](int layer) { panel_.moveLayer(layer, layer + 1); });
    onCurrent("layer-down", [this](int layer) { panel_.moveLayer(layer, layer - 1); });
    onCurrent("layer-show", [this](int layer) { panel_.toggleShown(layer); });
    onCurrent("layer-solo", [this](int layer) { panel_.toggleSolo(layer); });
}

void LayerController::connectMapping() {
    QDockWidget& dock = bench_.dock("dock-layers");
    connect(&bench_.actions["mapping"], &QAction::toggled, this, [this, &dock](bool on) {
        if (on && isBehind()) dock.raise();
        showMapping();
    });
    connect(&dock, &QDockWidget::visibilityChanged, this, &LayerController::showMapping,
            Qt::QueuedConnection); // when the tabs are as they will be
    connect(&bench_.view, &SceneView::mappingAsked, this, [this] {
        QAction& mapping = bench_.actions["mapping"];
        if (mapping.isEnabled()) {
            if (isBehind()) mapping.setChecked(false); // they are asked for, not sent away
            return mapping.toggle();
        }
        bench_.notice.showNote(whyOff(QStringLiteral("mapping"), bench_.playback.active()));
    });
    const auto gesture = std::make_shared<Gesture>(0);
    connect(&bench_.view, &SceneView::mappingGrabbed, this,
            [this, gesture] { *gesture = bench_.document.beginTrial(); });
    connect(&bench_.view, &SceneView::mappingDragged, this,
            [this, gesture](const MappingFrame& frame) { panel_.setMappingFrame(frame, *gesture); });
    connect(&bench_.view, &SceneView::handlesLeft, this,
            [this, gesture](bool givenUp) { bench_.document.endTrial(*gesture, givenUp); });
}

void LayerController::showCommands() {
    const bool edits = panel_.canEdit();
    const auto current = panel_.currentLayer();
    const auto selection = bench_.document.selection();
    const int count = selection && current ? int(bench_.document.surface(*selection)->layers.size()) : 0;
    for (const auto& [id, source] : kSources)
        bench_.actions[id].setEnabled(edits);
    bench_.actions["layer-image"].setEnabled(edits);
    for (const char* id : {"layer-duplicate", "layer-remove", "layer-show", "layer-solo"})
        bench_.actions[id].setEnabled(edits && current);
    bench_.actions["layer-up"].setEnabled(edits && current && *current + 1 < count);
    bench_.actions["layer-down"].setEnabled(edits && current && *current > 0);
    bench_.actions["layer-solo"].setChecked(current && panel_.solo() && panel_.solo()->layer == *current);
    bench_.actions["mapping"].setEnabled(panel_.mappingFrame().has_value());
    showMapping();
}

// A layer without a frame hides the handles, and so does a panel before this one, which may have handles of
// its own; another layer or this panel brings them back.
void LayerController::showMapping() {
    const bool shown = bench_.actions["mapping"].isChecked() && !isBehind();
    bench_.view.setMapping(shown ? panel_.mappingFrame() : std::nullopt);
}

bool LayerController::isBehind() const {
    return dockInFrontOf(bench_.window, bench_.dock("dock-layers"));
}

void LayerController::drop(const QString& file, QPointF place) {
    bench_.view.endLight();
    if (bench_.document.empty() || bench_.playback.active())
        return bench_.notice.showNote(
            tr("A picture becomes a layer of a surface: open a model first, and drop it "
               "there."));
    if (panel_.isVisible() && panel_.rect().contains(panel_.mapFrom(&bench_.window, place).toPoint())) {
        if (bench_.document.selected().empty())
            return bench_.notice.showNote(tr("Select a surface first, or drop the picture on the model."));
        return panel_.addImage(bench_.document.selected(), file);
    }
    const QPointF inView = bench_.view.mapFrom(&bench_.window, place);
    const auto hit = bench_.view.rect().contains(inView.toPoint()) ? bench_.view.light(inView) : std::nullopt;
    bench_.view.endLight();
    if (!hit)
        return bench_.notice.showNote(tr(
            "Drop a picture on a surface of the model, or on the Layers panel for the selected surfaces."));
    bench_.document.select(hit->surface);
    panel_.addImage(hit->surface, file);
}

} // namespace tactum
