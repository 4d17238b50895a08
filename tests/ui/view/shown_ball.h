// A view of the ball on the screen, with a mouse. For tests.
#pragma once

#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QWheelEvent>

#include "core/haptics/haptic_step.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/scene_view.h"

namespace tactum::testing {

using Picked = std::optional<SurfaceRef>;
inline constexpr QSize kBallView(640, 480);
inline const QPoint kBallCentre(320, 240);

/// A view of the ball from the front, on the screen.
struct ShownBall {
    ShownBall() : scene(ballScene()) {
        view.resize(kBallView);
        view.setScene(scene);
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        view.showStandardView(StandardView::Front);
    }

    /// The camera that the view must have now: the same fit from the front.
    ViewCamera camera() const {
        ViewCamera camera;
        camera.fieldOfView = EIGEN_PI / 6;
        camera.size = kBallView;
        camera.fit(spanningPoints(scene));
        return camera;
    }
    QPoint pixelOf(const Vec3& p) const { return camera().project(p)->toPoint(); }

    void touch(const Vec3& finger, const Vec3& proxy, const Vec3& force = Vec3::Zero()) {
        ProxyTelemetry out;
        out.updates = 1;
        out.finger = finger;
        out.output.proxy = proxy;
        out.output.force = force;
        out.output.contacts = force.norm() > 0;
        out.output.contact[0].point = proxy;
        out.output.contact[0].normal = Vec3::UnitZ();
        ServoTelemetry servo;
        servo.ticks = 1;
        servo.finger = finger;
        servo.force = force;
        view.setHandGoal(finger);
        view.setHaptics(out, servo, 8, true);
    }

    void drag(QPoint from, QPoint to, Qt::MouseButton button = Qt::LeftButton,
              Qt::KeyboardModifiers keys = {}) {
        QTest::mousePress(&view, button, keys, from);
        move(0.5 * (from + to), button, keys);
        move(to, button, keys);
        QTest::mouseRelease(&view, button, keys, to);
    }
    void move(QPoint to, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys = {}) {
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(QPointF(to)), Qt::NoButton, buttons, keys);
        QApplication::sendEvent(&view, &event);
    }
    void wheel(QPoint at, int notches) {
        QWheelEvent event(at, view.mapToGlobal(QPointF(at)), {}, {0, 120 * notches}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&view, &event);
    }
    /// Until the finger has come to where it glides. A slow machine may be a long way from it for a while.
    void waitForHand() {
        Vec3 before = Vec3::Constant(qQNaN());
        const bool arrived = test::waitFor([&] {
            const bool rests = view.handGoal() == before;
            before = view.handGoal();
            // The parts of a press have one goal each, for 0.18 s at most.
            if (!rests) QTest::qWait(300);
            return rests;
        });
        if (!arrived) qFatal("the finger does not come to rest");
    }
    QColor colourAt(QPoint pixel) {
        const QImage picture = view.grabPicture();
        return picture.pixelColor((QPointF(pixel) * picture.devicePixelRatio()).toPoint());
    }

    Scene scene;
    SceneView view;
};

} // namespace tactum::testing
