#include "tests/ui/window/layer_pictures.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QTest>

#include "ui/panels/flat_swatch.h"
#include "ui/panels/layer_panel.h"
#include "ui/panels/profile_chart.h"

namespace tactum {

namespace {

void choose(TouchedWindow& program, const char* box, int choice) {
    auto* list = program.window->findChild<QComboBox*>(QLatin1String(box));
    list->setCurrentIndex(choice);
    emit list->activated(choice);
}

void save(TouchedWindow& program, const QDir& folder, const char* name) {
    program.frames(30);
    const QString file = folder.filePath(QLatin1String(name));
    if (!program.window->grab().save(file)) qFatal("%s cannot be written", qPrintable(file));
    qInfo("%s", qPrintable(file));
}

/// Ridges and a weave on the body of the teapot, where friction is higher on the ridges.
void makeLayers(TouchedWindow& program) {
    program.command("layer-weave").trigger();
    program.type(QStringLiteral("size"), QStringLiteral("6"));
    program.command("layer-noise").trigger();
    program.type(QStringLiteral("height"), QStringLiteral("0.35"));
    program.command("layer-grooves").trigger();
    choose(program, "mapping", int(TextureMapping::Cylindrical));
    program.type(QStringLiteral("size"), QStringLiteral("12"));
    program.type(QStringLiteral("height"), QStringLiteral("0.6"));
    program.type(QStringLiteral("rotation"), QStringLiteral("30"));
    program.command("layer-grooves").trigger();
    choose(program, "layer-target", int(TextureTarget::StaticFriction));
    program.window->findChild<LayerPanel*>()->setCurrentLayer(2);
}

void stroke(TouchedWindow& program) {
    QPoint at = program.centre() + QPoint(60, 20);
    program.press(at);
    program.frames(60);
    for (int i = 0; i < 40; ++i) {
        at += QPoint(-3, 0);
        program.moveTo(at);
        program.frames(2);
    }
    program.release(at); // the hand lifts off, and the stroke is over
    program.frames(60);
}

} // namespace

void takeLayerPictures(TouchedWindow& program, const QDir& folder, const QString& scenes) {
    if (!program.open(scenes + QStringLiteral("teapot.obj"))) qFatal("the teapot cannot be opened");
    program.window->findChild<QDockWidget*>(QStringLiteral("dock-layers"))->raise();
    program.document.select({SurfaceRef{program.document.scene().objects[0].id, 0}});
    save(program, folder, "layers-empty.png");
    makeLayers(program);
    stroke(program);
    save(program, folder, "layers.png");
    program.command("mapping").trigger();
    save(program, folder, "layers-mapping.png");
    program.command("theme-light").trigger();
    program.frames(10);
    save(program, folder, "layers-light.png");
    program.command("theme-dark").trigger();
    program.command("mapping").trigger();
}

} // namespace tactum
