// The points of a path in the view: which are drawn, and that each can be grabbed.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/view/path_gizmo.h"

namespace test_path_gizmo {

using namespace tactum;

namespace {

/// Along -z, so that a ring about z is seen as a circle.
ViewCamera camera() {
    ViewCamera c;
    c.size = {800, 600};
    c.fieldOfView = 0.6;
    c.distance = 0.6;
    c.yaw = 0;
    c.pitch = 0;
    return c;
}

PathMark ring(int points) {
    PathMark mark;
    mark.closed = true;
    for (int i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * i / points;
        mark.points.emplace_back(0.1 * std::cos(angle), 0.1 * std::sin(angle), 0);
    }
    return mark;
}

const QPointF kFar(1, 1); // where nothing is

} // namespace

class TestPathGizmo : public QObject {
    Q_OBJECT

private slots:
    void ofFewPointsAllAreDrawn() {
        PathGizmo gizmo;
        QVERIFY(gizmo.drawn(camera(), kFar).empty());
        gizmo.show(ring(8));
        QCOMPARE(gizmo.drawn(camera(), kFar).size(), std::size_t(16));
    }

    // The figure that would show the test wrong: on a circle of 300 pixels no more than its length over the
    // distance have room.
    void ofManyPointsFewAreDrawn() {
        PathGizmo gizmo;
        gizmo.show(ring(500));
        const auto few = gizmo.drawn(camera(), kFar);
        const double circle = 2 * std::numbers::pi * 0.1 / camera().pixelSize(Vec3::Zero());
        QCOMPARE_LE(few.size(), std::size_t(circle / 30) + 1);
        QCOMPARE_GE(few.size(), std::size_t(circle / 40));
        for (const int one : few)
            for (const int other : few)
                if (one != other)
                    QCOMPARE_GE(lengthOf(*gizmo.placeOf(one, camera()) - *gizmo.placeOf(other, camera())),
                                30);
    }

    // About the cursor all of them, and so whatever can be grabbed there.
    void whatCanBeGrabbedIsDrawn() {
        PathGizmo gizmo;
        gizmo.show(ring(500));
        for (const int handle : {0, 17, 250, 499, 500, 733, 999}) {
            const QPointF at = *gizmo.placeOf(handle, camera());
            const auto drawn = gizmo.drawn(camera(), at);
            for (int i = 0; i < 1000; ++i)
                if (lengthOf(*gizmo.placeOf(i, camera()) - at) < 50)
                    QVERIFY2(std::ranges::find(drawn, i) != drawn.end(), qPrintable(QString::number(i)));
            QVERIFY(gizmo.take(at, camera()));
            const auto held = gizmo.drawn(camera(), kFar); // it stays while it is dragged
            QVERIFY(std::ranges::find(held, handle) != held.end());
            gizmo.letGo();
        }
    }

    // A drag of 0.012 m to the right and 0.007 m up: as it is, and in steps of 5 mm.
    void aPointGoesWhereItIsDragged_data() {
        QTest::addColumn<int>("handle");
        QTest::addColumn<bool>("snapped");
        QTest::addColumn<int>("points");
        QTest::addColumn<Vec3>("by");
        QTest::newRow("a point") << 0 << false << 4 << Vec3(0.012, 0.007, 0);
        QTest::newRow("a point in steps") << 0 << true << 4 << Vec3(0.01, 0.005, 0);
        QTest::newRow("between two, which makes one") << 4 << false << 5 << Vec3(0.012, 0.007, 0);
        QTest::newRow("between two in steps") << 4 << true << 5 << Vec3(0.01, 0.005, 0);
    }
    void aPointGoesWhereItIsDragged() {
        QFETCH(int, handle);
        QFETCH(bool, snapped);
        QFETCH(int, points);
        QFETCH(Vec3, by);
        PathGizmo gizmo;
        const PathMark mark = ring(4);
        gizmo.show(mark);
        const QPointF at = *gizmo.placeOf(handle, camera());
        QCOMPARE(gizmo.dragged(at, camera(), snapped).size(), mark.points.size()); // nothing is held
        QVERIFY(gizmo.take(at, camera()));
        const double pixel = camera().pixelSize(Vec3::Zero());
        const auto now = gizmo.dragged(at + QPointF(0.012, -0.007) / pixel, camera(), snapped);
        QCOMPARE(int(now.size()), points);
        const Vec3 from = handle == 0 ? mark.points[0] : Vec3((mark.points[0] + mark.points[1]) / 2);
        COMPARE_NEAR(now[handle == 0 ? 0 : 1], Vec3(from + by), 1e-9, "m");
        COMPARE_NEAR(now.back(), mark.points.back(), 1e-12, "m");
    }
};

TACTUM_TEST(TestPathGizmo)

} // namespace test_path_gizmo

#include "test_path_gizmo.moc"
