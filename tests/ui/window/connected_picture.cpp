#include "tests/ui/window/connected_picture.h"

#include "core/import/import_scene.h"
#include "tests/app/window/connected_window.h"
#include "ui/view/scene_view.h"

namespace tactum {

void takeConnectedPicture(const QDir& folder, const QString& scenes, QSize size) {
    const auto loaded = importScene((scenes + QStringLiteral("texture-wall.glb")).toStdU16String());
    if (!loaded) qFatal("%s", loaded.error().text.c_str());
    test::Serving serving;
    serving.begin(loaded->scene);
    test::Connected here(serving.place());
    here.window->resize(size);
    RemoteEngine other({.target = serving.place(), .name = "study.py"}, nullptr);
    if (!here.opened() || !other.start()) qFatal("the server's scene is not there");
    QAction& armed = here.command("armed");
    const SceneView& view = here.window->view();
    const QPoint at = view.mapTo(here.window.get(), view.rect().center());
    QTest::qWait(500); // the jump of the hand
    QTest::mouseMove(here.window->windowHandle(), at);
    QTest::mousePress(here.window->windowHandle(), Qt::LeftButton, {}, at);
    const bool pressed = test::waitFor([&] {
        if (!armed.isChecked()) armed.trigger();
        return here.engine.servo().force.norm() > 0.5;
    });
    if (!pressed) qFatal("the hand does not press");
    for (int i = 0; i < 60; ++i) {
        QTest::mouseMove(here.window->windowHandle(), at + QPoint(i, -i / 4));
        QTest::qWait(30);
    }
    here.window->grab().save(folder.filePath(QStringLiteral("connected.png")));
    QTest::mouseRelease(here.window->windowHandle(), Qt::LeftButton, {}, at);
}

} // namespace tactum
