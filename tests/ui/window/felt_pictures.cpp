#include "tests/ui/window/felt_pictures.h"

#include <QAction>
#include <QDockWidget>
#include <QTest>

#include "ui/view/scene_view.h"
#include "ui/widgets/force_plot.h"

namespace tactum {

namespace {

class Pictures {
public:
    Pictures(TouchedWindow& program, const QDir& folder, const QString& scenes)
        : program_(program), folder_(folder), scenes_(scenes) {}

    void open(const char* scene) {
        if (!program_.open(scenes_ + QLatin1String(scene))) qFatal("%s cannot be opened", scene);
    }
    /// Switches commands on, or off again.
    void toggle(std::initializer_list<const char*> ids) {
        for (const char* id : ids)
            program_.command(id).trigger();
        (void)test::waitFor([&] { return !program_.window->view().makesFelt(); });
        program_.frames(30);
    }
    void save(const char* name) {
        const QString file = folder_.filePath(QLatin1String(name));
        if (!program_.window->grab().save(file)) qFatal("%s cannot be written", qPrintable(file));
        qInfo("%s", qPrintable(file));
    }
    /// Leads the pressed finger on.
    void stroke(QPoint by, int steps, int framesEach = 2) {
        const QPointF from = at_;
        for (int i = 1; i <= steps; ++i) {
            at_ = (from + QPointF(by) * i / steps).toPoint();
            program_.moveTo(at_);
            program_.frames(framesEach);
        }
    }
    void press(QPoint offset, int deeper) {
        at_ = program_.centre() + offset;
        program_.press(at_);
        program_.frames(60);
        program_.wheel(at_, deeper);
        program_.frames(40);
    }
    void release() {
        program_.release(at_);
        program_.frames(10);
    }
    void zoom(QPoint offset, int notches) { program_.wheel(program_.centre() + offset, notches); }
    ForcePlot& plot() { return *program_.window->findChild<ForcePlot*>(); }
    TouchedWindow& program() { return program_; }

private:
    TouchedWindow& program_;
    QDir folder_;
    QString scenes_;
    QPoint at_;
};

/// The force near the rim of its cone, the trail behind it, and the plots of the same touch.
void takeContact(Pictures& pictures) {
    pictures.open("teapot.obj");
    TouchedWindow& program = pictures.program();
    program.window->document().select({SurfaceRef{program.window->document().scene().objects[0].id, 0}});
    program.type(QStringLiteral("stiffness"), QStringLiteral("350"));
    program.type(QStringLiteral("static-friction"), QStringLiteral("0.5"));
    program.type(QStringLiteral("dynamic-friction"), QStringLiteral("0.3"));
    program.type(QStringLiteral("proxy-radius"), QStringLiteral("2"));
    program.window->document().select({});
    pictures.zoom({60, 0}, 6);
    pictures.toggle({"friction-cone", "trail"});
    for (const char* strip : {"ratio", "lag"})
        pictures.plot().setShown(QLatin1String(strip), true);
    pictures.press({0, -40}, 6);
    pictures.stroke({90, 50}, 25, 1);
    pictures.save("friction-cone.png");
    for (const char* strip : {"energy", "rate"})
        pictures.plot().setShown(QLatin1String(strip), true);
    pictures.stroke({-60, -40}, 30, 1);
    pictures.save("plots.png");
    for (const char* strip : {"ratio", "lag", "energy", "rate"})
        pictures.plot().setShown(QLatin1String(strip), false);
    pictures.release();
    pictures.toggle({"friction-cone", "trail"});
}

/// A finger in the relief of leather, from nearby.
void takeLoupe(Pictures& pictures) {
    pictures.open("layered-leather.glb");
    pictures.toggle({"loupe"});
    pictures.press({60, 20}, 4);
    pictures.stroke({-80, 20}, 20);
    pictures.save("loupe.png");
    pictures.release();
    pictures.toggle({"loupe"});
}

void takeModel(Pictures& pictures) {
    pictures.open("teapot.obj");
    pictures.toggle({"spheres"});
    pictures.save("spheres.png");
    pictures.toggle({"spheres", "felt-normals"});
    pictures.save("felt-normals.png");
    pictures.toggle({"felt-normals"});
}

void takeMaps(Pictures& pictures) {
    pictures.open("friction-ladder.glb");
    pictures.toggle({"map-static-friction"});
    pictures.save("friction-map.png");
    pictures.open("layered-leather.glb");
    pictures.toggle({"map-static-friction", "map-height", "bumps-10"});
    pictures.save("height-map.png");
    pictures.toggle({"map-height"});
    pictures.save("bumps.png");
    pictures.toggle({"bumps-10"});
}

} // namespace

void takeFeltPictures(TouchedWindow& program, const QDir& folder, const QString& scenes) {
    Pictures pictures(program, folder, scenes);
    takeMaps(pictures);
    takeLoupe(pictures);
    takeModel(pictures);
    takeContact(pictures);
}

} // namespace tactum
