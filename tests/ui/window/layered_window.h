// The window with a cube and the dock of its layers, for tests.
#pragma once

#include <initializer_list>
#include <string>

#include <QAction>
#include <QComboBox>
#include <QTest>
#include <QUndoStack>

#include "tests/ui/window/window_fixture.h"
#include "ui/panels/layer_list.h"
#include "ui/panels/layer_panel.h"
#include "ui/view/scene_view.h"

namespace tactum {

/// The window with the cube, its front side selected and the dock of layers in front.
struct Layered {
    explicit Layered(const QTemporaryDir& folder) {
        if (!program.open(writeCube(folder))) qFatal("the cube cannot be opened");
        program.window->view().showStandardView(StandardView::Front);
        id = program.document.scene().objects.front().id;
        program.document.select(SurfaceRef{id, kFront});
        dock("dock-layers")->raise();
        program.frames(10);
    }

    QWidget* dock(const char* name) const { return program.window->findChild<QWidget*>(QLatin1String(name)); }
    LayerPanel& panel() const { return *program.window->findChild<LayerPanel*>(); }
    LayerList& list() const { return *program.window->findChild<LayerList*>(); }
    void choose(const char* box, int choice) const {
        auto* list = program.window->findChild<QComboBox*>(QLatin1String(box));
        list->setCurrentIndex(choice);
        emit list->activated(choice);
    }
    const TextureLayers& layers(Index surface = kFront) const {
        return program.document.scene().objects.front().surfaces[surface].layers;
    }
    std::string names() const {
        std::string all;
        for (const TextureLayer& layer : layers())
            all += (all.empty() ? "" : " ") + layer.name;
        return all;
    }
    void add(std::initializer_list<const char*> ids) {
        for (const char* each : ids)
            program.command(each).trigger();
    }
    QPoint middleOf(int row, int column = 0) const {
        return list().visualRect(list().model()->index(row, column)).center();
    }
    void click(int row, int column) const {
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, middleOf(row, column));
    }
    /// What the loops have of the front side.
    const TextureStack* felt() const {
        return program.window->publisher().world()->bodies.at(0).textures.at(kFront).get();
    }
    void undoAll() {
        while (program.document.history().canUndo())
            program.document.history().undo();
    }

    static constexpr Index kFront = 4;
    TouchedWindow program;
    ObjectId id = 0;
};

} // namespace tactum
