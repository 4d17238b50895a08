// The dock of texture layers: their list, what is set on one of them, and how they look and feel together.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <QWidget>

#include "core/haptics/world.h"
#include "ui/document/document.h"
#include "ui/document/layer_edits.h"
#include "ui/panels/last_stroke.h"
#include "ui/view/mapping_gizmo.h"

class QLabel;
class QScrollArea;

namespace tactum {

class Actions;
class FlatSwatch;
class LayerFields;
class LayerList;
class ProfileChart;

/// Shows the layers of the active surface; what is set is set on the layer of that surface, what is added
/// comes onto all selected ones. Every edit goes through the document and can be undone.
///
/// Solo is no edit: the scene keeps which of its layers are on, so nothing can be lost when it is saved,
/// undone or closed meanwhile. Whoever compiles the scene asks soloChanged() what to leave out. It ends with
/// the selection of another surface. Thread: ui.
class LayerPanel : public QWidget {
    Q_OBJECT
public:
    explicit LayerPanel(Document& document, QWidget* parent = nullptr);

    /// Buttons for the commands of the table.
    void addButtons(const Actions& actions);

    /// Which of the active surface's layers is selected; 0 lies at the bottom.
    std::optional<int> currentLayer() const;
    void setCurrentLayer(int layer);
    /// Whether what is to be painted is the mask of that layer.
    bool maskIsEdited() const;
    std::optional<SoloLayer> solo() const { return solo_; }
    /// Whether the active surface can get layers: there is one, and it is not locked.
    bool canEdit() const;
    const FlatSwatch& swatch() const { return *swatch_; }
    const ProfileChart& chart() const { return *chart_; }

    // What the commands do.
    void add(TextureSource source);
    /// The same layer on all selected surfaces.
    void addCopy(const TextureLayer& of);
    /// Reads a picture on a worker and makes a layer of it on each of these surfaces.
    void addImage(const SurfaceRefs& on, const QString& file);
    void askForImage();
    void duplicate();
    void remove();
    void moveLayer(int from, int to);
    void toggleShown(int layer);
    void toggleSolo(int layer);

    /// The frame of the selected layer's mapping; nothing when it has none, or when the surface is locked.
    std::optional<MappingFrame> mappingFrame() const;
    void setMappingFrame(const MappingFrame& frame, Gesture gesture);

    /// For the profile: where bodies are, and what the servo did since the last frame.
    void setWorld(std::shared_ptr<const World> world);
    void take(std::span<const TracePoint> points, double bodiesTime);

signals:
    void currentLayerChanged();
    /// What is felt alone now; nothing: all layers are felt again.
    void soloChanged(const std::optional<tactum::SoloLayer>& solo);
    /// After whatever the panel shows has changed.
    void displayed();
    /// One line for the person.
    void failed(const QString& sentence);
    void noted(const QString& sentence);
    void readProgressed(double fraction, double secondsLeft);
    void readEnded();

private:
    QWidget* makeLower();
    void connectList();
    void rename(int layer, const QString& name);
    void follow(const SceneChange& change);
    void keepCurrent();
    void keepSolo(const SceneChange& change);
    void setSolo(std::optional<SoloLayer> solo);
    void refresh();
    void describe();
    void drawGround();
    void drawProfile();
    const Surface* surface() const;
    const TextureLayer* layer() const;
    bool hasUvs(const SurfaceRefs& refs) const;
    TextureLayers feltLayers() const;
    void edit(const QString& what, const std::function<void(TextureLayer&)>& change, Gesture gesture = 0);
    void editList(const QString& text, const std::function<void(TextureLayers&)>& change);
    bool haveRoom(const SurfaceRefs& refs);
    void addOn(const SurfaceRefs& refs, const std::function<TextureLayer(const TextureLayers&)>& make);
    void readImage(const QString& file, std::function<void(std::shared_ptr<const TextureImage>)> use);
    void chooseImage(bool ofMask);
    void fitNewMapping(TexturePattern& pattern, const TexturePattern& before) const;
    void announceCurrent();

    Document& document_;
    QLabel *heading_, *hint_;
    QWidget *buttons_, *body_, *feel_;
    QScrollArea* scroll_;
    LayerList* list_;
    LayerFields* fields_;
    FlatSwatch* swatch_;
    ProfileChart* chart_;
    std::optional<SurfaceRef> shown_; ///< whose layers these are
    int current_ = 0;
    TextureLayers known_; ///< as they were when they were last shown
    std::optional<SoloLayer> solo_;
    TextureLayers soloKnown_;
    struct Announced {
        std::optional<SurfaceRef> surface;
        std::optional<int> layer;
        bool mask = false;

        bool operator==(const Announced&) const = default;
    } announced_;
    LastStroke stroke_;
    std::shared_ptr<const World> world_;
    BackgroundJob reading_, profiling_;
    bool profileAgain_ = false;
};

} // namespace tactum
