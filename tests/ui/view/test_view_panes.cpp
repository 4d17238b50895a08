// Where the panes of a divided view are, which of them a place is in, and what they are called.
#include <algorithm>
#include <numbers>
#include <random>

#include <QTest>

#include "tests/support/compare.h"
#include "tests/support/test_program.h"
#include "ui/view/pane_mark.h"
#include "ui/view/view_panes.h"

namespace test_view_panes {

using namespace tactum;

namespace {

ViewPanes divided(ViewSplit split, QSize size = {402, 302}) {
    ViewPanes panes;
    panes.layOut(size);
    panes.setSplit(split);
    return panes;
}

std::vector<QRect> placesOf(const ViewPanes& panes) {
    std::vector<QRect> places;
    for (const std::size_t number : panes.shown())
        places.push_back(panes[number].place);
    return places;
}

} // namespace

class TestViewPanes : public QObject {
    Q_OBJECT
private slots:
    void aWholeViewIsOnePane() {
        const ViewPanes panes = divided(ViewSplit::One);
        QCOMPARE(placesOf(panes), std::vector{QRect(0, 0, 402, 302)});
        QVERIFY(!panes.isDivided() && !panes.linesAt({201, 151}));
        QCOMPARE(panes.at({-5, 700}), ViewPanes::kOwn);
    }

    void theyFillTheViewButForTheLinesBetween() {
        QCOMPARE(placesOf(divided(ViewSplit::Columns)),
                 (std::vector{QRect(0, 0, 200, 302), QRect(202, 0, 200, 302)}));
        QCOMPARE(placesOf(divided(ViewSplit::Rows)),
                 (std::vector{QRect(0, 0, 402, 150), QRect(0, 152, 402, 150)}));
        QCOMPARE(placesOf(divided(ViewSplit::Four)),
                 (std::vector{QRect(0, 0, 200, 150), QRect(202, 0, 200, 150), QRect(0, 152, 200, 150),
                              QRect(202, 152, 200, 150)}));
    }

    // However small the view is, or far the lines are led.
    void noneGoesAway() {
        for (const QSize size : {QSize(160, 120), QSize(402, 302), QSize(1900, 1000)})
            for (const QPointF to : {QPointF(-50, -50), QPointF(5000, 5000)}) {
                ViewPanes panes = divided(ViewSplit::Four, size);
                panes.lead(Qt::Horizontal | Qt::Vertical, to);
                for (const QRect& place : placesOf(panes)) {
                    QCOMPARE_GE(std::min(place.width(), place.height()), 38);
                    QVERIFY(QRect(QPoint(), size).contains(place));
                }
            }
    }

    void aPlaceIsInThePaneThatIsThere() {
        ViewPanes panes = divided(ViewSplit::Four);
        QCOMPARE(panes.at({10, 10}), ViewPanes::kTop);
        QCOMPARE(panes.at({300, 10}), ViewPanes::kOwn);
        QCOMPARE(panes.at({10, 300}), ViewPanes::kFront);
        QCOMPARE(panes.at({900, 900}), ViewPanes::kRight); // a drag goes on beyond the edge
        QCOMPARE(panes[ViewPanes::kRight].inside({212, 172}), QPointF(10, 20));
    }

    void aLineIsTakenNearIt() {
        const ViewPanes panes = divided(ViewSplit::Four);
        QCOMPARE(panes.linesAt({201, 20}), Qt::Orientations(Qt::Vertical));
        QCOMPARE(panes.linesAt({20, 153}), Qt::Orientations(Qt::Horizontal));
        QCOMPARE(panes.linesAt({202, 150}), Qt::Horizontal | Qt::Vertical);
        QVERIFY(!panes.linesAt({190, 20}));
        QVERIFY(!divided(ViewSplit::Rows).linesAt({201, 20}));
    }

    void theActiveOneIsUnderThePointerElseTheOneLastUsed() {
        ViewPanes panes = divided(ViewSplit::Four);
        QCOMPARE(panes.active(), ViewPanes::kOwn);
        QVERIFY(panes.pointAt({10, 10}) && !panes.pointAt({20, 20}));
        QCOMPARE(panes.active(), ViewPanes::kTop);
        QVERIFY(panes.pointNowhere());
        QCOMPARE(panes.active(), ViewPanes::kOwn);
        panes.pointAt({10, 300});
        panes.use();
        panes.pointAt({10, 10});
        panes.pointNowhere();
        QCOMPARE(panes.active(), ViewPanes::kFront);
        panes.setSplit(ViewSplit::Columns); // where it is not
        QCOMPARE(panes.active(), ViewPanes::kOwn);
    }

    void theyAreCalledByWhereTheyLookFrom() {
        ViewPanes panes;
        const auto name = [&](std::size_t pane) { return paneName(pane, panes[pane].camera); };
        QCOMPARE(name(ViewPanes::kFront), QStringLiteral("Front, parallel"));
        QCOMPARE(name(ViewPanes::kRight), QStringLiteral("Right, parallel"));
        QCOMPARE(name(ViewPanes::kTop), QStringLiteral("Top, parallel"));
        panes[ViewPanes::kTop].camera.yaw = 0.1;
        QCOMPARE(name(ViewPanes::kTop), QStringLiteral("Top, turned, parallel"));
        panes[ViewPanes::kRight].camera.pitch = 0.1;
        panes[ViewPanes::kRight].camera.parallel = false;
        QCOMPARE(name(ViewPanes::kRight), QStringLiteral("Right, turned"));
        QCOMPARE(name(ViewPanes::kOwn), QStringLiteral("Own view"));
        ViewCamera& camera = panes[ViewPanes::kOwn].camera;
        camera.pitch = 0;
        camera.yaw = std::numbers::pi;
        QCOMPARE(name(ViewPanes::kOwn), QStringLiteral("Back"));
        camera.yaw = -0.5 * std::numbers::pi;
        QCOMPARE(name(ViewPanes::kOwn), QStringLiteral("Left"));
        camera.pitch = -0.5 * std::numbers::pi;
        QCOMPARE(name(ViewPanes::kOwn), QStringLiteral("Own view"));
        camera.yaw = 0;
        QCOMPARE(name(ViewPanes::kOwn), QStringLiteral("Bottom"));
        panes.plan();
        QCOMPARE(name(ViewPanes::kTop), QStringLiteral("Top, parallel"));
        QCOMPARE(name(ViewPanes::kRight), QStringLiteral("Right, parallel"));
        QCOMPARE(name(ViewPanes::kOwn), QStringLiteral("Own view"));
    }

    // A plate 3 long and 1 high, from the front in parallel, looked at beside its middle: the picture is as
    // large as the tighter side allows, so in a pane of another size it grows or shrinks as that side does.
    void inAnotherSizeTheSceneFillsAsMuchOfThePicture() {
        const std::vector<Vec3> plate{{-1.5, -0.5, 0}, {1.5, 0.5, 0}};
        for (const double zoom : {1.0, 0.3, 2.5}) { // framed, and nearer and farther than that
            ViewPanes panes;
            ViewPane& pane = panes[ViewPanes::kOwn];
            panes.setSpanning(plate);
            panes.layOut({600, 400});
            pane.camera = ViewPanes::planned(ViewPanes::kFront);
            pane.camera.size = {600, 400};
            pane.camera.fit(plate);
            pane.fitted = true;
            pane.camera.distance *= zoom;
            pane.camera.focus = {0.2, 0.1, 0}; // 1.7 and 0.6 to the farther edges
            const ViewCamera before = pane.camera;
            const auto length = [&] {
                const ViewCamera& camera = pane.camera;
                return camera.project({1, 0, 0})->x() - camera.project({0, 0, 0})->x();
            };
            const auto largest = [](double width, double height) {
                return std::min(0.5 * width / 1.7, 0.5 * height / 0.6);
            };
            const double part = length() / largest(600, 400);
            for (const QSize size : {QSize(300, 400), QSize(300, 150), QSize(300, 50), QSize(900, 800)}) {
                panes.layOut(size);
                COMPARE_NEAR(length(), part * largest(size.width(), size.height()), 1e-9, "pixels");
            }
            panes.layOut({600, 400});
            COMPARE_NEAR(pane.camera.distance, before.distance, 1e-12 * before.distance, "m");
            QVERIFY(pane.camera.focus == before.focus);
        }
    }

    // Turned, moved and with vanishing points: what no formula is short for.
    void whatIsWholeStaysWholeFromAnywhere() {
        std::mt19937 random(7);
        const auto among = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        int whole = 0, tall = 0;
        for (int i = 0; i < 2000; ++i) {
            std::vector<Vec3> points;
            for (int k = 0; k < 30; ++k)
                points.emplace_back(among(-1, 1), among(-0.3, 0.3), among(-2, 2));
            ViewPanes panes;
            ViewPane& pane = panes[ViewPanes::kOwn];
            panes.setSpanning(points);
            panes.layOut({int(among(100, 900)), int(among(100, 900))});
            pane.camera.fit(points);
            pane.fitted = true;
            pane.camera.yaw = among(-4, 4);
            pane.camera.pitch = among(-1.5, 1.5);
            pane.camera.distance *= among(0.7, 3);
            pane.camera.parallel = i % 2 == 0;
            pane.camera.focus += Vec3(among(-0.1, 0.1), among(-0.1, 0.1), among(-0.1, 0.1));
            const ViewCamera before = pane.camera;
            panes.layOut({int(among(100, 900)), int(among(100, 900))});
            const auto isWhole = [&](const ViewCamera& camera) {
                return std::ranges::all_of(points, [&](const Vec3& p) {
                    const auto at = camera.project(p);
                    return at && QRectF({-1e-6, -1e-6}, camera.size + QSizeF(2e-6, 2e-6)).contains(*at);
                });
            };
            whole += isWhole(before);
            tall += pane.camera.size.width() < pane.camera.size.height();
            if (isWhole(before)) QVERIFY2(isWhole(pane.camera), qPrintable(QString::number(i)));
            panes.layOut(before.size.toSize());
            COMPARE_NEAR(pane.camera.distance, before.distance, 1e-9 * before.distance, "m");
        }
        QVERIFY(whole > 500 && whole < 1990 && tall > 500);
    }

    void theProjectionLeavesWholeWhatIsWholeAndElseTheFocusItsSize() {
        const std::vector<Vec3> plate{{-1.5, 0, -1.5}, {1.5, 0.1, 1.5}, {-1.5, 0, 1.5}, {1.5, 0, -1.5}};
        ViewPanes panes;
        panes.setSpanning(plate);
        panes.layOut({600, 400});
        ViewPane& pane = panes[ViewPanes::kOwn];
        panes.setParallel(ViewPanes::kOwn, true);
        pane.camera.pitch = 0.3; // along it: its near edge is large with vanishing points
        pane.camera.fit(plate);
        pane.fitted = true;
        const ViewCamera before = pane.camera;
        const double part = before.filled(plate);
        panes.setParallel(ViewPanes::kOwn, false);
        QVERIFY(!pane.camera.parallel);
        COMPARE_NEAR(pane.camera.filled(plate), part, 1e-9, "");
        panes.setParallel(ViewPanes::kOwn, true);
        COMPARE_NEAR(pane.camera.distance, before.distance, 1e-9 * before.distance, "m");
        pane.camera.distance *= 0.2;
        const double near = pane.camera.distance;
        panes.setParallel(ViewPanes::kOwn, false);
        QCOMPARE(pane.camera.distance, near);
        // What is chosen is kept with another scene, what a kept camera brought is not.
        pane.camera.parallel = true;
        panes.plan();
        QVERIFY(!panes[ViewPanes::kOwn].camera.parallel && panes[ViewPanes::kTop].camera.parallel);
    }

    void aPaneThatWasNeverFramedKeepsItsCamera() {
        ViewPanes panes;
        panes.setSpanning({{-1, -1, -1}, {1, 1, 1}});
        const double distance = panes[ViewPanes::kOwn].camera.distance;
        panes.layOut({300, 900});
        panes.layOut({900, 300});
        QCOMPARE(panes[ViewPanes::kOwn].camera.distance, distance);
    }
};

TACTUM_TEST(TestViewPanes)

} // namespace test_view_panes

#include "test_view_panes.moc"
