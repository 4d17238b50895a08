// Texture layers: commands, the mapping in the view, pictures that are dropped.
#pragma once

#include <QObject>
#include <QPointF>

#include "ui/controllers/workbench.h"

namespace tactum {

class LayerPanel;

/// Thread: ui.
class LayerController : public QObject {
    Q_OBJECT
public:
    LayerController(const Workbench& bench, LayerPanel& panel);

    /// A picture that was dropped at a place of the window becomes a layer of what lies there.
    void drop(const QString& file, QPointF place);

private:
    void connectCommands();
    void connectMapping();
    void showCommands();
    void showMapping();
    /// Whether another panel that shares its tabs is in front.
    bool isBehind() const;

    Workbench bench_;
    LayerPanel& panel_;
};

} // namespace tactum
