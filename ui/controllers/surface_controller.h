// What is done with the feel of the selected surfaces as a whole, and with their normals.
#pragma once

#include <functional>
#include <optional>

#include <QObject>

#include "core/geometry/repair.h"
#include "ui/controllers/workbench.h"
#include "ui/document/document.h"

namespace tactum {

class Inspector;

/// Thread: ui.
class SurfaceController : public QObject {
    Q_OBJECT
public:
    SurfaceController(const Workbench& bench, Inspector& inspector);

private:
    void copyFeel();
    /// Of the selected surfaces; seen at once, and one step when the dialog is accepted.
    void chooseColour();
    void setShading(const QString& text, const std::function<void(Shading&)>& change);
    void turnOverSelected();
    void repairSelected(const QString& text, Result<Repaired> (*how)(const SharedSoup&, const Progress&));

    Workbench bench_;
    std::optional<Feel> copied_; ///< to be pasted
};

} // namespace tactum
