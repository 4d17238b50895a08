// The picture of the contact from nearby, beside that of the view.
#include <algorithm>
#include <numeric>

#include <QElapsedTimer>
#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/contact_loupe.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_contact_loupe {

using namespace tactum;

namespace {

constexpr double kAside = 0.0034, kMark = 0.0005; ///< m, of two red marks on the plate and half their size
constexpr double kOver = 0.0024;                  ///< m, from the line between them to the finger

void addSquare(TriangleSoup& soup, const Vec3& middle, double half, Index surface) {
    const auto first = Index(soup.positions.size());
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        soup.positions.push_back(middle + half * Vec3(x, y, 0));
    for (const Index corner : {1, 2}) {
        soup.triangles.push_back({first, first + corner, first + corner + 1});
        soup.surfaceOf.push_back(surface);
    }
}

/// A plate across Z with a red mark on both sides of its middle.
Scene markedPlate() {
    auto soup = std::make_shared<TriangleSoup>();
    addSquare(*soup, Vec3::Zero(), 0.05, 0);
    for (const double x : {-kAside, kAside})
        addSquare(*soup, {x, 0, 1e-4}, kMark, 1);
    SceneObject plate;
    plate.geometry = soup;
    plate.surfaces.resize(2);
    plate.surfaces[0].colour = {0.5F, 0.5F, 0.5F};
    plate.surfaces[1].colour = {0.9F, 0.02F, 0.02F};
    Scene scene;
    scene.add(plate);
    return scene;
}

struct LoupeView {
    explicit LoupeView(bool parallel = false, double times = 5) {
        view.resize(800, 600);
        view.setScene(markedPlate());
        options.normals = options.planes = options.ground = false;
        view.setParallel(parallel);
        options.loupe = true;
        view.setLoupe({200, times});
        view.setFelt(options);
        view.showStandardView(StandardView::Front);
        QObject::connect(&view, &SceneView::loupeDrawn, &view, [this](const QImage& drawn, QPointF at) {
            picture = drawn;
            contact = at;
        });
        QObject::connect(&view, &SceneView::loupeLeft, &view, [this] { ++left; });
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        if (!test::waitFor([&] { return !view.makesMeshes() && !view.makesFelt(); }))
            qFatal("it is never made");
        proxy.updates = servo.ticks = 1;
    }

    void touch(double x, int contacts = 1) {
        proxy.output.proxy = {x, kOver, 0.0005};
        proxy.output.contacts = contacts;
        proxy.output.contact[0].point = {x, kOver, 0};
        proxy.output.contact[0].normal = Vec3::UnitZ();
        servo.finger = proxy.finger = {x, kOver, 0};
        view.setHaptics(proxy, servo, 8, true);
    }
    /// The next one of a touch there.
    QImage loupe(double x) {
        picture = {};
        if (!test::waitFor([&] {
                touch(x);
                return !picture.isNull();
            }))
            qFatal("there is no loupe");
        return picture;
    }

    SceneView view;
    FeltOptions options;
    ProxyTelemetry proxy;
    ServoTelemetry servo;
    QImage picture;
    QPointF contact;
    int left = 0;
};

/// Places of red pixels, logical ones, from the left to the right.
std::vector<QPointF> redPlaces(const QImage& picture) {
    std::vector<QPointF> places;
    for (int x = 0; x < picture.width(); ++x)
        for (int y = 0; y < picture.height(); ++y) {
            const QColor c = picture.pixelColor(x, y);
            if (c.red() > 60 && c.red() > 2.5 * std::max(c.green(), c.blue()))
                places.push_back(QPointF(x, y) / picture.devicePixelRatio());
        }
    return places;
}

QPointF middleOf(std::span<const QPointF> places) {
    return std::accumulate(places.begin(), places.end(), QPointF()) /
           double(std::max<std::size_t>(places.size(), 1));
}

/// Between the two marks, logical pixels.
double between(const QImage& picture) {
    const std::vector<QPointF> places = redPlaces(picture);
    const double middle = middleOf(places).x();
    const auto right = std::ranges::partition_point(places, [&](const QPointF& p) { return p.x() < middle; });
    const QPointF apart = middleOf({right, places.end()}) - middleOf({places.begin(), right});
    return std::hypot(apart.x(), apart.y());
}

/// Of what is within half the way to the other mark.
QPointF nearest(std::vector<QPointF> places) {
    std::erase_if(places, [](const QPointF& p) { return std::abs(p.x() - 100) > 80; });
    return middleOf(places);
}

int pixelsLike(const QImage& picture, const QColor& colour) {
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x) {
            const QColor c = picture.pixelColor(x, y);
            count += c.saturation() > 100 && std::abs(c.hue() - colour.hue()) < 12;
        }
    return count;
}

} // namespace

class TestContactLoupe : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void marksAreFurtherApartByTheFactor_data() {
        QTest::addColumn<bool>("parallel");
        QTest::addColumn<double>("times");
        QTest::addColumn<double>("turned");
        QTest::newRow("three times") << false << 3.0 << 0.0;
        QTest::newRow("five times") << false << 5.0 << 0.0;
        QTest::newRow("aslant") << false << 5.0 << 0.6;
        QTest::newRow("parallel") << true << 5.0 << 0.0;
        QTest::newRow("parallel, aslant") << true << 3.0 << -0.5;
    }
    void marksAreFurtherApartByTheFactor() {
        QFETCH(bool, parallel);
        QFETCH(double, times);
        QFETCH(double, turned);
        LoupeView shown(parallel, times);
        shown.view.moveCamera(turned, 0);
        const QImage close = shown.loupe(0);
        QCOMPARE(close.deviceIndependentSize(), QSizeF(200, 200));
        const double wide = between(shown.view.grabPicture());
        QCOMPARE_GT(wide, 20.0);
        COMPARE_NEAR(between(close) / wide, times, 0.05 * times, "");
    }

    void theContactIsInItsMiddle() {
        LoupeView shown;
        for (const double x : {-kAside, kAside}) {
            const QPointF mark = nearest(redPlaces(shown.loupe(x)));
            COMPARE_NEAR(mark.x(), 100, 1.5, "pixels");
            const Vec3& proxy = shown.proxy.output.proxy;
            COMPARE_NEAR(mark.y(), 100 + 5 * kOver / shown.view.camera().pixelSize(proxy), 1.5, "pixels");
            const auto seen = shown.view.camera().project(proxy);
            QCOMPARE(shown.contact, *seen);
        }
    }

    void fingerAndProxyAreInIt() {
        LoupeView shown;
        const QImage close = shown.loupe(0);
        QCOMPARE_GT(pixelsLike(close, kDarkTheme.proxy), 50);
        QCOMPARE_GT(pixelsLike(close, kDarkTheme.finger), 50);
    }

    void planesAreSeenThrough() {
        LoupeView shown;
        shown.options.planes = true;
        shown.view.setFelt(shown.options);
        const QImage close = shown.loupe(0);
        const QPoint contact = shown.contact.toPoint();
        const QColor there = shown.view.grabPicture().pixelColor(contact + QPoint(20, -14));
        const QColor here = close.pixelColor(QPoint(150, 80)); // beside the ball
        COMPARE_NEAR(here.red(), there.red(), 12.0, "");
        COMPARE_NEAR(here.green(), there.green(), 12.0, "");
    }

    void theViewStaysAsItIs() {
        LoupeView shown;
        shown.options.loupe = false;
        shown.view.setFelt(shown.options);
        shown.touch(0.01);
        const QImage before = shown.view.grabPicture();
        shown.options.loupe = true;
        shown.view.setFelt(shown.options);
        for (const double x : {0.01, 0.012, 0.01}) { // and what a picture takes is known
            (void)shown.loupe(x);
            QTRY_VERIFY2(shown.view.rests(), "one in motion and one at rest are kept");
        }
        const int drawn = shown.view.modelPictures();
        (void)shown.loupe(0.012);
        (void)shown.loupe(0.01);
        QCOMPARE(shown.view.modelPictures(), drawn);
        QCOMPARE(shown.view.grabPicture(), before);
    }

    /// What lay over its place may have gone meanwhile. The view itself has nothing new to draw.
    void aStillTouchIsDrawnAgainAndAgain() {
        LoupeView shown;
        for (int picture = 0; picture < 10; ++picture)
            QVERIFY(!shown.loupe(0.001).isNull());
    }

    void itLeavesAfterTheTouch() {
        LoupeView shown;
        (void)shown.loupe(0);
        QCOMPARE(shown.left, 0);
        QVERIFY(test::waitFor([&] {
            shown.touch(0, 0);
            return shown.left == 1;
        }));
        shown.picture = {};
        shown.view.moveCamera(0.1, 0);
        (void)shown.view.grabPicture();
        QCoreApplication::processEvents();
        QVERIFY(shown.picture.isNull());
        (void)shown.loupe(0);
    }

    void itGoesWhenItIsSwitchedOff() {
        LoupeView shown;
        (void)shown.loupe(0);
        shown.options.loupe = false;
        shown.view.setFelt(shown.options);
        QCOMPARE(shown.left, 1);
        shown.picture = {};
        shown.touch(0.01);
        (void)shown.view.grabPicture();
        QTRY_VERIFY(shown.view.rests());
        QVERIFY(shown.picture.isNull());
    }

    /// Pictures a second of a touch that moves, without and with the loupe, by turns.
    void figures() {
        const int triangles = qEnvironmentVariableIntValue("TACTUM_TRIANGLES");
        if (triangles < 8) QSKIP("TACTUM_TRIANGLES says of how many");
        const auto rings = Index(std::sqrt(triangles / 4.0));
        LoupeView shown;
        shown.view.resize(1280, 800);
        shown.view.setScene(testing::ballScene(2 * rings, rings));
        shown.view.fit();
        if (!test::waitFor([&] { return !shown.view.makesMeshes(); })) qFatal("the meshes are never made");
        int views = 0, loupes = 0;
        connect(&shown.view, &QOpenGLWidget::frameSwapped, this, [&] { ++views; });
        connect(&shown.view, &SceneView::loupeDrawn, this, [&] { ++loupes; });
        for (int run = 0; run < 6; ++run) {
            shown.options.loupe = run % 2 == 1;
            shown.view.setFelt(shown.options);
            QTRY_VERIFY(shown.view.rests());
            views = loupes = 0;
            QElapsedTimer clock;
            clock.start();
            for (int drawn = -1, i = 0; clock.elapsed() < 5000; QCoreApplication::processEvents())
                if (std::exchange(drawn, views) != views) shown.touch(1e-4 * (++i % 100));
            qInfo("loupe %s: %5.1f pictures a second, %4.1f of the loupe",
                  shown.options.loupe ? "on " : "off", 1e3 * views / double(clock.elapsed()),
                  1e3 * loupes / double(clock.elapsed()));
        }
    }

    void whatTakesLongComesSeldom() {
        using std::chrono::milliseconds;
        QCOMPARE_EQ(loupePause(milliseconds(2)).count(), 40);
        QCOMPARE_EQ(loupePause(milliseconds(100)).count(), 400);
    }
};

TACTUM_GUI_TEST(TestContactLoupe)

} // namespace test_contact_loupe

#include "test_contact_loupe.moc"
