// What a layer can be made of, as pictures by kind: opens under the button that adds one.
#pragma once

#include <functional>
#include <vector>

#include <QFrame>

#include "ui/document/layer_edits.h"

class QAction;
class QListWidgetItem;

namespace tactum {

class Actions;
class PictureGrid;
struct Preset;

/// Commands of the table, and the layers of the presets that have some. Thread: ui.
class LayerChooser : public QFrame {
    Q_OBJECT
public:
    LayerChooser(const Actions& actions, QWidget* parent);

    /// With the presets that there are now. It closes with a choice, a click elsewhere or Esc.
    void openUnder(const QWidget& button);

signals:
    /// A layer of a preset, as it is there.
    void layerChosen(const tactum::TextureLayer& layer);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void fill();
    void offer(const char* command, const QString& name, TextureSource source);
    void offerPresets();
    void offerOne(const Preset& preset, const TextureLayer& layer, const QString& name);
    void add(const QString& name, const QPixmap& picture, const QString& words, std::function<void()> choice);
    void take(QListWidgetItem* item);

    const Actions& actions_;
    PictureGrid* grid_;
    std::vector<std::function<void()>> choices_; ///< what each picture does
};

} // namespace tactum
