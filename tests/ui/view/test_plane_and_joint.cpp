// The handles of a section's plane and of a joint: where they are, what is drawn of them, what a drag of each
// leads to. Wrong itself if the camera were: it is the one of test_view_camera, which projects by hand.
#include <QPainter>
#include <QTest>

#include "tests/support/as_shown.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/shown.h"
#include "tests/ui/panels/panels.h"
#include "ui/view/joint_gizmo.h"
#include "ui/view/section_gizmo.h"

namespace test_plane_and_joint {

using namespace tactum;
using namespace tactum::testing;
using namespace tactum::test;

namespace {

constexpr QSize kView(800, 600);

/// From above, from the right; a pixel at the origin is half a millimetre.
ViewCamera camera() {
    ViewCamera c;
    c.size = kView;
    c.fieldOfView = 0.6;
    c.distance = 0.15 / std::tan(0.3);
    c.yaw = 0.4;
    c.pitch = 0.3;
    return c;
}

QString figure(double x) {
    return QString::number(std::abs(x) < 5e-8 ? 0 : x, 'g', 4);
}
QString text(const Vec3& v) {
    return QStringLiteral("(%1 %2 %3)").arg(figure(v.x()), figure(v.y()), figure(v.z()));
}
QString text(QPointF p) {
    return QStringLiteral("(%1 %2)").arg(p.x(), 0, 'f', 1).arg(p.y(), 0, 'f', 1);
}
QString text(const SectionPlane& plane) {
    return QStringLiteral("at %1 toward %2, x along %3")
        .arg(text(plane.frame.translation), text(plane.normal()), text(plane.frame.rotate(Vec3::UnitX())));
}
QString text(const JointMark& mark) {
    return QStringLiteral("at %1 along %2, from %3 to %4")
        .arg(text(mark.at), text(mark.axis), mark.hasLow ? figure(mark.low) : QStringLiteral("no stop"),
             mark.hasHigh ? figure(mark.high) : QStringLiteral("no stop"));
}

SectionPlane plane() {
    SectionPlane plane;
    plane.frame.translation = {0.01, 0.02, 0};
    plane.frame.rotation = Quat(Eigen::AngleAxisd(0.5, Vec3(1, 1, 0).normalized()));
    return plane;
}

JointMark hinge() {
    return {true, {-0.02, 0, 0}, Vec3::UnitY(), {0.04, 0.01, 0}, -0.6, 1.2, true, true};
}

/// Which handle lies where: a letter for each place of a grid about the middle.
template <class Gizmo> QString mapOf(const Gizmo& gizmo, const ViewCamera& c, const char* letters) {
    QString rows;
    for (int y = 100; y < kView.height() - 60; y += 12) {
        for (int x = 200; x < 640; x += 8) {
            const auto handle = gizmo.at({double(x), double(y)}, c);
            rows += handle ? QLatin1Char(letters[int(*handle)]) : QLatin1Char('.');
        }
        rows += u'\n';
    }
    return rows;
}

template <class Gizmo> QString drawn(const Gizmo& gizmo, const ViewCamera& c, QPointF cursor) {
    return drawnBy(kView, [&](QPainter& painter) { gizmo.draw(painter, c, kDarkTheme, cursor); });
}

constexpr QPointF kFar(-100, -100);
const QPointF kDrags[] = {{40, 0}, {0, 25}, {-30, -30}, {3, -1}};

} // namespace

class TestPlaneAndJoint : public QObject {
    Q_OBJECT

private slots:
    void thePlaneHasItsHandles() {
        const ViewCamera c = camera();
        SectionGizmo gizmo;
        QVERIFY(!gizmo.placeOf(SectionHandle::Move, c));
        QVERIFY(!gizmo.shows());
        QCOMPARE(drawn(gizmo, c, kFar), "\n");
        gizmo.show(plane());
        gizmo.setReach(0.08);
        QString places;
        for (const auto handle : {SectionHandle::Move, SectionHandle::TurnX, SectionHandle::TurnY})
            places += text(*gizmo.placeOf(handle, c)) + u'\n';
        COMPARE_SHOWN(places + mapOf(gizmo, c, "mxy") + drawn(gizmo, c, kFar), "plane");
        QString lit;
        for (const auto handle : {SectionHandle::Move, SectionHandle::TurnX, SectionHandle::TurnY})
            lit += drawn(gizmo, c, *gizmo.placeOf(handle, c)) + QStringLiteral("--\n");
        COMPARE_SHOWN(lit, "plane-lit");
        gizmo.setReach(0.04);
        COMPARE_SHOWN(drawn(gizmo, c, kFar), "plane-near");
        SectionPlane behind = plane();
        behind.frame.translation = c.eye() - 0.1 * c.forward();
        gizmo.show(behind);
        QCOMPARE(drawn(gizmo, c, kFar), "\n");
        QVERIFY(!gizmo.isUnder({400, 300}, c));
    }

    void thePlaneIsDragged() {
        const ViewCamera c = camera();
        SectionGizmo gizmo;
        gizmo.show(plane());
        QCOMPARE(text(gizmo.dragged({1, 2}, c, false)), text(plane())); // by nothing
        QString said;
        for (const auto& [handle, name] : {std::pair(SectionHandle::Move, "move"),
                                           {SectionHandle::TurnX, "turn x"},
                                           {SectionHandle::TurnY, "turn y"}}) {
            const QPointF from = *gizmo.placeOf(handle, c);
            QVERIFY(gizmo.take(from, c));
            for (const QPointF& by : kDrags)
                for (const bool snapped : {false, true})
                    said += QStringLiteral("%1 by %2%3: %4\n")
                                .arg(QLatin1String(name), text(by), snapped ? " in steps" : "",
                                     text(gizmo.dragged(from + by, c, snapped)));
            gizmo.letGo();
        }
        COMPARE_SHOWN(said, "plane-drags");
    }

    void theJointHasItsHandles() {
        const ViewCamera c = camera();
        JointGizmo gizmo;
        QVERIFY(!gizmo.placeOf(JointHandle::Place, c));
        QCOMPARE(drawn(gizmo, c, kFar), "\n");
        QString said;
        const auto show = [&](const char* words, const JointMark& mark) {
            gizmo.show(mark);
            said += QLatin1String(words) + u'\n';
            for (const auto handle :
                 {JointHandle::Place, JointHandle::Tip, JointHandle::Low, JointHandle::High})
                said += text(*gizmo.placeOf(handle, c)) + u' ';
            said += u'\n' + drawn(gizmo, c, kFar);
        };
        JointMark mark = hinge();
        show("hinge", mark);
        said += mapOf(gizmo, c, "ptlh");
        for (const auto handle : {JointHandle::Place, JointHandle::Tip, JointHandle::Low, JointHandle::High})
            said += QStringLiteral("lit\n") + drawn(gizmo, c, *gizmo.placeOf(handle, c));
        mark.hasLow = mark.hasHigh = false;
        show("hinge without stops", mark);
        mark.body = mark.at; // the angle begins somewhere across
        show("hinge through the body", mark);
        mark = hinge();
        mark.high = 100;
        show("hinge that turns on and on", mark);
        mark = hinge();
        mark.turns = false;
        mark.low = -0.03;
        mark.high = 0.05;
        show("slider", mark);
        mark.hasLow = mark.hasHigh = false;
        show("slider without stops", mark);
        COMPARE_SHOWN(said, "joint");
        mark.at = c.eye() - 0.1 * c.forward();
        gizmo.show(mark);
        QCOMPARE(drawn(gizmo, c, kFar), "\n");
    }

    void theJointIsDragged() {
        const ViewCamera c = camera();
        QString said;
        for (const bool turns : {true, false}) {
            JointGizmo gizmo;
            JointMark mark = hinge();
            mark.turns = turns;
            if (!turns) mark.low = -0.03, mark.high = 0.05;
            gizmo.show(mark);
            QCOMPARE(text(gizmo.dragged({1, 2}, c)), text(mark));
            for (const auto& [handle, name] : {std::pair(JointHandle::Place, "place"),
                                               {JointHandle::Tip, "tip"},
                                               {JointHandle::Low, "low"},
                                               {JointHandle::High, "high"}}) {
                const QPointF from = *gizmo.placeOf(handle, c);
                gizmo.grab(handle, from);
                for (const QPointF& by :
                     {kDrags[0], kDrags[1], kDrags[2], kDrags[3], QPointF(-150, 90), QPointF(150, -90)})
                    said += QStringLiteral("%1 %2 by %3: %4\n")
                                .arg(turns ? "hinge" : "slider", QLatin1String(name), text(by),
                                     text(gizmo.dragged(from + by, c)));
                gizmo.letGo();
            }
        }
        COMPARE_SHOWN(said, "joint-drags");
    }
};

TACTUM_GUI_TEST(TestPlaneAndJoint)

} // namespace test_plane_and_joint

#include "test_plane_and_joint.moc"
