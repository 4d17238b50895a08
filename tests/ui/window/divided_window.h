// A window with a cube in it whose view is divided, and what a person does in its panes.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <QTemporaryDir>
#include <QTest>

#include "tests/support/waiting.h"
#include "tests/ui/window/window_fixture.h"
#include "ui/view/scene_view.h"

namespace tactum {

// In the order of SceneView::panes().
inline constexpr std::size_t kTopPane = 0, kOwnPane = 1, kFrontPane = 2, kRightPane = 3;
inline constexpr Qt::Key kNoKey{};    ///< it stays as it is
inline constexpr double kHalf = 0.05; ///< of the cube's side, m

struct Divided {
    explicit Divided(Qt::Key key = Qt::Key_Q, QSize size = {1200, 800}) : program(size) {
        if (!program.open(writeCube(folder))) qFatal("the cube cannot be opened");
        if (!test::waitFor([&] { return !view().makesMeshes() && !view().makesFelt(); }))
            qFatal("the meshes are never made");
        if (key != kNoKey) press(key);
    }
    SceneView& view() { return program.window->view(); }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::ControlModifier | Qt::AltModifier) {
        view().setFocus();
        QTest::keyClick(&view(), key, modifiers);
        program.frames(2);
    }
    std::size_t count() { return view().panes().size(); }
    QRect pane(std::size_t i) { return view().panes().at(i); }
    /// Where a pane shows a place of the model; of the view.
    QPoint seen(std::size_t pane, const Vec3& p_W) {
        const auto at = view().cameraOf(pane).project(p_W);
        if (!at) qFatal("it is behind the eye");
        return this->pane(pane).topLeft() + at->toPoint();
    }
    std::vector<ViewCamera> cameras() {
        std::vector<ViewCamera> all;
        for (std::size_t i = 0; i < count(); ++i)
            all.push_back(view().cameraOf(i));
        return all;
    }
    /// With the middle button.
    void orbit(QPoint from, QPoint by) {
        QWindow* window = program.window->windowHandle();
        const auto inWindow = [&](QPoint at) { return view().mapTo(program.window.get(), at); };
        QTest::mouseMove(window, inWindow(from));
        QTest::mousePress(window, Qt::MiddleButton, {}, inWindow(from));
        for (int i = 1; i <= 4; ++i)
            QTest::mouseMove(window, inWindow(from + i * by / 4));
        QTest::mouseRelease(window, Qt::MiddleButton, {}, inWindow(from + by));
    }
    void click(QPoint at) {
        program.moveTo(at);
        program.press(at);
        program.release(at);
    }
    /// A drag with the left button.
    void drag(QPoint from, QPoint to) {
        program.moveTo(from);
        program.press(from);
        for (int i = 1; i <= 4; ++i)
            program.moveTo(from + i * (to - from) / 4);
        program.release(to);
        program.frames(2);
    }
    const Surface* surfaceAt(QPoint at) {
        const auto found = view().surfaceAt(at);
        return found ? program.document.surface(*found) : nullptr;
    }
    QByteArray nameAt(QPoint at) {
        const Surface* surface = surfaceAt(at);
        return surface ? QByteArray::fromStdString(surface->name) : QByteArray();
    }

    QTemporaryDir folder;
    TouchedWindow program;
};

inline bool same(const ViewCamera& a, const ViewCamera& b) {
    return a.focus == b.focus && std::abs(a.distance - b.distance) <= 1e-12 * b.distance && a.yaw == b.yaw &&
           a.pitch == b.pitch && a.parallel == b.parallel && a.size == b.size;
}

} // namespace tactum
