// How the model is drawn where a person chooses: lines between surfaces, as a wireframe, in parallel.
#include <QTest>

#include "core/motion/motion_build.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/boundary_lines.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_drawn_model {

using namespace tactum;
using namespace tactum::testing;

namespace {

struct DrawnView {
    explicit DrawnView(const Scene& shown) : scene(shown) {
        view.resize(400, 400);
        view.setScene(scene);
        options([](FeltOptions& o) { o.ground = false; });
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        settle();
        view.showStandardView(StandardView::Front);
    }
    void options(const std::function<void(FeltOptions&)>& change) {
        FeltOptions now = view.felt();
        change(now);
        view.setFelt(now);
    }
    void settle() {
        if (!test::waitFor([&] { return !view.makesFelt() && !view.makesMeshes(); })) qFatal("never made");
    }
    void edit(const std::function<void(Scene&)>& change) {
        change(scene);
        view.setScene(scene);
        settle();
        view.grabPicture();
    }

    Scene scene;
    SceneView view;
};

int lightness(const QImage& picture, QPointF at) {
    return picture.pixelColor(at.toPoint()).lightness();
}

/// Pixels that are not as light as in the other picture.
int changed(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 6;
    return count;
}

} // namespace

class TestDrawnModel : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    /// The halves of the ball meet in as many edges as it has meridians.
    void edgesBetweenSurfacesAreFoundOnce() {
        const auto soup = ballSoup(64, 32);
        const auto edges = boundaryEdges(*soup);
        QCOMPARE(edges.size(), std::size_t(64));
        for (const BoundaryEdge& edge : edges) {
            for (const Index end : edge.ends)
                COMPARE_NEAR(soup->positions[end].y(), 0, 1e-12, "m");
            QCOMPARE_NE(edge.surfaces[0], edge.surfaces[1]);
        }
        TriangleSoup one = *soup;
        std::ranges::fill(one.surfaceOf, kUpper);
        QVERIFY(boundaryEdges(one).empty());
        QVERIFY(boundaryEdges(TriangleSoup()).empty());
    }

    void anEdgeOfManyTrianglesIsOne() {
        TriangleSoup fan; // three wings on one edge, and a point
        fan.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}};
        fan.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {0, 0, 0}};
        fan.surfaceOf = {0, 1, 2, 3};
        QCOMPARE(boundaryEdges(fan).size(), std::size_t(1));
    }

    void linesFollowSurfaces_data() {
        QTest::addColumn<int>("meridians");
        QTest::newRow("alone") << 128;
        QTest::newRow("found aside") << 1400;
        QTest::newRow("in a crowd") << 32;
    }
    void linesFollowSurfaces() {
        QFETCH(int, meridians);
        DrawnView shown(ballScene(Index(meridians), 16));
        const QImage with = shown.view.grabPicture();
        QCOMPARE(shown.view.boundaryEdgesShown(), std::size_t(meridians));
        shown.options([](FeltOptions& o) { o.boundaries = false; });
        const QImage without = shown.view.grabPicture();
        QCOMPARE(shown.view.boundaryEdgesShown(), std::size_t(0));
        const QPointF middle = *shown.view.camera().project({0, 0, kBallRadius});
        int darker = 0;
        for (int y = -2; y <= 2; ++y)
            darker = std::max(darker, lightness(without, middle + QPointF(0, y)) -
                                          lightness(with, middle + QPointF(0, y)));
        QCOMPARE_GT(darker, 20);
        QVERIFY(changed(with, without) < 2500); // a line alone
        shown.options([](FeltOptions& o) { o.boundaries = true; });
        shown.edit([](Scene& s) { s.objects[0].surfaces[kUpper].visible = false; });
        QCOMPARE(shown.view.boundaryEdgesShown(), std::size_t(meridians)); // the edge of the rest
        shown.edit([](Scene& s) { s.objects[0].surfaces[kLower].visible = false; });
        QCOMPARE(shown.view.boundaryEdgesShown(), std::size_t(0));
        shown.edit([](Scene& s) {
            s.objects[0].surfaces[kLower].visible = s.objects[0].surfaces[kUpper].visible = true;
            auto soup = std::make_shared<TriangleSoup>(*s.objects[0].geometry);
            std::ranges::fill(soup->surfaceOf, kUpper);
            s.objects[0].geometry = soup;
        });
        QCOMPARE(shown.view.boundaryEdgesShown(), std::size_t(0));
    }

    void linesGoWithABodyThatMoves() {
        Scene scene = ballScene();
        SceneObject still = scene.objects[0]; // keeps the view where it is
        still.id = 0;
        still.pose.translation.x() = 0.15;
        scene.add(still);
        const Track<Vec3> up{Interpolation::Linear, {0, 2}, {Vec3::Zero(), {0, 0.06, 0}}, {}, {}};
        scene.objects[0].motion = std::make_shared<const Motion>(makeMotion(up, {}, 2));
        DrawnView shown(scene);
        ProxyTelemetry proxy;
        ServoTelemetry servo;
        proxy.updates = servo.ticks = 1;
        proxy.time = 1;
        shown.view.setOverlayVisible(false);
        shown.view.setHaptics(proxy, servo, 8, true);
        const QImage with = shown.view.grabPicture();
        shown.options([](FeltOptions& o) { o.boundaries = false; });
        const QImage without = shown.view.grabPicture();
        const auto darker = [&](const Vec3& p_W) {
            const QPointF at = *shown.view.camera().project(p_W);
            int most = 0;
            for (int y = -2; y <= 2; ++y)
                most = std::max(most,
                                lightness(without, at + QPointF(0, y)) - lightness(with, at + QPointF(0, y)));
            return most;
        };
        QCOMPARE_GT(darker({0, 0.03, kBallRadius}), 20);
        QCOMPARE_LT(darker({0, 0.01, kBallRadius}), 6);
    }

    void aWireframeIsSeenThrough() {
        for (const Index meridians : {Index(128), Index(32)}) {
            DrawnView shown(ballScene(meridians, 16));
            shown.options([](FeltOptions& o) { o.boundaries = false; });
            const QImage filled = shown.view.grabPicture();
            shown.options([](FeltOptions& o) { o.wireframe = true; });
            const QImage lines = shown.view.grabPicture();
            const QColor sky = lines.pixelColor(5, 200);
            int through = 0, drawn = 0;
            for (int y = 150; y < 250; ++y)
                for (int x = 150; x < 250; ++x) {
                    const int apart = std::abs(lines.pixelColor(x, y).lightness() - sky.lightness());
                    through += apart < 12;
                    drawn += apart > 25;
                }
            QCOMPARE_GT(through, meridians > 64 ? 200 : 2000);
            QCOMPARE_GT(drawn, 500);
            shown.options([](FeltOptions& o) { o.wireframe = false; });
            QVERIFY(shown.view.grabPicture() == filled);
        }
    }

    // Two balls one behind the other: in parallel the one behind is as large as the one before.
    void aParallelProjectionKeepsSizes() {
        Scene scene = ballScene();
        scene.objects[0].pose.translation = {-0.08, 0, 0.2};
        SceneObject back = scene.objects[0];
        back.id = 0;
        back.pose.translation = {0.08, 0, -0.2};
        scene.add(back);
        DrawnView shown(scene);
        const auto widths = [&](bool parallel) {
            shown.view.setParallel(parallel);
            shown.view.showStandardView(StandardView::Front);
            const QImage picture = shown.view.grabPicture();
            const int row = picture.height() / 2;
            const int sky = qGray(picture.pixel(1, row));
            std::array<int, 2> count{};
            for (int x = 0; x < picture.width(); ++x)
                count[2 * x < picture.width() ? 0 : 1] += std::abs(qGray(picture.pixel(x, row)) - sky) > 20;
            return count;
        };
        const auto perspective = widths(false), parallel = widths(true);
        QCOMPARE_GT(perspective[0], perspective[1] + 10);
        QCOMPARE_LE(std::abs(parallel[0] - parallel[1]), 3);
        QCOMPARE_GT(parallel[0], 80);
        QVERIFY(shown.view.surfaceAt(*shown.view.camera().project({0.08, 0.02, -0.15})));
        QVERIFY(!shown.view.surfaceAt(*shown.view.camera().project({0.08, 0.06, -0.2})));
    }
};

TACTUM_GUI_TEST(TestDrawnModel)

} // namespace test_drawn_model

#include "test_drawn_model.moc"
