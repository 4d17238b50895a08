// What is lit and named under the pointer, while it moves and while it rests. The ball's halves are told
// apart by where its geometry has them (tests/ui/view/ball_scene.h), which a wrong picker would not know.
#include <QSignalSpy>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/ui/view/shown_ball.h"
#include "ui/view/surface_format.h"

namespace test_hover {

using namespace tactum;
using namespace tactum::testing;

class TestHover : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void hoverNamesAndBrightensTheSurface() {
        ShownBall shown;
        shown.view.grabPicture(); // time for the hierarchy
        QSignalSpy hovered(&shown.view, &SceneView::surfaceHovered);
        const QPoint upper = kBallCentre - QPoint(0, 60);
        const int before = shown.colourAt(upper).lightness();
        QTRY_VERIFY((shown.move(upper, Qt::NoButton), !hovered.isEmpty()));
        QCOMPARE(hovered.last()[0].value<Picked>()->surface, kUpper);
        QCOMPARE_GT(shown.colourAt(upper).lightness(), before + 4);
        shown.move({5, 5}, Qt::NoButton);
        QVERIFY(!hovered.last()[0].value<Picked>());
        QCOMPARE(shown.colourAt(upper).lightness(), before);
    }

    // The pointer stays while the camera goes: what it lies on then is another thing.
    void hoverFollowsTheCamera() {
        ShownBall shown;
        shown.view.grabPicture();
        QSignalSpy hovered(&shown.view, &SceneView::surfaceHovered);
        const QPoint upper = kBallCentre - QPoint(0, 60);
        QTRY_VERIFY((shown.move(upper, Qt::NoButton), !hovered.isEmpty()));
        QCOMPARE(hovered.last()[0].value<Picked>()->surface, kUpper);
        ViewCamera other = shown.view.camera();
        other.focus.y() += 10 * other.distance; // the ball lies far below
        shown.view.flyTo(other);
        QTRY_VERIFY(!hovered.last()[0].value<Picked>());
        shown.view.showStandardView(StandardView::Front);
        QTRY_VERIFY(hovered.last()[0].value<Picked>().has_value());
        QCOMPARE(hovered.last()[0].value<Picked>()->surface, kUpper);
    }

    // Nor does it move when the view is divided under it: it lies in another pane then, nearer to the ball's
    // top.
    void hoverFollowsTheDivision() {
        ShownBall shown;
        shown.view.grabPicture();
        QSignalSpy hovered(&shown.view, &SceneView::surfaceHovered);
        QTRY_VERIFY((shown.move({170, 290}, Qt::NoButton), !hovered.isEmpty()));
        QCOMPARE(hovered.last()[0].value<Picked>()->surface, kLower);
        shown.view.setSplit(ViewSplit::Four);
        QTRY_COMPARE(hovered.last()[0].value<Picked>().value_or(SurfaceRef{}).surface, kUpper);
    }
};

TACTUM_GUI_TEST(TestHover)

} // namespace test_hover

#include "test_hover.moc"
