// The handles that move, turn and scale: where they are, and what a drag of each comes to.
#include <cmath>
#include <numbers>

#include <QImage>
#include <QPainter>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "ui/view/arrange_gizmo.h"

namespace test_arrange_gizmo {

using namespace tactum;
using enum ArrangeHandle;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
const ArrangeHandle kAll[] = {Move,   MoveX, MoveY, MoveZ, MoveYZ, MoveZX,
                              MoveXY, TurnX, TurnY, TurnZ, Turn,   Scale};

/// Looked at from the corner between the axes.
ViewCamera camera() {
    ViewCamera c;
    c.size = {800, 600};
    c.fieldOfView = 0.6;
    c.distance = 0.6;
    c.yaw = 0.7;
    c.pitch = 0.5;
    return c;
}

Pose frame() {
    return {Quat(Eigen::AngleAxisd(0.2, Vec3(3, 1, 2).normalized())), {0.01, -0.02, 0.03}};
}

Vec3 axis(int i) {
    return frame().rotate(Vec3::Unit(i));
}

/// A drag from a handle to where a place of the world is seen.
struct Drag {
    ArrangeGizmo gizmo;
    ViewCamera c = camera();
    explicit Drag(ArrangeHandle handle) {
        gizmo.show(frame());
        const QPointF from = gizmo.placeOf(handle, c).value();
        if (!gizmo.take(from, c)) qFatal("no handle");
        at = from;
    }
    Arrangement by(QPointF step, bool snapped = false, bool fine = false) {
        at += step;
        gizmo.lead(step, fine);
        return gizmo.dragged(c, snapped, fine);
    }
    Arrangement to(const Vec3& p_W, bool snapped = false) { return by(c.project(p_W).value() - at, snapped); }
    QPointF at;
};

constexpr int kAround = 300; ///< pixels about the picture, which nothing clips

QImage drawn(const Drag& drag, const std::optional<Arrangement>& now) {
    QImage image(drag.c.size.toSize() + 2 * QSize(kAround, kAround), QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.translate(kAround, kAround);
    drag.gizmo.draw(painter, drag.c, themeFor(true), drag.at, now);
    return image;
}

QRect differing(const QImage& a, const QImage& b) {
    QRect all;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            if (a.pixel(x, y) != b.pixel(x, y)) all |= QRect(x, y, 1, 1);
    return all;
}

double angleOf(const Arrangement& by) {
    return Eigen::AngleAxisd(by.turn).angle();
}

} // namespace

class TestArrangeGizmo : public QObject {
    Q_OBJECT

private slots:
    void everyHandleIsWhereItIsGrabbed() {
        ArrangeGizmo gizmo;
        QVERIFY(!gizmo.at({400, 300}, camera()));
        gizmo.show(frame());
        for (const ArrangeHandle handle : kAll)
            QCOMPARE(int(gizmo.at(*gizmo.placeOf(handle, camera()), camera()).value()), int(handle));
        QVERIFY(!gizmo.at({10, 10}, camera()));
        Pose behind = frame();
        behind.translation = camera().eye() - camera().forward();
        gizmo.show(behind);
        QVERIFY(!gizmo.at({400, 300}, camera()));
        QVERIFY(!gizmo.placeOf(Move, camera()));
    }

    // The tip of an arrow goes where the pointer leads it along its axis, and nowhere else.
    void anArrowMovesAlongItsAxis() {
        for (int i = 0; i < 3; ++i) {
            Drag drag{ArrangeHandle(int(MoveX) + i)};
            const double arm = 92 * drag.c.pixelSize(frame().translation);
            const Arrangement by = drag.to(frame().translation + (arm + 0.0123) * axis(i));
            COMPARE_NEAR(by.move, Vec3(0.0123 * axis(i)), 1e-9, "m");
            QVERIFY(by.turn.isApprox(Quat::Identity()) && by.scale == 1);
            COMPARE_NEAR(by.about, frame().translation, 1e-15, "m");
        }
    }

    void aSquareMovesInItsPlane() {
        for (int i = 0; i < 3; ++i) {
            Drag drag{ArrangeHandle(int(MoveYZ) + i)};
            const double middle = 33 * drag.c.pixelSize(frame().translation);
            const Vec3 u = axis((i + 1) % 3), v = axis((i + 2) % 3);
            const Arrangement by = drag.to(frame().translation + (middle + 0.02) * u + (middle - 0.03) * v);
            COMPARE_NEAR(by.move, Vec3(0.02 * u - 0.03 * v), 1e-9, "m");
        }
    }

    void theDotMovesAcrossTheView() {
        Drag drag{Move};
        const Arrangement by = drag.by({30, -40});
        COMPARE_NEAR(by.move.dot(drag.c.forward()), 0, 1e-12, "m");
        COMPARE_NEAR(by.move.norm(), 50 * drag.c.pixelSize(frame().translation), 1e-9, "m");
    }

    // By the way of the pointer along the ring, of small ways.
    void aRingTurnsAboutItsAxis() {
        for (int i = 0; i < 3; ++i) {
            Drag drag{ArrangeHandle(int(TurnX) + i)};
            const Vec3 out = (axis((i + 1) % 3) + axis((i + 2) % 3)) * std::sqrt(0.5) * 66 *
                             drag.c.pixelSize(frame().translation);
            const Quat small(Eigen::AngleAxisd(2 * kDegree, axis(i)));
            const Arrangement by = drag.to(frame().translation + small * out);
            COMPARE_NEAR(angleOf(by) / kDegree, 2, 0.1, "degrees");
            COMPARE_NEAR(Vec3(Eigen::AngleAxisd(by.turn).axis()), axis(i), 1e-9, "");
            QVERIFY(by.move.isZero() && by.scale == 1);
        }
    }

    // Round the pivot by a right angle, counter-clockwise as it is seen: toward the eye.
    void theOuterRingTurnsAboutTheLineOfSight() {
        Drag drag{Turn};
        const QPointF centre = *drag.c.project(frame().translation), out = drag.at - centre;
        const Arrangement by = drag.by(QPointF(out.y(), -out.x()) - out);
        COMPARE_NEAR(angleOf(by) / kDegree, 90, 1e-6, "degrees");
        COMPARE_NEAR(Vec3(Eigen::AngleAxisd(by.turn).axis()), Vec3(-drag.c.forward()), 1e-9, "");
    }

    void theSquareOnTheRingScales() {
        Drag drag{Scale};
        const QPointF centre = *drag.c.project(frame().translation), out = drag.at - centre;
        COMPARE_NEAR(drag.by(0.5 * out).scale, 1.5, 1e-9, "");
        QVERIFY(drag.by(-1.5 * out).scale > 0); // on the pivot: no size is none
    }

    // 5 mm, 15 degrees, 0.1; with fine steps a tenth, a degree, a hundredth.
    void ctrlSnapsToEvenSteps() {
        Drag along{MoveX};
        const double arm = 92 * along.c.pixelSize(frame().translation);
        const Vec3 near = frame().translation + (arm + 0.0123) * axis(0);
        COMPARE_NEAR(along.to(near, true).move, Vec3(0.01 * axis(0)), 1e-12, "m");
        COMPARE_NEAR(along.gizmo.dragged(along.c, true, true).move, Vec3(0.0125 * axis(0)), 1e-12, "m");
        Drag turn{Turn};
        const QPointF centre = *turn.c.project(frame().translation), out = turn.at - centre;
        const double a = 50 * kDegree;
        const QPointF turned(std::cos(a) * out.x() + std::sin(a) * out.y(),
                             std::cos(a) * out.y() - std::sin(a) * out.x());
        COMPARE_NEAR(angleOf(turn.by(turned - out, true)) / kDegree, 45, 1e-9, "degrees");
        Drag scale{Scale};
        const QPointF wide = scale.at - *scale.c.project(frame().translation);
        COMPARE_NEAR(scale.by(0.26 * wide, true).scale, 1.3, 1e-12, "");
        QCOMPARE(Drag{Scale}.by(-wide, true).scale, 0.1);
    }

    // Shift in the middle of a drag changes what comes, and not what was.
    void shiftIsTenTimesFiner() {
        Drag drag{Move};
        const Vec3 before = drag.by({100, 0}).move;
        COMPARE_NEAR(drag.by({100, 0}, false, true).move, Vec3(1.1 * before), 1e-12, "m");
        COMPARE_NEAR(drag.by({-100, 0}).move, Vec3(0.1 * before), 1e-12, "m");
    }

    // G and X, R and X: the same drag from where it began.
    void aFreeDragIsKeptToAnAxis() {
        Drag drag{Move};
        drag.gizmo.grabFree(Move, drag.at);
        QVERIFY(drag.gizmo.takenFree());
        drag.by({40, 10});
        drag.gizmo.keepTo(0);
        const Vec3 way = drag.gizmo.dragged(drag.c, false, false).move;
        QCOMPARE_GT(way.norm(), 1e-3);
        COMPARE_NEAR(Vec3(way - way.dot(axis(0)) * axis(0)), Vec3(Vec3::Zero()), 1e-12, "m");
        const QPointF centre = *drag.c.project(frame().translation);
        for (int i = 0; i < 3; ++i) { // round the pivot: about the axis as it is seen
            drag.gizmo.grabFree(Turn, centre + QPointF(50, 0));
            drag.gizmo.keepTo(i);
            const Arrangement by = drag.by({-50, -50});
            COMPARE_NEAR(angleOf(by) / kDegree, 90, 1e-6, "degrees");
            const double toward = -axis(i).dot(drag.c.forward());
            COMPARE_NEAR(Eigen::AngleAxisd(by.turn).axis().dot(axis(i)), std::copysign(1, toward), 1e-9, "");
        }
        drag.gizmo.letGo();
        QVERIFY(drag.gizmo.dragged(drag.c, false, false).changesNothing());
    }

    // Beside the handles where there is room, else farther in: a pane cuts off what is outside of it.
    void itsNumbersStayInThePicture() {
        for (const QPointF& to : {QPointF(400, 300), QPointF(795, 300), QPointF(5, 5), QPointF(795, 595)}) {
            Drag drag{Move};
            drag.c.pan(to - *drag.c.project(frame().translation));
            const Arrangement now = drag.by({2, 1});
            const QRect numbers = differing(drawn(drag, now), drawn(drag, std::nullopt));
            QVERIFY(!numbers.isEmpty());
            QVERIFY(QRect({kAround, kAround}, drag.c.size.toSize()).contains(numbers));
        }
    }
};

TACTUM_GUI_TEST(TestArrangeGizmo)

} // namespace test_arrange_gizmo

#include "test_arrange_gizmo.moc"
