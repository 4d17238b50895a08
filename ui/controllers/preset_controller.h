// The library of presets: its dock, its commands, and what is dropped from it onto the model.
#pragma once

#include <optional>

#include <QObject>

#include "ui/controllers/workbench.h"
#include "ui/document/document.h"

namespace tactum {

class PresetLibrary;
class PresetStore;
struct LoadedPreset;
struct Preset;

/// Thread: ui.
class PresetController : public QObject {
    Q_OBJECT
public:
    /// Adds the dock beside that of the problems.
    explicit PresetController(const Workbench& bench);

    /// Whether the file is a preset; then it is imported, and given to the surface if there is one.
    bool take(const QString& file, std::optional<SurfaceRef> surface);

private:
    void addDock();
    void connectLibrary();
    void connectDrops();
    void showCommands();
    void applyTo(const SurfaceRefs& surfaces, const Preset& preset);
    void applyChosen();
    void showKept(const QString& file, const LoadedPreset& made);
    void save();
    void askForFiles();
    void exportChosen();

    Workbench bench_;
    PresetStore* store_;
    PresetLibrary* library_;
    std::optional<SurfaceRef> droppedOn_; ///< who gets the preset that is being imported
};

} // namespace tactum
