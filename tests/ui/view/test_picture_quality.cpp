// Where the processor draws, a picture is as good as the time allows: coarser meshes in motion, edges
// smoothed at rest where samples take too long, and always the exact mesh at rest.
#include <map>
#include <set>

#include <QTest>

#include "core/haptics/compile.h"
#include "tests/support/compare.h"
#include "tests/support/gui_test_program.h"
#include "tests/support/waiting.h"
#include "tests/ui/view/ball_scene.h"
#include "ui/view/coarse_mesh.h"
#include "ui/view/picture_budget.h"
#include "ui/view/scene_view.h"
#include "ui/view/surface_format.h"

namespace test_picture_quality {

using namespace tactum;
using namespace tactum::testing;

namespace {

constexpr PictureLimits kNoTime{0, 0}, kAllTime{1e9, 1e9};

struct QualityView {
    explicit QualityView(const PictureLimits& limits, Index meridians = 512, Index rings = 128)
        : scene(ballScene(meridians, rings)) {
        view.resize(400, 300);
        view.setScene(scene);
        view.setPictureLimits(limits);
        FeltOptions bare;
        bare.ground = bare.boundaries = false; // lines are not drawn coarsely
        view.setFelt(bare);
        view.show();
        if (!QTest::qWaitForWindowExposed(&view)) qFatal("no window");
        if (!test::waitFor([&] { return !view.makesMeshes() && !view.makesFelt(); }))
            qFatal("it is never made");
        proxy.updates = servo.ticks = 1;
        touch(0);
        rest();
    }

    void touch(double aside) {
        proxy.output.proxy = {aside, 0, 0.06};
        servo.finger = proxy.finger = {aside, 0, 0.055};
        view.setHaptics(proxy, servo, 8, true);
    }
    QImage rest() {
        if (!test::waitFor([&] { return view.rests(); })) qFatal("it never rests");
        return view.grabFramebuffer();
    }
    QImage turn() {
        view.moveCamera(0.05, 0);
        return view.grabFramebuffer();
    }
    /// The same picture with all the time there is.
    QImage exact() {
        view.setPictureLimits(kAllTime);
        view.forgetPicture();
        return view.grabFramebuffer();
    }

    Scene scene;
    SceneView view;
    ProxyTelemetry proxy;
    ServoTelemetry servo;
};

int differing(const QImage& a, const QImage& b, int than) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > than;
    return count;
}

/// How much neighbours in a row bend: what a picture of fewer pixels has less of. The sky has none.
double steps(const QImage& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 2; x < picture.width(); ++x)
            sum += std::abs(qGray(picture.pixel(x - 2, y)) - 2 * qGray(picture.pixel(x - 1, y)) +
                            qGray(picture.pixel(x, y)));
    return sum;
}

struct Lit {
    double count = 0; ///< pixels
    QPointF middle;
};

/// What is brighter than the sky beside it.
Lit litOf(const QImage& picture) {
    Lit lit;
    QPointF sum;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (qGray(picture.pixel(x, y)) > qGray(picture.pixel(1, y)) + 20) {
                ++lit.count;
                sum += QPointF(x, y);
            }
    lit.middle = sum / std::max(1.0, lit.count);
    return lit;
}

} // namespace

class TestPictureQuality : public QObject {
    Q_OBJECT
public:
    static void initMain() { useViewSurfaceFormat(); }

private slots:
    void theLastPictureDecides() {
        PictureBudget budget;
        QVERIFY(!budget.known() && !budget.affordsMotion());
        QCOMPARE(budget.atRest(), PictureQuality::Smoothed);
        budget.took(0.05, false);
        QVERIFY(budget.affordsMotion());
        QCOMPARE(budget.atRest(), PictureQuality::Sampled);
        budget.took(0.2, true);
        QCOMPARE(budget.atRest(), PictureQuality::Sampled);
        budget.took(0.26, true); // longer than was thought
        QCOMPARE(budget.atRest(), PictureQuality::Smoothed);
        budget.took(0.07, false);
        QVERIFY(!budget.affordsMotion());
        budget.setLimits({0.1, 0.3});
        QVERIFY(budget.affordsMotion());
        QCOMPARE(budget.atRest(), PictureQuality::Sampled);
        budget.forget();
        QVERIFY(!budget.known());
    }

    // A part of the exact one, which follows that when something is taken off the model.
    void aCoarsePictureIsJudgedByTheQuickerOfTwo() {
        PictureBudget budget;
        budget.took(0.15, false);
        QCOMPARE(budget.affordedSide(), 1.0);
        budget.tookCoarse(0.4); // brings meshes to the card
        QCOMPARE(budget.affordedSide(), 1.0);
        budget.tookCoarse(0.06);
        QCOMPARE(budget.affordedSide(), 1.0);
        QCOMPARE(budget.affordedSide(2), 1.0 / 3);
        budget.tookCoarse(0.09);
        QCOMPARE(budget.affordedSide(), 1.0);
        budget.tookCoarse(0.1);
        QCOMPARE(budget.affordedSide(), 0.5);
        budget.took(0.09, false); // 0.09 / 0.15 of it
        QCOMPARE(budget.affordedSide(), 1.0);
        budget.took(0.12, false);
        QCOMPARE(budget.affordedSide(), 0.5);
        budget.took(0.24, false);
        QCOMPARE(budget.affordedSide(), 1.0 / 3);
        budget.forget();
        QCOMPARE(budget.affordedSide(), 1.0);
    }

    void aCoarseMeshIsClosedWhereTheExactOneIs() {
        const auto soup = ballSoup(512, 128);
        const DisplayMesh mesh = smoothMesh(*soup);
        const CoarseMesh coarse = coarseMesh(mesh, 10000);
        QCOMPARE_GT(coarse.corners.size(), std::size_t(5000));
        QVERIFY2(coarse.corners.size() < 15000, qPrintable(QString::number(coarse.corners.size())));
        const auto height = [&](int corner) { return mesh.positions[3 * std::size_t(corner) + 1]; };
        std::map<std::set<int>, int> edges; // between surfaces, too
        for (const auto& [a, b, c] : coarse.corners)
            for (const std::set<int>& edge : {std::set{a, b}, std::set{b, c}, std::set{c, a}})
                ++edges[edge];
        for (const auto& [edge, triangles] : edges)
            if (std::abs(height(*edge.begin())) < 0.9 * kBallRadius) // at its poles the ball itself is open
                QCOMPARE(triangles % 2, 0);
        const auto surfaces = coarse.surfaceOf(soup->surfaceOf);
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            const double middle =
                (height(coarse.corners[i][0]) + height(coarse.corners[i][1]) + height(coarse.corners[i][2])) /
                3;
            if (std::abs(middle) > 0.005) QCOMPARE(surfaces[i], middle > 0 ? kUpper : kLower);
        }
    }

    void whatHasNoAreaHasNoCoarseMesh() {
        DisplayMesh flat;
        QVERIFY(coarseMesh(flat, 100).corners.empty());
        flat.positions.assign(9, 0);
        flat.corners = {{0, 1, 2}};
        QVERIFY(coarseMesh(flat, 100).corners.empty());
    }

    void theCameraTurnsCoarsely() {
        QualityView shown(kNoTime);
        if (!shown.view.rendersInSoftware()) QSKIP("a graphics card draws the exact mesh");
        QVERIFY(!shown.view.drawsCoarse());
        const QImage coarse = shown.turn();
        QVERIFY(shown.view.drawsCoarse());
        const QImage exact = shown.exact();
        QVERIFY(!shown.view.drawsCoarse());
        QCOMPARE_GT(differing(coarse, exact, 0), 0);
        QVERIFY(differing(coarse, exact, 24) < 200); // of 120,000, along the rim
    }

    void whereThatTakesTooLongItHasFewerPixels() {
        for (const QSize size : {QSize(400, 300), QSize(401, 303)}) {
            QualityView shown(kNoTime);
            if (!shown.view.rendersInSoftware()) QSKIP("a graphics card draws the exact mesh");
            shown.view.resize(size);
            shown.rest();
            shown.view.setPictureLimits(kAllTime);
            const QImage whole = shown.turn();
            shown.view.setPictureLimits(kNoTime);
            QImage small;
            for (int i = 0; i < 2; ++i) { // three tell what they take
                shown.view.moveCamera(-0.05, 0);
                shown.view.grabFramebuffer();
                small = shown.turn();
            }
            QVERIFY(shown.view.drawsCoarse());
            QCOMPARE(small.size(), whole.size());
            if (const QString to = qEnvironmentVariable("TACTUM_PICTURE"); !to.isEmpty()) {
                small.save(to + "-small.png");
                whole.save(to + "-whole.png");
            }
            QCOMPARE_LT(steps(small), 0.75 * steps(whole));
            // It is where it was, not a pixel of it aside: the middle of what is not sky, and how much that
            // is.
            QCOMPARE_GT(litOf(whole).count, 0.1 * size.width() * size.height());
            COMPARE_NEAR(litOf(small).middle.x(), litOf(whole).middle.x(), 1.0, "pixels");
            COMPARE_NEAR(litOf(small).middle.y(), litOf(whole).middle.y(), 1.0, "pixels");
            COMPARE_NEAR(litOf(small).count, litOf(whole).count, 0.025 * litOf(whole).count, "pixels");
            // To its edges: none is of another picture or of none.
            for (const QPoint& at : {QPoint(0, 0), QPoint(size.width() - 1, size.height() - 1)})
                QCOMPARE_LE(std::abs(qGray(small.pixel(at)) - qGray(whole.pixel(at))), 3);
            // As much of a finger is seen as with all pixels: before the ball, half in it, behind it.
            const auto seen = [&](double z) {
                shown.proxy.output.proxy = shown.servo.finger = shown.proxy.finger = {0, 0, z};
                shown.view.setHaptics(shown.proxy, shown.servo, 8, true);
                const QImage with = shown.turn();
                shown.view.setOverlayVisible(false);
                shown.view.moveCamera(-0.05, 0);
                const QImage without = shown.turn();
                shown.view.setOverlayVisible(true);
                shown.view.moveCamera(-0.05, 0);
                return differing(with, without, 60);
            };
            const std::array<double, 3> places{0.06, 0.0495, -0.03};
            std::array<int, 3> few{}, all{};
            std::ranges::transform(places, few.begin(), seen);
            shown.view.setPictureLimits(kAllTime);
            std::ranges::transform(places, all.begin(), seen);
            shown.view.setPictureLimits(kNoTime);
            QCOMPARE_GT(all[0], 2 * all[2]);
            for (std::size_t i = 0; i < places.size(); ++i)
                COMPARE_NEAR(few[i], all[i], 0.25 * all[0], "pixels");
            const QImage resting = shown.rest();
            QVERIFY(!shown.view.drawsCoarse());
            QCOMPARE_GT(steps(resting), steps(small));
        }
    }

    void restsAndIsTouchedExactly() {
        QualityView shown(kNoTime);
        if (!shown.view.rendersInSoftware()) QSKIP("a graphics card draws the exact mesh");
        shown.turn();
        const int turned = shown.view.modelPictures();
        shown.rest();
        QVERIFY(!shown.view.drawsCoarse());
        QCOMPARE(shown.view.modelPictures(), turned + 1);
        for (int i = 1; i <= 3; ++i) {
            shown.touch(0.001 * i);
            shown.view.grabFramebuffer();
            QVERIFY(!shown.view.drawsCoarse());
        }
        QCOMPARE(shown.view.modelPictures(), turned + 1);
    }

    void aTouchThatNeverRestsIsSoonExact() {
        QualityView shown(kNoTime);
        if (!shown.view.rendersInSoftware()) QSKIP("a graphics card draws the exact mesh");
        shown.turn();
        int touches = 0;
        QVERIFY(test::waitFor([&] {
            shown.touch(0.001 * (++touches % 20));
            shown.view.grabFramebuffer();
            return !shown.view.drawsCoarse();
        }));
    }

    /// Noise on three planes costs the most of all reliefs: it loses its finest octaves in motion alone.
    void aReliefIsCoarseInMotion() {
        Scene rough = ballScene(64, 32);
        TextureLayer noise;
        noise.pattern.source = TextureSource::Noise;
        noise.pattern.mapping = TextureMapping::Triplanar;
        noise.strength = 1e-3;
        for (Surface& surface : rough.objects[0].surfaces)
            surface.layers = {noise};
        QualityView shown(kNoTime, 64, 32);
        if (!shown.view.rendersInSoftware()) QSKIP("a graphics card draws all of it");
        shown.turn();
        QVERIFY(!shown.view.drawsCoarse()); // there is nothing to leave out
        shown.view.setScene(rough);
        shown.view.setWorld(compile(rough).value());
        if (!test::waitFor([&] { return !shown.view.makesFelt(); })) qFatal("it is never made");
        shown.rest();
        const QImage quick = shown.turn();
        QVERIFY(shown.view.drawsCoarse());
        const QImage exact = shown.exact();
        QVERIFY(!shown.view.drawsCoarse());
        QCOMPARE_GT(differing(quick, exact, 4), 500);
        QVERIFY(differing(quick, exact, 64) < 6000); // of 120,000: it looks like what it is
        if (const QString to = qEnvironmentVariable("TACTUM_PICTURE"); !to.isEmpty()) {
            quick.save(to + "-quick.png");
            exact.save(to + "-exact.png");
        }
        QVERIFY(shown.turn() != quick);
        QVERIFY(!shown.view.drawsCoarse()); // for that there is time now
    }

    void whatIsLaidOverLiesOnTheExactMesh() {
        QualityView shown(kNoTime);
        shown.view.setSelectedFaces(shown.scene.objects[0].id, {1000, 1001, 1002});
        shown.turn();
        QVERIFY(!shown.view.drawsCoarse());
    }

    void edgesAreSmoothedWhereSamplesTakeTooLong() {
        QualityView shown(kNoTime, 64, 32);
        if (!shown.view.rendersInSoftware()) QSKIP("a graphics card draws samples at once");
        const QImage moving = shown.turn();
        const int drawn = shown.view.modelPictures();
        const QImage smoothed = shown.rest();
        QCOMPARE(shown.view.quality(), PictureQuality::Smoothed);
        QCOMPARE(shown.view.modelPictures(), drawn);
        QCOMPARE_GT(differing(moving, smoothed, 10), 100);
        const QImage sampled = shown.view.grabPicture();
        QVERIFY(differing(smoothed, sampled, 10) < differing(moving, sampled, 10));
    }

    void restsSampledWhereThereIsTime() {
        QualityView shown(kAllTime, 64, 32);
        shown.turn();
        shown.rest();
        QCOMPARE(shown.view.quality(), PictureQuality::Sampled);
    }
};

TACTUM_GUI_TEST(TestPictureQuality)

} // namespace test_picture_quality

#include "test_picture_quality.moc"
